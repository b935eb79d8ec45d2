/* Checks projection along the averaged normal of faces at a node: derivatives of xi, eta and distance by the nodes of
 * these faces, through the normal, and by the node itself, against differences of two solutions in quadruple precision. */
#include "../../runtime/geometry/footpoint-averaged-normal.h"
#include "../support/long_cases.h"
#include "along_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { FACES = 3, MOST_AROUND = 1 + FACES * MOST_NODES, SHORT = 20, LONG = 20000 };

/* Holds faces around node 0, which is a different corner of each, and last a face onto which node 0 is projected. */
struct surface {
    int nodes, seg[FACES * MOST_NODES];
    double around[MOST_AROUND][3];
    along_vectors x; /* of that face; node 0 and the normal */
};

static void draw(uint64_t *stream, int nodes, struct surface *s)
{
    const struct exact_face f = exact_face_of(nodes);
    int next = 1;
    s->nodes = nodes;
    along_draw(stream, nodes, 1.0, 1.5, s->x);
    memcpy(s->around[0], s->x[nodes], sizeof s->around[0]);
    for (int n = 0; n < FACES; n++) {
        const int shared = (int)(along_uniform(stream) * nodes);
        for (int k = 0; k < nodes; k++) {
            const int node = k == shared ? 0 : next++;
            s->seg[n * nodes + k] = node;
            for (int i = 0; node && i < 3; i++)
                s->around[node][i] = s->around[0][i] + (i < 2 ? f.place[k][i] - f.place[shared][i] : 0.0) +
                                     0.2 * (along_uniform(stream) - 0.5);
        }
    }
}

/* Solves for {xi, eta, distance} with all nodes moved. */
static void solve_moved(const struct surface *s, const double *by, quadruple step, const double from[3],
                        quadruple at[3])
{
    const struct exact_face f = exact_face_of(s->nodes);
    quadruple around[3 * MOST_AROUND], y[MOST_ALONG] = {0};
    for (int i = 0; i < 3 * (1 + FACES * (s->nodes - 1)); i++)
        around[i] = (&s->around[0][0])[i] + step * by[3 * s->nodes + i];
    for (int i = 0; i < 3 * s->nodes; i++)
        y[i] = s->x[i / 3][i % 3] + step * by[i];
    quadruple *const slave = y + 3 * s->nodes, *const along = slave + 3;
    memcpy(slave, around, 3 * sizeof *slave);
    for (int n = 0; n < FACES; n++) {
        quadruple z[3 * MOST_NODES], a[3], b[3];
        int shared = 0;
        for (int k = 0; k < s->nodes; k++) {
            shared = s->seg[n * s->nodes + k] ? shared : k;
            memcpy(z + 3 * k, around + 3 * s->seg[n * s->nodes + k], 3 * sizeof *z);
        }
        along_tangents(&f, z, f.place[shared][0], f.place[shared][1], a, b);
        for (int i = 0; i < 3; i++)
            along[i] += a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    }
    along_solve(&f, y, from, at);
}

/* Returns the derivative along a change `by` of the nodes of the face and of all nodes around. */
static double chained(const struct surface *s, enum footpoint_face face, const double *d, const double *by)
{
    const double *const around = by + 3 * s->nodes;
    double through[3 * FACES * MOST_NODES], sum = 0.0;
    assert_int_equal(
        footpoint_averaged_normal_gradient(face, s->around[0], FACES, s->seg, 0, d + 3 * s->nodes + 3, through),
        FOOTPOINT_OK);
    for (int i = 0; i < 3 * s->nodes + 3; i++) /* node 0 is the slave node */
        sum += d[i] * by[i];
    for (int i = 0; i < 3 * FACES * s->nodes; i++)
        sum += through[i] * around[3 * s->seg[i / 3] + i % 3];
    return sum;
}

