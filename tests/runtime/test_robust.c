/* Proved answers: footpoint_certify, footpoint_robust, footpoint_stationary, footpoint_differentiate, and the statuses
 * of footpoint_locate. Hard cases against extended precision are in tests/hard/, see cli/hard.sh. */
#include "../../runtime/footpoint_face.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"
#include "../support/ordinary_quad.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SEGMENTS = 300 };

#define NODES(q) (q)->x[0], (q)->x[1], (q)->x[2], (q)->x[3], (q)->xs
#define UNTOUCHED 77.25

static double size_of(const struct quad *q)
{
    double size = 0;
    for (int k = 0; k < 3; k++)
        size = fmax(size, fabs(q->x[2][k] - q->x[0][k]));
    return size;
}

/* Returns the largest coordinate, which determines the rounding of the slave node's place. */
static double extent_of(const struct quad *q)
{
    double extent = 0;
    for (int k = 0; k < 12; k++)
        extent = fmax(extent, fabs(q->x[k / 3][k % 3]));
    return extent;
}

/* Returns the saddle z = xi eta over the square, with xS on its axis. It has two closest points if xS is farther away
 * than 1, its radius of curvature: with xi = -eta below, xi = eta above. */
static struct quad saddle(double height)
{
    const struct quad q = {{{-1, -1, 1}, {1, -1, -1}, {1, 1, 1}, {-1, 1, -1}}, {0, 0, height}, 0, 0, height};
    return q;
}

/* Finds the foot point by Newton's method in long double, from (xi,eta); x in the order A, B, C, D, S. */
static void long_foot(const long double x[15], long double z[2], long double *gap)
{
    long double a[3], b[3], d[3], n[3], length = 0;
    for (int step = 0; step < 20; step++) {
        long double aa = 0, bb = 0, ab = 0, ad = 0, bd = 0;
        for (int i = 0; i < 3; i++) {
            const long double p = x[i], q = x[3 + i], r = x[6 + i], s = x[9 + i], c = (p - q + r - s) / 4;
            a[i] = (q - p + r - s) / 4 + c * z[1];
            b[i] = (s - p + r - q) / 4 + c * z[0];
            d[i] = x[12 + i] - (p + q + r + s) / 4 - (a[i] - c * z[1]) * z[0] - b[i] * z[1];
            aa += a[i] * a[i];
            bb += b[i] * b[i];
            ab += a[i] * b[i] - c * d[i];
            ad += a[i] * d[i];
            bd += b[i] * d[i];
        }
        z[0] += (bb * ad - ab * bd) / (aa * bb - ab * ab);
        z[1] += (aa * bd - ab * ad) / (aa * bb - ab * ab);
    }
    *gap = 0;
    for (int i = 0; i < 3; i++) {
        n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        length += n[i] * n[i];
        *gap += n[i] * d[i];
    }
    *gap /= sqrtl(length);
}

/* ---- the closest point ---- */

static void closest_points_inside_are_proved(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad drawn = quad_draw(&quad_ordinary, i), q = quad_move(&drawn, i, i % 2 ? 1e-200 : 1, 2);
        double loc[2], dist;
        assert_int_equal(footpoint_robust(NODES(&q), loc, &dist), FOOTPOINT_OK);
        assert_true(fabs(loc[0] - q.xi) < 1e-11 && fabs(loc[1] - q.eta) < 1e-11);
        assert_true(fabs(dist - q.gap) < 1e-12 * size_of(&q));
    }
}

/* Above the square with corners +-1 the nearest point is obvious. */
static void points_over_a_square_are_known(void **state)
{
    const struct quad q = {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0}, 0, 0, 0};
    (void)state;
    for (int i = -6; i <= 6; i++)
        for (int j = -6; j <= 6; j++)
            for (int k = -3; k <= 3; k++) {
                const double s[3] = {i / 2.0, j / 2.0, k / 4.0}, x = fmax(-1, fmin(1, s[0])),
                             y = fmax(-1, fmin(1, s[1]));
                const double true_dist = sqrt((s[0] - x) * (s[0] - x) + (s[1] - y) * (s[1] - y) + s[2] * s[2]);
                double loc[2], dist;
                const int status = footpoint_robust(q.x[0], q.x[1], q.x[2], q.x[3], s, loc, &dist);
                assert_int_equal(status, fabs(x) < 1 && fabs(y) < 1 ? FOOTPOINT_OK : FOOTPOINT_OUTSIDE);
                assert_true(fabs(loc[0] - x) < 1e-15 && fabs(loc[1] - y) < 1e-15);
                assert_true(fabs(dist - (s[2] < 0 ? -true_dist : true_dist)) < 1e-15);
            }
}

