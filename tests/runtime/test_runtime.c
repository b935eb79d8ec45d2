/* The runtime library: search of one pair and of many, converged Newton, segment geometry, bad input. test_contact.c
 * tests contact normal, gap, forces and the choice of a segment. */
#include "../../runtime/geometry/footpoint-quad4-geometry.h"
#include "../support/ordinary_quad.h"

#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SEGMENTS = 300 };

/* Largest error of xi and eta, and of the gap over the edge, of the iteration-free search on ordinary segments. */
#define LOCATE_ERROR 1e-6
#define NEWTON_ERROR 1e-9
#define UNTOUCHED 77.25

typedef int search(const struct quad *q, double loc[2], double *gap);

static int locate(const struct quad *q, double loc[2], double *gap)
{
    return footpoint_locate(q->x[0], q->x[1], q->x[2], q->x[3], q->xs, loc, gap);
}

static int newton(const struct quad *q, double loc[2], double *gap)
{
    return footpoint_newton(q->x[0], q->x[1], q->x[2], q->x[3], q->xs, 20, 1e-12, loc, gap, NULL);
}

static const struct method {
    const char *name;
    search *find;
    double error;
} methods[] = {{"footpoint_locate", locate, LOCATE_ERROR}, {"footpoint_newton", newton, NEWTON_ERROR}};
enum { METHODS = sizeof methods / sizeof *methods };

static double size_of(const struct quad *q)
{
    double size = 0;
    for (int k = 0; k < 3; k++)
        size = fmax(size, fabs(q->x[2][k] - q->x[0][k]));
    return size;
}

static void print_quad(const struct quad *q)
{
    for (int i = 0; i < 4; i++)
        print_error("  %c %a %a %a\n", "ABCD"[i], q -> x[i][0], q -> x[i][1], q -> x[i][2]);
    print_error("  S %a %a %a\n", q->xs[0], q->xs[1], q->xs[2]);
}

static void check_answer(const struct method *m, const struct quad *q)
{
    double loc[2] = {UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED;
    const int status = m->find(q, loc, &gap);
    if (status == FOOTPOINT_OK && fabs(loc[0] - q->xi) <= m->error && fabs(loc[1] - q->eta) <= m->error &&
        fabs(gap - q->gap) <= m->error * size_of(q))
        return;
    print_error("%s: status %d (%s), xi %a eta %a gap %a instead of %a %a %a\n", m->name, status,
                footpoint_strerror(status), loc[0], loc[1], gap, q->xi, q->eta, q->gap);
    print_quad(q);
    fail();
}

static void check_refused(const struct method *m, const struct quad *q, int expected)
{
    double loc[2] = {UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED;
    const int status = m->find(q, loc, &gap);
    if (status == expected && loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && gap == UNTOUCHED)
        return;
    print_error("%s: status %d instead of %d, xi %a eta %a gap %a\n", m->name, status, expected, loc[0], loc[1], gap);
    print_quad(q);
    fail();
}

/* ---- answers ---- */

static void points_over_a_square_are_known(void **state)
{
    struct quad q = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0}, 0, 0, 0};
    (void)state;
    for (int i = 0; i <= 4; i++)
        for (int j = 0; j <= 4; j++)
            for (int k = -1; k <= 1; k++) {
                q.xi = 0.5 * i - 1;
                q.eta = 0.5 * j - 1;
                q.gap = 0.125 * k;
                q.xs[0] = 0.25 * i;
                q.xs[1] = 0.25 * j;
                q.xs[2] = q.gap;
                for (int m = 0; m < METHODS; m++)
                    check_answer(&methods[m], &q);
            }
}

