/* The hard cases: hard_main [N [SEED [FAMILY]]] prints, as CSV, what each method makes of N cases of each family,
 * against truth.c, methods in float (hard_float.c) of cases of their own; hard_main --certify N [SEED] puts N
 * certificates to the test.  Exits 1 if the library was wrong, or a checked function in float. */
#include "../../generated/footpoint_quad4.h"
#include "../../runtime/footpoint.h"
#include "../trust_region.h"
#include "hard.h"
#include "hard_float.h"
#include "verdict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of the generated expression, in xi and eta: what its banner calls max. */
#define BANNER_WORST 2.219e-05
#define CLOSEST_ERROR 1e-10 /* of the longest edge */
#define CONVERGED_ERROR 1e-6
#define FARTHEST 1e11 /* longest edges up to which footpoint_robust has to have an answer */

typedef int search(const struct hard_case *h, double loc[2], double *dist);

static int expression(const struct hard_case *h, double loc[2], double *dist)
{
    return footpoint_quad4_accurate(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, dist);
}

static int locate(const struct hard_case *h, double loc[2], double *dist)
{
    return footpoint_locate(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, dist);
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

static int robust(const struct hard_case *h, double loc[2], double *dist)
{
    return footpoint_robust(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, dist);
}

/* free: looks for a foot point, inside the segment or not; else for the closest point of the segment. */
static const struct method {
    const char *name;
    search *find;
    double error; /* that its answers may have */
    int free, ours;
} methods[] = {{"expression", expression, BANNER_WORST, 1, 0},
               {"locate", locate, BANNER_WORST, 1, 1},
               {"newton", newton, CONVERGED_ERROR, 1, 0},
               {"trust_region", trust, CONVERGED_ERROR, 0, 0},
               {"robust", robust, CLOSEST_ERROR, 0, 1}};
enum { METHODS = sizeof methods / sizeof *methods };

struct tally {
    long answered, outside, not_unique, refused; /* by status */
    long wrong, wrong_status;                    /* answers too far off; statuses that are not true */
    double worst;
};

/* Distance in space from the closest point, of several the nearest. */
static double closest_error(const struct truth *t, const double loc[2], double *higher)
{
    const wide z[2] = {loc[0], loc[1]};
    double least = INFINITY;
    *higher = verdict_root(truth_square(&t->surface, z)) - verdict_root(t->point[0].square);
    for (int k = 0;
         k < t->count && verdict_root(t->point[k].square) <= verdict_root(t->point[0].square) + verdict_tie(t); k++)
        least = fmin(least, verdict_between(&t->surface, z, t->point[k].z));
    return least;
}

/* Several closest points, or one whose place rounding decides. */
static int is_ambiguous(const struct truth *t)
{
    for (int k = 1; k < t->count; k++)
        if (verdict_root(t->point[k].square) <= verdict_root(t->point[0].square) + 4 * verdict_tie(t) &&
            (verdict_between(&t->surface, t->point[0].z, t->point[k].z) > 1e-11 || t->count == TRUTH_MOST))
            return 1;
    return t->point[0].least < 1e-5 * (1 + t->surface.distance);
}

static int has_area(const struct hard_case *h)
{
    wide most = 0, area = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            wide a[3], b[3];
            for (int k = 0; k < 3; k++) {
                a[k] = (wide)h->x[(i + 1) % 4][k] - h->x[i][k];
                b[k] = (wide)h->x[(j + 1) % 4][k] - h->x[j][k];
            }
            for (int k = 0; k < 3; k++) {
                const wide n = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
                area = n * n > area ? n * n : area;
                most = a[k] * a[k] > most ? a[k] * a[k] : most;
            }
        }
    return area > (wide)1e-28 * most * most;
}

static void judge_closest(const struct method *m, const struct hard_case *h, const struct truth *t, int status,
                          const double loc[2], double dist, struct tally *tally)
{
    double higher, error = closest_error(t, loc, &higher);
    const double true_dist = verdict_root(t->point[0].square) * t->surface.scale;
    if (m->ours && !(fabs(fabs(dist) - true_dist) <= CLOSEST_ERROR * (t->surface.scale + true_dist)))
        tally->wrong++;
    if (status == FOOTPOINT_NOT_UNIQUE || status == FOOTPOINT_ERR_DEGENERATE) {
        if (!(higher <= CLOSEST_ERROR * (1 + t->surface.distance)))
            tally->wrong++;
        if (status == FOOTPOINT_NOT_UNIQUE ? !is_ambiguous(t) : has_area(h))
            tally->wrong_status++;
        return;
    }
    tally->worst = fmax(tally->worst, error);
    if (!(error <= m->error))
        tally->wrong++;
    const double side = fmax(fabs((double)t->point[0].z[0]), fabs((double)t->point[0].z[1]));
    if (m->ours && (status == FOOTPOINT_OK ? fmax(fabs(loc[0]), fabs(loc[1])) > 1 : side < 1 - 1e-3))
        tally->wrong_status++;
}