/* Renumbered corners and transformed coordinates change (xi,eta), but not the point. */
static void renumbering_keeps_the_point(void **state)
{
    const struct quad_limits wild = {0.45, 0.6, 1.5, 2};
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&wild, i), turned = quad_turn_corners(&q), mirrored = quad_mirror_corners(&q);
        struct quad scaled = q;
        double loc[2], dist, z[2], d;
        for (int k = 0; k < 15; k++)
            *(k < 12 ? &scaled.x[k / 3][k % 3] : &scaled.xs[k % 3]) *= 0x1p-600;
        const int status = footpoint_robust(NODES(&q), loc, &dist);
        assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE);
        assert_true(fabs(loc[0]) <= 1 && fabs(loc[1]) <= 1);
        assert_int_equal(footpoint_robust(NODES(&turned), z, &d), status);
        assert_true(fabs(z[0] - loc[1]) < 1e-9 && fabs(z[1] + loc[0]) < 1e-9 && fabs(d - dist) < 1e-12 * size_of(&q));
        assert_int_equal(footpoint_robust(NODES(&mirrored), z, &d), status);
        assert_true(fabs(z[0] - loc[1]) < 1e-9 && fabs(z[1] - loc[0]) < 1e-9);
        assert_true(fabs(fabs(d) - fabs(dist)) < 1e-12 * size_of(&q));
        assert_int_equal(footpoint_robust(NODES(&scaled), z, &d), status);
        assert_true(fabs(z[0] - loc[0]) < 1e-9 && fabs(z[1] - loc[1]) < 1e-9);
        assert_true(fabs(d * 0x1p600 - dist) < 1e-12 * size_of(&q));
    }
}

static void ties_are_not_unique(void **state)
{
    double loc[2], dist;
    struct quad q = saddle(0.5);
    (void)state;
    assert_int_equal(footpoint_robust(NODES(&q), loc, &dist), FOOTPOINT_OK);
    assert_true(loc[0] == 0 && loc[1] == 0 && dist == 0.5);
    for (int side = -1; side <= 1; side += 2) {
        q = saddle(side * 1.5);
        assert_int_equal(footpoint_robust(NODES(&q), loc, &dist), FOOTPOINT_NOT_UNIQUE);
        assert_true(fabs(loc[0] - side * loc[1]) < 1e-12);
        assert_true(fabs(loc[0] * loc[0] - 0.5) < 1e-12); /* 2 t^2 + (1.5 - t^2)^2 is least at t^2 = 1/2 */
        assert_true(fabs(dist - side * sqrt(2)) < 1e-12);
    }
}

/* Folded, concave and crossing segments, nearly plane, with the slave node on them. Another sheet is 1e-4 to 1e-6 edges
 * away, so double precision does not separate stationary points. */
static void nearly_plane_folds_are_decided(void **state)
{
    (void)state;
    for (int flat = 4; flat <= 6; flat++) {
        const struct quad_limits folded = {1.5, pow(10, -flat), 0, 1};
        for (uint64_t i = 0; i < 100 * SEGMENTS; i++) {
            const struct quad q = quad_draw(&folded, i);
            double loc[2], dist;
            const int status = footpoint_robust(NODES(&q), loc, &dist);
            assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE);
            assert_true(fabs(dist) < 1e-11 * extent_of(&q));
        }
    }
}

