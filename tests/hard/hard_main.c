/* Judges the hard cases: hard_main [N [SEED [FAMILY]]] prints, as CSV, the answers of each method to N cases of each family, against
 * truth.c, methods in float (hard_float.c) on cases of their own; hard_main --certain N [SEED [FIRST [FAMILY]]]
 * judges the certain functions (certain.c).  Exits 1 if the library was wrong, or a checked function in float. */
#include "../../generated/footpoint_quad4.h"
#include "../../runtime/footpoint.h"
#include "../rivals/trust_region.h"
#include "certain.h"
#include "hard_float.h"
#include "judges.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CONVERGED_ERROR 1e-6

typedef int search(const struct hard_case *h, double loc[2], double *dist);

static int expression(const struct hard_case *h, double loc[2], double *dist)
{
    footpoint_quad4_accurate_at(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], &loc[0], &loc[1]);
    *dist = 0;
    return isfinite(loc[0]) && isfinite(loc[1]) ? FOOTPOINT_OK : FOOTPOINT_ERR_DEGENERATE;
}

static int header(const struct hard_case *h, double loc[2], double *dist)
{
    return footpoint_quad4_accurate(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, dist);
}

static int newton(const struct hard_case *h, double loc[2], double *dist)
{
    return footpoint_newton(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], 50, 1e-12, loc, dist, NULL);
}

static int trust(const struct hard_case *h, double loc[2], double *dist)
{
    const struct rival_box box = {{-1, -1}, {1, 1}};
    *dist = 0;
    return rival_trust_region(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], &box, 50, TRUST_REGION_TOLERANCE, &loc[0],
                              &loc[1])
               ? FOOTPOINT_OK
               : FOOTPOINT_ERR_NO_CONVERGENCE;
}

/* The aim of a method: a minimum of the distance to the whole surface; a foot point, which is the closest point of the
 * segment if that is inside; the closest point of the segment. */
enum aim { MINIMUM, FOOT_POINT, CLOSEST };

static const struct method {
    const char *name;
    search *find;
    double error; /* permitted error of its answers */
    enum aim aim;
} methods[] = {{"expression", expression, BANNER_WORST, FOOT_POINT},
               {"newton", newton, CONVERGED_ERROR, FOOT_POINT},
               {"trust_region", trust, CONVERGED_ERROR, CLOSEST},
               {"header", header, FOOTPOINT_QUAD4_ACCURATE_PROMISE, MINIMUM}};
enum { OTHERS = sizeof methods / sizeof *methods, RIVALS = OTHERS - 1, LOCATE = OTHERS, ROBUST, STATIONARY, METHODS };

/* Returns the distance in space from the closest point, or from the nearest of several. */
static double closest_error(const struct truth *t, const double loc[2])
{
    const wide z[2] = {loc[0], loc[1]};
    double least = INFINITY;
    for (int k = 0;
         k < t->count && verdict_root(t->point[k].square) <= verdict_root(t->point[0].square) + verdict_tie(t); k++)
        least = fmin(least, truth_between(&t->surface, z, t->point[k].z));
    return least;
}

static void judge_rival(const struct method *m, const struct hard_case *h, const struct truth *t, struct tally *a)
{
    double loc[2] = {7, 7}, dist = 7;
    const int status = m->find(h, loc, &dist);
    a->calls++;
    a->answered += status == FOOTPOINT_OK;
    a->unproved += status == FOOTPOINT_UNPROVED;
    a->refused += status < FOOTPOINT_OK;
    if (status != FOOTPOINT_OK || t->count == 0)
        return;
    const int finite = isfinite(loc[0]) && isfinite(loc[1]) && isfinite(dist);
    const double error = !finite             ? INFINITY
                         : m->aim == MINIMUM ? verdict_minimum(t, loc)
                         : m->aim == CLOSEST ? closest_error(t, loc)
                                             : verdict_free(t, loc, BANNER_WORST);
    a->worst = fmax(a->worst, error);
    a->wrong += !(error <= m->error);
    a->why = "no minimum that near";
}

static void print_case(const struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        printf("#   {%a, %a, %a}\n", h->x[i][0], h->x[i][1], h->x[i][2]);
}

static const char *name_of(int m)
{
    static const char *const ours[] = {"locate", "robust", "stationary"};
    return m < OTHERS ? methods[m].name : ours[m - OTHERS];
}

static void run_case(int family, const struct hard_case *h, struct tally tally[METHODS])
{
    static struct truth t;
    t.count = 0;
    if (hard_families[family].finite)
        truth_find(h, TRUTH_ALL, &t);
    for (int m = 0; m < OTHERS; m++)
        judge_rival(&methods[m], h, &t, &tally[m]);
    if (!hard_families[family].finite) {
        judge_not_finite(h, &tally[ROBUST], &tally[STATIONARY], &tally[LOCATE]);
        return;
    }
    judge_robust(h, &t, &tally[ROBUST]);
    judge_locate(h, &t, &tally[LOCATE]);
    judge_stationary(h, &t, &tally[STATIONARY]);
}

static int run_family(int family, long n, uint64_t seed)
{
    struct tally tally[METHODS];
    const struct hard_family *const f = &hard_families[family];
    long wrong = 0;
    memset(tally, 0, sizeof tally);
    for (long i = 0; i < n; i++) {
        struct hard_case h;
        long before[METHODS];
        hard_draw(family, seed, (uint64_t)i, &h);
        for (int m = 0; m < METHODS; m++)
            before[m] = tally[m].wrong + tally[m].wrong_status;
        run_case(family, &h, tally);
        for (int m = RIVALS; m < METHODS; m++)
            if (tally[m].wrong + tally[m].wrong_status > before[m] && before[m] < 3) {
                printf("# %s %ld %s: %s\n", f->name, i, name_of(m), tally[m].why);
                print_case(&h);
            }
    }
    for (int m = 0; m < METHODS; m++) {
        const struct tally *const a = &tally[m];
        printf("%s,%s,%ld,%ld,%ld,%ld,%ld,%ld,%.1e,%ld,%ld\n", f->name, name_of(m), n, a->answered, a->outside,
               a->not_unique, a->unproved, a->refused, a->worst, a->wrong, a->wrong_status);
        wrong += m < RIVALS ? 0 : a->wrong + a->wrong_status;
    }
    return wrong == 0;
}

int main(int argc, char **argv)
{
    if (argc > 2 && strcmp(argv[1], "--certain") == 0)
        return !certain_run(atol(argv[2]), argc > 3 ? strtoull(argv[3], NULL, 10) : 1, argc > 4 ? atol(argv[4]) : 0,
                            argc > 5 ? argv[5] : NULL);
    const long n = argc > 1 ? atol(argv[1]) : 1000;
    const uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    int good = 1;
    printf("family,method,n,ok,outside,not_unique,unproved,refused,worst,wrong,wrong_status\n");
    for (int family = 0; family < hard_family_count; family++)
        if (argc <= 3 || strcmp(argv[3], hard_families[family].name) == 0)
            good = run_family(family, n, seed) & hard_float_family(family, n, seed) & good;
    return !good;
}
