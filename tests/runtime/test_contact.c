/* Contact of one pair: choice of the segment (3), (4), normal (6), gap (9), forces (10), (11). */
#include "../../runtime/geometry/footpoint-quad4-geometry.h"
#include "../support/ordinary_quad.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { SEGMENTS = 300 };
#define UNTOUCHED 77.25

/* Four unit squares around node 4, each starting from another corner. */
static const double patch[9][3] = {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {-1, 0, 0}, {0, 0, 0},
                                   {1, 0, 0},   {-1, 1, 0}, {0, 1, 0},  {1, 1, 0}};
static const int around[4][4] = {{4, 5, 8, 7}, {3, 4, 7, 6}, {0, 1, 4, 3}, {5, 4, 1, 2}};

/* ---- normal, gap, forces ---- */

static void normals_are_right(void **state)
{
    const double O[3] = {1, 1, 1}, X[3] = {3, 1, 1}, Y[3] = {1, 5, 1}, X2[3] = {7, 1, 1}, bad[3] = {0, (double)NAN, 0};
    double m[3];
    (void)state;
    assert_int_equal(footpoint_normal(O, X, Y, m), FOOTPOINT_OK);
    assert_true(m[0] == 0 && m[1] == 0 && m[2] == 1);
    assert_int_equal(footpoint_normal(O, Y, X, m), FOOTPOINT_OK);
    assert_true(m[2] == -1);
    m[0] = m[1] = m[2] = UNTOUCHED;
    assert_int_equal(footpoint_normal(O, X, X2, m), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(footpoint_normal(O, O, X, m), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(footpoint_normal(O, bad, X, m), FOOTPOINT_ERR_NOT_FINITE);
    assert_true(m[0] == UNTOUCHED && m[1] == UNTOUCHED && m[2] == UNTOUCHED);
}

/* Edges and nodes on a line, for which rounding leaves products other than 0. */
static void lines_have_no_normal(void **state)
{
    const double O[3] = {0, 0, 0}, X[3] = {0.1, 0.2, 0.3}, loc[2] = {0.1, 0.2};
    /* multiples of (-366083, 471023, 59437) */
    const double line[4][3] = {{-366083. * 40000001, 471023. * 40000001, 59437. * 40000001},
                               {366083. * 133333333, -471023. * 133333333, -59437. * 133333333},
                               {-366083. * 7777777, 471023. * 7777777, 59437. * 7777777},
                               {-366083. * 99999999, 471023. * 99999999, 59437. * 99999999}};
    double m[3] = {UNTOUCHED, UNTOUCHED, UNTOUCHED}, fs[3] = {UNTOUCHED}, fm[4][3], xyz[5][3] = {{0}};
    static const int seg[4] = {0, 1, 2, 3};
    (void)state;
    for (int i = 1; i < 1000; i++) {
        const double by = i % 2 ? i / 700. : -i / 700., Y[3] = {by * X[0], by * X[1], by * X[2]};
        const double xs[3] = {0.2, 0.1 * (i % 5 - 2), 0.05};
        int chosen = -7;
        assert_int_equal(footpoint_normal(O, X, Y, m), FOOTPOINT_ERR_DEGENERATE);
        for (int k = 0; k < 3; k++) {
            xyz[1][k] = X[k];
            xyz[3][k] = Y[k];
        }
        xyz[2][0] = 0.5;
        assert_int_equal(footpoint_select_segment(xyz[0], 0, 1, seg, xs, &chosen), FOOTPOINT_ERR_DOMAIN);
        assert_int_equal(chosen, -7);
    }
    for (int i = 0; i < 100; i++) {
        const double at[2] = {0.02 * i - 1, loc[1]}, xs[3] = {1e13, 2e13 - 1e12 * i, -3e13};
        const int status = footpoint_force_balanced(line[0], line[1], line[2], line[3], xs, at, 1, fs, fm);
        assert_int_equal(status, FOOTPOINT_ERR_DEGENERATE);
    }
    assert_true(m[0] == UNTOUCHED && m[1] == UNTOUCHED && m[2] == UNTOUCHED && fs[0] == UNTOUCHED);
}

/* With the segment's own normal, (9) is its signed gap; with another unit vector, the projection of xS - r. */
static void gaps_are_projections(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i);
        const double loc[2] = {q.xi, q.eta}, bad[2] = {(double)NAN, 0}, z[3] = {0, 0, 1};
        double n[3], r[3], gap = UNTOUCHED;
        const double *A = q.x[0], *B = q.x[1], *C = q.x[2], *D = q.x[3];
        assert_int_equal(footpoint_gap(A, B, C, D, q.xs, bad, z, &gap), FOOTPOINT_ERR_NOT_FINITE);
        assert_true(gap == UNTOUCHED);
        assert_int_equal(footpoint_quad4_normal(A, B, C, D, q.xi, q.eta, n), FOOTPOINT_OK);
        assert_int_equal(footpoint_gap(A, B, C, D, q.xs, loc, n, &gap), FOOTPOINT_OK);
        assert_true(fabs(gap - q.gap) < 1e-11);
        footpoint_quad4_position(A, B, C, D, q.xi, q.eta, r);
        assert_int_equal(footpoint_gap(A, B, C, D, q.xs, loc, z, &gap), FOOTPOINT_OK);
        assert_true(fabs(gap - (q.xs[2] - r[2])) < 1e-11);
    }
}