static void derivatives_match_differences(void **state)
{
    static const struct {
        int nodes;
        enum footpoint_face face;
    } kind[] = {
        {3, FOOTPOINT_TRI3}, {6, FOOTPOINT_TRI6}, {4, FOOTPOINT_QUAD4}, {8, FOOTPOINT_QUAD8}, {9, FOOTPOINT_QUAD9}};
    const quadruple step = 1e-12;
    uint64_t stream = 21;
    int judged = 0;
    (void)state;
    for (long n = 0; n < 5 * long_cases(SHORT, LONG); n++) {
        const enum footpoint_face face = kind[n % 5].face;
        double by[3 * MOST_NODES + 3 * MOST_AROUND], d[3][MOST_ALONG], from[3];
        quadruple at[2][3];
        struct surface s;
        draw(&stream, kind[n % 5].nodes, &s);
        double *const normal = s.x[s.nodes + 1];
        assert_int_equal(footpoint_averaged_normal(face, s.around[0], FACES, s.seg, 0, normal), FOOTPOINT_OK);
        if (footpoint_face_along(face, s.x[0], normal, from, &from[2]) < FOOTPOINT_OK)
            continue; /* the line passes by */
        judged++;
        assert_int_equal(footpoint_face_differentiate_along(face, s.x[0], normal, from, &from[2], d[0], d[1], d[2],
                                                            NULL, NULL, NULL),
                         FOOTPOINT_OK);
        for (size_t i = 0; i < sizeof by / sizeof *by; i++)
            by[i] = along_uniform(&stream) - 0.5;
        for (int k = 0; k < 2; k++)
            solve_moved(&s, by, k ? -step : step, from, at[k]);
        for (int j = 0; j < 3; j++) {
            const double sum = chained(&s, face, d[j], by), truth = (double)((at[0][j] - at[1][j]) / (2 * step));
            if (!(fabs(sum - truth) <= 1e-9 * (1.0 + fabs(truth))))
                fail_msg("%d nodes, row %d: %.17g, not %.17g", s.nodes, j, sum, truth);
        }
    }
    assert_true(judged >= 4 * long_cases(SHORT, LONG));
}

/* Checks two edges at a corner of the plane: the sum of their normals, weighted by half their lengths. */
static void edges_have_normals(void **state)
{
    const double xyz[] = {0, 0, 0, 2, 0, 9, 2, 4, -9, 1, 0, 3, 2, 2, 3};
    const int two[] = {0, 1, 1, 2}, three[] = {0, 1, 3, 1, 2, 4};
    const double g[3] = {1, 10, 100};
    double normal[3], by[18];
    (void)state;
    assert_int_equal(footpoint_averaged_normal(FOOTPOINT_EDGE2, xyz, 2, two, 1, normal), FOOTPOINT_OK);
    assert_true(normal[0] == 2 && normal[1] == -1 && normal[2] == 0);
    assert_int_equal(footpoint_averaged_normal(FOOTPOINT_EDGE3, xyz, 2, three, 1, normal), FOOTPOINT_OK);
    assert_true(normal[0] == 2 && normal[1] == -1 && normal[2] == 0);
    assert_int_equal(footpoint_averaged_normal_gradient(FOOTPOINT_EDGE2, xyz, 2, two, 1, g, by), FOOTPOINT_OK);
    for (int e = 0; e < 2; e++) /* n = (t_y, -t_x), t = (x1 - x0)/2 */
        assert_true(by[6 * e] == 5 && by[6 * e + 1] == -0.5 && by[6 * e + 3] == -5 && by[6 * e + 4] == 0.5 &&
                    by[6 * e + 2] == 0 && by[6 * e + 5] == 0);
}

static void statuses(void **state)
{
    const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, (double)NAN, 0, 0};
    const int there[] = {0, 1, 2}, back[] = {0, 1, 2, 0, 2, 1}, bad[] = {0, 1, 3};
    double normal[3] = {7, 7, 7}, by[9] = {7};
    (void)state;
    assert_int_equal(footpoint_averaged_normal(FOOTPOINT_FACES, xyz, 1, there, 0, normal), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_averaged_normal(FOOTPOINT_TRI3, xyz, 1, there, 3, normal), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_averaged_normal(FOOTPOINT_TRI3, xyz, 2, back, 0, normal), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(footpoint_averaged_normal(FOOTPOINT_TRI3, xyz, 1, bad, 0, normal), FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_averaged_normal_gradient(FOOTPOINT_TRI3, xyz, 1, bad, 0, normal, by),
                     FOOTPOINT_ERR_NOT_FINITE);
    assert_true(normal[0] == 7 && by[0] == 7);
    assert_int_equal(footpoint_averaged_normal(FOOTPOINT_TRI3, xyz, 1, there, 0, normal), FOOTPOINT_OK);
    assert_true(normal[0] == 0 && normal[1] == 0 && normal[2] == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(derivatives_match_differences),
                                       cmocka_unit_test(edges_have_normals), cmocka_unit_test(statuses)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
