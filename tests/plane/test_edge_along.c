/* Projection of a slave node on an edge along a direction: each proved status, point and distance, against the roots of
 * the quadratic equation in quadruple precision. */
#include "../../generated/footpoint_edge2.h"
#include "../../generated/footpoint_edge3.h"
#include "../hard/draw.h"
#include "edge_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

enum { LINES = 300, LINES_LONG = 100000, STATUSES = 5 };

static int along_of(int nodes, double x[4][2], const double p[2], double *xi, double *dist)
{
    return nodes == 2 ? footpoint_edge2_along(x[0], x[1], x[2], p, xi, dist)
                      : footpoint_edge3_along(x[0], x[1], x[2], x[3], p, xi, dist);
}

/* Computes g = (r(t) - S) x p for r = C + t u + t^2 v. */
static void equation(const struct judged *j, const double p[2], wide g[3])
{
    wide c[3][2];
    for (int i = 0; i < 2; i++) {
        c[0][i] = j->x[2][i] - j->x[3][i];
        c[1][i] = (j->x[1][i] - j->x[0][i]) / 2;
        c[2][i] = (j->x[0][i] + j->x[1][i]) / 2 - j->x[2][i];
    }
    for (int k = 0; k < 3; k++)
        g[k] = c[k][0] * p[1] - c[k][1] * p[0];
    const wide most = g[1] * g[1] > g[2] * g[2] ? g[1] : g[2]; /* scales one of the coefficients to 1 */
    for (int k = 0; k < 3; k++)
        g[k] /= most != 0 ? (most < 0 ? -most : most) : 1;
}

/* Finds the real roots, at most two. */
static int roots_of(const wide g[3], wide root[2])
{
    const wide under = g[1] * g[1] - 4 * g[2] * g[0];
    if (under < 0)
        return 0;
    const wide q = (g[1] < 0 ? judge_root(under) - g[1] : -judge_root(under) - g[1]) / 2;
    root[0] = q != 0 ? g[0] / q : 0;
    if (g[2] == 0)
        return q != 0;
    root[1] = q / g[2];
    return 2;
}

static double distance_at(const struct judged *j, const double p[2], wide t)
{
    wide r[2];
    judge_point(j, t, r);
    return (double)(((j->x[3][0] - r[0]) * p[0] + (j->x[3][1] - r[1]) * p[1]) / hypot(p[0], p[1]));
}

static bool is_right(const struct judged *j, const double p[2], int status, double xi, double dist, double size)
{
    const double within = FOOTPOINT_ALONG_PROMISE * fmax(1, fabs(xi)), steep = 1 + xi * xi;
    wide g[3], root[2];
    int near = 0, on = 0, other = 0;
    equation(j, p, g);
    const int n = roots_of(g, root);
    if (status == FOOTPOINT_ERR_DOMAIN)
        return n == 0;
    for (int k = 0; k < n; k++) {
        const double off = fabs((double)(root[k] - xi)), t = fabs((double)root[k]);
        near += off <= within;
        on += t <= 1;
        other += off > within && t <= 1;
        if (status == FOOTPOINT_NOT_UNIQUE && fabs(distance_at(j, p, root[k])) < fabs(dist) - 1e-8 * size)
            return false;
    }
    if (!near || fabs(distance_at(j, p, xi) - dist) > 1e-13 * (size * steep + fabs(dist)))
        return false;
    return status == FOOTPOINT_NOT_UNIQUE ? on == 2 : !other && (status == FOOTPOINT_OUTSIDE) == (fabs(xi) > 1);
}

