/* What functions of patches promise: where they return FOOTPOINT_OK a minimum of the distance lies within NAME_PROMISE of xi and
 * eta, on the patch or where its formula continues it; with FOOTPOINT_OUTSIDE a minimum on the closed patch, at the border.  Patches are
 * ordinary, strongly warped, slivers, wild (collapsed, far away, of any size), slave nodes beside and about borders; some of each, a million
 * of each kind in each group with FOOTPOINT_LONG.  The judge makes control points by their definition and takes Newton's steps, in
 * quadruple precision; it shares no code with what it judges. */
#include "../../runtime/footpoint.h"
#include "../patches/drawn_patches.h"
#include "../support/long_cases.h"
#include "header_functions.h"

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

enum { CASES = 130, CASES_LONG = 1000000 };

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

static const char *const kinds[] = {"bezier", "gregory"};
enum { KINDS = sizeof kinds / sizeof *kinds };

static const char *const group_names[] = {"ordinary", "strongly warped", "sliver", "border", "wild"};
/* % that must be proved of promises from 1e-7 on. */
static const int proved_least[PATCH_GROUPS][KINDS] = {{99, 97}, {80, 60}, {70, 40}, {90, 70}, {30, 25}};

static const struct header_function *judged(size_t i, int kind)
{
    const struct header_function *const f = &header_functions[i];
    return f->promise > 0 && strcmp(f->kind, kinds[kind]) == 0 ? f : NULL;
}

static void fail_on(const struct patch_case *f, const char *name, const char *group, int status, const double loc[2])
{
    for (int v = 0; v < PATCH_VECTORS; v++)
        print_error("{%a, %a, %a},\n", f->x[v][0], f->x[v][1], f->x[v][2]);
    fail_msg("%s, %s: status %d at (%.17g, %.17g)", name, group, status, loc[0], loc[1]);
}

static void judge(const struct patch_case *f, enum patch_group group, long proved[HEADER_FUNCTIONS][2])
{
    const struct patch_case scaled = patch_unit(f);
    const double *x[PATCH_VECTORS];
    struct patch_net t;
    patch_wide known[2] = {0, 0};
    bool is_known = false;
    patch_net_make(&scaled, &t);
    for (int v = 0; v < PATCH_VECTORS; v++)
        x[v] = f->x[v];
    for (size_t i = HEADER_FUNCTIONS; i-- > 0;) {
        const struct header_function *const function = judged(i, f->kind);
        double loc[2], gap;
        const int status = function ? function->locate(x, f->x[8], loc, &gap) : FOOTPOINT_UNPROVED;
        if (status != FOOTPOINT_OK && status != FOOTPOINT_OUTSIDE)
            continue;
        if (!patch_answer_holds(&scaled, &t, status, loc, function->promise, known, &is_known))
            fail_on(f, function->name, group_names[group], status, loc);
        proved[i][status == FOOTPOINT_OUTSIDE]++;
    }
}

static void test_group(enum patch_group group)
{
    for (int k = 0; k < KINDS; k++) {
        long proved[HEADER_FUNCTIONS][2] = {{0}};
        uint64_t stream = 640 + (uint64_t)group;
        for (long i = 0; i < cases(); i++) {
            struct patch_case f = {.kind = k};
            patch_draw(&stream, group, &f);
            judge(&f, group, proved);
        }
        for (size_t i = 0; i < HEADER_FUNCTIONS; i++) {
            const struct header_function *const f = judged(i, k);
            if (!f)
                continue;
            const double share = 100. * (double)(proved[i][0] + proved[i][1]) / (double)cases();
            if (cases() != CASES)
                print_message("%s, %s: %.2f %% proved, %.2f %% outside\n", f->name, group_names[group], share,
                              100. * (double)proved[i][1] / (double)cases());
            if (f->promise > 1e-8 && share < proved_least[group][k])
                fail_msg("%s, %s: %.2f %% proved", f->name, group_names[group], share);
        }
    }
}

