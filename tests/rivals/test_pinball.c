/* The pinball test: known answers above a square, invariance under motion and change of scale, and the classification
 * of decisions. */
#include "../support/ordinary_quad.h"
#include "contact_table.h"
#include "pinball.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>

/* Returns a square of edge `edge` about the origin, seen from above, with a slave node. */
static struct sample square(double edge, double x, double y, double z)
{
    const double h = edge / 2;
    return (struct sample){
        .x = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}, .xs = {x, y, z}, .xi = x / h, .eta = y / h, .gap = z};
}

static double depth_of(const struct sample *s)
{
    return rival_pinball_depth(s->x[0], s->x[1], s->x[2], s->x[3], s->xs);
}

static void near(double got, double expected)
{
    if (!(fabs(got - expected) <= 1e-13 * (1 + fabs(expected))))
        fail_msg("%.17g instead of %.17g", got, expected);
}

static void depths_over_a_square_are_known(void **state)
{
    (void)state;
    const double pi = 3.14159265358979324;
    /* two spheres with the volume of a unit cube */
    const double diameter = 2 * cbrt(3 / (4 * pi));
    const struct sample touching = square(1, 0, 0, 0), above = square(1, 0, 0, diameter - 1);
    const struct sample below = square(1, 0, 0, -0.3), aside = square(1, 0.6, 0.8, -1), big = square(4, 0, 0, 1);
    near(depth_of(&touching), diameter - 1);
    near(depth_of(&above), 0);
    near(depth_of(&below), diameter - 0.7);
    near(depth_of(&aside), diameter - 1); /* centres side by side, 1 apart */
    near(depth_of(&big), 4 * diameter - 5);
}

static void depth_does_not_depend_on_place_and_size(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < 200; i++) {
        const struct quad q = quad_draw(&quad_ordinary, i);
        double x[5][3];
        const double *node[5] = {q.x[0], q.x[1], q.x[2], q.x[3], q.xs};
        for (int n = 0; n < 5; n++) { /* times 3, turned about two axes, moved */
            const double a = 0.6 * node[n][0] - 0.8 * node[n][1], b = 0.8 * node[n][0] + 0.6 * node[n][1];
            x[n][0] = 3 * a + 5;
            x[n][1] = 3 * (0.28 * b - 0.96 * node[n][2]) - 2;
            x[n][2] = 3 * (0.96 * b + 0.28 * node[n][2]);
        }
        const double depth = rival_pinball_depth(q.x[0], q.x[1], q.x[2], q.x[3], q.xs);
        near(rival_pinball_depth(x[0], x[1], x[2], x[3], x[4]) / 3, depth);
        near(rival_pinball_depth(x[1], x[2], x[3], x[0], x[4]) / 3, depth); /* whichever corner is A */
    }
}

static void decisions_are_classified(void **state)
{
    (void)state;
    struct sample s[] = {
        square(2, 0, 0, -0.1),     /* right: contact */
        square(2, 0, 0, 2),        /* right: no contact */
        square(2, 0, 0, 0.1),      /* invented */
        square(2, 0.99, 0.99, -3), /* right: overlap at the same height, however deep */
        square(2, 0.9, 0.9, -4.5), /* missed: outside on the other side */
        square(2, 1.2, 0, -0.1),   /* invented: the foot point is off the segment */
        square(2, 0, 0, 0),        /* not counted */
    };
    const struct sample_set set = {.s = s, .n = sizeof s / sizeof *s};
    const struct contact_decisions c = contact_decide(&set);
    assert_int_equal(c.n, 6);
    assert_int_equal(c.contacts, 3);
    assert_int_equal(c.missed, 1);
    assert_int_equal(c.invented, 2);
    near(c.depth.mean, ((PINBALL_DIAMETER - 1) + fabs(depth_of(&s[3]) / 2 - 1.5)) / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(depths_over_a_square_are_known),
                                       cmocka_unit_test(depth_does_not_depend_on_place_and_size),
                                       cmocka_unit_test(decisions_are_classified)};
    return cmocka_run_group_tests_name("pinball", tests, NULL, NULL);
}
