/* The sixteen inputs of section 7.2, as the frame computes them, against a plain evaluation in the local axes of the
 * segment; anywhere in space, at any size and orientation. */
#include "../../evolve/common/stream.h"
#include "../../evolve/eval/frame.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

enum { SAMPLES = 500, INPUTS = 16, A = 0, B, C, D, NORMALS };

static const char *const name[INPUTS] = {"xc",  "yc",  "zc",  "xd",  "yd",  "xs",  "ys",  "zs",
                                         "nxA", "nyA", "nxB", "nyB", "nxC", "nyC", "nxD", "nyD"};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* a x b, of unit length */
static void unit_cross(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    const double length = sqrt(dot(c, c));
    for (int k = 0; k < 3; k++)
        c[k] /= length;
}

static void relative(const double p[3], const double origin[3], double r[3])
{
    for (int k = 0; k < 3; k++)
        r[k] = p[k] - origin[k];
}

/* Draws segments, a quarter of them plane, the others warped; normals are up to 45 degrees off the local z. */
static struct sample random_sample(gsl_rng *rng)
{
    static const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    struct sample s = {0};
    double axis[3][3], sideways[3], at[3];
    const double size = exp(gsl_ran_flat(rng, -6, 6)), warp = gsl_rng_uniform(rng) < 0.25 ? 0 : 0.3;
    gsl_ran_dir_3d(rng, &axis[0][0], &axis[0][1], &axis[0][2]);
    gsl_ran_dir_3d(rng, &sideways[0], &sideways[1], &sideways[2]);
    unit_cross(axis[0], sideways, axis[2]);
    unit_cross(axis[2], axis[0], axis[1]);
    for (int k = 0; k < 3; k++)
        at[k] = size * gsl_ran_flat(rng, -3, 3);
    for (int c = 0; c < 5; c++) {
        double x[3], n[3];
        for (int k = 0; k < 2; k++)
            x[k] = c < 4 ? corner[c][k] + gsl_ran_flat(rng, -0.3, 0.3) : gsl_ran_flat(rng, -0.5, 1.5);
        x[2] = c < 4 ? gsl_ran_flat(rng, -warp, warp) : gsl_ran_flat(rng, -0.5, 0.5);
        n[0] = gsl_ran_flat(rng, -0.7, 0.7);
        n[1] = gsl_ran_flat(rng, -0.7, 0.7);
        n[2] = 1;
        const double length = sqrt(dot(n, n));
        for (int k = 0; k < 3; k++) {
            double *node = c < 4 ? s.x[c] : s.xs;
            node[k] = at[k] + size * (x[0] * axis[0][k] + x[1] * axis[1][k] + x[2] * axis[2][k]);
            if (c < 4)
                s.x[NORMALS + c][k] = (n[0] * axis[0][k] + n[1] * axis[1][k] + n[2] * axis[2][k]) / length;
        }
    }
    return s;
}

static void plain_inputs(const struct sample *s, double value[INPUTS])
{
    double axis[3][3], ab[3], ad[3], p[3];
    relative(s->x[B], s->x[A], ab);
    relative(s->x[D], s->x[A], ad);
    const double length = sqrt(dot(ab, ab));
    for (int k = 0; k < 3; k++)
        axis[0][k] = ab[k] / length;
    unit_cross(ab, ad, axis[2]);
    unit_cross(axis[2], axis[0], axis[1]);
    relative(s->x[C], s->x[A], p);
    for (int k = 0; k < 3; k++)
        value[k] = dot(p, axis[k]) / length;
    for (int k = 0; k < 2; k++)
        value[3 + k] = dot(ad, axis[k]) / length;
    relative(s->xs, s->x[A], p);
    for (int k = 0; k < 3; k++)
        value[5 + k] = dot(p, axis[k]) / length;
    for (int c = 0; c < 4; c++)
        for (int k = 0; k < 2; k++)
            value[8 + 2 * c + k] = dot(s->x[NORMALS + c], axis[k]) / dot(s->x[NORMALS + c], axis[2]);
}

static void frame_is_the_plain_evaluation(void **state)
{
    struct diag d;
    struct sample s[SAMPLES];
    struct scene *scene = scene_read(".", "tests/scenes/gregory-inputs.scene", &d);
    (void)state;
    assert_non_null(scene);
    struct genome_file *program = frame_program(".", scene, "inputs", &d);
    if (!program)
        fail_msg("%s", d.text);
    gsl_rng *rng = stream_new();
    for (size_t i = 0; i < SAMPLES; i++) {
        stream_key(rng, 5, i, 0, 0);
        s[i] = random_sample(rng);
    }
    gsl_rng_free(rng);
    struct columns table = frame_columns(program, s, SAMPLES);
    for (size_t t = 0; t < scene->tiers; t++) /* every tier uses all inputs, in the paper's order */
        for (size_t k = 0; k < INPUTS; k++)
            assert_string_equal(scene->tier[t].terminal[k], name[k]);
    for (size_t i = 0; i < SAMPLES; i++) {
        double value[INPUTS];
        plain_inputs(&s[i], value);
        for (size_t k = 0; k < INPUTS; k++) {
            const double v = columns_at(&table, (size_t)genome_find_symbol(program, name[k]))[i];
            if (!(fabs(v - value[k]) <= 2e-13 * (1 + fabs(value[k]))))
                fail_msg("%s of sample %zu: %.17g, not %.17g", name[k], i, v, value[k]);
        }
    }
    columns_free(&table);
    genome_file_free(program);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(frame_is_the_plain_evaluation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
