/* Projection of a slave node on an edge along a direction: each proved status, point and distance, against the roots of the
 * quadratic equation in quadruple precision; first and second derivatives, against differences of these. */
#include "../../generated/footpoint_edge2.h"
#include "../../generated/footpoint_edge3.h"
#include "../hard/draw.h"
#include "../support/long_cases.h"
#include "edge_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

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
    const long lines = long_cases(LINES, LINES_LONG);
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

static void check_array(int nodes)
{
    enum { PAIRS = 50 };
    static double column[8][PAIRS], p[2][PAIRS], xi[PAIRS], dist[PAIRS];
    static int status[PAIRS];
    const double *c[8], *along[2] = {p[0], p[1]};
    uint64_t stream = 12;
    for (int i = 0; i < PAIRS; i++) {
        double x[4][2] = {{0}};
        draw_edge((enum family)(i % FAMILIES), &stream, nodes, x);
        for (int k = 0; k < 8; k++) {
            column[k][i] = x[k / 2][k % 2];
            c[k] = column[k];
        }
        p[0][i] = draw_flat(&stream, -1, 1);
        p[1][i] = draw_flat(&stream, -1, 1);
    }
    (nodes == 2 ? footpoint_edge2_along_n : footpoint_edge3_along_n)(PAIRS, c, along, xi, dist, status);
    for (int i = 0; i < PAIRS; i++) {
        const double q[2] = {p[0][i], p[1][i]};
        double x[4][2], at = 0, d = 0;
        for (int k = 0; k < 8; k++)
            x[k / 2][k % 2] = column[k][i];
        const int one = along_of(nodes, x, q, &at, &d);
        assert_int_equal(status[i], one);
        assert_true(one < FOOTPOINT_OK || (xi[i] == at && dist[i] == d));
    }
}

static void arrays_match_calls(void **state)
{
    (void)state;
    check_array(2);
    check_array(3);
}

enum { COORDINATES = 10, PACKED = COORDINATES * (COORDINATES + 1) / 2 };

struct rows {
    double dist, d[2][COORDINATES], h[2][PACKED];
};

static int rows_of(int nodes, double x[4][2], const double p[2], double xi, struct rows *r)
{
    return nodes == 2
               ? footpoint_edge2_hessian_along(x[0], x[1], x[2], p, xi, &r->dist, r->d[0], r->d[1], r->h[0], r->h[1])
               : footpoint_edge3_hessian_along(x[0], x[1], x[2], x[3], p, xi, &r->dist, r->d[0], r->d[1], r->h[0],
                                               r->h[1]);
}

/* {xi, distance} near `from`, with all coordinates and the direction moved. */
static void moved(int nodes, double x[4][2], const double p[2], const double *by, wide step, double from, wide at[2])
{
    struct judged j;
    wide q[2], c[3][2], r[2];
    judge_edge(&j, nodes, x);
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k <= nodes; k++)
            j.x[k < nodes ? k : 3][i] = x[k][i] + step * by[2 * k + i];
        if (nodes == 2)
            j.x[2][i] = (j.x[0][i] + j.x[1][i]) / 2;
        q[i] = p[i] + step * by[2 * nodes + 2 + i];
        c[0][i] = j.x[2][i] - j.x[3][i];
        c[1][i] = (j.x[1][i] - j.x[0][i]) / 2;
        c[2][i] = (j.x[0][i] + j.x[1][i]) / 2 - j.x[2][i];
    }
    at[0] = from;
    for (int n = 0; n < 6; n++) {
        wide g = 0, slope = 0;
        for (int i = 0; i < 2; i++) {
            const wide across = i ? -q[0] : q[1];
            g += across * (c[0][i] + at[0] * (c[1][i] + at[0] * c[2][i]));
            slope += across * (c[1][i] + 2 * at[0] * c[2][i]);
        }
        at[0] -= g / slope;
    }
    judge_point(&j, at[0], r);
    at[1] = ((j.x[3][0] - r[0]) * q[0] + (j.x[3][1] - r[1]) * q[1]) / judge_root(q[0] * q[0] + q[1] * q[1]);
}

static void near_sum(const char *what, double sum, wide differences, double size)
{
    if (!(fabs(sum - (double)differences) <= 1e-9 * size))
        fail_msg("%s: %.17g, by differences %.17g, of %g", what, sum, (double)differences, size);
}