static void points_over_a_parallelogram_are_known(void **state)
{
    /* A = (1,2,3), edges (2,0,1) and (1,1,0); S over (xi,eta) = (0.5,-0.25) by 0.3 along (-1,1,2)/sqrt(6). */
    const double n = 0.3 / sqrt(6);
    const struct quad q = {{{1, 2, 3}, {3, 2, 4}, {4, 3, 4}, {2, 3, 3}},
                           {1 + 0.75 * 2 + 0.375 - n, 2 + 0.375 + n, 3 + 0.75 + 2 * n},
                           0.5,
                           -0.25,
                           0.3};
    (void)state;
    for (int m = 0; m < METHODS; m++)
        check_answer(&methods[m], &q);
}

static void ordinary_segments_are_accurate(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i);
        for (int m = 0; m < METHODS; m++)
            check_answer(&methods[m], &q);
    }
}

/* Strong warp and taper, and foot points outside, which Newton's iteration finds but the iteration-free search does
 * not. */
static void newton_finds_warped_foot_points(void **state)
{
    const struct quad_limits limits = {0.2, 0.2, 0.1, 1.3};
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&limits, i);
        check_answer(&methods[1], &q);
    }
}

/* ---- properties ---- */

static void moving_and_scaling_keep_answers(void **state)
{
    static const double scale[] = {1, 0.25, 1e-6, 1e6};
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i),
                          moved = quad_move(&q, i + 1, scale[i % 4], i % 3 ? 10 : 1e6);
        for (int m = 0; m < METHODS; m++) {
            double loc[2], gap, loc_moved[2], gap_moved;
            check_answer(&methods[m], &moved);
            assert_int_equal(methods[m].find(&q, loc, &gap), FOOTPOINT_OK);
            assert_int_equal(methods[m].find(&moved, loc_moved, &gap_moved), FOOTPOINT_OK);
            assert_true(fabs(loc[0] - loc_moved[0]) < 1e-8);
            assert_true(fabs(loc[1] - loc_moved[1]) < 1e-8);
            assert_true(fabs(gap * scale[i % 4] - gap_moved) < 1e-8 * size_of(&moved));
        }
    }
}

static void renumbering_keeps_the_point(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        struct quad q = quad_draw(&quad_ordinary, i);
        for (int turn = 0; turn < 4; turn++) {
            const struct quad mirror = quad_mirror_corners(&q);
            for (int m = 0; m < METHODS; m++) {
                check_answer(&methods[m], &q);
                check_answer(&methods[m], &mirror);
            }
            q = quad_turn_corners(&q);
        }
    }
}

static void inputs_stay_unchanged(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        struct quad q;
        const struct quad drawn = quad_draw(&quad_ordinary, i);
        memcpy(&q, &drawn, sizeof q);
        for (int m = 0; m < METHODS; m++) {
            double loc[2], gap;
            methods[m].find(&q, loc, &gap);
            assert_memory_equal(q.x, drawn.x, sizeof q.x);
            assert_memory_equal(q.xs, drawn.xs, sizeof q.xs);
        }
    }
}

/* ---- bad input ---- */

static void bad_numbers_are_refused(void **state)
{
    static const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    (void)state;
    for (int k = 0; k < 15; k++)
        for (int b = 0; b < 3; b++) {
            struct quad q = quad_draw(&quad_ordinary, (uint64_t)k);
            *(k < 12 ? &q.x[k / 3][k % 3] : &q.xs[k % 3]) = bad[b];
            for (int m = 0; m < METHODS; m++)
                check_refused(&methods[m], &q, FOOTPOINT_ERR_NOT_FINITE);
        }
}

