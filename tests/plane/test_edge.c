/* The promise of edges: FOOTPOINT_OK and FOOTPOINT_NOT_UNIQUE of footpoint_edge2_exact, footpoint_edge3_accurate and
 * their _closest hold on ordinary and strongly curved edges, with the middle node at a quarter, on a line or anywhere,
 * with coinciding nodes, of any size and with coordinates of mixed scales, for near, far and equally near slave nodes;
 * in calls, from last answers, in arrays and of several edges. The judge finds all roots of the cubic of shape
 * functions in quadruple precision. */
#include "../../generated/footpoint_edge2.h"
#include "../../generated/footpoint_edge3.h"
#include "../hard/draw.h"
#include "../support/long_cases.h"
#include "edge_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { CASES = 900, CASES_LONG = 920000 };

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

/* ---- calls --------------------------------------------------------------------------------------------------------- */

static int locate(int nodes, double x[4][2], double *xi, double *gap)
{
    return nodes == 2 ? footpoint_edge2_exact(x[0], x[1], x[2], xi, gap)
                      : footpoint_edge3_accurate(x[0], x[1], x[2], x[3], xi, gap);
}

static int follow(int nodes, double x[4][2], double *xi, double *gap)
{
    return nodes == 2 ? footpoint_edge2_exact_from(x[0], x[1], x[2], xi, gap)
                      : footpoint_edge3_accurate_from(x[0], x[1], x[2], x[3], xi, gap);
}

static int closest(int nodes, double x[4][2], double *xi, double *dist, int *region)
{
    return nodes == 2 ? footpoint_edge2_exact_closest(x[0], x[1], x[2], xi, dist, region)
                      : footpoint_edge3_accurate_closest(x[0], x[1], x[2], x[3], xi, dist, region);
}

static void refuse(int nodes, double x[4][2], const char *what, const char *call, double xi, double gap)
{
    for (int k = 0; k <= nodes; k++)
        print_error("{%a, %a},\n", x[k][0], x[k][1]);
    fail_msg("%s, %d nodes, %s: xi %.17g, gap %.17g", what, nodes, call, xi, gap);
}

/* Returns 1 if the foot point is proved, plus 2 if the closest point is proved, plus 4 if another point is as near. */
static int judge(int nodes, double x[4][2], enum family family, double last)
{
    struct judged j;
    double xi = 0, gap = 0, from = last, dist = 0;
    int region = 0, proved = 0, status;
    judge_edge(&j, nodes, x);
    status = locate(nodes, x, &xi, &gap);
    if (status == FOOTPOINT_OK && ++proved && (!judge_holds(&j, xi) || !judge_gap_holds(&j, xi, gap)))
        refuse(nodes, x, edge_families[family], "foot point", xi, gap);
    if (follow(nodes, x, &from, &gap) == FOOTPOINT_OK && (!judge_holds(&j, from) || !judge_gap_holds(&j, from, gap)))
        refuse(nodes, x, edge_families[family], "from the last answer", from, gap);
    judge_find(&j);
    status = closest(nodes, x, &xi, &dist, &region);
    proved += status == FOOTPOINT_OK ? 2 : status == FOOTPOINT_NOT_UNIQUE ? 4 : 0;
    if ((status == FOOTPOINT_OK || status == FOOTPOINT_NOT_UNIQUE) &&
        !judge_closest_holds(&j, status, xi, dist, region))
        refuse(nodes, x, edge_families[family], "closest point", xi, dist);
    return proved;
}

/* Shares of the foot points and of the closest points that must be proved. */
/* clang-format off */
static const double proved_part[2][FAMILIES][2] = {
    {{0.999, 0.999}, {0.999, 0.999}, {0.999, 0.999}, {0.999, 0.999}, {0.999, 0.999}, {0.7, 0.7}, {0.99, 0.99}, {0.999, 0.999}, {0.97, 0.97}, {0.9, 0.9}, {0.999, 0.999}, {0.999, 0.999}},
    {{0.999, 0.999}, {0.99, 0.98}, {0.99, 0.98}, {0.97, 0.8}, {0.99, 0.97}, {0.8, 0.7}, {0.99, 0.99}, {0.99, 0.99}, {0.97, 0.97}, {0.9, 0.5}, {0.999, 0.999}, {0.999, 0.99}}};
/* clang-format on */

