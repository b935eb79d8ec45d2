/* Rivals that are tuned to a scene, rivals that iterate until they converge, and their forms for columns. */
#include "../support/ordinary_quad.h"
#include "newton_lanes_calls.h"
#include "rivals_kept.h"
#include "trust_region.h"

#include "../../evolve/surface/foot_bilinear.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { SEGMENTS = 512 };
static const double tolerance = 1e-9;

#define NODES(q) (q).x[0], (q).x[1], (q).x[2], (q).x[3], (q).xs

static void close_to(double a, double b)
{
    if (!(fabs(a - b) <= tolerance))
        fail_msg("%a instead of %a", a, b);
}

/* A tuned iteration that starts in the middle of the whole segment equals the iteration from the centre. */
static void tuned_start_in_the_middle_is_the_centre(void **state)
{
    struct rival_tuning t = {.s = 0.5, .t = 0.5};
    t.clamp.plain = (struct rival_box){{-0.5, -0.5}, {0.5, 0.5}};
    t.clamp.scaled = (struct rival_box){{-1, -1}, {1, 1}};
    (void)state;
    for (uint64_t number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&quad_ordinary, number);
        double xi, eta, same_xi, same_eta;
#define COMPARE(name)                                                                                                  \
    rival_##name##_centre(NODES(q), &xi, &eta);                                                                        \
    rival_##name##_best(NODES(q), &t, &same_xi, &same_eta);                                                            \
    close_to(same_xi, xi);                                                                                             \
    close_to(same_eta, eta);                                                                                           \
    rival_##name##_centre_clamped(NODES(q), &xi, &eta);                                                                \
    rival_##name##_best_clamped(NODES(q), &t, &same_xi, &same_eta);                                                    \
    close_to(same_xi, xi);                                                                                             \
    close_to(same_eta, eta);
        COMPARE(gn1)
        COMPARE(gn4)
        COMPARE(gn1n3)
        COMPARE(gn2n1)
        COMPARE(n1)
    }
}

/* A step from the answer does not move. */
static void answers_do_not_move(void **state)
{
    (void)state;
    for (uint64_t number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&quad_ordinary, number);
        const struct rival_tuning t = {.s = 0.5 * (1 + q.xi), .t = 0.5 * (1 + q.eta), .xi0 = q.xi, .eta0 = q.eta};
        double xi, eta;
        rival_gn1_best(NODES(q), &t, &xi, &eta);
        close_to(xi, q.xi);
        close_to(eta, q.eta);
        rival_n2_best(NODES(q), &t, &xi, &eta);
        close_to(xi, q.xi);
        close_to(eta, q.eta);
    }
}

/* Steps with kept determinants approach the foot point, and sufficiently many reach it; the box limits them. */
static void kept_steps_converge_in_the_box(void **state)
{
    struct rival_tuning t = {.s = 0.5, .t = 0.5};
    t.clamp.plain = (struct rival_box){{-0.7, -0.7}, {0.7, 0.7}};
    double sum[7] = {0};
    (void)state;
    for (uint64_t number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&quad_ordinary, number);
        double xi, eta;
        int i = 0;
#define KEPT(name, ...)                                                                                                \
    rival_##name(NODES(q), &t, &xi, &eta);                                                                             \
    sum[i++] += fabs(xi - q.xi) + fabs(eta - q.eta);
        RIVAL_KEPT(KEPT)
        close_to(xi, q.xi);
        close_to(eta, q.eta);
    }
    for (int i = 1; i < 5; i++)
        assert_true(sum[i] < 0.5 * sum[i - 1]);
    assert_true(sum[5] < 0.1 * sum[2] && sum[5] < 1e-6 * SEGMENTS);
    t.clamp.plain = (struct rival_box){{0.1, 0.2}, {0.1, 0.2}};
    const struct quad q = quad_draw(&quad_ordinary, 0);
    double xi, eta;
    rival_hand_kept_fine(NODES(q), &t, &xi, &eta);
    assert_true(xi == 0.2 && eta == 0.4);
}