/* If two corners of a segment coincide, the answer is as usual if there is an area at the foot point. */
static void collapsed_corners_have_answers(void **state)
{
    (void)state;
    for (int m = 0; m < METHODS; m++)
        for (int edge = 0; edge < 4; edge++) {
            int answered = 0;
            for (int i = 0; i < SEGMENTS; i++) {
                struct quad q = quad_draw(&quad_ordinary, (uint64_t)(4 * i + edge));
                double r[3], n[3], loc[2], gap;
                memcpy(q.x[edge], q.x[(edge + 1) % 4], sizeof q.x[0]);
                q.xi *= 0.8;
                q.eta *= 0.8;
                footpoint_quad4_position(q.x[0], q.x[1], q.x[2], q.x[3], q.xi, q.eta, r);
                if (footpoint_quad4_normal(q.x[0], q.x[1], q.x[2], q.x[3], q.xi, q.eta, n) != FOOTPOINT_OK)
                    fail();
                q.gap *= 0.1;
                for (int k = 0; k < 3; k++)
                    q.xs[k] = r[k] + q.gap * n[k];
                const int status = methods[m].find(&q, loc, &gap);
                if (status != FOOTPOINT_ERR_DOMAIN) {
                    check_answer(&methods[m], &q);
                    answered++;
                }
            }
            if (answered < SEGMENTS * 3 / 4)
                fail_msg("%s, edge %d: %d", methods[m].name, edge, answered);
        }
}

/* Corners that enclose no area. */
static void corners_without_area_are_refused(void **state)
{
    static const int same[5][4] = {{0, 0, 2, 2}, {0, 1, 1, 0}, {0, 0, 0, 3}, {0, 1, 0, 1}, {2, 2, 2, 2}};
    (void)state;
    for (int i = 0; i < 5; i++) {
        const struct quad q = quad_draw(&quad_ordinary, (uint64_t)i);
        struct quad flat = q;
        for (int k = 0; k < 4; k++)
            memcpy(flat.x[k], q.x[same[i][k]], sizeof q.x[k]);
        for (int m = 0; m < METHODS; m++)
            check_refused(&methods[m], &flat, FOOTPOINT_ERR_DEGENERATE);
    }
}