static void forces_balance(void **state)
{
    const double k = 250;
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i);
        const double loc[2] = {q.xi, q.eta};
        double n[3], fs[3], fm[4][3], sum[3], moment[3];
        assert_int_equal(footpoint_quad4_normal(q.x[0], q.x[1], q.x[2], q.x[3], q.xi, q.eta, n), FOOTPOINT_OK);
        assert_int_equal(footpoint_force(q.gap, k, n, loc, fs, fm), FOOTPOINT_OK);
        for (int c = 0; c < 3; c++) {
            const int u = (c + 1) % 3, v = (c + 2) % 3;
            /* (10): the force points out of the segment; it is 0 if the gap is open. */
            assert_true(fabs(fs[c] - (q.gap < 0 ? -q.gap * k * n[c] : 0)) < 1e-12);
            sum[c] = fs[c];
            moment[c] = q.xs[u] * fs[v] - q.xs[v] * fs[u];
            for (int j = 0; j < 4; j++) {
                sum[c] += fm[j][c];
                moment[c] += q.x[j][u] * fm[j][v] - q.x[j][v] * fm[j][u];
            }
        }
        for (int c = 0; c < 3; c++) {
            assert_true(fabs(sum[c]) <= 1e-12 * k);
            assert_true(fabs(moment[c]) <= 1e-9 * k);
        }
    }
}

static void open_gaps_have_no_force(void **state)
{
    const double m[3] = {0, 0, 1}, loc[2] = {0.5, -0.5}, open[2] = {0, 0.25};
    double fs[3], fm[4][3];
    (void)state;
    for (int i = 0; i < 2; i++) {
        fs[2] = fm[3][2] = UNTOUCHED;
        assert_int_equal(footpoint_force(open[i], 10, m, loc, fs, fm), FOOTPOINT_OK);
        for (int c = 0; c < 3; c++)
            assert_true(fs[c] == 0 && fm[0][c] == 0 && fm[1][c] == 0 && fm[2][c] == 0 && fm[3][c] == 0);
    }
}

static double uniform(uint64_t *stream)
{
    *stream = *stream * 6364136223846793005u + 1442695040888963407u;
    return (double)(*stream >> 11) * 0x1p-53;
}

/* A parallelogram in any position with slave nodes in its plane, 1e-3 to 10 edges beside it, has no forces. Slave nodes
 * moved behind the plane by 1e-9 have some. */
