/* Checks edges in float. If footpoint_edge2_float_exact, footpoint_edge3_float_accurate, their _from or their _closest
 * return FOOTPOINT_OK or FOOTPOINT_NOT_UNIQUE, that must hold, in calls and over arrays, for the families of
 * edge_judge.h. The judge finds all roots of the cubic of shape functions in quadruple precision from the same floats.
 * 1e5 of each with FOOTPOINT_LONG. */
#include "../support/long_cases.h"
#include "footpoint_edge2_float.h"
#include "footpoint_edge3_float.h"

#include "../hard/draw.h"
#include "../plane/edge_judge.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { CASES = 500, CASES_LONG = 100000, BLOCK = 480 };

struct edge {
    float x[4][2]; /* the slave node follows the nodes */
};

static float rounded(double x)
{
    return fabs(x) <= (double)FLT_MAX ? (float)x : (float)copysign(HUGE_VAL, x);
}

static struct edge draw(enum family family, uint64_t *stream, int nodes)
{
    const double size = family == SIZE ? draw_power(stream, -45, 38) : 1;
    struct edge e;
    double x[4][2];
    draw_edge(family == SIZE ? ORDINARY : family, stream, nodes, x);
    for (int k = 0; k < 2 * (nodes + 1); k++)
        e.x[k / 2][k % 2] = rounded(size * x[k / 2][k % 2]);
    return e;
}

/* ---- calls ---- */

static int locate(int nodes, const struct edge *e, float *xi, float *gap)
{
    return nodes == 2 ? footpoint_edge2_float_exact(e->x[0], e->x[1], e->x[2], xi, gap)
                      : footpoint_edge3_float_accurate(e->x[0], e->x[1], e->x[2], e->x[3], xi, gap);
}

static int follow(int nodes, const struct edge *e, float *xi, float *gap)
{
    return nodes == 2 ? footpoint_edge2_float_exact_from(e->x[0], e->x[1], e->x[2], xi, gap)
                      : footpoint_edge3_float_accurate_from(e->x[0], e->x[1], e->x[2], e->x[3], xi, gap);
}

static int closest(int nodes, const struct edge *e, float *xi, float *dist, int *region)
{
    return nodes == 2 ? footpoint_edge2_float_exact_closest(e->x[0], e->x[1], e->x[2], xi, dist, region)
                      : footpoint_edge3_float_accurate_closest(e->x[0], e->x[1], e->x[2], e->x[3], xi, dist, region);
}

/* ---- the judge ---- */

static void refuse(int nodes, const struct edge *e, enum family family, const char *call, float xi, float gap)
{
    for (int k = 0; k <= nodes; k++)
        print_error("{%a, %a},\n", (double)e->x[k][0], (double)e->x[k][1]);
    fail_msg("%s, %d nodes, %s: xi %.9g, gap %.9g", edge_families[family], nodes, call, (double)xi, (double)gap);
}

static void begin(struct judged *j, int nodes, const struct edge *e)
{
    double x[4][2];
    for (int k = 0; k < 2 * (nodes + 1); k++)
        x[k / 2][k % 2] = (double)e->x[k / 2][k % 2];
    judge_edge(j, nodes, x);
    judge_single(j);
}

/* Returns 1 if the foot point is proved, plus 2 if the closest point is proved, or that another point is as near. */
static int judge(int nodes, const struct edge *e, enum family family, float last)
{
    struct judged j;
    float xi = 0, gap = 0, from = last, dist = 0;
    int region = 0, proved = 0, status;
    begin(&j, nodes, e);
    if (locate(nodes, e, &xi, &gap) == FOOTPOINT_OK && ++proved &&
        (!judge_holds(&j, (double)xi) || !judge_gap_holds(&j, (double)xi, (double)gap)))
        refuse(nodes, e, family, "foot point", xi, gap);
    if (follow(nodes, e, &from, &gap) == FOOTPOINT_OK &&
        (!judge_holds(&j, (double)from) || !judge_gap_holds(&j, (double)from, (double)gap)))
        refuse(nodes, e, family, "from the last answer", from, gap);
    judge_find(&j);
    status = closest(nodes, e, &xi, &dist, &region);
    if (status != FOOTPOINT_OK && status != FOOTPOINT_NOT_UNIQUE)
        return proved;
    if (!judge_closest_holds(&j, status, (double)xi, (double)dist, region))
        refuse(nodes, e, family, "closest point", xi, dist);
    return proved + 2;
}

/* ---- tests ---- */

/* Sets the percentages of foot points and of closest points that must be proved, by nodes. */
/* clang-format off */
static const int least[2][FAMILIES][2] = {
    {{99, 99}, {99, 99}, {99, 99}, {99, 99}, {99, 99}, {60, 60}, {65, 65}, {60, 60}, {60, 60}, {0, 0}, {99, 99}, {99, 99}},
    {{99, 99}, {98, 85}, {98, 90}, {90, 70}, {99, 70}, {50, 40}, {90, 85}, {70, 70}, {70, 70}, {60, 10}, {99, 99}, {95, 50}}};