static void test_ordinary(void **state)
{
    (void)state;
    test_group(PATCH_ORDINARY);
}

static void test_strong(void **state)
{
    (void)state;
    test_group(PATCH_STRONG);
}

static void test_sliver(void **state)
{
    (void)state;
    test_group(PATCH_SLIVER);
}

static void test_border(void **state)
{
    (void)state;
    test_group(PATCH_BORDER);
}

static void test_wild(void **state)
{
    (void)state;
    test_group(PATCH_WILD);
}

/* The answer in an array is as good as the answer alone: proved if that is, within both promises of that on ordinary
 * patches, where the gap differs by the square of what xi and eta do, by the third power of a step, and by rounding to single precision; statuses below 0 are the same. */
static void compare(const struct header_function *f, const struct patch_case *p, int status, const double found[2],
                    double gap, bool ordinary)
{
    const double *y[PATCH_VECTORS];
    double loc[2] = {0, 0}, g = 0, size = 0;
    for (int v = 0; v < PATCH_VECTORS; v++)
        y[v] = p->x[v];
    const int alone = f->locate(y, p->x[8], loc, &g);
    if (status != alone && !(status == FOOTPOINT_OK && alone > FOOTPOINT_OK))
        fail_msg("%s: status %d in an array, %d alone", f->name, status, alone);
    if (!ordinary || alone != FOOTPOINT_OK)
        return;
    for (int i = 0; i < 3; i++)
        size += fabs(p->x[1][i] - p->x[0][i]) + fabs(p->x[2][i] - p->x[1][i]);
    const double away = fmax(fabs(loc[0] - found[0]), fabs(loc[1] - found[1]));
    const double off = (away * away + (f->promise < 9e-4 ? 1e-14 + 1e-6 * f->promise : 1e-6)) * size;
    if (!(away <= 2 * f->promise && fabs(gap - g) <= off))
        fail_msg("%s: %g away from the answer alone, gaps by %g", f->name, away, fabs(gap - g));
}

static void test_arrays(void **state)
{
    enum { PAIRS = 75, ROWS = 3 * PATCH_VECTORS };
    static double column[ROWS][PAIRS], xi[PAIRS], eta[PAIRS], gap[PAIRS];
    static struct patch_case patch[PAIRS];
    static int status[PAIRS];
    const double *x[ROWS];
    uint64_t stream = 650;
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        for (int i = 0; i < PAIRS; i++) {
            patch[i].kind = k;
            patch_draw(&stream, (enum patch_group)(i % PATCH_GROUPS), &patch[i]);
            for (int row = 0; row < ROWS; row++) {
                column[row][i] = patch[i].x[row / 3][row % 3];
                x[row] = column[row];
            }
        }
        for (size_t j = 0; j < HEADER_FUNCTIONS; j++) {
            const struct header_function *const f = judged(j, k);
            if (!f)
                continue;
            f->checked_n(PAIRS, x, xi, eta, gap, status);
            for (int i = 0; i < PAIRS; i++) {
                const struct patch_case scaled = patch_unit(&patch[i]);
                const double found[2] = {xi[i], eta[i]};
                struct patch_net t;
                patch_wide known[2] = {0, 0};
                bool is_known = false;
                patch_net_make(&scaled, &t);
                if ((status[i] == FOOTPOINT_OK || status[i] == FOOTPOINT_OUTSIDE) &&
                    !patch_answer_holds(&scaled, &t, status[i], found, f->promise, known, &is_known))
                    fail_on(&patch[i], f->name, "arrays", status[i], found);
                compare(f, &patch[i], status[i], found, gap[i], i % PATCH_GROUPS == PATCH_ORDINARY);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ordinary), cmocka_unit_test(test_strong), cmocka_unit_test(test_sliver),
        cmocka_unit_test(test_border),   cmocka_unit_test(test_wild),   cmocka_unit_test(test_arrays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
