/* The library's patches: foot points and derivatives against quadruple precision, many pairs against single pairs to
 * the bit, and statuses. */
#include "../../runtime/footpoint_patch.h"
#include "../support/quad_patch.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 25, PAIRS = 70, ALL = PATCH_COORDINATES, SLAVE = 24 };
#define UNTOUCHED 77.25

static const enum footpoint_patch kinds[] = {FOOTPOINT_BEZIER, FOOTPOINT_GREGORY};
static const enum footpoint_patch nothing = (enum footpoint_patch)7;

static double uniform(uint64_t *stream)
{
    *stream = *stream * 6364136223846793005u + 1442695040888963407u;
    return (double)(*stream >> 11) * 0x1p-53;
}

/* Draws a patch of a slightly crooked sphere, with the slave node above or below a point well inside. */
static void draw(uint64_t *stream, enum footpoint_patch patch, double *x)
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    quadruple y[ALL] = {0};
    struct patch_foot at;
    for (int c = 0; c < 4; c++) {
        double *const n = x + 12 + 3 * c;
        for (int i = 0; i < 3; i++) {
            x[3 * c + i] = 0.1 * (uniform(stream) - 0.5) + (i < 2 ? corner[c][i] : 0.0);
            n[i] = 0.1 * (uniform(stream) - 0.5) + (i < 2 ? 0.1 * corner[c][i] : 1.0);
        }
        const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int i = 0; i < 3; i++)
            n[i] /= length;
    }
    for (int i = 0; i < SLAVE; i++)
        y[i] = x[i];
    patch_point(patch == FOOTPOINT_GREGORY, y, 1.8 * uniform(stream) - 0.9, 1.8 * uniform(stream) - 0.9, &at);
    const double gap = 0.2 * uniform(stream) - 0.1;
    for (int i = 0; i < 3; i++)
        x[SLAVE + i] = (double)(at.r[i] + gap * at.normal[i]);
}

static void expect_near(double a, double b, double within, const char *what, int patch)
{
    if (!(fabs(a - b) <= within))
        fail_msg("patch %d, %s: %.17g, not %.17g", patch, what, a, b);
}

static void foot_points_are_right(void **state)
{
    uint64_t stream = 3;
    (void)state;
    for (int kind = 0; kind < 2; kind++)
        for (int sample = 0; sample < SAMPLES; sample++) {
            const bool twins = kinds[kind] == FOOTPOINT_GREGORY;
            double x[ALL], loc[2], gap, again, r[3], d_xi[15], d_gap[15], d_gap_n[12];
            quadruple y[ALL];
            struct patch_foot foot, moved;
            draw(&stream, kinds[kind], x);
            for (int i = 0; i < ALL; i++)
                y[i] = x[i];
            assert_int_equal(footpoint_patch_locate(kinds[kind], x, loc, &gap), FOOTPOINT_OK);
            assert_true(patch_foot_near(twins, y, loc[0], loc[1], &foot));
            expect_near(loc[0], (double)foot.xi, 1e-7, "xi", kind);
            expect_near(loc[1], (double)foot.eta, 1e-7, "eta", kind);
            expect_near(gap, (double)foot.gap, 1e-12, "gap", kind);
            assert_int_equal(footpoint_patch_place(kinds[kind], x, loc, r, NULL, NULL, NULL, &again), FOOTPOINT_OK);
            expect_near(again, gap, 1e-14, "gap once more", kind);
            expect_near(r[2], (double)foot.r[2], 1e-7, "point", kind);
            assert_int_equal(footpoint_patch_differentiate(kinds[kind], x, loc, NULL, NULL, NULL, NULL, NULL, d_xi,
                                                           NULL, d_gap, NULL, NULL, d_gap_n),
                             FOOTPOINT_OK);
            const int c = (int)(uniform(&stream) * 12), n = 12 + (int)(uniform(&stream) * 12);
            y[c] += 1e-9;
            assert_true(patch_foot_near(twins, y, foot.xi, foot.eta, &moved));
            expect_near(d_xi[c], (double)((moved.xi - foot.xi) / 1e-9), 1e-5, "derivative of xi", kind);
            expect_near(d_gap[c], (double)((moved.gap - foot.gap) / 1e-9), 1e-7, "derivative of the gap", kind);
            y[c] = x[c];
            y[n] += 1e-9;
            assert_true(patch_foot_near(twins, y, foot.xi, foot.eta, &moved));
            expect_near(d_gap_n[n - 12], (double)((moved.gap - foot.gap) / 1e-9), 1e-7, "and by a normal", kind);
        }
}