/* clang-format on */

static void promises_hold(void **state)
{
    const long n = long_cases(CASES, CASES_LONG);
    (void)state;
    for (int nodes = 2; nodes <= 3; nodes++)
        for (int family = 0; family < FAMILIES; family++) {
            uint64_t stream = (uint64_t)(2 * family + nodes);
            long found = 0, near = 0;
            for (long k = 0; k < n; k++) {
                const struct edge e = draw((enum family)family, &stream, nodes);
                const float last = k % 50 ? (float)draw_flat(&stream, -1.5, 1.5) : (float)NAN;
                const int proved = judge(nodes, &e, (enum family)family, last);
                found += proved & 1;
                near += proved >> 1;
            }
            print_message("# edge%d, %s: %.2f %% proved, %.2f %% of the closest points\n", nodes, edge_families[family],
                          100. * (double)found / (double)n, 100. * (double)near / (double)n);
            assert_true(100 * found >= least[nodes - 2][family][0] * n &&
                        100 * near >= least[nodes - 2][family][1] * n);
        }
}

/* Checks that arrays return the bits of calls, except for fused operations. */
static void arrays_match_calls(void **state)
{
    static float column[8][BLOCK], xi[3][BLOCK], gap[3][BLOCK];
    static int region[BLOCK], status[3][BLOCK];
    static struct edge e[BLOCK];
    const float *c[8];
    (void)state;
    for (int k = 0; k < 8; k++)
        c[k] = column[k];
    for (int nodes = 2; nodes <= 3; nodes++) {
        uint64_t stream = 9;
        for (int i = 0; i < BLOCK; i++) {
            e[i] = draw((enum family)(i % FAMILIES), &stream, nodes);
            xi[1][i] = i % 7 ? 0.1f : (float)NAN;
            for (int k = 0; k < 2 * (nodes + 1); k++)
                column[k][i] = e[i].x[k / 2][k % 2];
        }
        (nodes == 2 ? footpoint_edge2_float_exact_checked_n
                    : footpoint_edge3_float_accurate_checked_n)(BLOCK, c, xi[0], gap[0], status[0]);
        (nodes == 2 ? footpoint_edge2_float_exact_from_n : footpoint_edge3_float_accurate_from_n)(BLOCK, c, xi[1],
                                                                                                  gap[1], status[1]);
        (nodes == 2 ? footpoint_edge2_float_exact_closest_n
                    : footpoint_edge3_float_accurate_closest_n)(BLOCK, c, xi[2], gap[2], region, status[2]);
        for (int i = 0; i < BLOCK; i++)
            for (int call = 0; call < 3; call++) {
                float at = i % 7 ? 0.1f : (float)NAN, g = 0;
                int where = 0;
                const int alone = call == 0   ? locate(nodes, &e[i], &at, &g)
                                  : call == 1 ? follow(nodes, &e[i], &at, &g)
                                              : closest(nodes, &e[i], &at, &g, &where);
                struct judged j;
                begin(&j, nodes, &e[i]);
                assert_true(call == 2 || status[call][i] != FOOTPOINT_OK || judge_holds(&j, (double)xi[call][i]));
#ifndef __FMA__
                assert_int_equal(status[call][i], alone);
                if (alone >= FOOTPOINT_OK)
                    assert_true(xi[call][i] == at && gap[call][i] == g);
#else
                (void)alone;
#endif
            }
    }
}

/* Checks intersections of lines and edges: the judge walks from the answer along the line. */
static void lines_meet_edges(void **state)
{
    uint64_t stream = 12;
    long proved = 0;
    (void)state;
    for (int k = 0; k < 2000; k++) {
        const struct edge e = draw(k % 2 ? ORDINARY : CURVED, &stream, 3);
        const float along[2] = {(float)draw_flat(&stream, -1, 1), (float)draw_flat(&stream, -1, 1)};
        float xi = 0, dist;
        struct judged j;
        if (footpoint_edge3_float_along(e.x[0], e.x[1], e.x[2], e.x[3], along, &xi, &dist) != FOOTPOINT_OK)
            continue;
        proved++;
        begin(&j, 3, &e);
        wide side[2];
        for (int i = 0; i < 2; i++) {
            wide r[2];
            judge_point(&j, (wide)xi + (2 * i - 1) * (wide)FOOTPOINT_ALONG_PROMISE_F, r);
            side[i] = (r[0] - j.x[3][0]) * (wide)along[1] - (r[1] - j.x[3][1]) * (wide)along[0];
        }
        assert_true((side[0] < 0) != (side[1] < 0));
    }
    assert_true(proved > 500);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(promises_hold),
        cmocka_unit_test(arrays_match_calls),
        cmocka_unit_test(lines_meet_edges),
    };
    return cmocka_run_group_tests_name("float promises of edges", tests, NULL, NULL);
}