static void segments_without_area_have_statuses(void **state)
{
    const double a[3] = {0, 0, 0}, b[3] = {1, 1, 1}, c[3] = {3, 3, 3}, s[3] = {3, 3, 0}, far[3] = {1e30, 0, 0};
    double loc[2] = {UNTOUCHED, UNTOUCHED}, dist = UNTOUCHED;
    (void)state;
    assert_int_equal(footpoint_robust(a, b, c, b, s, loc, &dist), FOOTPOINT_NO_AREA);
    assert_true(fabs(dist - sqrt(6)) < 1e-12); /* from (2,2,2) */
    assert_int_equal(footpoint_robust(b, b, b, b, s, loc, &dist), FOOTPOINT_NO_AREA);
    assert_true(loc[0] == 0 && loc[1] == 0 && dist == 3);
    loc[0] = loc[1] = dist = UNTOUCHED;
    assert_int_equal(footpoint_robust(a, b, c, b, far, loc, &dist), FOOTPOINT_ERR_DOMAIN);
    assert_true(loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && dist == UNTOUCHED);
    /* corners on a line, xS beside it or beyond its end */
    static const double along[3] = {-2, 1, 3};
    uint64_t stream = 1;
    for (int i = 0; i < 3000; i++) {
        struct quad q = {{{0}}, {0}, 0, 0, 0};
        double least = 0;
        int low = 9, high = -9;
        for (int k = 0; k < 7; k++) {
            stream = stream * 6364136223846793005u + 1442695040888963407u;
            const int step = (int)(stream >> 40) % 9 - 4;
            if (k >= 4)
                q.xs[k - 4] = 3 * step;
            low = k < 4 && step < low ? step : low;
            high = k < 4 && step > high ? step : high;
            for (int j = 0; k < 4 && j < 3; j++)
                q.x[k][j] = step * along[j];
        }
        const double at = (along[0] * q.xs[0] + along[1] * q.xs[1] + along[2] * q.xs[2]) / 14;
        const double t = at < low ? low : at > high ? high : at;
        for (int j = 0; j < 3; j++)
            least += (q.xs[j] - t * along[j]) * (q.xs[j] - t * along[j]);
        assert_int_equal(footpoint_robust(NODES(&q), loc, &dist), FOOTPOINT_NO_AREA);
        assert_true(fabs(dist - sqrt(least)) < 1e-9);
    }
    const double tiny[3] = {0x1p-1074, 0, 0};
    assert_int_equal(footpoint_robust(a, a, a, a, tiny, loc, &dist), FOOTPOINT_NO_AREA);
    assert_true(dist == 0x1p-1074);
}

static void bad_numbers_are_refused(void **state)
{
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    (void)state;
    for (int k = 0; k < 45; k++) {
        struct quad q = quad_draw(&quad_ordinary, (uint64_t)k);
        struct footpoint_derivatives derivatives;
        double loc[2] = {UNTOUCHED, UNTOUCHED}, dist = UNTOUCHED, at[2] = {0, 0}, rho[2] = {UNTOUCHED, UNTOUCHED};
        double points[FOOTPOINT_STATIONARY_MOST][2];
        int count = -7;
        *(k % 15 < 12 ? &q.x[k % 15 / 3][k % 3] : &q.xs[k % 3]) = bad[k / 15];
        assert_int_equal(footpoint_robust(NODES(&q), loc, &dist), FOOTPOINT_ERR_NOT_FINITE);
        assert_int_equal(footpoint_certify(NODES(&q), at, rho), FOOTPOINT_ERR_NOT_FINITE);
        assert_int_equal(footpoint_stationary(NODES(&q), points, &count), FOOTPOINT_ERR_NOT_FINITE);
        assert_int_equal(footpoint_differentiate(NODES(&q), at, &derivatives), FOOTPOINT_ERR_NOT_FINITE);
        assert_true(loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && dist == UNTOUCHED);
        assert_true(rho[0] == UNTOUCHED && rho[1] == UNTOUCHED && count == -7);
    }
}

static int is_on_edge(int corners, const double loc[2])
{
    if (corners == 3)
        return loc[0] <= 0 || loc[1] <= 0 || loc[0] + loc[1] >= 1;
    return fabs(loc[0]) >= 1 || fabs(loc[1]) >= 1;
}

/* For slave nodes over edges, or beside them by less than rounding, the status is OUTSIDE, with a region, if and only
 * if loc is on an edge. */
static void statuses_match_the_region(void **state)
{
    static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    static const double three[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    uint64_t stream = 3;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++)
        for (int i = 0; i < 10 * SEGMENTS; i++) {
            const int nodes = footpoint_face_nodes(face), corners = face <= FOOTPOINT_TRI6 ? 3 : 4, a = i % corners;
            double x[30], loc[2], at[2], dist, d, part[2];
            int region;
            for (int k = 0; k < 2; k++) {
                stream = stream * 6364136223846793005u + 1442695040888963407u;
                part[k] = (double)(stream >> 11) * 0x1p-53;
            }
            for (int n = 0; n < nodes; n++) {
                const double *const p = corners == 3 ? three[n] : square[n];
                x[3 * n] = p[0] + 0.2 * p[1];
                x[3 * n + 1] = p[1] - 0.1 * p[0];
                x[3 * n + 2] = i % 2 ? 0.05 * p[0] * p[1] : 0;
            }
            const double off = i % 3 ? ldexp(part[1] - 0.5, -20 - i % 37) : 0;
            for (int k = 0; k < 3; k++) {
                const double p = x[3 * a + k], q = x[3 * ((a + 1) % corners) + k];
                x[3 * nodes + k] = p + (i % 5 ? part[0] : 0) * (q - p) + (k < 2 ? off : 0.1 * (i % 4));
            }
            const int status = footpoint_face_robust(face, x, loc, &dist, &region), on = is_on_edge(corners, loc);
            assert_int_equal(status, on ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK);
            assert_int_equal(region != 0, on);
            if (face != FOOTPOINT_QUAD4)
                continue;
            assert_int_equal(footpoint_robust(x, x + 3, x + 6, x + 9, x + 12, at, &d), status);
            assert_true(at[0] == loc[0] && at[1] == loc[1] && d == dist);
        }
}

