/* The promise of plane triangles. With FOOTPOINT_OK the foot point of footpoint_tri3_exact lies within its promise, and
 * so does the closest point of the closed triangle of footpoint_tri3_exact_closest. Triangles are ordinary, slivers,
 * needles, far and shifted, of any size, with coordinates of mixed scales; slave nodes lie also on edges and corners
 * and within rounding of them; and three corners of the hard cases; in calls, in arrays and of several triangles. The
 * judge solves the normal equations in quadruple precision. */
#include "../../generated/footpoint_tri3.h"
#include "../hard/draw.h"
#include "../hard/hard.h"
#include "../support/long_cases.h"

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
    return long_cases(CASES, CASES_LONG);
}

static double size_of(wide x)
{
    return fabs((double)x);
}

static void find_foot(double x[4][3], wide z[2])
{
    wide uu = 0, uv = 0, vv = 0, uw = 0, vw = 0;
    for (int i = 0; i < 3; i++) {
        const wide u = (wide)x[1][i] - x[0][i], v = (wide)x[2][i] - x[0][i], w = (wide)x[3][i] - x[0][i];
        uu += u * u;
        uv += u * v;
        vv += v * v;
        uw += u * w;
        vw += v * w;
    }
    const wide det = uu * vv - uv * uv;
    z[0] = (vv * uw - uv * vw) / det;
    z[1] = (uu * vw - uv * uw) / det;
}

static bool is_near(const wide z[2], const double loc[2], double within)
{
    return size_of(z[0] - loc[0]) <= within && size_of(z[1] - loc[1]) <= within;
}

/* Returns true if the foot point is as near to loc as promised. */
static bool holds(double x[4][3], const double loc[2])
{
    wide z[2];
    find_foot(x, z);
    return is_near(z, loc, FOOTPOINT_TRI3_EXACT_PROMISE * fmax(1, fmax(fabs(loc[0]), fabs(loc[1]))));
}

/* Returns the squared distance of the point at z. */
static wide apart(double x[4][3], const wide z[2])
{
    wide sum = 0;
    for (int i = 0; i < 3; i++) {
        const wide d = (wide)x[3][i] - x[0][i] - z[0] * ((wide)x[1][i] - x[0][i]) - z[1] * ((wide)x[2][i] - x[0][i]);
        sum += d * d;
    }
    return sum;
}

/* Finds the closest point of edge k, AB, BC or CA. */
static void find_on_edge(double x[4][3], int k, wide z[2])
{
    static const int corner[4][2] = {{0, 0}, {1, 0}, {0, 1}, {0, 0}};
    wide ee = 0, ep = 0;
    for (int i = 0; i < 3; i++) {
        const wide e = (wide)x[(k + 1) % 3][i] - x[k][i];
        ee += e * e;
        ep += e * ((wide)x[3][i] - x[k][i]);
    }
    const wide t = ep <= 0 ? 0 : ep >= ee ? 1 : ep / ee;
    for (int j = 0; j < 2; j++)
        z[j] = corner[k][j] + t * (corner[k + 1][j] - corner[k][j]);
}

/* Finds the closest point of the closed triangle; returns its squared distance. */
static wide find_closest(double x[4][3], wide z[2])
{
    wide least = -1;
    find_foot(x, z);
    if (z[0] > 0 && z[1] > 0 && z[0] + z[1] < 1)
        return apart(x, z);
    for (int k = 0; k < 3; k++) {
        wide at[2];
        find_on_edge(x, k, at);
        if (least < 0 || apart(x, at) < least) {
            least = apart(x, at);
            z[0] = at[0];
            z[1] = at[1];
        }
    }
    return least;
}

/* Returns true if loc lies in `region`, and the closest point is as near to it as promised. */
static bool holds_closest(double x[4][3], int status, const double loc[2], double dist, int region)
{
    const double last = 1 - loc[0] - loc[1], of[3] = {loc[1], last, loc[0]}; /* 0 on AB, BC, CA */
    wide z[2] = {loc[0], loc[1]};
    bool there = true;
    for (int k = 0; k < 3; k++)
        there = there &&
                (region == k + 1 || region == k + 4 || region == (k + 1) % 3 + 4 ? fabs(of[k]) <= 1.2e-16 : of[k] >= 0);
    double longest = 0;
    for (int i = 0; i < 3; i++)
        longest = fmax(longest, fmax(fabs(x[1][i] - x[0][i]), fabs(x[2][i] - x[0][i])));
    const double here = longest * sqrt((double)(apart(x, z) / ((wide)longest * longest)));
    if (status == FOOTPOINT_UNPROVED)
        return there;
    const double off = fabs(fabs(dist) - here);
    (void)find_closest(x, z);
    return there && off <= 1e-13 * (longest + here) && is_near(z, loc, FOOTPOINT_TRI3_EXACT_PROMISE);
}

enum family { ORDINARY, SLIVER, NEEDLE, FAR, OFFSET, SIZE, SCALES, BORDER, FAMILIES };
static const char *const names[FAMILIES] = {"ordinary", "sliver", "needle", "far",
                                            "offset",   "size",   "scales", "border"};

