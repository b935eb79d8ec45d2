/* Judges hard cases in float; see hard_float.h.  Coordinates are rounded before the truth is computed, so that their rounding explains
 * no error: a minimum of the distance is within NAME_PROMISE, wherever the segment lies. */
#include "hard_float.h"

#include "../../generated/footpoint_quad4_float.h"
#include "hard.h"
#include "verdict.h"

#include <math.h>
#include <stdio.h>

/* Error of the gap at (xi,eta), over the sum of edge and distance and the sine between the tangents. */
#define GAP_ERROR 2e-6

typedef int search(const float *xA, const float *xB, const float *xC, const float *xD, const float *xS, float loc[2],
                   float *gap);

#define FUNCTION(name, NAME)                                                                                           \
    {                                                                                                                  \
        footpoint_quad4_float_##name, (double)FOOTPOINT_QUAD4_FLOAT_##NAME##_PROMISE                                   \
    }
static const struct function {
    search *find;
    double promise;
} functions[] = {FUNCTION(accurate, ACCURATE), FUNCTION(precise, PRECISE), FUNCTION(fine, FINE),
                 FUNCTION(balanced, BALANCED), FUNCTION(medium, MEDIUM),   FUNCTION(gauss2, GAUSS2),
                 FUNCTION(coarse, COARSE),     FUNCTION(fast, FAST)};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

enum row { ACCURATE, ALL, ROWS };
static const char *const row_name[ROWS] = {"float", "float_all"};

struct tally {
    long asked, answered, refused;
    long wrong, wrong_status; /* answers beyond the promise; results not finite, false statuses */
    double worst;
};

struct single {
    float x[5][3];
    int finite;
};

static void set_single(const struct hard_case *h, struct single *s)
{
    s->finite = 1;
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            s->x[i][k] = (float)h->x[i][k];
            s->finite = s->finite && isfinite(s->x[i][k]);
        }
}

/* Returns 1 if the gap is right along the normal at loc, whose direction depends on rounding if tangents are nearly parallel. */
static int gap_is_right(const struct truth_surface *f, const double loc[2], double gap)
{
    const wide z[2] = {loc[0], loc[1]};
    wide d[3], u[3], v[3], uu = 0, vv = 0, nn = 0, dn = 0;
    truth_offset(f, z, d);
    for (int k = 0; k < 3; k++) {
        u[k] = f->c1[k] + z[1] * f->c3[k];
        v[k] = f->c2[k] + z[0] * f->c3[k];
        uu += u[k] * u[k];
        vv += v[k] * v[k];
    }
    for (int k = 0; k < 3; k++) {
        const wide n = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
        nn += n * n;
        dn += n * d[k];
    }
    const double sine = sqrt((double)(nn / (uu * vv))), right = (double)dn / sqrt((double)nn) * f->scale;
    return fabs(gap - right) <= GAP_ERROR / sine * (1 + f->distance) * f->scale;
}

static void judge(const struct function *f, const struct single *s, const struct truth *t, struct tally *a)
{
    float found[2] = {7, 7}, gap = 7;
    const int status = f->find(s->x[0], s->x[1], s->x[2], s->x[3], s->x[4], found, &gap);
    const int written = found[0] != 7 || found[1] != 7 || gap != 7;
    a->asked++;
    a->answered += status == FOOTPOINT_OK;
    a->refused += status != FOOTPOINT_OK;
    if (status != FOOTPOINT_OK || !s->finite) {
        a->wrong_status +=
            written != (status == FOOTPOINT_UNPROVED) || (!s->finite && status != FOOTPOINT_ERR_NOT_FINITE);
        return;
    }
    if (!isfinite(found[0]) || !isfinite(found[1]) || !isfinite(gap) || t->count == 0) {
        a->wrong_status++;
        return;
    }
    const double loc[2] = {(double)found[0], (double)found[1]}, error = verdict_minimum(t, loc);
    a->worst = fmax(a->worst, error);
    a->wrong += !(error <= f->promise) || !gap_is_right(&t->surface, loc, (double)gap);
}

static void print_case(const char *family, long i, int function, const struct single *s)
{
    printf("# %s %ld float function %d\n", family, i, function);
    for (int k = 0; k < 5; k++)
        printf("#   {%a, %a, %a}\n", (double)s->x[k][0], (double)s->x[k][1], (double)s->x[k][2]);
}

int hard_float_family(int family, long n, uint64_t seed)
{
    const char *const name = hard_families[family].name;
    if (!hard_families[family].draw_float)
        return 1;
    struct tally tally[ROWS] = {{0}};
    long wrong = 0;
    for (long i = 0; i < n; i++) {
        struct hard_case h;
        struct single s;
        static struct truth t;
        hard_draw_float(family, seed, (uint64_t)i, &h);
        set_single(&h, &s);
        t.count = 0;
        if (s.finite)
            truth_find(&h, TRUTH_ALL, &t);
        judge(&functions[0], &s, &t, &tally[ACCURATE]);
        for (int f = 0; f < FUNCTIONS; f++) {
            struct tally *const all = &tally[ALL];
            const long before = all->wrong + all->wrong_status;
            judge(&functions[f], &s, &t, all);
            if (all->wrong + all->wrong_status > before && before < 3)
                print_case(name, i, f, &s);
        }
    }
    for (int row = 0; row < ROWS; row++) {
        const struct tally *const a = &tally[row];
        printf("%s,%s,%ld,%ld,0,0,0,%ld,%.1e,%ld,%ld\n", name, row_name[row], a->asked, a->answered, a->refused,
               a->worst, a->wrong, a->wrong_status);
        wrong += a->wrong + a->wrong_status;
    }
    return wrong == 0;
}