/* The inputs are those of section 3.1: distances are kept, and A, B, D are in their places. */
static void similarity_keeps_distances(void **state)
{
    (void)state;
    for (uint64_t number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&quad_ordinary, number);
        double x[RIVAL_INPUTS], ab[3], ac[3], ad[3], as[3], sc[3];
        rival_similarity(NODES(q), 1, x);
        for (int i = 0; i < 3; i++) {
            ab[i] = q.x[1][i] - q.x[0][i];
            ac[i] = q.x[2][i] - q.x[0][i];
            ad[i] = q.x[3][i] - q.x[0][i];
            as[i] = q.xs[i] - q.x[0][i];
            sc[i] = ac[i] - as[i];
        }
        const double unit = rival_dot(ab, ab);
        const double c[3] = {x[RIVAL_XC], x[RIVAL_YC], x[RIVAL_ZC]}, s[3] = {x[RIVAL_XS], x[RIVAL_YS], x[RIVAL_ZS]};
        const double d[3] = {x[RIVAL_XD], x[RIVAL_YD], 0}, cs[3] = {c[0] - s[0], c[1] - s[1], c[2] - s[2]};
        close_to(rival_dot(c, c), rival_dot(ac, ac) / unit);
        close_to(rival_dot(s, s), rival_dot(as, as) / unit);
        close_to(rival_dot(d, d), rival_dot(ad, ad) / unit);
        close_to(rival_dot(cs, cs), rival_dot(sc, sc) / unit);
        close_to(rival_dot(c, d), rival_dot(ac, ad) / unit);
        assert_true(d[1] > 0);
    }
}

/* Horner's form contains every monomial once. */
static void polynomials_have_every_monomial(void **state)
{
    const struct quad q = quad_draw(&quad_ordinary, 7);
    double x[RIVAL_INPUTS], xi, eta;
    struct rival_tuning t = {.s = 0};
    (void)state;
    rival_similarity(NODES(q), 1, x);
    for (int i = 0; i < RIVAL_TERMS; i++) {
        t.xi[i] = 1 + 0.1 * i;
        t.eta[i] = -t.xi[i];
    }
    double sum = t.xi[0], square_sum = t.xi[0];
    int at = 1, square_at = 1;
    for (int i = 0; i < RIVAL_INPUTS; i++) {
        sum += t.xi[at++] * x[i];
        square_sum += t.xi[square_at++] * x[i];
        for (int j = i; j < RIVAL_INPUTS; j++) {
            sum += t.xi[at++] * x[i] * x[j];
            square_sum += t.xi[square_at++] * x[i] * x[j];
            for (int k = j; k < RIVAL_INPUTS; k++)
                sum += t.xi[at++] * x[i] * x[j] * x[k];
        }
    }
    assert_int_equal(at, RIVAL_TERMS);
    assert_int_equal(square_at, 45);
    rival_cubic(NODES(q), &t, &xi, &eta);
    close_to(xi, sum);
    close_to(eta, -sum);
    rival_quadratic(NODES(q), &t, &xi, &eta);
    close_to(xi, square_sum);
    close_to(eta, -square_sum);
}

/* Writes quads as columns; groups of `over` share the segment of their first. */
static void fill_columns(double columns[15][NEWTON_LANES], struct quad quads[NEWTON_LANES],
                         const struct quad_limits *limits, uint64_t first, uint64_t over)
{
    for (uint64_t i = 0; i < NEWTON_LANES; i++) {
        quads[i] = quad_draw(limits, first + i);
        for (int k = 0; k < 12; k++)
            quads[i].x[k / 3][k % 3] = quads[i - i % over].x[k / 3][k % 3];
        for (int k = 0; k < 15; k++)
            columns[k][i] = k < 12 ? quads[i].x[k / 3][k % 3] : quads[i].xs[k - 12];
    }
}

static int alone(const struct quad *q, enum newton_lanes_start start, double *xi, double *eta)
{
    switch (start) {
    case NEWTON_LANES_CENTRE:
        return rival_newton(NODES(*q), RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, xi, eta);
    case NEWTON_LANES_GIVEN:
        return rival_newton_from(NODES(*q), RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, xi, eta);
    default:
        return rival_newton_fair(NODES(*q), RIVAL_FAIR_STEPS_MAX, RIVAL_FAIR_TOLERANCE, xi, eta);
    }
}

/* Each lane finds what its sample's own search finds, however long the others take. */
static void lanes_match_single_searches(void **state)
{
    const struct quad_limits limits = {0.45, 0.4, 0.8, 1.5};
    (void)state;
    for (uint64_t first = 0; first < SEGMENTS; first += NEWTON_LANES)
        for (enum newton_lanes_start start = NEWTON_LANES_CENTRE; start <= NEWTON_LANES_TAPER; start++) {
            double columns[15][NEWTON_LANES];
            const double *x[15];
            struct quad quads[NEWTON_LANES];
            struct newton_lanes lanes;
            for (int k = 0; k < 15; k++)
                x[k] = columns[k];
            fill_columns(columns, quads, &limits, first, 1);
            for (int i = 0; i < NEWTON_LANES; i++) {
                lanes.u[i] = quads[i].xi + 0.02;
                lanes.v[i] = quads[i].eta - 0.01;
            }
            newton_lanes_read(&lanes, x, start);
            newton_lanes_run(&lanes, start,
                             start == NEWTON_LANES_TAPER ? RIVAL_FAIR_TOLERANCE : RIVAL_NEWTON_TOLERANCE);
            for (int i = 0; i < NEWTON_LANES; i++) {
                double xi = quads[i].xi + 0.02, eta = quads[i].eta - 0.01;
                const int n = alone(&quads[i], start, &xi, &eta);
                assert_int_equal(n == 0, lanes.moving[i] > 0);
                if (n) {
                    close_to(lanes.u[i], xi);
                    close_to(lanes.v[i], eta);
                }
            }
        }
}