/* ---- proofs ---- */

static void foot_points_are_certified(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i);
        const double off = pow(10, -(double)(i % 13));
        double loc[2] = {q.xi, q.eta}, rho[2];
        assert_int_equal(footpoint_certify(NODES(&q), loc, rho), FOOTPOINT_OK);
        assert_true(rho[0] < 1e-11 && rho[1] < 1e-11);
        loc[0] += off * 0.01;
        loc[1] -= off * 0.02;
        assert_int_equal(footpoint_certify(NODES(&q), loc, rho), FOOTPOINT_OK);
        assert_true(fabs(loc[0] - q.xi) <= rho[0] && fabs(loc[1] - q.eta) <= rho[1]);
        assert_true(rho[0] < off + 1e-11 && rho[1] < off + 1e-11);
    }
}

static void wrong_points_are_not_certified(void **state)
{
    const struct quad focal = saddle(1), q = saddle(0.5);
    const double centre[2] = {0, 0}, away[2] = {3, -2}, bad[2] = {0, (double)NAN};
    double rho[2] = {UNTOUCHED, UNTOUCHED};
    (void)state;
    assert_int_equal(footpoint_certify(NODES(&focal), centre, rho), FOOTPOINT_ERR_UNPROVED);
    assert_int_equal(footpoint_certify(NODES(&q), away, rho), FOOTPOINT_ERR_UNPROVED);
    assert_int_equal(footpoint_certify(NODES(&q), bad, rho), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_certify(q.xs, q.xs, q.xs, q.xs, q.x[0], centre, rho), FOOTPOINT_ERR_DEGENERATE);
    assert_true(rho[0] == UNTOUCHED && rho[1] == UNTOUCHED);
}

