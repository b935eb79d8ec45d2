/* Checks functions of faces of six, eight and nine nodes in float. If NAME returns FOOTPOINT_OK, in a call or over
 * arrays, a minimum of the distance must lie within NAME_PROMISE of xi and eta, whatever the face. The judge takes
 * Newton's steps in quadruple precision from the same floats. FOOTPOINT_LONG draws 1e5 faces of each family and prints
 * the shares that are proved. */
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_keep_the_promise),
        cmocka_unit_test(arrays_match_calls),
    };
    return cmocka_run_group_tests_name("float promises of curved faces", tests, NULL, NULL);
}
