/* Checks functions of faces of six, eight and nine nodes in float. If NAME returns FOOTPOINT_OK, in a call or over
 * arrays, a minimum of the distance must lie within NAME_PROMISE of xi and eta, whatever the face. The judge takes
 * Newton's steps in quadruple precision from the same floats. FOOTPOINT_LONG draws 1e5 faces of each family and prints
 * the shares that are proved. Points of lines are checked likewise. */
#define FOOTPOINT_PART static inline /* three kinds are compiled sooner */
#define FOOTPOINT_LOOP static inline
#include "../support/long_cases.h"
#include "footpoint_quad8_float.h"
#include "footpoint_quad9_float.h"
#include "footpoint_tri6_float.h"

#include "../generated/judged_faces.h"
#include "../hard/draw.h"
#include "single_cases.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { CASES = 150, CASES_LONG = 100000, BLOCK = 180, ROWS = 3 * (CURVED_NODES + 1) };

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

/* ---- functions ---- */

#define FIRST_6 x[0], x[1], x[2], x[3], x[4], x[5], x[6]
#define FIRST_8 FIRST_6, x[7], x[8]
#define FIRST_9 FIRST_8, x[9]
#define DEFINE(kind, name, nodes)                                                                                      \
    static int kind##_##name(const float *const *x, float loc[2], float *gap)                                          \
    {                                                                                                                  \
        return footpoint_##kind##_float_##name(FIRST_##nodes, loc, gap);                                               \
    }
#define EACH(kind, KIND, nodes)                                                                                        \
    DO(kind, KIND, fast, FAST, nodes)                                                                                  \
    DO(kind, KIND, balanced, BALANCED, nodes) DO(kind, KIND, fine, FINE, nodes)
#define ALL EACH(tri6, TRI6, 6) EACH(quad8, QUAD8, 8) EACH(quad9, QUAD9, 9)

