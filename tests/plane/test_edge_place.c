/* Derivatives at foot points of edges, against differences in quadruple precision, and statuses if they do not
 * exist. */
#include "../../generated/footpoint_edge2.h"
#include "../../generated/footpoint_edge3.h"
#include "edge_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

struct foot {
    wide xi, gap, n[2];
};

/* Moves coordinates of the vectors of an edge, numbered as in derivatives; an edge of two nodes keeps its middle. */
static void move(struct judged *j, int nodes, int coordinate, wide by)
{
    const int k = coordinate / 2 < nodes ? coordinate / 2 : 3;
    j->x[k][coordinate % 2] += by;
    if (nodes == 2 && k < 2)
        j->x[2][coordinate % 2] += by / 2;
}

static struct foot foot_of(struct judged *j, double from)
{
    struct foot f = {.xi = from};
    wide r[2], t[2];
    judge_expand(j);
    for (int i = 0; i < 8; i++)
        f.xi -= judge_value(j->f, f.xi) / ((3 * j->f[3] * f.xi + 2 * j->f[2]) * f.xi + j->f[1]);
    judge_point(j, f.xi, r);
    for (int i = 0; i < 2; i++)
        t[i] = j->x[0][i] * (f.xi - 0.5) + j->x[1][i] * (f.xi + 0.5) - 2 * j->x[2][i] * f.xi;
    const wide length = judge_root(t[0] * t[0] + t[1] * t[1]);
    f.n[0] = t[1] / length;
    f.n[1] = -t[0] / length;
    f.gap = (j->x[3][0] - r[0]) * f.n[0] + (j->x[3][1] - r[1]) * f.n[1];
    return f;
}

static struct foot moved(const struct judged *j, int nodes, double from, int first, int one, int second, int two)
{
    const wide by = 1e-8;
    struct judged other = *j;
    move(&other, nodes, first, one * by);
    move(&other, nodes, second, two * by);
    return foot_of(&other, from);
}

static void near_enough(const char *what, wide differences, double derivative)
{
    const double exact = (double)differences;
    if (!(fabs(exact - derivative) <= 1e-9 * (1 + fabs(exact))))
        fail_msg("%s: %.17g, by differences %.17g", what, derivative, exact);
}

static void derivatives_of(int nodes, double x[4][2], double xi)
{
    const int n = 2 * nodes + 2;
    double d_xi[8], d_gap[8], d_normal[16], hessian[36], phi[3], t[2], normal[2], gap;
    const wide by = 1e-8;
    struct judged j;
    judge_edge(&j, nodes, x);
    if (nodes == 2) {
        assert_int_equal(footpoint_edge2_place(x[0], x[1], x[2], xi, phi, t, normal, &gap), FOOTPOINT_OK);
        assert_int_equal(footpoint_edge2_gradients(x[0], x[1], x[2], xi, d_xi, d_gap), FOOTPOINT_OK);
        assert_int_equal(footpoint_edge2_hessian(x[0], x[1], x[2], xi, d_normal, hessian), FOOTPOINT_OK);
    } else {
        assert_int_equal(footpoint_edge3_place(x[0], x[1], x[2], x[3], xi, phi, t, normal, &gap), FOOTPOINT_OK);
        assert_int_equal(footpoint_edge3_gradients(x[0], x[1], x[2], x[3], xi, d_xi, d_gap), FOOTPOINT_OK);
        assert_int_equal(footpoint_edge3_hessian(x[0], x[1], x[2], x[3], xi, d_normal, hessian), FOOTPOINT_OK);
    }
    const struct foot here = moved(&j, nodes, xi, 0, 0, 0, 0);
    near_enough("gap", here.gap, gap);
    near_enough("normal", here.n[0], normal[0]);
    near_enough("normal", here.n[1], normal[1]);
    for (int p = 0; p < n; p++) {
        const struct foot low = moved(&j, nodes, xi, p, -1, 0, 0), high = moved(&j, nodes, xi, p, 1, 0, 0);
        near_enough("d_xi", (high.xi - low.xi) / (2 * by), d_xi[p]);
        near_enough("d_gap", (high.gap - low.gap) / (2 * by), d_gap[p]);
        for (int i = 0; i < 2; i++)
            near_enough("d_normal", (high.n[i] - low.n[i]) / (2 * by), d_normal[i * n + p]);
        for (int q = 0; q <= p; q++) {
            wide sum = 0;
            for (int k = 0; k < 4; k++)
                sum += (k % 3 ? -1 : 1) * moved(&j, nodes, xi, p, k / 2 ? 1 : -1, q, k % 2 ? 1 : -1).gap;
            near_enough("hessian", sum / (4 * by * by), hessian[p * (p + 1) / 2 + q]);
        }
    }
}

static void derivatives_match_differences(void **state)
{
    uint64_t stream = 8;
    (void)state;
    for (long k = 0; k < (getenv("FOOTPOINT_LONG") ? 2000 : 20); k++)
        for (int nodes = 2; nodes <= 3; nodes++) {
            double x[4][2], xi, gap;
            draw_edge(ORDINARY, &stream, nodes, x);
            if ((nodes == 2 ? footpoint_edge2_exact(x[0], x[1], x[2], &xi, &gap)
                            : footpoint_edge3_accurate(x[0], x[1], x[2], x[3], &xi, &gap)) == FOOTPOINT_OK)
                derivatives_of(nodes, x, xi);
        }
}

static void places_have_statuses(void **state)
{
    const double a[2] = {0, 0}, b[2] = {2, 0}, c[2] = {1, 0.5}, s[2] = {1, 0.5 - 1.0}, bad[2] = {NAN, 0};
    double gap = 7, d[8];
    (void)state;
    assert_int_equal(footpoint_edge3_gradients(a, b, c, s, 0, d, NULL), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(footpoint_edge3_place(a, b, c, s, 0, NULL, NULL, NULL, &gap), FOOTPOINT_OK);
    assert_true(gap == 1);
    assert_int_equal(footpoint_edge3_place(a, b, c, bad, 0, NULL, NULL, NULL, &gap), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_edge2_place(a, a, s, 0, NULL, NULL, NULL, &gap), FOOTPOINT_ERR_DEGENERATE);
    assert_true(gap == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_match_differences),
        cmocka_unit_test(places_have_statuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