/* Consecutive segments and slave nodes, each with its own nodes, have the answers of single pairs. */
static void pairs_are_the_same(void **state)
{
    uint64_t stream = 5;
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        static double xyz[PAIRS * 15], normals[PAIRS * 15], loc[2 * PAIRS], gap[PAIRS];
        int seg[4 * PAIRS], slave[PAIRS], status[PAIRS];
        for (int p = 0; p < PAIRS; p++) {
            double x[ALL];
            draw(&stream, kinds[kind], x);
            memcpy(xyz + 15 * p, x, 12 * sizeof *x);
            memcpy(xyz + 15 * p + 12, x + SLAVE, 3 * sizeof *x);
            memcpy(normals + 15 * p, x + 12, 12 * sizeof *x);
            for (int c = 0; c < 4; c++)
                seg[4 * p + c] = 5 * p + c;
            slave[p] = 5 * p + 4;
        }
        xyz[15 * 8] = (double)NAN;
        seg[4 * 9 + 2] = -1;
        slave[10] = 5 * PAIRS;
        for (int p = 0; p < PAIRS; p++)
            loc[2 * p] = loc[2 * p + 1] = gap[p] = UNTOUCHED;
        assert_int_equal(
            footpoint_patch_locate_pairs(kinds[kind], PAIRS, xyz, normals, 5 * PAIRS, seg, slave, loc, gap, status), 3);
        for (int p = 0; p < PAIRS; p++) {
            double x[ALL], one[2] = {UNTOUCHED, UNTOUCHED}, g = UNTOUCHED;
            memcpy(x, xyz + 15 * p, 12 * sizeof *x);
            memcpy(x + 12, normals + 15 * p, 12 * sizeof *x);
            memcpy(x + SLAVE, xyz + 15 * p + 12, 3 * sizeof *x);
            const int bad = p == 9 || p == 10;
            assert_int_equal(status[p], bad      ? FOOTPOINT_ERR_ARGUMENT
                                        : p == 8 ? FOOTPOINT_ERR_NOT_FINITE
                                                 : FOOTPOINT_OK);
            if (!bad)
                assert_int_equal(footpoint_patch_locate(kinds[kind], x, one, &g), status[p]);
            /* each within the promise */
            assert_true(fabs(one[0] - loc[2 * p]) <= 2e-12 && fabs(one[1] - loc[2 * p + 1]) <= 2e-12);
            assert_true(fabs(g - gap[p]) <= 1e-12);
        }
    }
}

static void statuses_are_right(void **state)
{
    uint64_t stream = 7;
    double x[ALL], loc[2] = {0, 0}, gap = UNTOUCHED;
    const int seg[4] = {0, 1, 2, 3}, slave[1] = {4};
    int status[1];
    (void)state;
    draw(&stream, FOOTPOINT_BEZIER, x);
    assert_int_equal(footpoint_patch_locate(nothing, x, loc, &gap), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_patch_locate_pairs(nothing, 1, x, x, 5, seg, slave, loc, &gap, status), 1);
    assert_int_equal(status[0], FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_patch_place(nothing, x, loc, NULL, NULL, NULL, NULL, &gap), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_patch_differentiate(nothing, x, loc, NULL, NULL, NULL, NULL, &gap, NULL, NULL, NULL,
                                                   NULL, NULL, NULL),
                     FOOTPOINT_ERR_ARGUMENT);
    for (int kind = 0; kind < 2; kind++)
        for (int i = 0; i < ALL; i++) {
            draw(&stream, kinds[kind], x);
            x[i] = (double)INFINITY;
            assert_int_equal(footpoint_patch_locate(kinds[kind], x, loc, &gap), FOOTPOINT_ERR_NOT_FINITE);
            assert_int_equal(footpoint_patch_place(kinds[kind], x, loc, NULL, NULL, NULL, NULL, &gap),
                             FOOTPOINT_ERR_NOT_FINITE);
        }
    assert_true(gap == UNTOUCHED);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(foot_points_are_right),
        cmocka_unit_test(pairs_are_the_same),
        cmocka_unit_test(statuses_are_right),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
