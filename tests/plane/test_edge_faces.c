/* Edges in the library: footpoint_face_* of FOOTPOINT_EDGE2 and FOOTPOINT_EDGE3 return what the headers do, whatever z is. */
#include "../../generated/footpoint_edge2.h"
#include "../../generated/footpoint_edge3.h"
#include "../../runtime/footpoint_face.h"
#include "../hard/draw.h"
#include "edge_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { EDGES = 600 };

static enum footpoint_face face_of(int nodes)
{
    return nodes == 2 ? FOOTPOINT_EDGE2 : FOOTPOINT_EDGE3;
}

/* Number i: x of the header, and xyz of the library with some z. */
static void draw_both(int i, int nodes, uint64_t *stream, double x[4][2], double xyz[12])
{
    draw_edge((enum family)(i % FAMILIES), stream, nodes, x);
    for (int k = 0; k <= nodes; k++) {
        xyz[3 * k] = x[k][0];
        xyz[3 * k + 1] = x[k][1];
        xyz[3 * k + 2] = i % 3 ? 0 : draw_flat(stream, -5, 5);
    }
}

static void calls_match_headers(void **state)
{
    uint64_t stream = 3;
    (void)state;
    for (int i = 0; i < EDGES; i++)
        for (int nodes = 2; nodes <= 3; nodes++) {
            const enum footpoint_face face = face_of(nodes);
            double x[4][2], xyz[12], loc[2] = {7, 7}, gap = 7, xi = 7, g = 7;
            int region = 7, where = 7, status;
            draw_both(i, nodes, &stream, x, xyz);
            status = nodes == 2 ? footpoint_edge2_exact(x[0], x[1], x[2], &xi, &g)
                                : footpoint_edge3_accurate(x[0], x[1], x[2], x[3], &xi, &g);
            assert_int_equal(footpoint_face_locate(face, xyz, loc, &gap), status);
            assert_true(loc[0] == xi && loc[1] == (status < FOOTPOINT_OK ? 7 : 0) && gap == g);
            loc[0] = NAN;
            assert_int_equal(footpoint_track(face, xyz, loc, &gap), status);
            assert_true(status < FOOTPOINT_OK || loc[0] == xi);
            status = nodes == 2 ? footpoint_edge2_exact_closest(x[0], x[1], x[2], &xi, &g, &where)
                                : footpoint_edge3_accurate_closest(x[0], x[1], x[2], x[3], &xi, &g, &where);
            loc[0] = xi;
            gap = g;
            region = where;
            assert_int_equal(footpoint_face_closest(face, xyz, loc, &gap, &region), status);
            assert_true(loc[0] == xi && gap == g && region == where);
            const double along[3] = {0.2, 1.0, xyz[2]};
            status = nodes == 2 ? footpoint_edge2_along(x[0], x[1], x[2], along, &xi, &g)
                                : footpoint_edge3_along(x[0], x[1], x[2], x[3], along, &xi, &g);
            assert_int_equal(footpoint_face_along(face, xyz, along, loc, &gap), status);
            assert_true(loc[0] == xi && gap == g);
        }
}

/* What footpoint_face_robust is certain of: the distance, but for FOOTPOINT_UNPROVED. */
static void robust_distances_are_right(void **state)
{
    uint64_t stream = 5;
    int unproved = 0;
    (void)state;
    for (int i = 0; i < EDGES; i++)
        for (int nodes = 2; nodes <= 3; nodes++) {
            double x[4][2], xyz[12], loc[2], distance, size = 0;
            int region;
            struct judged j;
            draw_both(i, nodes, &stream, x, xyz);
            judge_edge(&j, nodes, x);
            judge_find(&j);
            for (int k = 0; k < nodes; k++)
                size = fmax(size, fmax(fabs(x[k][0] - x[nodes][0]), fabs(x[k][1] - x[nodes][1])));
            const int status = footpoint_face_robust(face_of(nodes), xyz, loc, &distance, &region);
            const double right = size > 0 ? size * (double)judge_root(j.least / size / size) : 0;
            assert_true(status >= FOOTPOINT_OK && (status != FOOTPOINT_OK || region == 0) &&
                        (status != FOOTPOINT_OUTSIDE || region));
            unproved += status == FOOTPOINT_UNPROVED;
            if (status != FOOTPOINT_UNPROVED)
                assert_true(fabs(fabs(distance) - right) <= 1e-10 * size);
        }
    print_message("# %d of %d unproved\n", unproved, 2 * EDGES);
    assert_true(unproved <= EDGES / 20);
}

