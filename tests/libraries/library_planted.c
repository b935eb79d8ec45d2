/* Planted searches, for the test of the judge: right, wrong, refusing, crashing and endless. */
#include "library.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void *open_face(int kind)
{
    (void)kind;
    return malloc(12 * sizeof(double));
}

static void set(void *work, const double *x)
{
    memcpy(work, x, 12 * sizeof *x);
}

static int corner(void *work, const double xs[3], struct library_answer *a)
{
    (void)work;
    (void)xs;
    a->loc[0] = a->loc[1] = -1;
    return LIBRARY_ANSWER;
}

static int far_point(void *work, const double xs[3], struct library_answer *a)
{
    memcpy(a->point, work, sizeof a->point);
    a->point[0] += 1e3 + xs[0];
    a->is_point = 1;
    return LIBRARY_ANSWER;
}

static int refuse(void *work, const double xs[3], struct library_answer *a)
{
    (void)work;
    (void)xs;
    (void)a;
    return LIBRARY_NONE;
}

static int crash(void *work, const double xs[3], struct library_answer *a)
{
    (void)work;
    (void)xs;
    (void)a;
    abort();
}

static int endless(void *work, const double xs[3], struct library_answer *a)
{
    volatile double sum = 0;
    (void)work;
    while (!(sum < 0))
        sum = fabs(xs[0] + a->loc[0]);
    return LIBRARY_NONE;
}

#define ROW(name, find)                                                                                                \
    {                                                                                                                  \
        name, 1u << LIBRARY_QUAD4, LIBRARY_CLOSEST, "", open_face, set, find, free                                     \
    }
static const struct library_search searches[] = {ROW("corner", corner), ROW("far", far_point), ROW("refuse", refuse),
                                                 ROW("crash", crash), ROW("endless", endless)};

const struct library *library_open(void)
{
    static const struct library self = {"planted", "0", sizeof searches / sizeof *searches, searches, 0, NULL};
    return &self;
}
