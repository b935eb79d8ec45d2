/* Checks plane triangles in float. If footpoint_tri3_float_exact returns FOOTPOINT_OK, the foot point must lie within
 * its promise; the same holds for the closest point and its _closest. Triangles are ordinary, slivers, far, shifted, of
 * any size, and of coordinates of mixed scales; slave nodes also lie over borders. The judge solves the normal
 * equations in quadruple precision from the same floats. 1e5 of each family with FOOTPOINT_LONG. */
#include "../support/long_cases.h"
#include "footpoint_tri3_float.h"

#include "../hard/draw.h"
#include "single_cases.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { CASES = 1000, CASES_LONG = 100000, BLOCK = 400 };
static const double promise = (double)FOOTPOINT_TRI3_FLOAT_EXACT_PROMISE;

struct triangle {
    float x[4][3]; /* the slave node is the last */
};

/* ---- families ---- */

enum family { PLAIN, SLIVERS, FAR_AWAY, SHIFTED, SIZES, SCALES, BORDER, FAMILIES };
static const char *const names[FAMILIES] = {"ordinary", "sliver", "far", "offset", "size", "scales", "border"};

static struct triangle draw(enum family family, uint64_t *stream)
{
    const double thin = family == SLIVERS ? draw_power(stream, -4, 0) : 1;
    const double away = family == FAR_AWAY ? draw_power(stream, 0, 4) : 1;
    const double size = family == SIZES ? draw_power(stream, -45, 38) : 1;
    double p = draw_flat(stream, -0.5, 1.5), q = draw_flat(stream, -0.5, 1.5);
    struct triangle t;
    if (family == BORDER) { /* halves and corners, and as little beside them as rounding */
        p = 0.5 * floor(4 * p) / 2 + draw_power(stream, -9, -5);
        q = 0.5 * floor(4 * q) / 2 - draw_power(stream, -9, -5);
    }
    for (int i = 0; i < 3; i++) {
        const double u = draw_flat(stream, -1, 1), n = draw_flat(stream, -0.2, 0.2);
        const double v = thin * draw_flat(stream, -1, 1) + (thin < 1 ? 0.4 * u : 0);
        const double shift = family == SHIFTED ? draw_power(stream, 0, 6) : 0;
        const double at[4] = {0, u, v, away * (p * u + q * v + n)};
        for (int k = 0; k < 4; k++)
            t.x[k][i] = single_round((family == SCALES ? draw_power(stream, -8, 8) : size) * (shift + at[k]));
    }
    return t;
}

/* ---- the judge ---- */

/* Computes {u.u, u.v, v.v, u.w, v.w, w.w} of the edges u, v and the slave node w from corner `from`. */
static void products(const struct triangle *t, int from, wide p[6])
{
    memset(p, 0, 6 * sizeof *p);
    for (int i = 0; i < 3; i++) {
        const wide a = t->x[from][i], u = t->x[(from + 1) % 3][i] - a, v = t->x[(from + 2) % 3][i] - a,
                   w = t->x[3][i] - a;
        const wide term[6] = {u * u, u * v, v * v, u * w, v * w, w * w};
        for (int k = 0; k < 6; k++)
            p[k] += term[k];
    }
}

static void find_foot(const struct triangle *t, wide z[2])
{
    wide p[6];
    products(t, 0, p);
    const wide det = p[0] * p[2] - p[1] * p[1];
    z[0] = (p[2] * p[3] - p[1] * p[4]) / det;
    z[1] = (p[0] * p[4] - p[1] * p[3]) / det;
}

/* Finds the closest point: the foot point if it is inside, or the closest point of an edge. */
static void find_closest(const struct triangle *t, wide z[2])
{
    static const int corner[4][2] = {{0, 0}, {1, 0}, {0, 1}, {0, 0}};
    wide least = -1;
    find_foot(t, z);
    if (z[0] > 0 && z[1] > 0 && z[0] + z[1] < 1)
        return;
    for (int k = 0; k < 3; k++) {
        wide p[6];
        products(t, k, p);
        const wide s = p[3] <= 0 ? 0 : p[3] >= p[0] ? 1 : p[3] / p[0], dd = p[5] - 2 * s * p[3] + s * s * p[0];
        if (least >= 0 && dd >= least)
            continue;
        least = dd;
        for (int j = 0; j < 2; j++)
            z[j] = corner[k][j] + s * (corner[k + 1][j] - corner[k][j]);
    }
}

static bool is_near(const wide z[2], const float loc[2], double within)
{
    return size_of(z[0] - (wide)loc[0]) <= within && size_of(z[1] - (wide)loc[1]) <= within;
}

static bool holds(const struct triangle *t, const float loc[2], bool closest)
{
    const double x = fabs((double)loc[0]), y = fabs((double)loc[1]);
    wide z[2];
    (closest ? find_closest : find_foot)(t, z);
    return is_near(z, loc, closest ? promise : promise * fmax(1, fmax(x, y)));
}

/* Finds the point in which the line through the slave node along `along` meets the plane, by Cramer's rule. */
static void find_meeting(const struct triangle *t, const float along[3], wide z[2])
{
    wide m[3][3]; /* u, v, w */
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m[k][i] = (wide)t->x[k + 1][i] - (wide)t->x[0][i];
    const wide *const u = m[0], *const v = m[1], *const w = m[2];
    wide det = 0, xi = 0, eta = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        det += (wide)along[i] * (u[j] * v[k] - u[k] * v[j]);
        xi += (wide)along[i] * (w[j] * v[k] - w[k] * v[j]);
        eta += (wide)along[i] * (u[j] * w[k] - u[k] * w[j]);
    }
    z[0] = xi / det;
    z[1] = eta / det;
}