#define DO(kind, KIND, name, NAME, nodes) DEFINE(kind, name, nodes)
ALL
#undef DO

    static const struct function {
    const char *kind, *name;
    double promise;
    int (*one)(const float *const *x, float loc[2], float *gap);
    void (*many)(size_t n, const float *const *x, float *xi, float *eta, float *gap, int *status);
} functions[] = {
#define DO(kind, KIND, name, NAME, nodes)                                                                              \
    {#kind, #name, (double)FOOTPOINT_##KIND##_FLOAT_##NAME##_PROMISE, kind##_##name,                                   \
     footpoint_##kind##_float_##name##_checked_n},
    ALL
#undef DO
};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* ---- tests ---- */

static void fail_on(const struct curved_case *f, const struct function *function, const char *family,
                    const float loc[2])
{
    for (int k = 0; k <= f->kind->nodes; k++)
        print_error("{%a, %a, %a},\n", f->x[k][0], f->x[k][1], f->x[k][2]);
    fail_msg("%s_%s, %s: OK at (%.9g, %.9g)", f->kind->name, function->name, family, (double)loc[0], (double)loc[1]);
}

static bool holds(const struct curved_case *f, const struct function *function, const float found[2])
{
    const struct curved_case scaled = judged_unit(f);
    const double loc[2] = {found[0], found[1]};
    wide known[2];
    bool is_known = false;
    return judged_holds(&scaled, loc, function->promise, known, &is_known);
}

static void round_rows(const struct curved_case *f, float x[CURVED_NODES + 1][3], const float *row[CURVED_NODES + 1])
{
    for (int k = 0; k <= f->kind->nodes; k++) {
        row[k] = x[k];
        for (int i = 0; i < 3; i++)
            x[k][i] = single_round(f->x[k][i]);
    }
}

static void judge(const struct curved_case *f, const char *family, long proved[FUNCTIONS])
{
    float x[CURVED_NODES + 1][3];
    const float *row[CURVED_NODES + 1];
    round_rows(f, x, row);
    for (int i = 0; i < FUNCTIONS; i++) {
        float loc[2] = {7, 7}, gap = 7;
        if (strcmp(functions[i].kind, f->kind->name) != 0)
            continue;
        const int status = functions[i].one(row, loc, &gap);
        assert_true(status >= FOOTPOINT_OK ? isfinite(loc[0] + loc[1]) && isfinite(gap) : loc[0] == 7 && gap == 7);
        if (status == FOOTPOINT_OK && ++proved[i] && !holds(f, &functions[i], loc))
            fail_on(f, &functions[i], family, loc);
    }
}

/* Sets the percentage of ordinary faces that must be proved for the coarsest and for the finest promise. */
enum { LEAST_FAST = 99, LEAST_FINE = 80 };

static void answers_keep_the_promise(void **state)
{
    (void)state;
    for (int family = 0; family < SINGLE_FAMILIES; family++) {
        uint64_t stream = 650 + (uint64_t)family;
        long proved[FUNCTIONS] = {0};
        for (int k = 0; k < CURVED_KINDS; k++)
            for (long n = 0; n < cases(); n++) {
                struct curved_case f = {.kind = &curved_kinds[k]};
                single_draw(&stream, (enum single_family)family, &f);
                judge(&f, single_families[family], proved);
            }
        for (int i = 0; i < FUNCTIONS; i++) {
            if (getenv("FOOTPOINT_LONG"))
                print_message("%s_%s, %s: %.2f %% proved\n", functions[i].kind, functions[i].name,
                              single_families[family], 100. * (double)proved[i] / (double)cases());
            if (family == ORDINARY)
                assert_true(100 * proved[i] >= cases() * (functions[i].promise > 0.01 ? LEAST_FAST : LEAST_FINE));
        }
    }
}

/* Checks that arrays return the answers of calls, except for rounding if compilers fuse operations. */
static void arrays_match_calls(void **state)
{
    static float column[ROWS][BLOCK], xi[BLOCK], eta[BLOCK], gap[BLOCK];
    static struct curved_case face[BLOCK];
    static int status[BLOCK];
    const float *c[ROWS];
    (void)state;
    for (const struct function *f = functions; f < functions + FUNCTIONS; f++) {
        uint64_t stream = 660;
        int k = 0;
        while (strcmp(curved_kinds[k].name, f->kind) != 0)
            k++;
        for (int i = 0; i < BLOCK; i++) {
            face[i].kind = &curved_kinds[k];
            single_draw(&stream, (enum single_family)(i % SINGLE_FAMILIES), &face[i]);
            for (int row = 0; row < 3 * (curved_kinds[k].nodes + 1); row++)
                column[row][i] = single_round(face[i].x[row / 3][row % 3]);
        }
        for (int row = 0; row < ROWS; row++)
            c[row] = column[row];
        f->many(BLOCK, c, xi, eta, gap, status);
        for (int i = 0; i < BLOCK; i++) {
            const float found[2] = {xi[i], eta[i]};
            float x[CURVED_NODES + 1][3], loc[2] = {0, 0}, g = 0;
            const float *row[CURVED_NODES + 1];
            round_rows(&face[i], x, row);
            if (status[i] == FOOTPOINT_OK && !holds(&face[i], f, found))
                fail_on(&face[i], f, "arrays", found);
#ifndef __FMA__
            assert_int_equal(status[i], f->one(row, loc, &g));
            if (status[i] >= FOOTPOINT_OK)
                assert_true(loc[0] == xi[i] && loc[1] == eta[i] && g == gap[i]);
#else
            (void)loc, (void)g;
#endif
        }
    }
}

/* ---- lines ---- */

#define LINE(kind, nodes)                                                                                              \
    static int kind##_line(const float *const *x, const float *along, float loc[2], float *dist)                       \
    {                                                                                                                  \
        return footpoint_##kind##_float_along(FIRST_##nodes, along, loc, dist);                                        \
    }
LINE(tri6, 6)
LINE(quad8, 8)
LINE(quad9, 9)

/* Computes d = xS - r and its derivatives by xi and eta at z. */
static void differences(const struct curved_powers *p, const wide z[2], wide d[3], wide u[3], wide v[3])
{
    for (int k = 0; k < 3; k++) {
        d[k] = u[k] = v[k] = 0;
        for (int i = 2; i >= 0; i--) {
            wide c = 0, by_eta = 0;
            for (int j = 2; j >= 0; j--) {
                by_eta = by_eta * z[1] + c;
                c = c * z[1] + p->d[k][i][j];
            }
            u[k] = u[k] * z[0] + d[k];
            d[k] = d[k] * z[0] + c;
            v[k] = v[k] * z[0] + by_eta;
        }
    }
}

static wide volume(const wide a[3], const wide b[3], const wide c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Returns true if Newton's steps in quadruple precision for d = t q lead from loc to a point that is near enough. */
static bool is_met(const struct curved_case *f, const float along[3], const float loc[2])
{
    const wide q[3] = {along[0], along[1], along[2]};
    wide z[2] = {loc[0], loc[1]}, d[3], u[3], v[3], moved = 1;
    struct curved_powers p;
    curved_powers(f, &p);
    for (int step = 0; step < 60 && size_of(moved) > 1e-30; step++) {
        differences(&p, z, d, u, v);
        const wide det = volume(u, v, q), s = volume(d, v, q) / det, t = volume(u, d, q) / det;
        z[0] -= s;
        z[1] -= t;
        moved = size_of(s) + size_of(t);
    }
    return size_of(moved) <= 1e-20 && size_of(z[0] - (wide)loc[0]) <= (double)FOOTPOINT_ALONG_PROMISE_F &&
           size_of(z[1] - (wide)loc[1]) <= (double)FOOTPOINT_ALONG_PROMISE_F;
}

/* Checks that _along returns FOOTPOINT_OK only near a point of the line. */
static void lines_meet_faces(void **state)
{
    static int (*const line[CURVED_KINDS])(const float *const *, const float *, float *,
                                           float *) = {tri6_line, quad8_line, quad9_line};
    uint64_t stream = 671;
    (void)state;
    for (int k = 0; k < CURVED_KINDS; k++)
        for (int group = ORDINARY; group < CURVED_GROUPS; group++) {
            long proved = 0;
            for (long n = 0; n < cases(); n++) {
                struct curved_case f = {.kind = &curved_kinds[k]};
                float x[CURVED_NODES + 1][3], along[3], loc[2], dist;
                const float *row[CURVED_NODES + 1];
                single_draw(&stream, (enum single_family)group, &f);
                round_rows(&f, x, row);
                for (int i = 0; i < 3; i++)
                    along[i] = (float)draw_flat(&stream, -1, 1);
                if (line[k](row, along, loc, &dist) != FOOTPOINT_OK)
                    continue;
                proved++;
                if (!is_met(&f, along, loc))
                    fail_msg("%s, %s, line %ld: OK at (%.9g, %.9g)", f.kind->name, curved_groups[group], n,
                             (double)loc[0], (double)loc[1]);
            }
            if (getenv("FOOTPOINT_LONG"))
                print_message("%s, %s: %.2f %% of lines proved\n", curved_kinds[k].name, curved_groups[group],
                              100. * (double)proved / (double)cases());
            assert_true(group != ORDINARY || 10 * proved > cases()); /* three in four miss the face */
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_keep_the_promise),
        cmocka_unit_test(arrays_match_calls),
        cmocka_unit_test(lines_meet_faces),
    };
    return cmocka_run_group_tests_name("float promises of curved faces", tests, NULL, NULL);
}
