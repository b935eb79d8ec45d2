/* Answers the queries on standard input by footpoint's searches and their rivals: answer_queries METHOD; and by other
 * libraries, built as in tests/libraries/rivals.sh: answer_queries LIBRARY.so METHOD.  Without METHOD, lists all methods and
 * whether they search the foot point or the closest point.  A status without a promise becomes "none". */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri6.h"
#include "../../runtime/footpoint.h"
#include "../../runtime/footpoint_face.h"
#include "../libraries/library.h"
#include "../rivals/four_triangles.h"
#include "../rivals/rivals_faces.h"
#include "../rivals/trust_region.h"
#include "query_text.h"

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { TRI3, QUAD4, TRI6, QUAD8, QUAD9 };

static const enum footpoint_face face_of[] = {FOOTPOINT_TRI3, FOOTPOINT_QUAD4, FOOTPOINT_TRI6, FOOTPOINT_QUAD8,
                                              FOOTPOINT_QUAD9};

/* Returns 1 if the status promises loc and distance, 0 if not, -1 if there is no such kind. */
typedef int answer(const struct query_text *q, double loc[2], double *distance);

#define X(i) (q->x + 3 * (i))
#define THREE X(0), X(1), X(2), X(3)
#define FOUR X(0), X(1), X(2), X(3), X(4)
#define SIX X(0), X(1), X(2), X(3), X(4), X(5), X(6)
#define EIGHT SIX, X(7), X(8)
#define NINE EIGHT, X(9)

static int told(int status)
{
    return status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE || status == FOOTPOINT_NOT_UNIQUE;
}

