/* The hand-written methods: exact if theory predicts it, equal to textbook iterations, and within their range. */
#include "../support/ordinary_quad.h"
#include "rivals_calls.h"
#include "rivals_closed.h"
#include "rivals_converged.h"
#include "rivals_tuned.h"
#include "trust_region.h"

#include <float.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { SEGMENTS = 300 };
static const double tolerance = 1e-9;

static const char *where;
static uint64_t number;

static void close_to(const struct quad *q, double got_xi, double got_eta, double xi, double eta, double within)
{
    if (fabs(got_xi - xi) <= within && fabs(got_eta - eta) <= within)
        return;
    print_error("%s, segment %ju: (%a, %a) instead of (%a, %a)\n", where, (uintmax_t)number, got_xi, got_eta, xi, eta);
    for (int i = 0; i < 4; i++)
        print_error("  %a %a %a\n", q->x[i][0], q->x[i][1], q->x[i][2]);
    print_error("  %a %a %a\n", q->xs[0], q->xs[1], q->xs[2]);
    fail();
}

static bool named(const char *part)
{
    return strstr(where, part) != NULL;
}

/* Runs Gauss-Newton and Newton steps as in a textbook: vectors and increments, at any cost. */
static void textbook(const struct quad *q, double xi, double eta, int gauss_newton, int newton, const double range[2],
                     double found[2])
{
    for (int k = 0; k < gauss_newton + newton; k++) {
        double aa = 0, ab = 0, bb = 0, ad = 0, bd = 0, cd = 0;
        for (int i = 0; i < 3; i++) {
            const double A = q->x[0][i], B = q->x[1][i], C = q->x[2][i], D = q->x[3][i];
            const double a = ((1 - eta) * (B - A) + (1 + eta) * (C - D)) / 4;
            const double b = ((1 - xi) * (D - A) + (1 + xi) * (C - B)) / 4;
            const double r = ((1 - xi) * (1 - eta) * A + (1 + xi) * (1 - eta) * B + (1 + xi) * (1 + eta) * C +
                              (1 - xi) * (1 + eta) * D) /
                             4;
            aa += a * a;
            ab += a * b;
            bb += b * b;
            ad += a * (q->xs[i] - r);
            bd += b * (q->xs[i] - r);
            cd += (A - B + C - D) / 4 * (q->xs[i] - r);
        }
        const double h = k < gauss_newton ? ab : ab - cd;
        xi += (bb * ad - h * bd) / (aa * bb - h * h);
        eta += (aa * bd - h * ad) / (aa * bb - h * h);
        xi = fmin(fmax(xi, range[0]), range[1]);
        eta = fmin(fmax(eta, range[0]), range[1]);
    }
    found[0] = xi;
    found[1] = eta;
}

static void rivals_equal_textbook_iterations(void **state)
{
    (void)state;
    for (number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&quad_ordinary, number);
        double found[2], xi, eta;
#define COMPARE(name, start, gauss_newton, newton, clamped)                                                            \
    {                                                                                                                  \
        const double middle = start == RIVAL_CENTRE ? 0 : -0.5, end = start == RIVAL_CENTRE ? 1 : 0;                   \
        const double clamp[2] = {-1, end}, free_range[2] = {-DBL_MAX, DBL_MAX};                                        \
        where = #name;                                                                                                 \
        textbook(&q, middle, middle, gauss_newton, newton, clamped ? clamp : free_range, found);                       \
        rival_##name(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, &xi, &eta);                                                 \
        close_to(&q, xi, eta, found[0], found[1], tolerance);                                                          \
    }
        RIVAL_ITERATIONS(COMPARE)
    }
}

/* On a parallelogram every iteration converges in one step, whatever the gap. */
static void parallelograms_take_one_step(void **state)
{
    const struct quad_limits limits = {0, 0, 0.5, 0.95};
    (void)state;
    for (number = 0; number < SEGMENTS; number++) {
        struct quad q = quad_draw(&limits, number);
        /* Shear moves D and C alike, and S with them, within the plane, and so the foot point. */
        const double shear = 0.4 * ((double)number / SEGMENTS - 0.5);
        for (int k = 0; k < 3; k++) {
            const double along = shear * (q.x[1][k] - q.x[0][k]);
            q.x[2][k] += along;
            q.x[3][k] += along;
            q.xs[k] += along * (1 + q.eta) / 2;
        }
        for (int i = 0; i < rival_count; i++) {
            double xi, eta;
            where = rivals[i].name;
            /* Newton's first step is not exact off the segment, nor are areas with a gap. */
            if (strcmp(where, "area") == 0 || (named("quarter_clamped") && (q.xi > 0 || q.eta > 0)))
                continue;
            rivals[i].search(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, &xi, &eta);
            close_to(&q, xi, eta, q.xi, q.eta, tolerance);
        }
    }
}