static void pairs_match_calls(void **state)
{
    static double xyz[12 * EDGES], loc[2 * EDGES], gap[EDGES];
    static int seg[3 * EDGES], slave[EDGES], status[EDGES], region[EDGES];
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++) {
        const enum footpoint_face face = face_of(nodes);
        const size_t all = (size_t)(nodes + 1) * EDGES;
        uint64_t stream = 6;
        for (int i = 0; i < EDGES; i++) {
            double x[4][2];
            draw_both(i, nodes, &stream, x, xyz + 3 * (nodes + 1) * i);
            for (int k = 0; k < nodes; k++)
                seg[nodes * i + k] = (nodes + 1) * i + k;
            slave[i] = (nodes + 1) * i + nodes;
        }
        slave[7] = -1;
        for (int call = 0; call < 3; call++) {
            for (int i = 0; i < 2 * EDGES; i++)
                loc[i] = NAN;
            if (call == 0)
                footpoint_face_locate_pairs(face, EDGES, xyz, all, seg, slave, loc, gap, status);
            else if (call == 1)
                footpoint_track_pairs(face, EDGES, xyz, all, seg, slave, loc, gap, status);
            else
                footpoint_face_robust_pairs(face, EDGES, xyz, all, seg, slave, loc, gap, region, status);
            for (int i = 0; i < EDGES; i++) {
                double at[2] = {NAN, NAN}, g = 0;
                const double *const x = xyz + 3 * (nodes + 1) * i;
                int where = 0;
                if (i == 7) {
                    assert_int_equal(status[i], FOOTPOINT_ERR_ARGUMENT);
                    continue;
                }
                assert_int_equal(status[i], call == 0   ? footpoint_face_locate(face, x, at, &g)
                                            : call == 1 ? footpoint_track(face, x, at, &g)
                                                        : footpoint_face_robust(face, x, at, &g, &where));
                if (status[i] >= FOOTPOINT_OK)
                    assert_true(fabs(at[0] - loc[2 * i]) <= (call == 1 ? 2e-12 : 0) && at[1] == 0 &&
                                loc[2 * i + 1] == 0);
            }
        }
    }
}

/* A triangle of edges, inside of which nodes are behind the nearest one. */
static void the_nearest_edge_has_a_side(void **state)
{
    const double xyz[] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const int two[] = {0, 1, 1, 2, 2, 0}, three[] = {0, 1, 3, 1, 2, 4, 2, 0, 5};
    const double in[3] = {0.4, 0.3, 9}, corner[3] = {-0.3, -0.4, 0};
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++) {
        size_t chosen;
        double loc[2], distance;
        int region;
        assert_int_equal(footpoint_face_nodes(face_of(nodes)), nodes);
        assert_int_equal(footpoint_face_select(face_of(nodes), xyz, 3, nodes == 2 ? two : three, in, &chosen, loc,
                                               &distance, &region),
                         FOOTPOINT_OK);
        assert_true(chosen == 0 && region == 0 && fabs(distance + 0.3) < 1e-14 && fabs(loc[0] + 0.6) < 1e-12);
        assert_int_equal(footpoint_face_select(face_of(nodes), xyz, 3, nodes == 2 ? two : three, corner, &chosen, loc,
                                               &distance, &region),
                         FOOTPOINT_OK);
        assert_true(region > 0 && fabs(distance - 0.5) < 1e-14);
    }
}

/* Derivatives by x and y are the header's, by z 0; the contact element takes them. */
static void derivatives_match_headers(void **state)
{
    const double x[4][2] = {{0, 0}, {2, 0.1}, {0.9, -0.3}, {1.2, -0.5}};
    const double xyz[12] = {0, 0, 0, 2, 0.1, 0, 0.9, -0.3, 0, 1.2, -0.5, 0};
    double loc[2], gap, phi[3], r_xi[3], r_eta[3], normal[3], d_xi[12], d_eta[12], d_gap[12], d_normal[36], hessian[78];
    double by_xi[8], by_gap[8], by_normal[16], second[36];
    (void)state;
    assert_int_equal(footpoint_face_locate(FOOTPOINT_EDGE3, xyz, loc, &gap), FOOTPOINT_OK);
    assert_int_equal(
        footpoint_face_differentiate(FOOTPOINT_EDGE3, xyz, loc, phi, r_xi, r_eta, normal, &gap, d_xi, d_eta, d_gap),
        FOOTPOINT_OK);
    assert_int_equal(footpoint_face_hessian(FOOTPOINT_EDGE3, xyz, loc, &gap, NULL, NULL, NULL, d_normal, hessian),
                     FOOTPOINT_OK);
    assert_int_equal(footpoint_edge3_gradients(x[0], x[1], x[2], x[3], loc[0], by_xi, by_gap), FOOTPOINT_OK);
    assert_int_equal(footpoint_edge3_hessian(x[0], x[1], x[2], x[3], loc[0], by_normal, second), FOOTPOINT_OK);
    assert_true(r_eta[0] == 0 && r_eta[1] == 0 && r_eta[2] == 1 && normal[2] == 0);
    assert_true(fabs(normal[0] * r_xi[0] + normal[1] * r_xi[1]) < 1e-15 && fabs(phi[0] + phi[1] + phi[2] - 1) < 1e-15);
    for (int p = 0; p < 12; p++) {
        const int flat = 2 * (p / 3) + p % 3, in = p % 3 < 2;
        assert_true(d_xi[p] == (in ? by_xi[flat] : 0) && d_gap[p] == (in ? by_gap[flat] : 0) && d_eta[p] == 0);
        for (int i = 0; i < 3; i++)
            assert_true(d_normal[12 * i + p] == (in && i < 2 ? by_normal[8 * i + flat] : 0));
        for (int q = 0; q <= p; q++) {
            const int other = 2 * (q / 3) + q % 3;
            assert_true(hessian[p * (p + 1) / 2 + q] == (in && q % 3 < 2 ? second[flat * (flat + 1) / 2 + other] : 0));
        }
    }
}