static void promises_hold(void **state)
{
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++)
        for (int family = 0; family < FAMILIES; family++) {
            uint64_t stream = (uint64_t)(2 * family + nodes);
            long found = 0, near = 0, tied = 0;
            for (long k = 0; k < cases() / (nodes == 2 ? 4 : 1); k++) {
                double x[4][2];
                draw_edge((enum family)family, &stream, nodes, x);
                const int proved = judge(nodes, x, (enum family)family, k % 50 ? draw_flat(&stream, -1.5, 1.5) : NAN);
                found += proved & 1;
                near += proved & 2;
                tied += proved & 4;
            }
            const double all = (double)(cases() / (nodes == 2 ? 4 : 1));
            print_message("# edge%d, %s: %.4f proved, %.4f closest, %.4f tied\n", nodes, edge_families[family],
                          (double)found / all, (double)near / 2 / all, (double)tied / 4 / all);
            assert_true((double)found >= proved_part[nodes - 2][family][0] * all);
            assert_true((double)near / 2 + (double)tied / 4 >= proved_part[nodes - 2][family][1] * all);
        }
}

enum { PAIRS = 600 };
static double column[8][PAIRS], xi_of[PAIRS], gap_of[PAIRS];
static int status_of[PAIRS], region_of[PAIRS];

static void draw_columns(int nodes, const double *c[8])
{
    uint64_t stream = 9;
    for (int i = 0; i < PAIRS; i++) {
        double x[4][2];
        draw_edge((enum family)(i % FAMILIES), &stream, nodes, x);
        for (int k = 0; k < 2 * nodes + 2; k++)
            column[k][i] = x[k / 2][k % 2];
    }
    for (int k = 0; k < 8; k++)
        c[k] = column[k];
}

static void row_of(int i, double x[4][2])
{
    for (int k = 0; k < 8; k++)
        x[k / 2][k % 2] = column[k][i];
}

/* Arrays return the bits of calls, unless operations are fused. */
static void same(int i, int status, double xi, double gap)
{
#ifndef __FMA__
    assert_int_equal(status_of[i], status);
    if (status >= FOOTPOINT_OK)
        assert_true(xi_of[i] == xi && gap_of[i] == gap);
#else
    (void)i, (void)status, (void)xi, (void)gap;
#endif
}

/* Places without proofs are near the foot points of ordinary edges; beyond an end the last step may be larger. */
static void check_places(int nodes, const double *c[8])
{
    (nodes == 2 ? footpoint_edge2_exact_n : footpoint_edge3_accurate_n)(PAIRS, c, xi_of);
    for (int i = ORDINARY; i < PAIRS; i += FAMILIES) {
        double x[4][2], xi = 0, gap, at = 0;
        row_of(i, x);
        if (nodes == 2)
            footpoint_edge2_exact_at(x[0], x[1], x[2], &at);
        else
            footpoint_edge3_accurate_at(x[0], x[1], x[2], x[3], &at);
        assert_int_equal(locate(nodes, x, &xi, &gap), FOOTPOINT_OK);
        assert_true(fabs(at - xi) <= 1e-8 * (1 + fabs(xi)) && fabs(xi_of[i] - xi) <= 1e-8 * (1 + fabs(xi)));
    }
}

static void arrays_match_calls(void **state)
{
    const double *c[8];
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++) {
        double x[4][2], xi = 0, gap = 0;
        int region = 0, status;
        draw_columns(nodes, c);
        check_places(nodes, c);
        (nodes == 2 ? footpoint_edge2_exact_checked_n : footpoint_edge3_accurate_checked_n)(PAIRS, c, xi_of, gap_of,
                                                                                            status_of);
        for (int i = 0; i < PAIRS; i++) {
            row_of(i, x);
            status = locate(nodes, x, &xi, &gap);
            same(i, status, xi, gap);
            xi_of[i] = i % 7 ? 0.1 : NAN;
        }
        (nodes == 2 ? footpoint_edge2_exact_from_n : footpoint_edge3_accurate_from_n)(PAIRS, c, xi_of, gap_of,
                                                                                      status_of);
        for (int i = 0; i < PAIRS; i++) {
            row_of(i, x);
            xi = i % 7 ? 0.1 : NAN;
            status = follow(nodes, x, &xi, &gap);
            same(i, status, xi, gap);
        }
        (nodes == 2 ? footpoint_edge2_exact_closest_n : footpoint_edge3_accurate_closest_n)(PAIRS, c, xi_of, gap_of,
                                                                                            region_of, status_of);
        for (int i = 0; i < PAIRS; i++) {
            row_of(i, x);
            status = closest(nodes, x, &xi, &gap, &region);
            same(i, status, xi, gap);
        }
        row_of(0, x);
        const double *const segment[3] = {x[0], x[1], x[2]};
        (nodes == 2 ? footpoint_edge2_exact_over_n : footpoint_edge3_accurate_over_n)(segment, PAIRS, c + 2 * nodes,
                                                                                      xi_of, gap_of, status_of);
        for (int i = 0; i < PAIRS; i++) {
            double y[4][2];
            row_of(i, y);
            memcpy(x[nodes], y[nodes], sizeof x[0]);
            status = locate(nodes, x, &xi, &gap);
            same(i, status, xi, gap);
        }
    }
}