static void nodes_beside_have_no_force(void **state)
{
    uint64_t stream = 20246;
    (void)state;
    for (int i = 0; i < 100000; i++) {
        double a[3], b[3], n[3], x[4][3], r[3], xs[3], fs[3], fm[4][3], forces = 0;
        for (int k = 0; k < 3; k++) {
            a[k] = uniform(&stream) - 0.5;
            b[k] = uniform(&stream) - 0.5;
        }
        if (footpoint_normal((const double[3]){0, 0, 0}, a, b, n) != FOOTPOINT_OK ||
            fabs(n[0] * (a[1] * b[2] - a[2] * b[1]) + n[1] * (a[2] * b[0] - a[0] * b[2]) +
                 n[2] * (a[0] * b[1] - a[1] * b[0])) < 0.05)
            continue;
        const int side = i % 4, along = side % 2;
        double at[2], far = pow(10, 4 * uniform(&stream) - 3), behind = i % 5 ? 0 : 1e-9 * far;
        at[along] = 2 * uniform(&stream) - 1;
        at[!along] = side < 2 ? -1 : 1;
        for (int k = 0; k < 3; k++) {
            for (int c = 0; c < 4; c++)
                x[c][k] = (c == 1 || c == 2 ? a[k] : -a[k]) + (c > 1 ? b[k] : -b[k]);
            r[k] = at[0] * a[k] + at[1] * b[k];
            xs[k] = r[k] + at[!along] * far * (along ? a[k] : b[k]) - behind * n[k];
        }
        assert_int_equal(footpoint_force_balanced(x[0], x[1], x[2], x[3], xs, at, 1e6, fs, fm), FOOTPOINT_OK);
        for (int k = 0; k < 15; k++)
            forces += fabs(k < 3 ? fs[k] : fm[k / 3 - 1][k % 3]);
        assert_true((forces > 0) == (behind > 0));
    }
}

static void bad_forces_are_refused(void **state)
{
    const double m[3] = {0, 0, 1}, loc[2] = {0.5, -0.5}, nan = (double)NAN;
    const double bad_m[3] = {0, 0, nan}, bad_loc[2] = {(double)INFINITY, 0}, deep[3] = {-0.5, -0.5, -1e200};
    double fs[3] = {UNTOUCHED, UNTOUCHED, UNTOUCHED}, fm[4][3] = {{UNTOUCHED}};
    (void)state;
    assert_int_equal(footpoint_force(nan, 10, m, loc, fs, fm), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_force(-1, nan, m, loc, fs, fm), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_force(-1, 10, bad_m, loc, fs, fm), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_force(-1, 10, m, bad_loc, fs, fm), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_force(-1, -10, m, loc, fs, fm), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_force(-1e200, 1e200, m, loc, fs, fm),
                     FOOTPOINT_ERR_NOT_FINITE); /* a force that overflows */
    assert_int_equal(footpoint_force_balanced(patch[0], patch[1], patch[4], patch[3], deep, loc, 1e200, fs, fm),
                     FOOTPOINT_ERR_NOT_FINITE);
    assert_true(fs[0] == UNTOUCHED && fs[2] == UNTOUCHED && fm[0][0] == UNTOUCHED);
}

/* ---- choice of the segment ---- */

static void check_chosen(const double *xyz, const double xs[3], int expected)
{
    int chosen = -7;
    const int status = footpoint_select_segment(xyz, 4, 4, around[0], xs, &chosen);
    if (status == FOOTPOINT_OK && chosen == expected)
        return;
    print_error("slave node %a %a %a: status %d, segment %d instead of %d\n", xs[0], xs[1], xs[2], status, chosen,
                expected);
    fail();
}

static void segments_around_are_chosen(void **state)
{
    (void)state;
    for (int k = 0; k < 4; k++) {
        const double xs[3] = {k == 0 || k == 3 ? 0.3 : -0.3, k < 2 ? 0.6 : -0.6, 0.2};
        check_chosen(patch[0], xs, k);
    }
}

/* Over an edge, the first of its two segments is chosen; over the node, the first of all. */
static void ties_choose_the_first(void **state)
{
    const double edge[4][3] = {{0, 0.5, 0.1}, {-0.5, 0, 0.1}, {0, -0.5, 0.1}, {0.5, 0, -0.1}}, node[3] = {0, 0, 0.2};
    static const int expected[4] = {0, 1, 2, 0};
    (void)state;
    for (int k = 0; k < 4; k++)
        check_chosen(patch[0], edge[k], expected[k]);
    check_chosen(patch[0], node, 0);
    check_chosen(patch[0], patch[4], 0);
}