/* Normal force and friction stay in the plane, and so do their tangents. */
static void derivatives_along_match_headers(void **state)
{
    enum { FLAT = 10, ALL = 15 };
    static const double along[3] = {0.2, 1.0, 5.0}, loc[2] = {0.3, 0.0};
    uint64_t stream = 8;
    (void)state;
    for (int i = 0; i < EDGES / 10; i++)
        for (int nodes = 2; nodes <= 3; nodes++) {
            double x[4][2], xyz[12], dist, d, first[2][FLAT], second[2][FLAT * (FLAT + 1) / 2];
            double d_xi[ALL], d_eta[ALL], d_dist[ALL], h[3][ALL * (ALL + 1) / 2];
            draw_both(i, nodes, &stream, x, xyz);
            const int status = nodes == 2 ? footpoint_edge2_hessian_along(x[0], x[1], x[2], along, loc[0], &d, first[0],
                                                                          first[1], second[0], second[1])
                                          : footpoint_edge3_hessian_along(x[0], x[1], x[2], x[3], along, loc[0], &d,
                                                                          first[0], first[1], second[0], second[1]);
            assert_int_equal(footpoint_face_differentiate_along(face_of(nodes), xyz, along, loc, &dist, d_xi, d_eta,
                                                                d_dist, h[0], h[1], h[2]),
                             status);
            for (int r = 0, e = 0; status == FOOTPOINT_OK && r < 3 * nodes + 6; r++) {
                const int row = 2 * (r / 3) + r % 3;
                assert_true(dist == d && d_eta[r] == 0 && d_xi[r] == (r % 3 < 2 ? first[0][row] : 0) &&
                            d_dist[r] == (r % 3 < 2 ? first[1][row] : 0));
                for (int c = 0; c <= r; c++, e++) {
                    const int at = row * (row + 1) / 2 + 2 * (c / 3) + c % 3, flat = r % 3 < 2 && c % 3 < 2;
                    assert_true(h[1][e] == 0 && h[0][e] == (flat ? second[0][at] : 0) &&
                                h[2][e] == (flat ? second[1][at] : 0));
                }
            }
        }
}

static void contact_elements_stay_in_the_plane(void **state)
{
    const double xyz[12] = {0, 0, 0, 2, 0.1, 0, 0.9, -0.3, 0, 1.2, -0.15, 0}, start[2] = {0.1, 0};
    double loc[2], gap, phi[3], r_xi[3], r_eta[3], normal[3], d_xi[12], d_eta[12], d_gap[12], d_normal[36], hessian[78];
    double pressure, force[12], tangent[144], slip[2];
    (void)state;
    assert_int_equal(footpoint_face_locate(FOOTPOINT_EDGE3, xyz, loc, &gap), FOOTPOINT_OK);
    assert_true(gap < 0);
    assert_int_equal(
        footpoint_face_differentiate(FOOTPOINT_EDGE3, xyz, loc, NULL, r_xi, r_eta, normal, &gap, d_xi, d_eta, d_gap),
        FOOTPOINT_OK);
    assert_int_equal(footpoint_face_hessian(FOOTPOINT_EDGE3, xyz, loc, &gap, NULL, NULL, NULL, d_normal, hessian),
                     FOOTPOINT_OK);
    assert_int_equal(footpoint_face_place(FOOTPOINT_EDGE3, xyz, start, phi, NULL, NULL, NULL, NULL), FOOTPOINT_OK);
    for (int friction = 0; friction < 2; friction++) {
        double sum[3] = {0};
        assert_int_equal(friction ? footpoint_element_friction(3, xyz, phi, r_xi, r_eta, normal, d_gap, d_normal,
                                                               pressure, 100, 0.3, 50, slip, force, tangent)
                                  : footpoint_element_normal(3, gap, d_gap, hessian, 100, 0, &pressure, force, tangent),
                         FOOTPOINT_OK);
        for (int i = 0; i < 12; i++)
            sum[i % 3] += force[i];
        assert_true(fabs(sum[0]) < 1e-13 && fabs(sum[1]) < 1e-13 && force[2] == 0 && force[11] == 0);
    }
    assert_true(slip[1] == 0 && slip[0] != 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_match_headers),
        cmocka_unit_test(robust_distances_are_right),
        cmocka_unit_test(pairs_match_calls),
        cmocka_unit_test(the_nearest_edge_has_a_side),
        cmocka_unit_test(derivatives_match_headers),
        cmocka_unit_test(derivatives_along_match_headers),
        cmocka_unit_test(contact_elements_stay_in_the_plane),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