static void check_gradients(int nodes, double x[4][2], const double p[2], double xi, const struct rows *r)
{
    struct rows alone = {.dist = 7};
    assert_int_equal(
        nodes == 2
            ? footpoint_edge2_gradients_along(x[0], x[1], x[2], p, xi, &alone.dist, alone.d[0], alone.d[1])
            : footpoint_edge3_gradients_along(x[0], x[1], x[2], x[3], p, xi, &alone.dist, alone.d[0], alone.d[1]),
        FOOTPOINT_OK);
    assert_true(alone.dist == r->dist);
    for (int j = 0; j < 2; j++)
        assert_memory_equal(alone.d[j], r->d[j], (size_t)(2 * nodes + 4) * sizeof *r->d[j]);
}

static void judge_rows(int nodes, double x[4][2], const double p[2], double xi, const struct rows *r, const double *by)
{
    const int n = 2 * nodes + 4;
    const wide step = 1e-10;
    wide at[3][2];
    for (int s = 0; s < 3; s++)
        moved(nodes, x, p, by, (s - 1) * step, xi, at[s]);
    assert_true(fabs((double)(at[1][1] - r->dist)) <= 1e-9 * (1 + fabs(r->dist)));
    for (int j = 0; j < 2; j++) {
        double first = 0, second = 0, size[2] = {0, 0};
        for (int i = 0, e = 0; i < n; i++) {
            first += r->d[j][i] * by[i];
            size[0] += fabs(r->d[j][i] * by[i]);
            for (int c = 0; c <= i; c++, e++) {
                second += (c < i ? 2 : 1) * r->h[j][e] * by[i] * by[c];
                size[1] += fabs(r->h[j][e] * by[i] * by[c]);
            }
        }
        near_sum("first", first, (at[2][j] - at[0][j]) / (2 * step), size[0]);
        near_sum("second", second, (at[2][j] - 2 * at[1][j] + at[0][j]) / (step * step), size[1]);
    }
}

static void derivatives_match_differences(void **state)
{
    const long lines = long_cases(LINES, LINES_LONG);
    uint64_t stream = 13;
    long refused = 0;
    (void)state;
    for (long n = 0; n < 2 * lines; n++) {
        const int nodes = 2 + (int)(n % 2);
        const double angle = draw_flat(&stream, 0, 6.3), length = draw_power(&stream, -2, 2);
        const double p[2] = {length * cos(angle), length * sin(angle)};
        double x[4][2], xi = 0, by[COORDINATES], dist;
        struct rows r;
        draw_edge(n % 6 < 4 ? ORDINARY : CURVED, &stream, nodes, x);
        const int status = along_of(nodes, x, p, &xi, &dist);
        if (status < FOOTPOINT_OK || fabs(xi) > 3 || rows_of(nodes, x, p, xi, &r) != FOOTPOINT_OK) {
            refused++;
            continue;
        }
        for (int i = 0; i < 2 * nodes + 4; i++)
            by[i] = draw_flat(&stream, -1, 1) * (i < 2 * nodes + 2 ? 1 : length);
        judge_rows(nodes, x, p, xi, &r, by);
        check_gradients(nodes, x, p, xi, &r);
    }
    assert_true(refused < lines);
}

static void derivatives_have_statuses(void **state)
{
    double x[4][2] = {{0, 0}, {2, 0}, {0.5, 1}, {0.5, 1}};
    const double none[2] = {0, 0}, bad[2] = {NAN, 1}, nearly[2] = {3, 1e-5}, good[2] = {0, 2},
                 short_one[2] = {0, 1e-200};
    struct rows r = {.dist = 7};
    (void)state;
    assert_int_equal(rows_of(2, x, none, -0.5, &r), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(rows_of(2, x, bad, -0.5, &r), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(rows_of(2, x, good, NAN, &r), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(rows_of(2, x, nearly, -0.5, &r), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(rows_of(2, x, short_one, -0.5, &r), FOOTPOINT_ERR_NOT_FINITE);
    assert_true(r.dist == 7);
    assert_int_equal(footpoint_edge2_gradients_along(x[0], x[1], x[2], short_one, -0.5, &r.dist, r.d[0], NULL),
                     FOOTPOINT_OK);
    assert_true(r.dist == 1 && r.d[0][0] == -0.75 && r.d[0][1] == 0 && r.d[0][4] == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(statuses_are_proved),       cmocka_unit_test(derivatives_match_differences),
        cmocka_unit_test(derivatives_have_statuses), cmocka_unit_test(bad_lines_have_statuses),
        cmocka_unit_test(arrays_match_calls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