static void bad_numbers_have_statuses(void **state)
{
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++)
        for (int k = 0; k < 2 * nodes + 2; k++)
            for (int bad = 0; bad < 2; bad++) {
                double x[4][2] = {{-1, 0}, {1, 0}, {0, -0.1}, {0.2, 0.3}}, xi = 7, gap = 7;
                int region = 7;
                x[k / 2][k % 2] = bad ? NAN : HUGE_VAL;
                assert_int_equal(locate(nodes, x, &xi, &gap), FOOTPOINT_ERR_NOT_FINITE);
                assert_int_equal(follow(nodes, x, &xi, &gap), FOOTPOINT_ERR_NOT_FINITE);
                assert_int_equal(closest(nodes, x, &xi, &gap, &region), FOOTPOINT_ERR_NOT_FINITE);
                assert_true(xi == 7 && gap == 7 && region == 7);
            }
}

static void edges_without_length_have_statuses(void **state)
{
    double x[4][2] = {{3, 4}, {3, 4}, {3, 4}, {3, 4}}, xi = 7, gap = 7;
    int region = 7;
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++) {
        assert_int_equal(locate(nodes, x, &xi, &gap), FOOTPOINT_ERR_DEGENERATE);
        assert_int_equal(closest(nodes, x, &xi, &gap, &region), FOOTPOINT_ERR_DEGENERATE);
        assert_true(xi == 7 && gap == 7 && region == 7);
    }
}

/* The body lies to the left of A -> B. */
static void gaps_are_open_on_the_right(void **state)
{
    double x[4][2] = {{0, 0}, {2, 0}, {1, 0}, {1.5, -0.25}}, y[4][2] = {{0, 0}, {2, 0}, {1.5, -0.25}}, xi, gap;
    (void)state;
    assert_int_equal(locate(3, x, &xi, &gap), FOOTPOINT_OK);
    assert_true(xi == 0.5 && gap == 0.25);
    assert_int_equal(locate(2, y, &xi, &gap), FOOTPOINT_OK);
    assert_true(xi == 0.5 && gap == 0.25);
}

/* Sides of a closed polygon, counter-clockwise: a node inside is behind the nearest edge, however sharp the corners. */
static void several_edges_have_a_side(void **state)
{
    enum { CORNERS = 7 };
    uint64_t stream = 4;
    (void)state;
    for (long k = 0; k < cases() / 3; k++) {
        double corner[CORNERS][2], middle[CORNERS][2], xS[2] = {draw_flat(&stream, -2, 2), draw_flat(&stream, -2, 2)};
        const double *two[2 * CORNERS], *three[3 * CORNERS];
        bool inside = false;
        for (int i = 0; i < CORNERS; i++) {
            const double angle = 6.283185307179586 * i / CORNERS, r = draw_flat(&stream, 0.2, 2);
            corner[i][0] = r * cos(angle);
            corner[i][1] = r * sin(angle);
        }
        for (int i = 0; i < CORNERS; i++) {
            double *const a = corner[i], *const b = corner[(i + 1) % CORNERS];
            for (int j = 0; j < 2; j++)
                middle[i][j] = 0.5 * (a[j] + b[j]);
            two[2 * i] = three[3 * i] = a;
            two[2 * i + 1] = three[3 * i + 1] = b;
            three[3 * i + 2] = middle[i];
            if ((a[1] > xS[1]) != (b[1] > xS[1]) && xS[0] < a[0] + (b[0] - a[0]) * (xS[1] - a[1]) / (b[1] - a[1]))
                inside = !inside;
        }
        for (int nodes = 2; nodes <= 3; nodes++) {
            double xi, dist, least = HUGE_VAL, x[4][2];
            int region;
            size_t which;
            const double *const *const all = nodes == 2 ? two : three;
            const int status = (nodes == 2 ? footpoint_edge2_exact_closest_of : footpoint_edge3_accurate_closest_of)(
                CORNERS, all, xS, &xi, &dist, &region, &which);
            assert_int_equal(status, FOOTPOINT_OK);
            for (int i = 0; i < CORNERS; i++) {
                double at, d;
                for (int m = 0; m <= nodes; m++)
                    memcpy(x[m], m < nodes ? all[nodes * i + m] : xS, sizeof x[m]);
                assert_int_equal(closest(nodes, x, &at, &d, &region), FOOTPOINT_OK);
                least = fmin(least, fabs(d));
            }
            assert_true(fabs(dist) == least);
            if (least > 1e-9)
                assert_int_equal(dist < 0, inside);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(promises_hold),
        cmocka_unit_test(arrays_match_calls),
        cmocka_unit_test(bad_numbers_have_statuses),
        cmocka_unit_test(edges_without_length_have_statuses),
        cmocka_unit_test(gaps_are_open_on_the_right),
        cmocka_unit_test(several_edges_have_a_side),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