/* The lowest point that anyone found is the truth. */
static void add_truth(struct truth *t, const double loc[2])
{
    struct truth_point p;
    truth_descend(&t->surface, loc, &p);
    if (t->count == 0 || p.square < t->point[0].square) {
        if (t->count < TRUTH_MOST)
            t->count++;
        memmove(t->point + 1, t->point, (size_t)(t->count - 1) * sizeof *t->point);
        t->point[0] = p;
    }
}

static void judge(const struct method *m, const struct hard_case *h, struct truth *t, int finite, struct tally *tally)
{
    double loc[2] = {7, 7}, dist = 7;
    const int status = m->find(h, loc, &dist);
    const int written = loc[0] != 7 || loc[1] != 7 || dist != 7;
    tally->answered += status == FOOTPOINT_OK;
    tally->outside += status == FOOTPOINT_OUTSIDE;
    tally->not_unique += status == FOOTPOINT_NOT_UNIQUE;
    tally->refused += status != FOOTPOINT_OK && status != FOOTPOINT_OUTSIDE && status != FOOTPOINT_NOT_UNIQUE;
    if (!finite) {
        tally->wrong_status += m->ours && (status != FOOTPOINT_ERR_NOT_FINITE || written);
        return;
    }
    if (status == FOOTPOINT_ERR_DOMAIN && !m->free)
        tally->wrong_status += t->surface.distance < FARTHEST;
    if (status == FOOTPOINT_ERR_NOT_FINITE)
        tally->wrong_status += m->ours && !m->free;
    if (status == FOOTPOINT_ERR_DOMAIN || status == FOOTPOINT_ERR_NOT_FINITE ||
        status == FOOTPOINT_ERR_NO_CONVERGENCE || (m->free && status != FOOTPOINT_OK))
        return;
    if (!isfinite(loc[0]) || !isfinite(loc[1]) || !isfinite(dist)) {
        tally->wrong++;
        return;
    }
    if (t->count == 0)
        return;
    if (m->free) {
        const double error = verdict_free(t, loc, BANNER_WORST);
        tally->worst = fmax(tally->worst, error);
        tally->wrong += !(error <= m->error);
        return;
    }
    add_truth(t, loc);
    judge_closest(m, h, t, status, loc, dist, tally);
}

static double sum_of(const wide g[2])
{
    return fabs((double)g[0]) + fabs((double)g[1]);
}

/* footpoint_stationary: finds every local minimum inside that is well defined, and nothing but stationary points. */
static void judge_stationary(const struct hard_case *h, const struct truth *t, struct tally *tally)
{
    double loc[FOOTPOINT_STATIONARY_MOST][2];
    int count = 0;
    const int status = footpoint_stationary(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, &count);
    tally->answered += status == FOOTPOINT_OK;
    tally->not_unique += status == FOOTPOINT_NOT_UNIQUE;
    tally->refused += status != FOOTPOINT_OK && status != FOOTPOINT_NOT_UNIQUE;
    if (status != FOOTPOINT_OK)
        return;
    for (int k = 0; k < t->count; k++) {
        const struct truth_point *const p = &t->point[k];
        double least = INFINITY;
        wide g[2];
        truth_gradient(&t->surface, p->z, g);
        if (p->on_edge || p->least < 1e-4 * (1 + t->surface.distance) || !(sum_of(g) < 1e-15))
            continue;
        for (int i = 0; i < count; i++)
            least = fmin(least, fmax(fabs((double)p->z[0] - loc[i][0]), fabs((double)p->z[1] - loc[i][1])));
        tally->worst = fmax(tally->worst, least);
        tally->wrong += !(least < CONVERGED_ERROR);
    }
    for (int i = 0; i < count; i++) {
        wide g[2];
        const wide z[2] = {loc[i][0], loc[i][1]};
        truth_gradient(&t->surface, z, g);
        tally->wrong_status += !(sum_of(g) < 1e-10 * (1 + t->surface.distance));
    }
}

static void print_case(const struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        printf("#   {%a, %a, %a}\n", h->x[i][0], h->x[i][1], h->x[i][2]);
}

static const char *name_of(int m)
{
    return m < METHODS ? methods[m].name : "stationary";
}

static int is_ours(int m)
{
    return m == METHODS || methods[m].ours;
}

