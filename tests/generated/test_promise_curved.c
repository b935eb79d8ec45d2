/* The promise of functions of faces of six, eight and nine nodes. With FOOTPOINT_OK a minimum of the distance lies
 * within NAME_PROMISE of xi and eta. Faces are ordinary, strongly curved, arcs, folded, slivers, far away, of any size,
 * with coinciding points; some of each, a million of each kind in each group with FOOTPOINT_LONG. The judge takes
 * Newton's steps in quadruple precision on shape functions and shares no code with the judged functions. */
#include "../../runtime/footpoint.h"
#include "../support/long_cases.h"
#include "header_functions.h"
#include "judged_faces.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { CASES = 700, CASES_LONG = 1000000 };

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

/* ---- tests ---- */

/* Percentage that must be proved, for promises from 1e-7 to 1e-2. */
static const int proved_least[] = {99, 80, 80, 40};

static const struct header_function *judged(size_t i, const struct curved_kind *k)
{
    const struct header_function *const f = &header_functions[i];
    return f->promise > 0 && strcmp(f->kind, k->name) == 0 ? f : NULL;
}

static void fail_on(const struct curved_case *f, const char *name, const char *group, const double loc[2])
{
    for (int k = 0; k <= f->kind->nodes; k++)
        print_error("{%a, %a, %a},\n", f->x[k][0], f->x[k][1], f->x[k][2]);
    fail_msg("%s, %s: OK at (%.17g, %.17g)", name, group, loc[0], loc[1]);
}

static void judge(const struct curved_case *f, enum curved_group group, long proved[HEADER_FUNCTIONS])
{
    const struct curved_case scaled = judged_unit(f);
    const double *x[CURVED_NODES];
    wide known[2] = {0, 0};
    bool is_known = false;
    for (int k = 0; k < f->kind->nodes; k++)
        x[k] = f->x[k];
    for (size_t i = HEADER_FUNCTIONS; i-- > 0;) {
        const struct header_function *const function = judged(i, f->kind);
        double loc[2], gap;
        if (!function || function->locate(x, f->x[f->kind->nodes], loc, &gap) != FOOTPOINT_OK)
            continue;
        if (!judged_holds(&scaled, loc, function->promise, known, &is_known))
            fail_on(f, function->name, curved_groups[group], loc);
        proved[i]++;
    }
}

static void test_group(enum curved_group group)
{
    for (int k = 0; k < CURVED_KINDS; k++) {
        long proved[HEADER_FUNCTIONS] = {0};
        uint64_t stream = 620 + (uint64_t)group;
        for (long i = 0; i < cases(); i++) {
            struct curved_case f = {.kind = &curved_kinds[k]};
            curved_draw(&stream, group, &f);
            judge(&f, group, proved);
        }
        for (size_t i = 0; i < HEADER_FUNCTIONS; i++) {
            const struct header_function *const f = judged(i, &curved_kinds[k]);
            if (f && getenv("FOOTPOINT_LONG"))
                print_message("%s, %s: %.2f %% proved\n", f->name, curved_groups[group],
                              100. * (double)proved[i] / (double)cases());
            if (f && f->promise > 1e-8 && 100 * proved[i] < proved_least[group] * cases())
                fail_msg("%s, %s: %ld of %ld proved", f->name, curved_groups[group], proved[i], cases());
        }
    }
}

static void test_ordinary(void **state)
{
    (void)state;
    test_group(ORDINARY);
}

static void test_strong(void **state)
{
    (void)state;
    test_group(STRONG);
}

static void test_sliver(void **state)
{
    (void)state;
    test_group(SLIVER);
}

static void test_wild(void **state)
{
    (void)state;
    test_group(WILD);
}