static void statuses_are_proved(void **state)
{
    const long lines = getenv("FOOTPOINT_LONG") ? LINES_LONG : LINES;
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++)
        for (int family = 0; family < FAMILIES; family++) {
            uint64_t stream = (uint64_t)(2 * family + nodes);
            long count[STATUSES + 3] = {0};
            for (long k = 0; k < lines; k++) {
                double x[4][2], p[2], xi = 0, dist = 0, size = 0, gap;
                struct judged j;
                draw_edge((enum family)family, &stream, nodes, x);
                const double angle = draw_flat(&stream, 0, 6.3), length = draw_power(&stream, -9, 9);
                p[0] = length * cos(angle);
                p[1] = length * sin(angle);
                if (k % 2 && nodes == 3 && footpoint_edge3_accurate(x[0], x[1], x[2], x[3], &xi, &gap) == FOOTPOINT_OK)
                    (void)footpoint_edge3_place(x[0], x[1], x[2], x[3], xi, NULL, NULL, p, NULL);
                judge_edge(&j, nodes, x);
                for (int i = 0; i < nodes; i++)
                    size = fmax(size, fmax(fabs(x[i][0] - x[nodes][0]), fabs(x[i][1] - x[nodes][1])));
                const int status = along_of(nodes, x, p, &xi, &dist);
                assert_in_range(status + 3, 0, STATUSES + 2);
                count[status + 3]++;
                if (status == FOOTPOINT_UNPROVED || status == FOOTPOINT_ERR_DEGENERATE)
                    continue;
                if (!is_right(&j, p, status, xi, dist, size)) {
                    for (int i = 0; i <= nodes; i++)
                        print_error("{%a, %a},\n", x[i][0], x[i][1]);
                    fail_msg("%s: along (%a, %a): status %d, xi %.17g, distance %.17g", edge_families[family], p[0],
                             p[1], status, xi, dist);
                }
            }
            print_message(
                "# edge%d, %s: ok %ld, outside %ld, not unique %ld, unproved %ld, degenerate %ld, no point %ld\n",
                nodes, edge_families[family], count[3], count[4], count[5], count[7], count[1], count[0]);
            assert_true(family == COINCIDENT || family == LINE || family == SCALES ||
                        (double)(count[7] + count[1]) <= 0.01 * (double)lines);
        }
}

static void bad_lines_have_statuses(void **state)
{
    double x[4][2] = {{0, 0}, {2, 0}, {1, 0}, {0.5, 1}}, xi = 7, dist = 7;
    const double none[2] = {0, 0}, bad[2] = {NAN, 1}, parallel[2] = {3, 0}, good[2] = {0, 2};
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++) {
        double y[4][2] = {{0, 0}, {2, 0}, {0.5, 1}, {0.5, 1}};
        double(*const edge)[2] = nodes == 2 ? y : x;
        assert_int_equal(along_of(nodes, edge, none, &xi, &dist), FOOTPOINT_ERR_DEGENERATE);
        assert_int_equal(along_of(nodes, edge, bad, &xi, &dist), FOOTPOINT_ERR_NOT_FINITE);
        assert_int_equal(along_of(nodes, edge, parallel, &xi, &dist), FOOTPOINT_ERR_DEGENERATE);
        assert_true(xi == 7 && dist == 7);
        assert_int_equal(along_of(nodes, edge, good, &xi, &dist), FOOTPOINT_OK);
        assert_true(xi == -0.5 && dist == 1);
        xi = dist = 7;
    }
}

static void arrays_match_calls(void **state)
{
    enum { PAIRS = 50 };
    static double column[8][PAIRS], p[2][PAIRS], xi[PAIRS], dist[PAIRS];
    static int status[PAIRS];
    const double *c[8], *along[2] = {p[0], p[1]};
    uint64_t stream = 12;
    (void)state;
    for (int i = 0; i < PAIRS; i++) {
        double x[4][2];
        draw_edge((enum family)(i % FAMILIES), &stream, 3, x);
        for (int k = 0; k < 8; k++) {
            column[k][i] = x[k / 2][k % 2];
            c[k] = column[k];
        }
        p[0][i] = draw_flat(&stream, -1, 1);
        p[1][i] = draw_flat(&stream, -1, 1);
    }
    footpoint_edge3_along_n(PAIRS, c, along, xi, dist, status);
    for (int i = 0; i < PAIRS; i++) {
        const double q[2] = {p[0][i], p[1][i]};
        double x[4][2], at = 0, d = 0;
        for (int k = 0; k < 8; k++)
            x[k / 2][k % 2] = column[k][i];
        const int one = along_of(3, x, q, &at, &d);
        assert_int_equal(status[i], one);
        assert_true(one < FOOTPOINT_OK || (xi[i] == at && dist[i] == d));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(statuses_are_proved),
        cmocka_unit_test(bad_lines_have_statuses),
        cmocka_unit_test(arrays_match_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