/* ---- tests ---- */

static void fail_on(const struct triangle *t, const char *what, const float loc[2])
{
    for (int k = 0; k < 4; k++)
        print_error("{%a, %a, %a},\n", (double)t->x[k][0], (double)t->x[k][1], (double)t->x[k][2]);
    fail_msg("%s: OK at (%.9g, %.9g)", what, (double)loc[0], (double)loc[1]);
}

/* Sets the percentages of foot points and of closest points that must be proved. */
static const int least[FAMILIES][2] = {{90, 95}, {15, 90}, {85, 80}, {85, 85}, {70, 70}, {0, 0}, {90, 80}};

static void promises_hold(void **state)
{
    const long n = long_cases(CASES, CASES_LONG);
    (void)state;
    for (int family = 0; family < FAMILIES; family++) {
        uint64_t stream = (uint64_t)family + 1;
        long proved = 0, near = 0, answers = 0;
        for (long k = 0; k < n; k++) {
            const struct triangle t = draw((enum family)family, &stream);
            float loc[2] = {7, 7}, gap;
            int region, status = footpoint_tri3_float_exact(t.x[0], t.x[1], t.x[2], t.x[3], loc, &gap);
            assert_true(status >= FOOTPOINT_OK || (loc[0] == 7 && loc[1] == 7));
            if (status == FOOTPOINT_OK && ++proved && !holds(&t, loc, false))
                fail_on(&t, names[family], loc);
            status = footpoint_tri3_float_exact_closest(t.x[0], t.x[1], t.x[2], t.x[3], loc, &gap, &region);
            answers += status >= FOOTPOINT_OK;
            if (status == FOOTPOINT_OK && ++near && !holds(&t, loc, true))
                fail_on(&t, names[family], loc);
        }
        print_message("# %s: %.2f %% proved, %.2f %% of the closest points\n", names[family],
                      100. * (double)proved / (double)n, 100. * (double)near / (double)answers);
        assert_true(100 * proved >= least[family][0] * n && 100 * near >= least[family][1] * answers);
    }
}

/* Checks that _along returns FOOTPOINT_OK only near the point of the line. */
static void lines_meet_triangles(void **state)
{
    const long n = long_cases(CASES, CASES_LONG);
    (void)state;
    for (int family = 0; family < FAMILIES; family++) {
        uint64_t stream = (uint64_t)family + 20;
        long proved = 0;
        for (long k = 0; k < n; k++) {
            const struct triangle t = draw((enum family)family, &stream);
            const float along[3] = {(float)draw_flat(&stream, -1, 1), (float)draw_flat(&stream, -1, 1),
                                    (float)draw_flat(&stream, -1, 1)};
            float loc[2], dist;
            wide z[2];
            if (footpoint_tri3_float_along(t.x[0], t.x[1], t.x[2], t.x[3], along, loc, &dist) != FOOTPOINT_OK)
                continue;
            proved++;
            find_meeting(&t, along, z);
            if (!is_near(z, loc, (double)FOOTPOINT_ALONG_PROMISE_F))
                fail_on(&t, "along a line", loc);
        }
        print_message("# %s: %.2f %% of lines proved\n", names[family], 100. * (double)proved / (double)n);
        assert_true(family > 0 || 20 * proved > n); /* most lines miss the triangle */
    }
}

/* Checks that arrays return the bits of calls, except for fused operations. */
static void arrays_match_calls(void **state)
{
    static float column[12][BLOCK], xi[2][BLOCK], eta[2][BLOCK], gap[2][BLOCK];
    static int region[BLOCK], status[2][BLOCK];
    static struct triangle t[BLOCK];
    const float *c[12];
    uint64_t stream = 9;
    (void)state;
    for (int i = 0; i < BLOCK; i++) {
        t[i] = draw((enum family)(i % FAMILIES), &stream);
        for (int k = 0; k < 12; k++)
            column[k][i] = t[i].x[k / 3][k % 3];
    }
    for (int k = 0; k < 12; k++)
        c[k] = column[k];
    footpoint_tri3_float_exact_checked_n(BLOCK, c, xi[0], eta[0], gap[0], status[0]);
    footpoint_tri3_float_exact_closest_n(BLOCK, c, xi[1], eta[1], gap[1], region, status[1]);
    for (int i = 0; i < BLOCK; i++)
        for (int k = 0; k < 2; k++) {
            const float found[2] = {xi[k][i], eta[k][i]}, *const x[4] = {t[i].x[0], t[i].x[1], t[i].x[2], t[i].x[3]};
            float loc[2], g;
            int where, alone;
            if (status[k][i] == FOOTPOINT_OK && !holds(&t[i], found, k))
                fail_on(&t[i], "arrays", found);
            alone = k ? footpoint_tri3_float_exact_closest(x[0], x[1], x[2], x[3], loc, &g, &where)
                      : footpoint_tri3_float_exact(x[0], x[1], x[2], x[3], loc, &g);
#ifndef __FMA__
            assert_int_equal(status[k][i], alone);
            if (alone >= FOOTPOINT_OK)
                assert_true(loc[0] == found[0] && loc[1] == found[1] && g == gap[k][i] && (!k || where == region[i]));
#else
            (void)alone, (void)loc, (void)g, (void)where;
#endif
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(promises_hold),
        cmocka_unit_test(lines_meet_triangles),
        cmocka_unit_test(arrays_match_calls),
    };
    return cmocka_run_group_tests_name("float promises of plane triangles", tests, NULL, NULL);
}