static void turn(double axis[3][3], const double x[3], double y[3])
{
    for (int k = 0; k < 3; k++)
        y[k] = axis[0][k] * x[0] + axis[1][k] * x[1] + axis[2][k] * x[2];
}

/* Rounding must not lose a slave node over an edge, however the patch lies in space. */
static void turned_patches_lose_no_node(void **state)
{
    static const double on_edge[4][2] = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}};
    static const int expected[4] = {0, 1, 2, 0};
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i);
        const double t = 0.05 + 0.9 * (double)i / SEGMENTS, *e = on_edge[i % 4];
        const double place[3] = {t * e[0], t * e[1], 0.3}, inside[3] = {0.3 * t, -0.4 * t, 0.1};
        double axis[3][3], xyz[9][3], xs[3], length = 0;
        /* an orthonormal frame from the random segment */
        for (int k = 0; k < 3; k++) {
            axis[0][k] = q.x[1][k] - q.x[0][k];
            length += axis[0][k] * axis[0][k];
        }
        for (int k = 0; k < 3; k++)
            axis[0][k] /= sqrt(length);
        assert_int_equal(footpoint_normal(q.x[0], q.x[1], q.x[3], axis[2]), FOOTPOINT_OK);
        for (int k = 0; k < 3; k++)
            axis[1][k] = axis[2][(k + 1) % 3] * axis[0][(k + 2) % 3] - axis[2][(k + 2) % 3] * axis[0][(k + 1) % 3];
        for (int n = 0; n < 9; n++)
            turn(axis, patch[n], xyz[n]);
        turn(axis, place, xs);
        check_chosen(xyz[0], xs, expected[i % 4]);
        turn(axis, inside, xs);
        check_chosen(xyz[0], xs, 3);
    }
}

static void bad_segments_are_refused(void **state)
{
    const double xs[3] = {-0.5, -0.5, 0}, bad[3] = {0, 0, (double)INFINITY};
    static const int negative[4] = {4, -1, 8, 7}, collapsed[4] = {4, 5, 8, 5}, opposite[4] = {4, 7, -1, 3},
                     opposite_bad[4] = {4, 7, 5, 3};
    double broken[9][3];
    int chosen = -7;
    (void)state;
    for (int n = 0; n < 27; n++)
        broken[n / 3][n % 3] = n == 15 ? (double)NAN : patch[n / 3][n % 3];
    assert_int_equal(footpoint_select_segment(patch[0], 4, 2, around[0], xs, &chosen), FOOTPOINT_ERR_DOMAIN);
    assert_int_equal(footpoint_select_segment(patch[0], 4, 0, NULL, xs, &chosen), FOOTPOINT_ERR_DOMAIN);
    assert_int_equal(footpoint_select_segment(patch[0], 4, 1, collapsed, xs, &chosen), FOOTPOINT_ERR_DOMAIN);
    assert_int_equal(footpoint_select_segment(patch[0], 4, -1, around[0], xs, &chosen), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_select_segment(patch[0], -1, 4, around[0], xs, &chosen), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_select_segment(patch[0], 0, 4, around[0], xs, &chosen), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_select_segment(patch[0], 4, 1, negative, xs, &chosen), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_select_segment(patch[0], 4, 1, opposite, xs, &chosen), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_select_segment(broken[0], 4, 1, opposite_bad, xs, &chosen), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_select_segment(patch[0], 4, 4, around[0], bad, &chosen), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_select_segment(broken[0], 4, 4, around[0], xs, &chosen), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(chosen, -7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_are_right),          cmocka_unit_test(lines_have_no_normal),
        cmocka_unit_test(gaps_are_projections),       cmocka_unit_test(forces_balance),
        cmocka_unit_test(open_gaps_have_no_force),    cmocka_unit_test(bad_forces_are_refused),
        cmocka_unit_test(nodes_beside_have_no_force), cmocka_unit_test(segments_around_are_chosen),
        cmocka_unit_test(ties_choose_the_first),      cmocka_unit_test(turned_patches_lose_no_node),
        cmocka_unit_test(bad_segments_are_refused)};
    return cmocka_run_group_tests_name("contact", tests, NULL, NULL);
}
