/* The choice of a segment by distance, against all stationary points and edges, on random fans of segments around a
 * node: ridges, valleys, reflex nodes, three to nine segments, edge and corner hits. And forces that balance. */
#include "../../evolve/surface/foot_bilinear.h"
#include "../../runtime/footpoint.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"
#include "../support/ordinary_quad.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOST = 9, FANS = 3000, QUADS = 4000 };

static uint64_t seed;

static double uniform(double low, double high)
{
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * ((double)(seed >> 11) / 9007199254740992.0);
}

static double distance_between(const double a[3], const double b[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(sum);
}

static double distance_to_edge(const double p[3], const double q[3], const double s[3])
{
    double way = 0, square = 0, at[3];
    for (int k = 0; k < 3; k++) {
        way += (s[k] - p[k]) * (q[k] - p[k]);
        square += (q[k] - p[k]) * (q[k] - p[k]);
    }
    way = square > 0 ? fmin(fmax(way / square, 0), 1) : 0;
    for (int k = 0; k < 3; k++)
        at[k] = p[k] + way * (q[k] - p[k]);
    return distance_between(s, at);
}

/* Returns the least distance of all stationary points inside and of the edges. */
static double true_distance(const double x[4][3], const double s[3])
{
    struct stationary found[5];
    double least = (double)INFINITY;
    const int n = foot_bilinear_stationary(x, s, found);
    for (int i = 0; i < n; i++)
        if (fabs(found[i].xi) <= 1 && fabs(found[i].eta) <= 1)
            least = fmin(least, found[i].distance);
    for (int k = 0; k < 4; k++)
        least = fmin(least, distance_to_edge(x[k], x[(k + 1) % 4], s));
    return least;
}

static void closest_points_are_nearest(void **state)
{
    static const struct quad_limits hard = {0.45, 0.8, 3, 3};
    (void)state;
    for (uint64_t i = 0; i < QUADS; i++) {
        struct quad q = quad_draw(i % 2 ? &hard : &quad_ordinary, i);
        double at[2], r[3];
        if (i % 8 == 1)
            memcpy(q.x[i / 8 % 4], q.x[(i / 8 + 1) % 4], sizeof q.x[0]);
        const double size = distance_between(q.x[0], q.x[2]) + distance_between(q.x[1], q.x[3]);
        double d = -1;
        (void)footpoint_robust(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, at, &d);
        d = fabs(d);
        const double truth = true_distance((const double(*)[3])q.x, q.xs);
        assert_true(fabs(at[0]) <= 1 && fabs(at[1]) <= 1);
        footpoint_quad4_position(q.x[0], q.x[1], q.x[2], q.x[3], at[0], at[1], r);
        assert_true(fabs(distance_between(r, q.xs) - d) <= 1e-13 * (size + d));
        if (fabs(d - truth) <= 1e-10 * (size + truth))
            continue;
        print_error("segment %d: %g at %g %g instead of %g\n", (int)i, d, at[0], at[1], truth);
        fail();
    }
}

/* ---- fans ---- */

/* Node 0 in the middle; segment s has the nodes 0, 1 + 2 s, 2 + 2 s, 3 + 2 s around, its corners turned at random. */
struct fan {
    int segments, seg[MOST][4];
    double xyz[1 + 2 * MOST][3];
};

static struct fan fan_draw(double height, double crooked)
{
    struct fan f = {.segments = 3 + (int)uniform(0, MOST - 2.001)};
    const int rim = 2 * f.segments;
    for (int i = 0; i < rim; i++) {
        const double angle = 6.283185307179586 * (i + uniform(-crooked, crooked)) / rim;
        const double radius = (i % 2 ? 1.4 : 1) * uniform(0.8, 1.2);
        f.xyz[1 + i][0] = radius * cos(angle);
        f.xyz[1 + i][1] = radius * sin(angle);
        f.xyz[1 + i][2] = uniform(-height, height);
    }
    for (int s = 0; s < f.segments; s++) {
        const int turn = (int)uniform(0, 3.999), node[4] = {0, 1 + 2 * s, 2 + 2 * s, 1 + (2 * s + 2) % rim};
        for (int k = 0; k < 4; k++)
            f.seg[s][(k + turn) % 4] = node[k];
    }
    return f;
}

static double fan_distance(const struct fan *f, int s, const double xs[3])
{
    double x[4][3];
    for (int k = 0; k < 4; k++)
        memcpy(x[k], f->xyz[f->seg[s][k]], sizeof x[k]);
    return true_distance((const double(*)[3])x, xs);
}

static void fans_choose_the_nearest(void **state)
{
    int missed = 0, other = 0;
    (void)state;
    seed = 11;
    for (int n = 0; n < FANS; n++) {
        const struct fan f = fan_draw(n % 4 * 0.5, 0.3);
        const double xs[3] = {uniform(-0.7, 0.7), uniform(-0.7, 0.7), uniform(-1, 1)};
        double least = (double)INFINITY, distance = -1;
        int chosen = -1, by_angle = -1;
        for (int s = 0; s < f.segments; s++)
            least = fmin(least, fan_distance(&f, s, xs));
        assert_int_equal(footpoint_select_closest(f.xyz[0], 0, f.segments, f.seg[0], xs, &chosen, &distance), 0);
        assert_true(fabs(distance - least) <= 1e-11 && fabs(fan_distance(&f, chosen, xs) - least) <= 1e-11);
        if (footpoint_select_segment(f.xyz[0], 0, f.segments, f.seg[0], xs, &by_angle) != FOOTPOINT_OK)
            missed++;
        else if (fan_distance(&f, by_angle, xs) > least + 1e-9)
            other++;
        else if (n % 4 == 0) /* a plane fan: one answer */
            assert_int_equal(chosen, by_angle);
    }
    /* enough fans distinguish the methods */
    assert_true(missed > FANS / 50 && other > FANS / 50);
}

/* On a shared edge, above the middle node, and outside of a ridge or a corner, any order of the segments has the same
 * distance, and the first of equals is chosen. */
static void order_keeps_distances_on_edges(void **state)
{
    (void)state;
    seed = 12;
    for (int n = 0; n < 500; n++) {
        struct fan f = fan_draw(0, 0.3);
        const int shared = (int)uniform(0, f.segments - 0.001), before = (shared + f.segments - 1) % f.segments;
        const double way = n % 2 ? uniform(0.1, 0.9) : 0, up = n % 3 * 0.2;
        const double *const end = f.xyz[1 + 2 * shared];
        const double xs[3] = {way * end[0], way * end[1], up};
        int chosen = -1;
        double distance = -1;
        assert_int_equal(footpoint_select_closest(f.xyz[0], 0, f.segments, f.seg[0], xs, &chosen, &distance), 0);
        assert_true(fabs(distance - up) <= 1e-14);
        assert_int_equal(chosen, n % 2 ? (shared < before ? shared : before) : 0);
    }
    /* The corner of a cube, seen from outside along its diagonal: (3), (4) find no segment. */
    static const double cube[7][3] = {{0, 0, 0},   {-1, 0, 0},  {0, -1, 0}, {0, 0, -1},
                                      {-1, -1, 0}, {0, -1, -1}, {-1, 0, -1}};
    static const int faces[3][4] = {{0, 1, 4, 2}, {0, 2, 5, 3}, {0, 3, 6, 1}};
    const double xs[3] = {0.3, 0.3, 0.3}, ridge[3] = {0.2, 0.2, -0.4};
    int chosen = -1;
    double distance = -1;
    assert_int_equal(footpoint_select_segment(cube[0], 0, 3, faces[0], xs, &chosen), FOOTPOINT_ERR_DOMAIN);
    assert_int_equal(footpoint_select_closest(cube[0], 0, 3, faces[0], xs, &chosen, &distance), FOOTPOINT_OK);
    assert_true(chosen == 0 && fabs(distance - 0.3 * sqrt(3)) < 1e-15);
    assert_int_equal(footpoint_select_closest(cube[0], 0, 3, faces[0], ridge, &chosen, NULL), FOOTPOINT_OK);
    assert_int_equal(chosen, 1);
}

/* Both choices work in any unit of length from 1e-300 to 1e300. */
static void any_unit_has_the_same_choice(void **state)
{
    (void)state;
    seed = 15;
    for (int n = 0; n < 100; n++) {
        const struct fan f = fan_draw(n % 4 * 0.5, 0.3);
        const double xs[3] = {uniform(-0.7, 0.7), uniform(-0.7, 0.7), uniform(-1, 1)};
        double least = -1;
        int by_angle = -1, by_distance = -1;
        const int status = footpoint_select_segment(f.xyz[0], 0, f.segments, f.seg[0], xs, &by_angle);
        assert_int_equal(footpoint_select_closest(f.xyz[0], 0, f.segments, f.seg[0], xs, &by_distance, &least), 0);
        for (int power = -990; power <= 990; power += 90) {
            struct fan g = f;
            double x[3], distance = -1;
            int chosen = -1;
            for (int k = 0; k < 3 * (1 + 2 * MOST); k++)
                g.xyz[k / 3][k % 3] = ldexp(f.xyz[k / 3][k % 3], power);
            for (int k = 0; k < 3; k++)
                x[k] = ldexp(xs[k], power);
            assert_int_equal(footpoint_select_segment(g.xyz[0], 0, g.segments, g.seg[0], x, &chosen), status);
            assert_int_equal(chosen, by_angle);
            assert_int_equal(footpoint_select_closest(g.xyz[0], 0, g.segments, g.seg[0], x, &chosen, &distance), 0);
            assert_int_equal(chosen, by_distance);
            assert_true(fabs(ldexp(distance, -power) - least) <= 1e-11);
        }
    }
}

static void bad_arguments_are_refused(void **state)
{
    seed = 13;
    (void)state;
    struct fan f = fan_draw(0.2, 0.1);
    const double xs[3] = {0.1, 0.2, 0.3}, bad[3] = {0, (double)NAN, 0};
    int chosen = -7;
    double distance = -7;
    assert_int_equal(footpoint_select_closest(f.xyz[0], 0, 0, NULL, xs, &chosen, &distance), FOOTPOINT_ERR_DOMAIN);
    assert_int_equal(footpoint_select_closest(f.xyz[0], -1, 3, f.seg[0], xs, &chosen, &distance),
                     FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_select_closest(f.xyz[0], 2, 3, f.seg[0], xs, &chosen, &distance),
                     FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_select_closest(f.xyz[0], 0, 3, f.seg[0], bad, &chosen, &distance),
                     FOOTPOINT_ERR_NOT_FINITE);
    f.xyz[2][1] = (double)INFINITY; /* opposite node 0 */
    assert_int_equal(footpoint_select_closest(f.xyz[0], 0, 3, f.seg[0], xs, &chosen, &distance),
                     FOOTPOINT_ERR_NOT_FINITE);
    for (int k = 0; k < 4; k++)
        if (f.seg[0][k] == 2)
            f.seg[0][k] = -1;
    assert_int_equal(footpoint_select_closest(f.xyz[0], 0, 3, f.seg[0], xs, &chosen, &distance),
                     FOOTPOINT_ERR_ARGUMENT);
    assert_true(chosen == -7 && distance == -7);
}

/* ---- forces ---- */

/* Computes the largest component of the sum of the five forces, and of their moments about a node. */
static void balance(const struct quad *q, const double fs[3], const double fm[4][3], double *force, double *moment)
{
    *force = *moment = 0;
    for (int k = 0; k < 3; k++) {
        const int u = (k + 1) % 3, v = (k + 2) % 3;
        double f = fs[k], m = (q->xs[u] - q->x[0][u]) * fs[v] - (q->xs[v] - q->x[0][v]) * fs[u];
        for (int i = 0; i < 4; i++) {
            f += fm[i][k];
            m += (q->x[i][u] - q->x[0][u]) * fm[i][v] - (q->x[i][v] - q->x[0][v]) * fm[i][u];
        }
        *force = fmax(*force, fabs(f));
        *moment = fmax(*moment, fabs(m));
    }
}

static void forces_balance(void **state)
{
    static const struct quad_limits deep = {0.3, 0.3, 0.5, 1.2};
    const double k = 250;
    int pressed = 0;
    (void)state;
    seed = 14;
    for (uint64_t i = 0; i < QUADS; i++) {
        const struct quad ordinary = quad_draw(&deep, i), q = quad_move(&ordinary, i, 1, i % 2 ? 0 : 1e6);
        const double *A = q.x[0], *B = q.x[1], *C = q.x[2], *D = q.x[3];
        /* the foot point, a point off it, and a point clamped to the segment */
        double loc[2] = {q.xi, q.eta}, fs[3], fm[4][3], force, moment, largest = 0;
        for (int c = 0; c < 2; c++)
            loc[c] = i % 3 == 0 ? loc[c] : i % 3 == 1 ? loc[c] + uniform(-0.3, 0.3) : fmin(fmax(loc[c], -1), 1);
        const double size = distance_between(A, C) + distance_between(B, D) + distance_between(A, q.xs);
        assert_int_equal(footpoint_force_balanced(A, B, C, D, q.xs, loc, k, fs, fm), FOOTPOINT_OK);
        for (int c = 0; c < 3; c++)
            largest = fmax(largest, fabs(fs[c]));
        pressed += largest > 0;
        balance(&q, fs, (const double(*)[3])fm, &force, &moment);
        assert_true(force <= 4 * DBL_EPSILON * largest);
        assert_true(moment <= 64 * DBL_EPSILON * largest * size);
    }
    assert_true(pressed > QUADS / 4 && pressed < QUADS * 3 / 4);
}

/* At the exact foot point they are (10), (11) with the normal there, and gradients of the energy k gap^2 / 2. */
static void forces_are_gradients_of_the_energy(void **state)
{
    static const struct quad_limits soft = {0.15, 0.1, 0.1, 0.9};
    const double k = 250;
    (void)state;
    for (uint64_t i = 0; i < 500; i++) {
        struct quad q = quad_draw(&soft, i);
        double *node[5] = {q.x[0], q.x[1], q.x[2], q.x[3], q.xs}, loc[2], n[3], gap, fs[3], fm[4][3], fs2[3], fm2[4][3];
        const double size = distance_between(q.x[0], q.x[2]), h = 1e-5 * size;
        if (q.gap > 0)
            continue;
        const int found = footpoint_newton(node[0], node[1], node[2], node[3], q.xs, 30, 1e-14, loc, &gap, NULL);
        assert_int_equal(found, FOOTPOINT_OK);
        assert_int_equal(footpoint_quad4_normal(node[0], node[1], node[2], node[3], loc[0], loc[1], n), FOOTPOINT_OK);
        assert_int_equal(footpoint_force(gap, k, n, loc, fs, fm), FOOTPOINT_OK);
        assert_int_equal(footpoint_force_balanced(node[0], node[1], node[2], node[3], q.xs, loc, k, fs2, fm2),
                         FOOTPOINT_OK);
        for (int j = 0; j < 15; j++) {
            const double f = j < 12 ? fm[j / 3][j % 3] : fs[j % 3], f2 = j < 12 ? fm2[j / 3][j % 3] : fs2[j % 3];
            double energy[2];
            assert_true(fabs(f - f2) <= 1e-12 * k * size);
            for (int side = 0; side < 2; side++) {
                double *const x = &node[j / 3][j % 3], old = *x, at[2], g;
                *x += side ? h : -h;
                assert_int_equal(footpoint_newton(node[0], node[1], node[2], node[3], q.xs, 30, 1e-13, at, &g, NULL),
                                 0);
                *x = old;
                energy[side] = 0.5 * k * g * g;
            }
            assert_true(fabs(-(energy[1] - energy[0]) / (2 * h) - f2) <= 1e-6 * k * size);
        }
    }
}

static void bad_forces_are_refused(void **state)
{
    const double A[3] = {0, 0, 0}, B[3] = {1, 0, 0}, C[3] = {1, 1, 0}, D[3] = {0, 1, 0}, S[3] = {0.5, 0.5, -0.1};
    const double loc[2] = {0, 0}, bad[3] = {0, (double)NAN, 0};
    double fs[3] = {7, 7, 7}, fm[4][3] = {{7}};
    (void)state;
    assert_int_equal(footpoint_force_balanced(A, B, C, bad, S, loc, 1, fs, fm), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_force_balanced(A, B, C, D, bad, loc, 1, fs, fm), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_force_balanced(A, B, C, D, S, bad, 1, fs, fm), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_force_balanced(A, B, C, D, S, loc, -1, fs, fm), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_force_balanced(A, B, B, A, S, loc, 1, fs, fm), FOOTPOINT_ERR_DEGENERATE);
    assert_true(fs[0] == 7 && fs[2] == 7 && fm[0][0] == 7);
    assert_int_equal(footpoint_force_balanced(A, B, C, D, S, loc, 10, fs, fm), FOOTPOINT_OK);
    assert_true(fs[0] == 0 && fs[1] == 0 && fs[2] == 1 && fm[2][2] == -0.25);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_points_are_nearest),         cmocka_unit_test(fans_choose_the_nearest),
        cmocka_unit_test(order_keeps_distances_on_edges),     cmocka_unit_test(any_unit_has_the_same_choice),
        cmocka_unit_test(bad_arguments_are_refused),          cmocka_unit_test(forces_balance),
        cmocka_unit_test(forces_are_gradients_of_the_energy), cmocka_unit_test(bad_forces_are_refused)};
    return cmocka_run_group_tests_name("select", tests, NULL, NULL);
}