static void draw(enum family family, uint64_t *stream, double x[4][3])
{
    const double thin = family == SLIVER || family == NEEDLE ? draw_power(stream, -6, 0) : 1;
    const double away = family == FAR ? draw_power(stream, 0, 2) : 1,
                 size = family == SIZE ? draw_power(stream, -300, 300) : 1;
    double p = draw_flat(stream, -0.5, 1.5), q = draw_flat(stream, -0.5, 1.5), u[3], v[3], n[3], shift[3];
    if (family == BORDER) { /* halves and corners, and places beside them by no more than rounding */
        p = 0.5 * floor(4 * p) / 2 + draw_power(stream, -18, -12);
        q = 0.5 * floor(4 * q) / 2 - draw_power(stream, -18, -12);
    }
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
    static const double least[FAMILIES] = {0.97, 0.1, 0.3, 0.9, 0.9, 0.9, 0.0, 0.9}; /* shares that must be proved */
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

/* Judges one closest point; returns 1 if it is proved, -1 if there is none. */
static int judge_closest(double x[4][3], const char *what)
{
    double loc[2], dist;
    int region;
    const int status = footpoint_tri3_exact_closest(x[0], x[1], x[2], x[3], loc, &dist, &region);
    if (status < FOOTPOINT_OK)
        return -1;
    if ((status != FOOTPOINT_OK && status != FOOTPOINT_UNPROVED) || !holds_closest(x, status, loc, dist, region)) {
        for (int k = 0; k < 4; k++)
            print_error("{%a, %a, %a}\n", x[k][0], x[k][1], x[k][2]);
        fail_msg("%s: status %d at (%.17g, %.17g), distance %g, region %d", what, status, loc[0], loc[1], dist, region);
    }
    return status == FOOTPOINT_OK;
}

static void closest_points_keep_the_promise(void **state)
{
    static const double least[FAMILIES] = {0.99, 0.5, 0.7, 0.9, 0.9, 0.9, 0.0, 0.9};
    (void)state;
    for (int family = 0; family < FAMILIES; family++) {
        uint64_t stream = (uint64_t)family + 1;
        long proved = 0, answers = 0;
        for (long k = 0; k < cases(); k++) {
            double x[4][3];
            draw((enum family)family, &stream, x);
            const int is = judge_closest(x, names[family]);
            proved += is > 0;
            answers += is >= 0;
        }
        print_message("# closest, %s: %.4f proved of %ld\n", names[family], (double)proved / (double)answers, answers);
        assert_true((double)proved >= least[family] * (double)answers);
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
            (void)judge_closest(h.x, hard_families[family].name);
        }
}

/* With several triangles and one slave node no point of any is nearer, and arrays match calls. */
static void closest_points_of_several(void **state)
{
    enum { SEVERAL = 3, ROUNDS = 300 };
    uint64_t stream = 11;
    (void)state;
    for (int k = 0; k < ROUNDS; k++) {
        double x[SEVERAL][4][3], column[12][SEVERAL], loc[2], dist, xi[SEVERAL], eta[SEVERAL], d[SEVERAL];
        const double *row[3 * SEVERAL], *c[12];
        int region, where[SEVERAL], status[SEVERAL];
        size_t which = 0;
        for (int i = 0; i < SEVERAL; i++) {
            draw((enum family)(k % 3 ? ORDINARY : SLIVER), &stream, x[i]);
            memcpy(x[i][3], x[0][3], sizeof x[i][3]);
            for (int j = 0; j < 3; j++)
                row[3 * i + j] = x[i][j];
            for (int j = 0; j < 12; j++)
                column[j][i] = x[i][j / 3][j % 3];
        }
        for (int j = 0; j < 12; j++)
            c[j] = column[j];
        footpoint_tri3_exact_closest_n(SEVERAL, c, xi, eta, d, where, status);
        for (int i = 0; i < SEVERAL; i++) {
            double at[2] = {xi[i], eta[i]};
            assert_true(status[i] < FOOTPOINT_OK || holds_closest(x[i], status[i], at, d[i], where[i]));
#ifndef __FMA__
            assert_int_equal(footpoint_tri3_exact_closest(x[i][0], x[i][1], x[i][2], x[i][3], loc, &dist, &region),
                             status[i]);
            assert_true(status[i] < FOOTPOINT_OK ||
                        (loc[0] == xi[i] && loc[1] == eta[i] && dist == d[i] && region == where[i]));
#endif
        }
        if (footpoint_tri3_exact_closest_of(SEVERAL, row, x[0][3], loc, &dist, &region, &which) != FOOTPOINT_OK)
            continue;
        assert_true(holds_closest(x[which], FOOTPOINT_OK, loc, dist, region));
        for (int i = 0; i < SEVERAL; i++) {
            wide z[2];
            assert_true(status[i] < FOOTPOINT_OK || sqrt((double)find_closest(x[i], z)) >= fabs(dist) - 1e-13);
        }
    }
}

/* Arrays return the bits of calls, unless operations are fused. */
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
        cmocka_unit_test(closest_points_keep_the_promise),
        cmocka_unit_test(closest_points_of_several),
        cmocka_unit_test(arrays_match_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
