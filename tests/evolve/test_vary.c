/* The inputs that segments vary: known shapes anywhere and of any size; rounding does not count. */
#include "../../evolve/eval/frame.h"
#include "../../evolve/samples/default_tiers.h"
#include "../../evolve/samples/variation.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Half mid-lines of lengths 1 and 0.5, `skew` off the right angle, and c3 = a c1 + b c2 + g n; turned by 1 rad about
 * (1,2,2)/3. */
struct form {
    double skew, a, b, g;
};

static void turned(const double v[3], double to[3])
{
    const double axis[3] = {1. / 3, 2. / 3, 2. / 3}, c = cos(1), s = sin(1);
    const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        to[k] = c * v[k] + s * (axis[i] * v[j] - axis[j] * v[i]) + (1 - c) * along * axis[k];
    }
}

static struct sample sample_of(const struct form *f, double scale, double offset)
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double c1[3] = {1, 0, 0}, c2[3] = {0.5 * sin(f->skew), 0.5 * cos(f->skew), 0};
    struct sample s = {.xi = 0};
    for (int i = 0; i < 4; i++) {
        double v[3];
        for (int k = 0; k < 3; k++)
            v[k] = c1[k] * corner[i][0] + c2[k] * corner[i][1] +
                   (f->a * c1[k] + f->b * c2[k] + (k == 2 ? f->g : 0)) * corner[i][0] * corner[i][1];
        turned(v, s.x[i]);
        for (int k = 0; k < 3; k++)
            s.x[i][k] = scale * s.x[i][k] + offset * (k - 1.3);
    }
    return s;
}

static struct variation vary_of(const struct form *f, double scale, double offset)
{
    struct sample s = sample_of(f, scale, offset);
    return variation_measure(segment_find("quad4"), &(struct sample_set){.s = &s, .n = 1});
}

static void known_shapes_anywhere(void **state)
{
    static const struct {
        struct form form;
        enum variation_kind kind;
    } known[] = {{{0, 0, 0, 0}, VARY_RECTANGLES},        {{0.3, 0, 0, 0}, VARY_PARALLELOGRAMS},
                 {{-1.2, 0, 0, 0}, VARY_PARALLELOGRAMS}, {{0, 0.2, 0, 0}, VARY_PLANE},
                 {{0.3, 0, -0.1, 0}, VARY_PLANE},        {{0, 0, 0, 0.1}, VARY_WARPED},
                 {{0.3, 0.1, 0.2, -0.1}, VARY_WARPED},   {{1e-6, 0, 0, 0}, VARY_PARALLELOGRAMS},
                 {{0, 1e-6, 0, 0}, VARY_PLANE},          {{0, 0, 0, 1e-6}, VARY_WARPED}};
    static const double scale[] = {1e-3, 1, 1e3}, offset[] = {0, 1, 1e3};
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++) {
                const struct form *f = &known[i].form;
                const struct variation v = vary_of(f, scale[j], offset[k]);
                const double near = 1e-12 + 4e-15 * offset[k] / scale[j]; /* rounding of coordinates */
                if (v.kind != known[i].kind || fabs(v.skew - fabs(f->skew)) > near ||
                    fabs(v.taper - fmax(fabs(f->a), fabs(f->b))) > near)
                    fail_msg("shape %zu, scale %g, offset %g: %s, skew %g, taper %g, warp %g", i, scale[j], offset[k],
                             variation_name[v.kind], v.skew, v.taper, v.warp);
                if (f->skew == 0 && f->a == 0 && f->b == 0) /* normals of a hyperbolic paraboloid over a rectangle */
                    assert_true(fabs(v.warp - 2 * atan(fabs(f->g) * hypot(1, 2))) < 2 * near);
            }
}