/* Arrays keep the promise, and prove all that calls prove. */
static void test_arrays(void **state)
{
    enum { PAIRS = 400, ROWS = 3 * (CURVED_NODES + 1) };
    static double column[ROWS][PAIRS], xi[PAIRS], eta[PAIRS], gap[PAIRS];
    static struct curved_case face[PAIRS];
    static int status[PAIRS];
    const double *x[ROWS];
    uint64_t stream = 630;
    (void)state;
    for (int k = 0; k < CURVED_KINDS; k++) {
        for (int i = 0; i < PAIRS; i++) {
            face[i].kind = &curved_kinds[k];
            curved_draw(&stream, (enum curved_group)(i % CURVED_GROUPS), &face[i]);
            for (int row = 0; row < 3 * (curved_kinds[k].nodes + 1); row++) {
                column[row][i] = face[i].x[row / 3][row % 3];
                x[row] = column[row];
            }
        }
        for (size_t j = 0; j < HEADER_FUNCTIONS; j++) {
            const struct header_function *const f = judged(j, &curved_kinds[k]);
            if (!f)
                continue;
            f->checked_n(PAIRS, x, xi, eta, gap, status);
            for (int i = 0; i < PAIRS; i++) {
                const struct curved_case scaled = judged_unit(&face[i]);
                const double *y[CURVED_NODES], found[2] = {xi[i], eta[i]};
                double loc[2] = {0, 0}, g = 0;
                wide known[2] = {0, 0};
                bool is_known = false;
                for (int node = 0; node < curved_kinds[k].nodes; node++)
                    y[node] = face[i].x[node];
                if (status[i] == FOOTPOINT_OK && !judged_holds(&scaled, found, f->promise, known, &is_known))
                    fail_on(&face[i], f->name, "arrays", found);
                const int alone = f->locate(y, face[i].x[curved_kinds[k].nodes], loc, &g);
                assert_true(status[i] == alone || status[i] == FOOTPOINT_OK);
                if (i % CURVED_GROUPS == ORDINARY && alone == FOOTPOINT_OK)
                    assert_true(fabs(gap[i] - g) <= f->promise);
            }
        }
    }
}

/* A face whose tangents at the foot point are parallel, on the inner side of its curvature; then the slave node. */
static const double parallel[7][3] = {{-0x1.3292b328cf713p-3, 0x1.501f586670352p-2, 0x1.abf45743bee34p-4},
                                      {-0x1.89b61ebd35d9ep-5, -0x1.5b6d8a13f87cap-1, 0x1.0c7e495b845f3p-2},
                                      {0x1.4892ebb43b4f3p-4, -0x1.48f8975a459dbp-1, -0x1.7d57a29579664p-5},
                                      {-0x1.bd12f18bd74f6p-5, -0x1.516b7066113fep-3, 0x1.97a6c58907e2ap-3},
                                      {0x1.347e50ff08ffcp-5, -0x1.4f18366a1e786p-1, 0x1.c9bd9f80bbbf3p-5},
                                      {0x1.3a3c632321158p-7, -0x1.2ca1a3f87dbeep-3, 0x1.7217117180ff1p-5},
                                      {-0x1.2416c06d0cbc7p+1, -0x1.0ebaf9c266874p-1, -0x1.0ea773ae11d43p+0}};

/* Arrays, too, say that there is no normal. */
static void test_parallel(void **state)
{
    enum { PAIRS = 32, ROWS = 21 };
    double column[ROWS][PAIRS], xi[PAIRS], eta[PAIRS], gap[PAIRS], loc[2] = {0, 0};
    const double *x[ROWS], *y[6];
    int status[PAIRS];
    (void)state;
    for (int row = 0; row < ROWS; row++) {
        for (int i = 0; i < PAIRS; i++)
            column[row][i] = parallel[row / 3][row % 3];
        x[row] = column[row];
    }
    for (int k = 0; k < 6; k++)
        y[k] = parallel[k];
    for (size_t j = 0; j < HEADER_FUNCTIONS; j++) {
        const struct header_function *const f = &header_functions[j];
        if (f->promise == 0 || strcmp(f->kind, "tri6") != 0)
            continue;
        const int alone = f->locate(y, parallel[6], loc, gap);
        f->checked_n(PAIRS, x, xi, eta, gap, status);
        for (int i = 0; i < PAIRS; i++)
            assert_int_equal(status[i], alone);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ordinary), cmocka_unit_test(test_strong), cmocka_unit_test(test_sliver),
        cmocka_unit_test(test_wild),     cmocka_unit_test(test_arrays), cmocka_unit_test(test_parallel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