/* Lanes of fair Newton return the gap and the status of calls, whether or not slave nodes share a segment. */
static void checked_lanes_match_calls(void **state)
{
    const struct quad_limits limits = {0.25, 0.1, 0.3, 1.2};
    (void)state;
    for (uint64_t first = 0; first < SEGMENTS; first += NEWTON_LANES)
        for (int over = 1; over <= 8; over += 7) {
            double columns[15][NEWTON_LANES], xi[NEWTON_LANES], eta[NEWTON_LANES], gap[NEWTON_LANES];
            const double *x[15];
            struct quad quads[NEWTON_LANES];
            int answered[NEWTON_LANES];
            for (int k = 0; k < 15; k++)
                x[k] = columns[k];
            fill_columns(columns, quads, &limits, first, (uint64_t)over);
            newton_lanes_fair(x, over, xi, eta, gap, answered);
            for (int i = 0; i < NEWTON_LANES; i++) {
                double at[5][3], loc[2], alone_gap;
                for (int k = 0; k < 15; k++)
                    at[k / 3][k % 3] = columns[k][i];
                assert_int_equal(rival_fair_checked((const double(*)[3])at, loc, &alone_gap), answered[i]);
                if (answered[i] && fabs(loc[0]) <= 2 && fabs(loc[1]) <= 2) {
                    close_to(xi[i], loc[0]);
                    close_to(eta[i], loc[1]);
                    close_to(gap[i] / (1 + fabs(alone_gap)), alone_gap / (1 + fabs(alone_gap)));
                }
            }
        }
}

/* The result lies in the box, equals the box's closest point if that lies inside, and is never farther off than the
 * middle, the corners or the edges. */
static void trust_region_finds_the_closest_point(void **state)
{
    const struct quad_limits limits = {0.45, 0.4, 0.8, 1.5};
    const struct rival_box box = {{-1, -1}, {1, 1}};
    const double lo[2] = {-1, -1}, hi[2] = {1, 1};
    int inside = 0;
    (void)state;
    for (uint64_t number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&limits, number);
        struct sample s = {.xi = 0};
        struct rival_basis b;
        double xi, eta;
        assert_true(rival_trust_region(NODES(q), &box, RIVAL_STEPS_MAX, TRUST_REGION_TOLERANCE, &xi, &eta) > 0);
        assert_true(xi >= -1 && xi <= 1 && eta >= -1 && eta <= 1);
        rival_basis_centre(NODES(q), &b);
        const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
        const double height = trust_height(&g, (struct rival_point){xi, eta});
        for (int i = -10; i <= 10; i++)
            for (int k = -1; k <= 1; k++) { /* along both middle lines and the edges */
                assert_true(height <= trust_height(&g, (struct rival_point){0.1 * i, k}) + tolerance * g.g11);
                assert_true(height <= trust_height(&g, (struct rival_point){k, 0.1 * i}) + tolerance * g.g11);
            }
        for (int i = 0; i < 15; i++)
            (i < 12 ? s.x[i / 3] : s.xs)[i % 3] = i < 12 ? q.x[i / 3][i % 3] : q.xs[i - 12];
        if (foot_bilinear(&s, lo, hi)) {
            close_to(xi, s.xi);
            close_to(eta, s.eta);
            inside++;
        }
    }
    assert_in_range(inside, SEGMENTS / 4, SEGMENTS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(tuned_start_in_the_middle_is_the_centre),
                                       cmocka_unit_test(answers_do_not_move),
                                       cmocka_unit_test(kept_steps_converge_in_the_box),
                                       cmocka_unit_test(similarity_keeps_distances),
                                       cmocka_unit_test(polynomials_have_every_monomial),
                                       cmocka_unit_test(lanes_match_single_searches),
                                       cmocka_unit_test(checked_lanes_match_calls),
                                       cmocka_unit_test(trust_region_finds_the_closest_point)};
    return cmocka_run_group_tests_name("tuned rivals", tests, NULL, NULL);
}