/* (12)-(16) hold in a square without a gap. */
static void areas_are_exact_in_squares(void **state)
{
    const struct quad square = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0.3, 0.8, 0}, -0.4, 0.6, 0};
    const struct quad_limits limits = {0, 0, 0, 0.95};
    double xi, eta;
    (void)state;
    where = "area";
    number = 0;
    rival_area(square.x[0], square.x[1], square.x[2], square.x[3], square.xs, &xi, &eta);
    close_to(&square, xi, eta, square.xi, square.eta, 1e-15);
    for (; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&limits, number);
        rival_area(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, &xi, &eta);
        close_to(&q, xi, eta, q.xi, q.eta, 1e-7);
    }
}

static void plane_form_is_exact(void **state)
{
    const struct quad_limits limits = {0.25, 0, 0.5, 1.2};
    double xi, eta;
    (void)state;
    where = "plane";
    for (number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&limits, number);
        rival_plane(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, &xi, &eta);
        close_to(&q, xi, eta, q.xi, q.eta, tolerance);
    }
}

static void newton_converges(void **state)
{
    double xi, eta;
    (void)state;
    where = "newton";
    for (number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&quad_ordinary, number);
        const int steps =
            rival_newton(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &xi, &eta);
        assert_in_range(steps, 2, 8);
        close_to(&q, xi, eta, q.xi, q.eta, tolerance);
        assert_int_equal(rival_newton(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, 3, 0, &xi, &eta), 0);
    }
}

/* Fair Newton finds the reference's foot point and gap, and returns 0 if it may take too few steps. */
static void fair_newton_matches_the_reference(void **state)
{
    (void)state;
    where = "newton_fair";
    for (number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&quad_ordinary, number);
        double x[5][3], loc[2], xi, eta, gap;
        memcpy(x, q.x, sizeof q.x);
        memcpy(x[4], q.xs, sizeof q.xs);
        const int steps = rival_newton_fair(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, RIVAL_FAIR_STEPS_MAX,
                                            RIVAL_FAIR_TOLERANCE, &xi, &eta);
        assert_in_range(steps, 2, 7);
        close_to(&q, xi, eta, q.xi, q.eta, tolerance);
        assert_int_equal(rival_newton_fair(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, 3, 0, &xi, &eta), 0);
        assert_true(rival_fair_checked((const double(*)[3])x, loc, &gap));
        close_to(&q, loc[0], loc[1], q.xi, q.eta, tolerance);
        assert_true(fabs(gap - q.gap) <= tolerance * sqrt(rival_dot(q.x[1], q.x[1]) + rival_dot(q.xs, q.xs)));
    }
}

/* If nodes lie on a line, no step succeeds, and there is no normal. */
static void fair_newton_refuses_lines(void **state)
{
    const double x[5][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}};
    double loc[2], gap;
    (void)state;
    assert_false(rival_fair_checked(x, loc, &gap));
}

static void clamped_rivals_stay_inside(void **state)
{
    const struct quad_limits limits = {0.15, 0.1, 0.3, 3};
    (void)state;
    for (number = 0; number < SEGMENTS; number++) {
        const struct quad q = quad_draw(&limits, number);
        for (int i = 0; i < rival_count; i++) {
            double xi, eta;
            where = rivals[i].name;
            if (!named("clamped"))
                continue;
            rivals[i].search(q.x[0], q.x[1], q.x[2], q.x[3], q.xs, &xi, &eta);
            assert_true(xi >= -1 && eta >= -1 && xi <= (named("quarter") ? 0 : 1) && eta <= (named("quarter") ? 0 : 1));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(rivals_equal_textbook_iterations),
                                       cmocka_unit_test(parallelograms_take_one_step),
                                       cmocka_unit_test(areas_are_exact_in_squares),
                                       cmocka_unit_test(plane_form_is_exact),
                                       cmocka_unit_test(newton_converges),
                                       cmocka_unit_test(fair_newton_matches_the_reference),
                                       cmocka_unit_test(fair_newton_refuses_lines),
                                       cmocka_unit_test(clamped_rivals_stay_inside)};
    return cmocka_run_group_tests_name("rivals", tests, NULL, NULL);
}