/* The answer is as accurate as the banner claims, or has another status. */
static void located_points_are_as_accurate_as_claimed(void **state)
{
    const struct quad_limits wild = {0.3, 0.4, 1, 1.5};
    int answered = 0;
    (void)state;
    for (uint64_t i = 0; i < 10 * SEGMENTS; i++) {
        const struct quad q = quad_draw(&wild, i);
        double loc[2] = {UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED;
        long double x[15], z[2], long_gap;
        const int status = footpoint_locate(NODES(&q), loc, &gap);
        if (status != FOOTPOINT_OK) {
            assert_int_equal(status, FOOTPOINT_ERR_DOMAIN);
            assert_true(loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && gap == UNTOUCHED);
            continue;
        }
        answered++;
        for (int k = 0; k < 15; k++)
            x[k] = k < 12 ? q.x[k / 3][k % 3] : q.xs[k % 3];
        z[0] = loc[0];
        z[1] = loc[1];
        long_foot(x, z, &long_gap);
        assert_true(fabsl(z[0] - loc[0]) <= 3.351e-4L && fabsl(z[1] - loc[1]) <= 3.351e-4L);
    }
    assert_in_range(answered, 5 * SEGMENTS, 10 * SEGMENTS - 1);
}

/* ---- stationary points ---- */

static int compare(const void *a, const void *b)
{
    const double *const p = a, *const q = b;
    return (p[0] > q[0]) - (p[0] < q[0]);
}

static void all_stationary_points_are_found(void **state)
{
    double z[FOOTPOINT_STATIONARY_MOST][2];
    int count;
    struct quad q = saddle(1.5);
    (void)state;
    assert_int_equal(footpoint_stationary(NODES(&q), z, &count), FOOTPOINT_OK);
    assert_int_equal(count, 3);
    qsort(z, 3, sizeof *z, compare);
    for (int k = 0; k < 3; k++)
        assert_true(fabs(z[k][0] - (k - 1) * sqrt(0.5)) < 1e-12 && fabs(z[k][1] - z[k][0]) < 1e-12);
    for (int k = 2; k <= 44; k++) { /* one becomes three: 2 t^2 + (1 + e - t^2)^2 is stationary at 0 and t^2 = e */
        const double e = ldexp(1, -k);
        q = saddle(1 + e);
        assert_int_equal(footpoint_stationary(NODES(&q), z, &count), FOOTPOINT_OK);
        assert_int_equal(count, 3);
        qsort(z, 3, sizeof *z, compare);
        for (int i = 0; i < 3; i++)
            assert_true(fabs(z[i][0] - (i - 1) * sqrt(e)) < 1e-14 && fabs(z[i][1] - z[i][0]) < 1e-14);
    }
    q = saddle(0.5);
    assert_int_equal(footpoint_stationary(NODES(&q), z, &count), FOOTPOINT_OK);
    assert_int_equal(count, 1);
    q.xs[0] = 40;
    assert_int_equal(footpoint_stationary(NODES(&q), z, &count), FOOTPOINT_OK);
    assert_int_equal(count, 0);
}

/* ---- derivatives ---- */

static void derivatives_match_differences(void **state)
{
    const struct quad_limits warped = {0.2, 0.2, 0.3, 1.2};
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&warped, i);
        const double size = size_of(&q), loc[2] = {q.xi, q.eta};
        struct footpoint_derivatives o;
        double phi[4], sum[3] = {0, 0, 0};
        assert_int_equal(footpoint_differentiate(NODES(&q), loc, &o), FOOTPOINT_OK);
        assert_true(fabs(o.gap - q.gap) < 1e-12 * size);
        footpoint_quad4_shape(loc[0], loc[1], phi);
        assert_memory_equal(phi, o.phi, sizeof phi);
        for (int k = 0; k < 15; k++) {
            const long double h = 1e-5L * size;
            long double f[2][3];
            for (int side = 0; side < 2; side++) {
                long double x[15];
                for (int j = 0; j < 15; j++)
                    x[j] = (j < 12 ? q.x[j / 3][j % 3] : q.xs[j % 3]) + (j == k ? (side ? h : -h) : 0);
                f[side][0] = loc[0];
                f[side][1] = loc[1];
                long_foot(x, f[side], &f[side][2]);
            }
            assert_true(fabsl((f[1][0] - f[0][0]) / (2 * h) - o.d_xi[k]) * size < 1e-7L);
            assert_true(fabsl((f[1][1] - f[0][1]) / (2 * h) - o.d_eta[k]) * size < 1e-7L);
            assert_true(fabsl((f[1][2] - f[0][2]) / (2 * h) - o.d_gap[k]) < 1e-8L);
            sum[0] += k % 3 == 0 ? o.d_xi[k] * size : 0;
            sum[1] += k % 3 == 1 ? o.d_eta[k] * size : 0;
            sum[2] += k % 3 == 2 ? o.d_gap[k] : 0;
        }
        for (int k = 0; k < 3; k++) /* moving all five nodes changes nothing */
            assert_true(fabs(sum[k]) < 1e-11);
    }
}

static void singular_derivatives_are_refused(void **state)
{
    const struct quad focal = saddle(1);
    const double a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {2, 0, 0}, centre[2] = {0, 0};
    struct footpoint_derivatives o;
    (void)state;
    assert_int_equal(footpoint_differentiate(NODES(&focal), centre, &o), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(footpoint_differentiate(a, b, c, b, focal.xs, centre, &o), FOOTPOINT_ERR_DEGENERATE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_points_inside_are_proved),
        cmocka_unit_test(points_over_a_square_are_known),
        cmocka_unit_test(renumbering_keeps_the_point),
        cmocka_unit_test(ties_are_not_unique),
        cmocka_unit_test(nearly_plane_folds_are_decided),
        cmocka_unit_test(segments_without_area_have_statuses),
        cmocka_unit_test(statuses_match_the_region),
        cmocka_unit_test(bad_numbers_are_refused),
        cmocka_unit_test(foot_points_are_certified),
        cmocka_unit_test(wrong_points_are_not_certified),
        cmocka_unit_test(located_points_are_as_accurate_as_claimed),
        cmocka_unit_test(all_stationary_points_are_found),
        cmocka_unit_test(derivatives_match_differences),
        cmocka_unit_test(singular_derivatives_are_refused),
    };
    return cmocka_run_group_tests_name("robust", tests, NULL, NULL);
}