static void newton_statuses_are_right(void **state)
{
    const struct quad q = quad_draw(&quad_ordinary, 5);
    const struct quad line = {{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}, {1, 2, 0}, 0, 0, 0};
    double loc[2] = {UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED;
    int iterations = -7;
    (void)state;
    check_refused(&methods[1], &line, FOOTPOINT_ERR_DEGENERATE);
#define NEWTON(most, tolerance)                                                                                        \
    footpoint_newton(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, most, tolerance, loc, &gap, &iterations)
    assert_int_equal(NEWTON(0, 1e-12), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(NEWTON(20, 0), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(NEWTON(20, -1), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(NEWTON(20, (double)NAN), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(NEWTON(2, 1e-12), FOOTPOINT_ERR_NO_CONVERGENCE);
    assert_true(loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && gap == UNTOUCHED && iterations == -7);
    assert_int_equal(NEWTON(20, 1e-12), FOOTPOINT_OK);
    assert_in_range(iterations, 3, 8);
#undef NEWTON
}

/* A segment with an area is never degenerate: slave nodes far away, corners collapsed and edges crossed. */
static void segments_with_area_are_not_degenerate(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < 20 * SEGMENTS; i++) {
        struct quad q = quad_draw(&quad_ordinary, i);
        const double far = ldexp(1.0, (int)(i % 1000));
        for (int k = 0; k < 3; k++) {
            q.xs[k] *= far;
            if (i % 3 == 1)
                q.x[2][k] = q.x[3][k];
            const double b = q.x[1][k];
            if (i % 3 == 2) {
                q.x[1][k] = q.x[2][k];
                q.x[2][k] = b;
            }
        }
        double loc[2] = {UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED;
        const int status = footpoint_newton(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, 20, 1e-12, loc, &gap, NULL);
        assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_ERR_NO_CONVERGENCE);
        assert_true(status == FOOTPOINT_OK || (loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && gap == UNTOUCHED));
    }
}

static void every_status_has_a_text(void **state)
{
    (void)state;
    const char *unknown = footpoint_strerror(INT_MAX);
    assert_string_equal(footpoint_strerror(FOOTPOINT_STATUS_MOST + 1), unknown);
    assert_string_equal(footpoint_strerror(FOOTPOINT_STATUS_LEAST - 1), unknown);
    assert_string_equal(footpoint_strerror(INT_MIN), unknown);
    for (int i = FOOTPOINT_STATUS_LEAST; i <= FOOTPOINT_STATUS_MOST; i++) {
        assert_true(strlen(footpoint_strerror(i)) > 0);
        assert_string_not_equal(footpoint_strerror(i), unknown);
        for (int j = FOOTPOINT_STATUS_LEAST; j < i; j++)
            assert_string_not_equal(footpoint_strerror(i), footpoint_strerror(j));
    }
}

/* ---- many pairs ---- */

enum { PAIRS = 200, NODES = 5 * PAIRS };

struct batch {
    double xyz[NODES][3], loc[PAIRS][2], gap[PAIRS];
    int seg[PAIRS][4], slave[PAIRS], status[PAIRS];
};

/* Fills in ordinary segments with their nodes scattered over the array. */
static void fill(struct batch *b)
{
    for (int i = 0; i < PAIRS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, (uint64_t)i);
        for (int k = 0; k < 5; k++) {
            const int node = (7 * (5 * i + k)) % NODES;
            memcpy(b->xyz[node], k < 4 ? q.x[k] : q.xs, sizeof b->xyz[node]);
            *(k < 4 ? &b->seg[i][k] : &b->slave[i]) = node;
        }
        b->loc[i][0] = b->loc[i][1] = b->gap[i] = UNTOUCHED;
        b->status[i] = -7;
    }
}

static size_t locate_pairs(struct batch *b, int n, int *status)
{
    return footpoint_locate_pairs((size_t)n, b->xyz[0], NODES, b->seg[0], b->slave, b->loc[0], b->gap, status);
}

static void check_pair(const struct batch *b, int i)
{
    const struct quad q = quad_draw(&quad_ordinary, (uint64_t)i);
    double loc[2], gap;
    assert_int_equal(locate(&q, loc, &gap), FOOTPOINT_OK);
    assert_true(fabs(b->loc[i][0] - loc[0]) <= NEWTON_ERROR);
    assert_true(fabs(b->loc[i][1] - loc[1]) <= NEWTON_ERROR);
    assert_true(fabs(b->gap[i] - gap) <= NEWTON_ERROR * size_of(&q));
}

static void check_untouched(const struct batch *b, int i)
{
    assert_true(b->loc[i][0] == UNTOUCHED && b->loc[i][1] == UNTOUCHED && b->gap[i] == UNTOUCHED);
}

static void pairs_match_single_calls(void **state)
{
    static const int counts[] = {0, 1, 2, 7, 63, 64, 65, 127, 128, 129, PAIRS};
    static struct batch b;
    (void)state;
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        fill(&b);
        assert_int_equal(locate_pairs(&b, counts[c], c % 2 ? b.status : NULL), 0);
        for (int i = 0; i < PAIRS; i++)
            if (i < counts[c]) {
                check_pair(&b, i);
                assert_int_equal(b.status[i], c % 2 ? FOOTPOINT_OK : -7);
            } else
                check_untouched(&b, i);
    }
}

static void bad_pairs_are_refused(void **state)
{
    static const int wrong[] = {-1, NODES, INT_MAX, INT_MIN};
    static struct batch b;
    (void)state;
    fill(&b);
    for (int i = 0; i < 20; i++)
        *(i % 5 < 4 ? &b.seg[3 * i][i % 5] : &b.slave[3 * i]) = wrong[i / 5];
    b.xyz[b.slave[70]][1] = (double)NAN;
    memcpy(b.xyz[b.seg[80][2]], b.xyz[b.seg[80][1]], sizeof b.xyz[0]);
    memcpy(b.xyz[b.seg[80][3]], b.xyz[b.seg[80][0]], sizeof b.xyz[0]);
    assert_int_equal(locate_pairs(&b, PAIRS, b.status), 22);
    for (int i = 0; i < PAIRS; i++) {
        const int expected = i < 60 && i % 3 == 0 ? FOOTPOINT_ERR_ARGUMENT
                             : i == 70            ? FOOTPOINT_ERR_NOT_FINITE
                             : i == 80            ? FOOTPOINT_ERR_DEGENERATE
                                                  : FOOTPOINT_OK;
        assert_int_equal(b.status[i], expected);
        if (expected == FOOTPOINT_OK)
            check_pair(&b, i);
        else
            check_untouched(&b, i);
    }
    assert_int_equal(footpoint_locate_pairs(PAIRS, NULL, 0, b.seg[0], b.slave, b.loc[0], b.gap, b.status), PAIRS);
}

/* ---- geometry ---- */

static void shape_functions_are_right(void **state)
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double phi[4];
    (void)state;
    for (int i = 0; i < 4; i++) {
        footpoint_quad4_shape(corner[i][0], corner[i][1], phi);
        for (int j = 0; j < 4; j++)
            assert_true(phi[j] == (i == j));
    }
    footpoint_quad4_shape(0.3, -0.7, phi);
    assert_true(fabs(phi[0] + phi[1] + phi[2] + phi[3] - 1) < 1e-15);
    assert_true(fabs(phi[1] + phi[2] - phi[0] - phi[3] - 0.3) < 1e-15);
    assert_true(fabs(phi[2] + phi[3] - phi[0] - phi[1] + 0.7) < 1e-15);
}

static void derivatives_match_differences(void **state)
{
    const double h = 1e-5;
    (void)state;
    for (uint64_t i = 0; i < SEGMENTS; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i);
        const double *A = q.x[0], *B = q.x[1], *C = q.x[2], *D = q.x[3], size = size_of(&q);
        double phi[4], r[3], r_xi[3], r_eta[3], n[3], d[3], low[3], high[3], gap, length = 0;
        footpoint_quad4_shape(q.xi, q.eta, phi);
        footpoint_quad4_position(A, B, C, D, q.xi, q.eta, r);
        footpoint_quad4_offset(A, B, C, D, q.xs, q.xi, q.eta, d);
        footpoint_quad4_derivatives(A, B, C, D, q.xi, q.eta, r_xi, r_eta);
        assert_int_equal(footpoint_quad4_normal(A, B, C, D, q.xi, q.eta, n), FOOTPOINT_OK);
        assert_int_equal(footpoint_quad4_gap(A, B, C, D, q.xs, q.xi, q.eta, &gap), FOOTPOINT_OK);
        assert_true(fabs(gap - q.gap) < 1e-12 * size);
        for (int k = 0; k < 3; k++) {
            const double sum = phi[0] * A[k] + phi[1] * B[k] + phi[2] * C[k] + phi[3] * D[k];
            assert_true(fabs(r[k] - sum) < 1e-13 * size);
            assert_true(fabs(d[k] - (q.xs[k] - r[k])) < 1e-13 * size);
            assert_true(fabs(d[k] - q.gap * n[k]) < 1e-12 * size);
            length += n[k] * n[k];
        }
        assert_true(fabs(length - 1) < 1e-14);
        footpoint_quad4_position(A, B, C, D, q.xi - h, q.eta, low);
        footpoint_quad4_position(A, B, C, D, q.xi + h, q.eta, high);
        for (int k = 0; k < 3; k++)
            assert_true(fabs((high[k] - low[k]) / (2 * h) - r_xi[k]) < 1e-9 * size);
        footpoint_quad4_position(A, B, C, D, q.xi, q.eta - h, low);
        footpoint_quad4_position(A, B, C, D, q.xi, q.eta + h, high);
        for (int k = 0; k < 3; k++)
            assert_true(fabs((high[k] - low[k]) / (2 * h) - r_eta[k]) < 1e-9 * size);
    }
}

