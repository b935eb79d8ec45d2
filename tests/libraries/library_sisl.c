/* SISL: closest points of spline surfaces. Four-, eight- and nine-node faces are Bezier surfaces. s1954 finds all
 * closest points, s1958 one "in clear cut cases", and s1775 iterates from a guess, here the middle. */
#include "library.h"

#include <sisl.h>
#include <stdlib.h>

#define COMPUTED 1e-12 /* relative */
#define GEOMETRY 1e-9  /* mesh length */

/* Replaces SISL's function, which prints on stderr: Debian's archive is not compiled for shared objects that use
 * stderr. */
void s6err(const char *routine, int status, int position);
void s6err(const char *routine, int status, int position)
{
    (void)routine;
    (void)status;
    (void)position;
}

struct work {
    int kind, order;
    SISLSurf *surface;
    double control[27], knots[6];
};

static void *open_surface(int kind)
{
    struct work *const w = calloc(1, sizeof *w);
    if (!w)
        return NULL;
    w->kind = kind;
    w->order = kind == LIBRARY_QUAD4 ? 2 : 3;
    for (int i = 0; i < 2 * w->order; i++)
        w->knots[i] = i < w->order ? 0 : 1;
    return w;
}

/* Returns the middle control point of a quadratic curve through three points. */
static double middle(double a, double m, double b)
{
    return 2 * m - 0.5 * (a + b);
}

/* Computes control points; the first parameter's index runs first. */
static void controls(int kind, const double *x, double *c)
{
    static const int corner[4] = {0, 2, 8, 6}, side[4] = {1, 5, 7, 3};
    for (int k = 0; k < 3; k++) {
        double corners = 0, middles = 0, sides = 0;
        if (kind == LIBRARY_QUAD4) {
            c[k] = x[k];
            c[3 + k] = x[3 + k];
            c[6 + k] = x[9 + k];
            c[9 + k] = x[6 + k];
            continue;
        }
        for (int i = 0; i < 4; i++) {
            c[3 * corner[i] + k] = x[3 * i + k];
            c[3 * side[i] + k] = middle(x[3 * i + k], x[12 + 3 * i + k], x[3 * ((i + 1) % 4) + k]);
            corners += x[3 * i + k];
            middles += x[12 + 3 * i + k];
            sides += c[3 * side[i] + k];
        }
        const double centre = kind == LIBRARY_QUAD9 ? x[24 + k] : 0.5 * middles - 0.25 * corners;
        c[12 + k] = 4 * centre - 0.25 * corners - 0.5 * sides;
    }
}

static void set(void *work, const double *x)
{
    struct work *const w = work;
    controls(w->kind, x, w->control);
    if (w->surface)
        freeSurf(w->surface);
    w->surface = newSurf(w->order, w->order, w->order, w->order, w->knots, w->knots, w->control, 1, 3, 1);
}

static int answer(const double parameters[2], struct library_answer *a)
{
    for (int k = 0; k < 2; k++)
        a->loc[k] = 2 * parameters[k] - 1;
    return LIBRARY_ANSWER;
}

static int all_closest(void *work, const double xs[3], struct library_answer *a)
{
    struct work *const w = work;
    double point[3] = {xs[0], xs[1], xs[2]}, *parameters = NULL;
    SISLIntcurve **curves = NULL;
    int points = 0, lines = 0, status = 0, found = LIBRARY_NONE;
    s1954(w->surface, point, 3, COMPUTED, GEOMETRY, &points, &parameters, &lines, &curves, &status);
    if (status >= 0 && points > 0)
        found = answer(parameters, a);
    else if (status >= 0 && lines > 0 && curves[0]->epar1)
        found = answer(curves[0]->epar1, a);
    free(parameters);
    if (lines > 0)
        freeIntcrvlist(curves, lines);
    return found;
}

static int one_closest(void *work, const double xs[3], struct library_answer *a)
{
    struct work *const w = work;
    double point[3] = {xs[0], xs[1], xs[2]}, parameters[2], distance;
    int status = 0;
    s1958(w->surface, point, 3, COMPUTED, GEOMETRY, parameters, &distance, &status);
    return status >= 0 ? answer(parameters, a) : LIBRARY_NONE;
}

static int iterate(void *work, const double xs[3], struct library_answer *a)
{
    struct work *const w = work;
    double start[2] = {0, 0}, end[2] = {1, 1}, guess[2] = {0.5, 0.5}, parameters[2], point[3] = {xs[0], xs[1], xs[2]};
    int status = 0;
    s1775(w->surface, point, 3, GEOMETRY, start, end, guess, parameters, &status);
    return status >= 0 ? answer(parameters, a) : LIBRARY_NONE;
}

static void close_surface(void *work)
{
    struct work *const w = work;
    if (w->surface)
        freeSurf(w->surface);
    free(w);
}

enum { QUADS = 1 << LIBRARY_QUAD4 | 1 << LIBRARY_QUAD8 | 1 << LIBRARY_QUAD9 };

#define ROW(name, find, note)                                                                                          \
    {                                                                                                                  \
        name, QUADS, LIBRARY_CLOSEST, note, open_surface, set, find, close_surface                                     \
    }
static const struct library_search searches[] = {
    ROW("s1954", all_closest, "closest points of a Bezier surface"),
    ROW("s1958", one_closest, "one closest point; in clear cut cases"),
    ROW("s1775", iterate, "Newton from the middle; within the surface"),
};

const struct library *library_open(void)
{
    static const struct library self = {"SISL", LIBRARY_VERSION, sizeof searches / sizeof *searches, searches, 0, NULL};
    return &self;
}