/* The tolerance is 1e-12 of the size at the origin; farther away it grows with the rounding of coordinates. */
static void tolerances_are_as_documented(void **state)
{
    static const struct {
        double a, scale, offset;
        enum variation_kind kind;
    } edge[] = {{3e-13, 1, 0, VARY_RECTANGLES}, {1e-11, 1, 0, VARY_PLANE},
                {1e-11, 1e-3, 0, VARY_PLANE},   {1e-12, 1, 1e3, VARY_RECTANGLES},
                {1e-10, 1, 1e3, VARY_PLANE},    {1e-10, 1e-3, 1e3, VARY_RECTANGLES},
                {1e-7, 1e-3, 1e3, VARY_PLANE},  {3e-13, 1e3, 1e3, VARY_RECTANGLES}};
    (void)state;
    for (size_t i = 0; i < sizeof edge / sizeof *edge; i++) {
        const struct variation v = vary_of(&(struct form){0, edge[i].a, 0, 0}, edge[i].scale, edge[i].offset);
        if (v.kind != edge[i].kind)
            fail_msg("taper %g at scale %g, offset %g: %s", edge[i].a, edge[i].scale, edge[i].offset,
                     variation_name[v.kind]);
    }
}

/* One sample among many decides; a segment without an area is not plane. */
static void the_worst_decides(void **state)
{
    struct sample s[50];
    (void)state;
    for (int i = 0; i < 50; i++)
        s[i] = sample_of(&(struct form){i == 37 ? 0.4 : 0, 0, 0, 0}, 1 + i, 0);
    const struct sample_set set = {.s = s, .n = 50};
    assert_int_equal(variation_measure(segment_find("quad4"), &set).kind, VARY_PARALLELOGRAMS);
    assert_true(fabs(variation_measure(segment_find("quad4"), &set).skew - 0.4) < 1e-14);
    s[12] = sample_of(&(struct form){0.1, 0, 0.1, 0}, 1, 0);
    assert_int_equal(variation_measure(segment_find("quad4"), &set).kind, VARY_PLANE);
    memset(&s[3], 0, sizeof s[3]);
    assert_int_equal(variation_measure(segment_find("quad4"), &set).kind, VARY_WARPED);
    assert_int_equal(variation_measure(segment_find("quad4"), &(struct sample_set){.s = s, .n = 0}).kind,
                     VARY_RECTANGLES);
}

/* The chosen frame has all values that its tiers name; warped segments have the tiers of the scene quad4. */
static void frame_and_tiers_follow(void **state)
{
    struct diag d;
    struct scene *quad4 = scene_read("", "quad4", &d);
    (void)state;
    assert_non_null(quad4);
    for (int kind = VARY_RECTANGLES; kind <= VARY_WARPED; kind++) {
        struct scene *s = scene_read("", "plane-quad4", &d);
        assert_true(s && s->tiers == 0);
        assert_true(scene_default_tiers("", s, (enum variation_kind)kind, &d));
        struct genome_file *program = frame_program(".", s, "program", &d);
        if (!program)
            fail_msg("%s", d.text);
        assert_true(s->reference[0] == (kind <= VARY_PARALLELOGRAMS ? -1 : 0) && s->reference[0] == s->reference[1]);
        for (size_t i = 0; kind == VARY_WARPED && i < s->tiers; i++) {
            const struct tier *t = &s->tier[i], *u = &quad4->tier[i];
            assert_int_equal(s->tiers, quad4->tiers);
            assert_string_equal(t->name, u->name);
            assert_string_equal(t->frame, u->frame);
            assert_true(t->terminals == u->terminals && t->max_length == u->max_length && t->rational == u->rational);
            for (size_t k = 0; k < t->terminals; k++)
                assert_string_equal(t->terminal[k], u->terminal[k]);
        }
        genome_file_free(program);
        scene_free(s);
    }
    scene_free(quad4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_shapes_anywhere),
        cmocka_unit_test(tolerances_are_as_documented),
        cmocka_unit_test(the_worst_decides),
        cmocka_unit_test(frame_and_tiers_follow),
    };
    return cmocka_run_group_tests_name("vary", tests, NULL, NULL);
}