static void degenerate_normals_are_refused(void **state)
{
    const double O[3] = {0, 0, 0}, X[3] = {1, 0, 0}, X2[3] = {2, 0, 0}, X3[3] = {3, 0, 0};
    double n[3] = {UNTOUCHED, UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED;
    (void)state;
    assert_int_equal(footpoint_quad4_normal(O, X, X3, X2, 0, 0, n), FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(footpoint_quad4_gap(O, X, X3, X2, O, 0, 0, &gap), FOOTPOINT_ERR_DEGENERATE);
    assert_true(n[0] == UNTOUCHED && n[1] == UNTOUCHED && n[2] == UNTOUCHED && gap == UNTOUCHED);
}

/* Four different corners on a line have no normal; the status reports it and the outputs stay. */
static void lines_have_no_normal(void **state)
{
    (void)state;
    srand(5);
    for (int n = 0; n < 2000; n++) {
        double x[5][3], way[3], loc[2] = {7, 7}, gap = 7;
        for (int k = 0; k < 3; k++)
            way[k] = rand() / (double)RAND_MAX - 0.5;
        for (int i = 0; i < 5; i++) {
            const double at = rand() / (double)RAND_MAX;
            for (int k = 0; k < 3; k++)
                x[i][k] = at * way[k] + (i == 4 ? rand() / (double)RAND_MAX : 0);
        }
        assert_int_equal(footpoint_locate(x[0], x[1], x[2], x[3], x[4], loc, &gap), FOOTPOINT_ERR_DEGENERATE);
        assert_true(loc[0] == 7 && loc[1] == 7 && gap == 7);
    }
}

/* Segments of any size have the same xi and eta, and the gap in proportion. */
static void sizes_change_only_the_gap(void **state)
{
    (void)state;
    for (int power = -300; power <= 300; power++)
        for (int m = 0; m < METHODS; m++) {
            const double size = pow(10, power);
            struct quad q = {.x = {{0, 0, 0}, {1, 0, 0.05}, {1.1, 0.75, 0}, {0, 0.6, 0.05}}, .xs = {0.35, 0.45, 0.125}};
            double loc[2], gap;
            for (int i = 0; i < 15; i++)
                *(i < 12 ? &q.x[i / 3][i % 3] : &q.xs[i % 3]) *= size;
            assert_int_equal(methods[m].find(&q, loc, &gap), FOOTPOINT_OK);
            assert_true(fabs(loc[0] + 0.349489) < 1e-6 && fabs(loc[1] - 0.395534) < 1e-6);
            assert_true(fabs(gap / size - 0.0966035) < 1e-6);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lines_have_no_normal),
                                       cmocka_unit_test(sizes_change_only_the_gap),
                                       cmocka_unit_test(points_over_a_square_are_known),
                                       cmocka_unit_test(points_over_a_parallelogram_are_known),
                                       cmocka_unit_test(ordinary_segments_are_accurate),
                                       cmocka_unit_test(newton_finds_warped_foot_points),
                                       cmocka_unit_test(moving_and_scaling_keep_answers),
                                       cmocka_unit_test(renumbering_keeps_the_point),
                                       cmocka_unit_test(inputs_stay_unchanged),
                                       cmocka_unit_test(bad_numbers_are_refused),
                                       cmocka_unit_test(collapsed_corners_have_answers),
                                       cmocka_unit_test(corners_without_area_are_refused),
                                       cmocka_unit_test(newton_statuses_are_right),
                                       cmocka_unit_test(segments_with_area_are_not_degenerate),
                                       cmocka_unit_test(every_status_has_a_text),
                                       cmocka_unit_test(pairs_match_single_calls),
                                       cmocka_unit_test(bad_pairs_are_refused),
                                       cmocka_unit_test(shape_functions_are_right),
                                       cmocka_unit_test(derivatives_match_differences),
                                       cmocka_unit_test(degenerate_normals_are_refused)};
    return cmocka_run_group_tests_name("runtime", tests, NULL, NULL);
}
