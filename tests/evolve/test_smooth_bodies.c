/* Smooth bodies and their meshes: exact geometry, the distance of smoothed surfaces from it, and node normals (44). */
#include "../../evolve/common/stream.h"
#include "../../evolve/samples/bodies.h"
#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../../runtime/geometry/footpoint-node-normals.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct footpoint_gregory patch_of(double x[4][3], double n[4][3])
{
    struct footpoint_gregory g;
    assert_int_equal(footpoint_gregory_points((const double(*)[3])x, (const double(*)[3])n, &g), FOOTPOINT_OK);
    return g;
}

struct deviation {
    double gregory, exact, facet; /* largest distance from the body: with (44), with exact normals, of facets */
};

static double distance_from(enum smooth_kind kind, const double r[3])
{
    double foot[3], normal[3];
    return fabs(smooth_project(kind, r, foot, normal));
}

static struct deviation deviation_of(enum smooth_kind kind, int n)
{
    struct smooth_mesh *m = smooth_mesh_new(kind, n, 0, 1);
    struct deviation most = {0};
    for (size_t i = 0; i < m->segments; i++) {
        double x[4][3], normal[4][3];
        smooth_segment(m, i, m->exact, x, normal);
        const struct footpoint_gregory exact = patch_of(x, normal);
        smooth_segment(m, i, m->mean, x, normal);
        const struct footpoint_gregory g = patch_of(x, normal);
        for (int k = 0; k < 81; k++) {
            const double xi = k / 9 / 4.0 - 1, eta = k % 9 / 4.0 - 1;
            double r[3];
            footpoint_gregory_position(&g, xi, eta, r);
            most.gregory = fmax(most.gregory, distance_from(kind, r));
            footpoint_gregory_position(&exact, xi, eta, r);
            most.exact = fmax(most.exact, distance_from(kind, r));
            footpoint_quad4_position(x[0], x[1], x[2], x[3], xi, eta, r);
            most.facet = fmax(most.facet, distance_from(kind, r));
        }
    }
    smooth_mesh_free(m);
    return most;
}

/* With exact normals the distance falls with the fourth power of the segments' width; for facets with the second power.
 * The bounds are the results of tests/bench/bench_gregory_main.c, rounded up. */
static void distances_fall_with_the_fourth_power(void **state)
{
    (void)state;
    static const struct {
        enum smooth_kind kind;
        int n;
        struct deviation bound;
    } body[] = {{SMOOTH_SPHERE, 8, {4.6e-4, 9.0e-5, 9.4e-3}},
                {SMOOTH_TORUS, 16, {4.0e-4, 4.0e-4, 1.4e-2}},
                {SMOOTH_SADDLE, 8, {3.1e-3, 6.8e-5, 6.2e-3}},
                {SMOOTH_SHEET, 16, {1.6e-3, 4.5e-4, 8.2e-3}}};
    for (size_t i = 0; i < sizeof body / sizeof *body; i++) {
        const struct deviation d = deviation_of(body[i].kind, body[i].n),
                               fine = deviation_of(body[i].kind, 2 * body[i].n);
        assert_true(d.gregory <= body[i].bound.gregory && d.exact <= body[i].bound.exact);
        assert_true(d.facet >= body[i].bound.facet);
        assert_true(d.exact / fine.exact > 8 && d.facet / fine.facet < 5);
    }
}

/* Exact normals agree with difference quotients and with the closest point's normal. */
static void projections_match_differences(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    stream_key(rng, 12, 0, 0, 0);
    for (int kind = 0; kind < SMOOTH_KINDS; kind++) {
        struct smooth_mesh *m = smooth_mesh_new((enum smooth_kind)kind, 12, 0.2, 3);
        for (size_t i = 0; i < m->nodes; i++) {
            const double height = gsl_ran_flat(rng, -0.05, 0.05);
            double x[3], foot[3], n[3], aside[3], dot = 0;
            for (int k = 0; k < 3; k++)
                x[k] = m->xyz[i][k] + height * m->exact[i][k];
            assert_true(fabs(smooth_project(m->kind, x, foot, n) - height) < 1e-14);
            for (int k = 0; k < 3; k++) {
                assert_true(fabs(foot[k] - m->xyz[i][k]) < 1e-14 && fabs(n[k] - m->exact[i][k]) < 1e-14);
                x[k] = m->xyz[i][k] + gsl_ran_flat(rng, -1e-4, 1e-4);
                dot += m->exact[i][k] * m->mean[i][k];
            }
            smooth_project(m->kind, x, aside, n);
            double out = 0;
            for (int k = 0; k < 3; k++)
                out += (aside[k] - m->xyz[i][k]) * m->exact[i][k];
            assert_true(fabs(out) < 1e-6 && dot > 0.9);
        }
        smooth_mesh_free(m);
    }
    gsl_rng_free(rng);
}

/* (44): known normals, nodes without a normal, indices out of range. */
static void node_normals_are_known(void **state)
{
    (void)state;
    /* A roof, its two slopes of different width, and a separate node. */
    const double xyz[7][3] = {{0, 0, 0}, {3, 0, 3}, {4, 0, 2}, {0, 1, 0}, {3, 1, 3}, {4, 1, 2}, {9, 9, 9}};
    int seg[2][4] = {{0, 1, 4, 3}, {1, 2, 5, 4}};
    double n[7][3];
    assert_int_equal(footpoint_node_normals(7, xyz[0], 2, seg[0], n[0]), FOOTPOINT_OK);
    /* Areas 3 (-1,0,1) + 1 (1,0,1) = (-2,0,4). */
    for (int i = 1; i <= 4; i += 3) {
        assert_true(fabs(n[i][0] + 2 / sqrt(20)) < 1e-15 && n[i][1] == 0 && fabs(n[i][2] - 4 / sqrt(20)) < 1e-15);
        assert_true(fabs(n[i - 1][0] + n[i - 1][2]) < 1e-15 && n[i - 1][2] > 0.7);
    }
    assert_true(n[6][0] == 0 && n[6][1] == 0 && n[6][2] == 0);
    seg[1][2] = 7;
    n[0][0] = 42;
    assert_int_equal(footpoint_node_normals(7, xyz[0], 2, seg[0], n[0]), FOOTPOINT_ERR_ARGUMENT);
    seg[1][2] = -1;
    assert_int_equal(footpoint_node_normals(7, xyz[0], 2, seg[0], n[0]), FOOTPOINT_ERR_ARGUMENT);
    assert_true(n[0][0] == 42);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_fall_with_the_fourth_power),
        cmocka_unit_test(projections_match_differences),
        cmocka_unit_test(node_normals_are_known),
    };
    return cmocka_run_group_tests_name("smooth_bodies", tests, NULL, NULL);
}
