/* What plane triangles promise: where footpoint_tri3_exact says FOOTPOINT_OK the foot point lies within its promise, on ordinary
 * triangles, slivers, needles, far and shifted ones, of any size and of coordinates of mixed scales, and on three corners of
 * the hard cases; alone and in arrays.  The judge solves the normal equations in quadruple precision. */
#include "../../generated/footpoint_tri3.h"
#include "../hard/draw.h"
#include "../hard/hard.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

__extension__ typedef __float128 wide;

enum { CASES = 2000, CASES_LONG = 1000000 };

static long cases(void)
{
    return getenv("FOOTPOINT_LONG") ? CASES_LONG : CASES;
}

static double size_of(wide x)
{
    return fabs((double)x);
}

/* Whether the foot point is as near to loc as promised. */
static bool holds(double x[4][3], const double loc[2])
{
    const double within = FOOTPOINT_TRI3_EXACT_PROMISE * fmax(1, fmax(fabs(loc[0]), fabs(loc[1])));
    wide uu = 0, uv = 0, vv = 0, uw = 0, vw = 0;
    for (int i = 0; i < 3; i++) {
        const wide u = (wide)x[1][i] - x[0][i], v = (wide)x[2][i] - x[0][i], w = (wide)x[3][i] - x[0][i];
        uu += u * u;
        uv += u * v;
        vv += v * v;
        uw += u * w;
        vw += v * w;
    }
    const wide det = uu * vv - uv * uv, xi = (vv * uw - uv * vw) / det, eta = (uu * vw - uv * uw) / det;
    return size_of(xi - loc[0]) <= within && size_of(eta - loc[1]) <= within;
}

enum family { ORDINARY, SLIVER, NEEDLE, FAR, OFFSET, SIZE, SCALES, FAMILIES };

static void draw(enum family family, uint64_t *stream, double x[4][3])
{
    const double thin = family == SLIVER || family == NEEDLE ? draw_power(stream, -6, 0) : 1;
    const double away = family == FAR ? draw_power(stream, 0, 2) : 1, p = draw_flat(stream, -0.5, 1.5);
    const double q = draw_flat(stream, -0.5, 1.5), size = family == SIZE ? draw_power(stream, -300, 300) : 1;
    double u[3], v[3], n[3], shift[3];
    for (int i = 0; i < 3; i++) {
        u[i] = draw_flat(stream, -1, 1);
        v[i] = thin * draw_flat(stream, -1, 1) + (family == SLIVER ? 0.4 * u[i] : 0);
        n[i] = draw_flat(stream, -0.2, 0.2);
        shift[i] = family == OFFSET ? draw_power(stream, 0, 9) : 0;
    }
    for (int i = 0; i < 3; i++) {
        const double unit = family == SCALES ? draw_power(stream, -8, 8) : size;
        x[0][i] = unit * shift[i];
        x[1][i] = unit * (shift[i] + u[i]);
        x[2][i] = unit * (shift[i] + v[i]);
        x[3][i] = unit * (shift[i] + away * (p * u[i] + q * v[i] + n[i]));
    }
}

static int judge(double x[4][3], const char *what)
{
    double loc[2], gap;
    if (footpoint_tri3_exact(x[0], x[1], x[2], x[3], loc, &gap) != FOOTPOINT_OK)
        return 0;
    if (!holds(x, loc)) {
        for (int k = 0; k < 4; k++)
            print_error("{%a, %a, %a}\n", x[k][0], x[k][1], x[k][2]);
        fail_msg("%s: OK at (%.17g, %.17g)", what, loc[0], loc[1]);
    }
    return 1;
}

static void promises_hold(void **state)
{
    static const char *const names[FAMILIES] = {"ordinary", "sliver", "needle", "far", "offset", "size", "scales"};
    static const double least[FAMILIES] = {0.97, 0.1, 0.3, 0.9, 0.9, 0.9, 0.0}; /* parts that have to be proved */
    (void)state;
    for (int family = 0; family < FAMILIES; family++) {
        uint64_t stream = (uint64_t)family + 1;
        long proved = 0;
        for (long k = 0; k < cases(); k++) {
            double x[4][3];
            draw((enum family)family, &stream, x);
            proved += judge(x, names[family]);
        }
        print_message("# %s: %.4f proved\n", names[family], (double)proved / (double)cases());
        assert_true((double)proved >= least[family] * (double)cases());
    }
}

static void promises_hold_on_hard_cases(void **state)
{
    (void)state;
    for (int family = 0; family < hard_family_count; family++)
        for (long k = 0; k < cases() / 10; k++) {
            struct hard_case h;
            hard_draw(family, 1, (uint64_t)k, &h);
            memcpy(h.x[3], h.x[4], sizeof h.x[3]);
            (void)judge(h.x, hard_families[family].name);
        }
}

/* The same bits as alone, but for fused operations. */
static void arrays_match_calls(void **state)
{
    enum { PAIRS = 700 };
    static double column[12][PAIRS], xi[PAIRS], eta[PAIRS], gap[PAIRS];
    static int status[PAIRS];
    const double *c[12];
    uint64_t stream = 9;
    (void)state;
    for (int i = 0; i < PAIRS; i++) {
        double x[4][3];
        draw((enum family)(i % FAMILIES), &stream, x);
        for (int k = 0; k < 12; k++)
            column[k][i] = x[k / 3][k % 3];
    }
    for (int k = 0; k < 12; k++)
        c[k] = column[k];
    footpoint_tri3_exact_checked_n(PAIRS, c, xi, eta, gap, status);
    for (int i = 0; i < PAIRS; i++) {
        double x[4][3], loc[2] = {0, 0}, g = 0;
        const double found[2] = {xi[i], eta[i]};
        for (int k = 0; k < 12; k++)
            x[k / 3][k % 3] = column[k][i];
        if (status[i] == FOOTPOINT_OK)
            assert_true(holds(x, found));
#ifndef __FMA__
        assert_int_equal(status[i], footpoint_tri3_exact(x[0], x[1], x[2], x[3], loc, &g));
        if (status[i] >= FOOTPOINT_OK)
            assert_true(loc[0] == xi[i] && loc[1] == eta[i] && g == gap[i]);
#else
        (void)loc, (void)g;
#endif
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(promises_hold),
        cmocka_unit_test(promises_hold_on_hard_cases),
        cmocka_unit_test(arrays_match_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