#define FOOT(name, tri3, quad4, tri6, quad8, quad9)                                                                    \
    static int foot_##name(const struct query_text *q, double loc[2], double *distance)                                \
    {                                                                                                                  \
        switch (q->index) {                                                                                            \
        case TRI3:                                                                                                     \
            return told(footpoint_tri3_##tri3(THREE, loc, distance));                                                  \
        case QUAD4:                                                                                                    \
            return told(footpoint_quad4_##quad4(FOUR, loc, distance));                                                 \
        case TRI6:                                                                                                     \
            return told(footpoint_tri6_##tri6(SIX, loc, distance));                                                    \
        case QUAD8:                                                                                                    \
            return told(footpoint_quad8_##quad8(EIGHT, loc, distance));                                                \
        default:                                                                                                       \
            return told(footpoint_quad9_##quad9(NINE, loc, distance));                                                 \
        }                                                                                                              \
    }                                                                                                                  \
    static int closest_##name(const struct query_text *q, double loc[2], double *distance)                             \
    {                                                                                                                  \
        int region;                                                                                                    \
        switch (q->index) {                                                                                            \
        case TRI3:                                                                                                     \
            return told(footpoint_tri3_##tri3##_closest(THREE, loc, distance, &region));                               \
        case QUAD4:                                                                                                    \
            return told(footpoint_quad4_##quad4##_closest(FOUR, loc, distance, &region));                              \
        case TRI6:                                                                                                     \
            return told(footpoint_tri6_##tri6##_closest(SIX, loc, distance, &region));                                 \
        case QUAD8:                                                                                                    \
            return told(footpoint_quad8_##quad8##_closest(EIGHT, loc, distance, &region));                             \
        default:                                                                                                       \
            return told(footpoint_quad9_##quad9##_closest(NINE, loc, distance, &region));                              \
        }                                                                                                              \
    }
FOOT(coarse, exact, coarse, coarse, coarse, coarse)
FOOT(balanced, exact, balanced, balanced, balanced, balanced)
FOOT(accurate, exact, accurate, accurate, accurate, accurate)
FOOT(full, exact, full, accurate, full, full)

static int locate(const struct query_text *q, double loc[2], double *distance)
{
    return told(footpoint_face_locate(face_of[q->index], q->x, loc, distance));
}

static int robust(const struct query_text *q, double loc[2], double *distance)
{
    int region;
    const int status = footpoint_face_robust(face_of[q->index], q->x, loc, distance, &region);
    return told(status) || status == FOOTPOINT_NO_AREA;
}

static void vectors(const struct query_text *q, double x[10][3])
{
    memcpy(x, q->x, (size_t)(3 * (q->nodes + 1)) * sizeof(double));
}

static int newton(const struct query_text *q, double loc[2], double *distance)
{
    double copy[10][3];
    const double(*const x)[3] = (const double(*)[3])copy;
    vectors(q, copy);
    *distance = NAN;
    switch (q->index) {
    case TRI3:
        return -1;
    case QUAD4:
        return rival_newton(FOUR, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]) > 0;
    case TRI6:
        return rival_tri6_newton(x, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]) > 0;
    case QUAD8:
        return rival_quad8_newton(x, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]) > 0;
    default:
        return rival_quad9_newton(x, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]) > 0;
    }
}

static int newton_fair(const struct query_text *q, double loc[2], double *distance)
{
    *distance = NAN;
    return q->index == QUAD4 ? rival_newton_fair(FOUR, RIVAL_FAIR_STEPS_MAX, RIVAL_FAIR_TOLERANCE, &loc[0], &loc[1]) > 0
                             : -1;
}

/* Clamps Newton's answer, which contact codes often take for the closest point. */
static int newton_clamped(const struct query_text *q, double loc[2], double *distance)
{
    const int found = newton(q, loc, distance);
    for (int k = 0; k < 2 && found > 0; k++)
        loc[k] = fmax(q->corners == 3 ? 0 : -1, fmin(1, loc[k]));
    const double over = q->corners == 3 && found > 0 ? fmax(0, loc[0] + loc[1] - 1) : 0;
    loc[0] -= over / 2;
    loc[1] -= over / 2;
    return found;
}

static int four_triangles(const struct query_text *q, double loc[2], double *distance)
{
    const double *const corner[4] = {X(0), X(1), X(2), X(3)};
    double r[3];
    *distance = NAN;
    return q->index == QUAD4 ? (rival_four_triangles(corner, X(4), loc, r), 1) : -1;
}

static const struct method {
    const char *name;
    answer *find;
    int is_closest;
} methods[] = {{"coarse", foot_coarse, 0},
               {"balanced", foot_balanced, 0},
               {"accurate", foot_accurate, 0},
               {"full", foot_full, 0},
               {"footpoint_face_locate", locate, 0},
               {"newton", newton, 0},
               {"newton_fair", newton_fair, 0},
               {"coarse_closest", closest_coarse, 1},
               {"balanced_closest", closest_balanced, 1},
               {"accurate_closest", closest_accurate, 1},
               {"full_closest", closest_full, 1},
               {"footpoint_face_robust", robust, 1},
               {"newton_clamped", newton_clamped, 1},
               {"four_triangles", four_triangles, 1}};
enum { METHODS = sizeof methods / sizeof *methods };

static void list(const char *name, int is_closest)
{
    printf("%s %s\n", name, is_closest ? "closest" : "inside");
}

static void print_answer(int found, const double loc[2], double distance)
{
    if (found < 0)
        puts("skip");
    else if (!found)
        puts("none");
    else if (isnan(distance))
        printf("%.17g %.17g\n", loc[0], loc[1]);
    else
        printf("%.17g %.17g %.17g\n", loc[0], loc[1], distance);
}

static int answer_all(const char *name)
{
    struct query_text q;
    int m = 0, got;
    while (m < METHODS && name && strcmp(methods[m].name, name) != 0)
        m++;
    if (m == METHODS)
        return 2;
    while ((got = query_read(stdin, &q)) == 1) {
        double loc[2] = {0, 0}, distance = 0;
        const int found = methods[m].find(&q, loc, &distance);
        print_answer(found, loc, distance);
    }
    return got < 0;
}

/* ---- other libraries ---- */

static void print_of_library(const struct library_search *search, const struct query_text *q)
{
    static const int kind_of[] = {-1, LIBRARY_QUAD4, LIBRARY_TRI6, LIBRARY_QUAD8, LIBRARY_QUAD9};
    const int kind = kind_of[q->index];
    struct library_answer a = {{0, 0}, {0, 0, 0}, 0};
    if (kind < 0 || !(search->kinds >> kind & 1)) {
        puts("skip");
        return;
    }
    void *const work = search->open(kind);
    search->set(work, q->x);
    const int found = search->find(work, X(q->nodes), &a) == LIBRARY_ANSWER;
    if (found && a.is_point)
        printf("point %.17g %.17g %.17g\n", a.point[0], a.point[1], a.point[2]);
    else
        print_answer(found, a.loc, NAN);
    search->close(work);
}

static int answer_of_library(const char *file, const char *name)
{
    void *const handle = dlopen(file, RTLD_NOW);
    const struct library *(*open)(void) = NULL;
    if (handle)
        *(void **)&open = dlsym(handle, "library_open");
    if (!open)
        return fprintf(stderr, "%s: error: no library: %s\n", file, dlerror()), 3;
    const struct library *const library = open();
    struct query_text q;
    for (int s = 0; s < library->searches; s++) {
        const struct library_search *const search = &library->search[s];
        if (!name && search->question != LIBRARY_POINT)
            list(search->name, search->question == LIBRARY_CLOSEST);
        if (!name || strcmp(name, search->name) != 0)
            continue;
        while (query_read(stdin, &q) == 1)
            print_of_library(search, &q);
        return 0;
    }
    return name != NULL;
}

int main(int argc, char **argv)
{
    if (argc > 1 && strchr(argv[1], '/'))
        return answer_of_library(argv[1], argc > 2 ? argv[2] : NULL);
    for (int m = 0; argc < 2 && m < METHODS; m++)
        list(methods[m].name, methods[m].is_closest);
    return argc > 1 ? answer_all(argv[1]) : 0;
}