static int run_family(int family, long n, uint64_t seed, int show)
{
    struct tally tally[METHODS + 1];
    const struct hard_family *const f = &hard_families[family];
    long wrong = 0;
    memset(tally, 0, sizeof tally);
    for (long i = 0; i < n; i++) {
        struct hard_case h;
        static struct truth t;
        hard_draw(family, seed, (uint64_t)i, &h);
        t.count = 0;
        if (f->finite)
            truth_find(&h, &t);
        for (int m = METHODS; m >= 0; m--) {
            const long before = tally[m].wrong + tally[m].wrong_status;
            if (m == METHODS)
                judge_stationary(&h, &t, &tally[m]);
            else
                judge(&methods[m], &h, &t, f->finite, &tally[m]);
            if (show && is_ours(m) && tally[m].wrong + tally[m].wrong_status > before && before < 3) {
                printf("# %s %ld %s\n", f->name, i, name_of(m));
                print_case(&h);
            }
        }
    }
    for (int m = 0; m <= METHODS; m++) {
        const struct tally *const a = &tally[m];
        printf("%s,%s,%ld,%ld,%ld,%ld,%ld,%.1e,%ld,%ld\n", f->name, name_of(m), n, a->answered, a->outside,
               a->not_unique, a->refused, a->worst, a->wrong, a->wrong_status);
        wrong += is_ours(m) ? a->wrong + a->wrong_status : 0;
    }
    return wrong == 0;
}

/* ---- certificates ---- */

struct certificates {
    long asked, proved, wrong;
    double tightest; /* of |answer - truth| / rho, the largest */
};

static uint64_t scramble(uint64_t z)
{
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    return (z ^ z >> 27) * 0x94d049bb133111ebu;
}

/* One stationary point within rho of loc; for some cases, reached from the corners of that, too. */
static int is_true(const struct truth_surface *f, const double loc[2], const double rho[2], int corners,
                   double *tightest)
{
    wide z[2], y[2];
    if (!truth_stationary(f, loc, z))
        return 0;
    const double off = fmax(fabs((double)(z[0] - loc[0])) / rho[0], fabs((double)(z[1] - loc[1])) / rho[1]);
    *tightest = fmax(*tightest, off);
    for (int k = 0; k < corners; k++) {
        const double from[2] = {loc[0] + (k & 1 ? rho[0] : -rho[0]), loc[1] + (k & 2 ? rho[1] : -rho[1])};
        if (!truth_stationary(f, from, y))
            continue;
        const int same = fabs((double)(y[0] - z[0])) < 1e-15 && fabs((double)(y[1] - z[1])) < 1e-15;
        const int within = fabs((double)(y[0] - loc[0])) < rho[0] && fabs((double)(y[1] - loc[1])) < rho[1];
        if (within && !same)
            return 0;
    }
    return off <= 1;
}

static void certify_case(const struct hard_case *h, uint64_t key, struct certificates *c)
{
    struct truth_surface f;
    double loc[2] = {0, 0}, dist, rho[2];
    if (footpoint_locate(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, &dist) != FOOTPOINT_OK &&
        footpoint_robust(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, &dist) == FOOTPOINT_ERR_DOMAIN)
        return;
    const double off = key & 1 ? 0 : pow(10, -16 * ((double)(scramble(key) >> 11) * 0x1p-53));
    loc[0] += off * ((double)(scramble(key + 1) >> 11) * 0x1p-52 - 1);
    loc[1] += off * ((double)(scramble(key + 2) >> 11) * 0x1p-52 - 1);
    c->asked++;
    if (footpoint_certify(h->x[0], h->x[1], h->x[2], h->x[3], h->x[4], loc, rho) != FOOTPOINT_OK)
        return;
    c->proved++;
    if (!truth_surface_of(h, &f) || !is_true(&f, loc, rho, key % 8 ? 0 : 4, &c->tightest)) {
        if (c->wrong++ < 3) {
            printf("# wrong: loc %a %a rho %a %a\n", loc[0], loc[1], rho[0], rho[1]);
            print_case(h);
        }
    }
}

static int certify(long n, uint64_t seed)
{
    long wrong = 0, asked = 0, proved = 0;
    printf("family,asked,proved,wrong,tightest\n");
    for (int family = 0; family < hard_family_count; family++) {
        struct certificates c = {0, 0, 0, 0};
        if (!hard_families[family].finite)
            continue;
        for (long i = 0; i < n / (hard_family_count - 1); i++) {
            struct hard_case h;
            hard_draw(family, seed, (uint64_t)i, &h);
            certify_case(&h, scramble(seed + (uint64_t)family) + 7 * (uint64_t)i, &c);
        }
        printf("%s,%ld,%ld,%ld,%.3f\n", hard_families[family].name, c.asked, c.proved, c.wrong, c.tightest);
        asked += c.asked;
        proved += c.proved;
        wrong += c.wrong;
    }
    printf("all,%ld,%ld,%ld,\n", asked, proved, wrong);
    return wrong == 0;
}

int main(int argc, char **argv)
{
    if (argc > 2 && strcmp(argv[1], "--certify") == 0)
        return !certify(atol(argv[2]), argc > 3 ? strtoull(argv[3], NULL, 10) : 1);
    const long n = argc > 1 ? atol(argv[1]) : 1000;
    const uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1;
    int good = 1;
    printf("family,method,n,ok,outside,not_unique,refused,worst,wrong,wrong_status\n");
    for (int family = 0; family < hard_family_count; family++)
        if (argc <= 3 || strcmp(argv[3], hard_families[family].name) == 0)
            good = run_family(family, n, seed, 1) & hard_float_family(family, n, seed) & good;
    return !good;
}
