/* Kinds of segments: geometry against finite differences and itself, and the certain foot point against other
 * methods. */
#include "../../evolve/samples/samples.h"
#include "../../evolve/surface/foot_bilinear.h"
#include "../../evolve/surface/surface.h"
#include "../../runtime/geometry/footpoint-quad8-geometry.h"
#include "../../runtime/geometry/footpoint-quad9-geometry.h"
#include "../../runtime/geometry/footpoint-tri3-geometry.h"
#include "../../runtime/geometry/footpoint-tri6-geometry.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 400, GRID = 24 };

typedef void first(const double *const *x, double xi, double eta, double r[3]);
typedef void two(const double *const *x, double xi, double eta, double a[3], double b[3]);
typedef void three(const double *const *x, double xi, double eta, double a[3], double b[3], double c[3]);

/* Local coordinates of the nodes, as Abaqus numbers them. */
static const double at_tri[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
static const double at_quad[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};

static const struct kind {
    const char *name;
    size_t nodes;
    const double (*at)[2];
    int degree; /* polynomials of this total degree are reproduced */
    first *position;
    two *derivatives;
    three *second;
} kinds[] = {
    {"tri3", 3, at_tri, 1, footpoint_tri3_position, footpoint_tri3_derivatives, NULL},
    {"tri6", 6, at_tri, 2, footpoint_tri6_position, footpoint_tri6_derivatives, footpoint_tri6_second_derivatives},
    {"quad8", 8, at_quad, 2, footpoint_quad8_position, footpoint_quad8_derivatives, footpoint_quad8_second_derivatives},
    {"quad9", 9, at_quad, 2, footpoint_quad9_position, footpoint_quad9_derivatives,
     footpoint_quad9_second_derivatives}};

enum { KINDS = sizeof kinds / sizeof *kinds };

/* Evaluates x, y, z as polynomials of xi and eta, and their derivatives. */
static double polynomial(int degree, int k, double u, double v, int by_u, int by_v)
{
    static const double c[3][6] = {
        {0.3, 1.1, -0.2, 0.05, 0.07, -0.04}, {-0.1, 0.15, 0.9, -0.03, 0.02, 0.06}, {0.7, 0.2, 0.1, 0.2, -0.15, 0.1}};
    const double q = degree > 1 ? 1 : 0, *a = c[k];
    const int which = 3 * by_u + by_v;
    switch (which) {
    case 0:
        return a[0] + a[1] * u + a[2] * v + q * (a[3] * u * u + a[4] * u * v + a[5] * v * v);
    case 3:
        return a[1] + q * (2 * a[3] * u + a[4] * v);
    case 1:
        return a[2] + q * (a[4] * u + 2 * a[5] * v);
    case 6:
        return 2 * q * a[3];
    case 4:
        return q * a[4];
    default:
        return 2 * q * a[5];
    }
}

static void check_near(const char *what, double got, double wanted, double tolerance)
{
    if (!(fabs(got - wanted) <= tolerance))
        fail_msg("%s: %a instead of %a", what, got, wanted);
}

/* A surface that the kind can represent is reproduced with its derivatives, also outside of the segment. */
static void polynomials_are_reproduced(void **state)
{
    (void)state;
    for (size_t n = 0; n < KINDS; n++) {
        const struct kind *kind = &kinds[n];
        double node[SEGMENT_VECTORS][3];
        const double *x[SEGMENT_VECTORS];
        for (size_t i = 0; i < kind->nodes; i++) {
            for (int k = 0; k < 3; k++)
                node[i][k] = polynomial(kind->degree, k, kind->at[i][0], kind->at[i][1], 0, 0);
            x[i] = node[i];
        }
        for (double u = -1.25; u <= 1.25; u += 0.25)
            for (double v = -1.25; v <= 1.25; v += 0.25) {
                double r[6][3] = {{0}};
                static const int by[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
                kind->position(x, u, v, r[0]);
                kind->derivatives(x, u, v, r[1], r[2]);
                if (kind->second)
                    kind->second(x, u, v, r[3], r[4], r[5]);
                for (int row = 0; row < 6; row++)
                    for (int k = 0; k < 3; k++)
                        check_near(kind->name, r[row][k], polynomial(kind->degree, k, u, v, by[row][0], by[row][1]),
                                   1e-14);
            }
    }
}

/* Shape functions are 1 at their node and 0 at the others. Derivatives equal finite differences, which are exact for
 * cubics up to rounding. */
static void shape_functions_are_right(void **state)
{
    const double h = 1.0 / 16;
    (void)state;
    for (size_t n = 0; n < KINDS; n++) {
        const struct kind *kind = &kinds[n];
        const size_t nodes = kind->nodes;
        const struct surface *f = surface_find(segment_find(kind->name));
        double phi[9][6 * SEGMENT_VECTORS];
        for (size_t i = 0; i < nodes; i++) {
            f->shape(kind->at[i][0], kind->at[i][1], phi[0]);
            for (size_t k = 0; k < nodes; k++)
                check_near(kind->name, phi[0][k], i == k, 1e-15);
        }
        for (double u = -1; u <= 1; u += 0.375)
            for (double v = -1; v <= 1; v += 0.375) {
                for (int i = 0; i < 9; i++)
                    f->shape(u + h * (i % 3 - 1), v + h * (i / 3 - 1), phi[i]);
                for (size_t k = 0; k < nodes; k++) {
                    const double *c = &phi[4][k];
                    check_near("by xi", c[nodes], (phi[5][k] - phi[3][k]) / (2 * h), 1e-13);
                    check_near("by eta", c[2 * nodes], (phi[7][k] - phi[1][k]) / (2 * h), 1e-13);
                    check_near("xi xi", c[3 * nodes], (phi[5][k] - 2 * c[0] + phi[3][k]) / (h * h), 1e-12);
                    check_near("eta eta", c[5 * nodes], (phi[7][k] - 2 * c[0] + phi[1][k]) / (h * h), 1e-12);
                    check_near("xi eta", c[4 * nodes], (phi[8][k] - phi[6][k] - phi[2][k] + phi[0][k]) / (4 * h * h),
                               1e-12);
                }
            }
    }
}

static struct sample_set samples_of(const char *name)
{
    struct sample_set set = {0};
    struct diag d;
    struct scene *s = scene_read("", name, &d);
    if (!s)
        fail_msg("%s", d.text);
    s->training = SAMPLES;
    assert_true(scene_samples(s, PART_TRAINING, &set, &d));
    scene_free(s);
    return set;
}

static double square_distance(const struct surface *f, struct sample *s, double xi, double eta)
{
    double r[3][3], sum = 0;
    f->point(f, s->x, xi, eta, r);
    for (int k = 0; k < 3; k++)
        sum += (s->xs[k] - r[0][k]) * (s->xs[k] - r[0][k]);
    return sum;
}

/* The labels of a scene are stationary, with their gap, and no point of a grid over the segment is nearer. */
static void labels_are_nearest(void **state)
{
    (void)state;
    for (size_t n = 0; n < KINDS; n++) {
        const struct segment_kind *kind = segment_find(kinds[n].name);
        const struct surface *f = surface_find(kind);
        struct sample_set set = samples_of(kinds[n].name);
        for (size_t i = 0; i < set.n; i++) {
            struct sample *s = &set.s[i];
            const double lo = kind->triangle ? -0.1 : -1.2, hi = kind->triangle ? 1.1 : 1.2;
            double r[3][3], length[2] = {0}, f1 = 0, f2 = 0;
            f->point(f, s->x, s->xi, s->eta, r);
            const double least = square_distance(f, s, s->xi, s->eta);
            for (int k = 0; k < 3; k++) {
                f1 += (s->xs[k] - r[0][k]) * r[1][k];
                f2 += (s->xs[k] - r[0][k]) * r[2][k];
                length[0] += r[1][k] * r[1][k];
                length[1] += r[2][k] * r[2][k];
            }
            assert_true(fabs(f1) <= 1e-11 * length[0] && fabs(f2) <= 1e-11 * length[1]);
            assert_true(fabs(least - s->gap * s->gap) <= 1e-11 * (length[0] + length[1]));
            for (int k = 0; k < (GRID + 1) * (GRID + 1); k++) {
                const double xi = lo + (hi - lo) * (k % (GRID + 1)) / GRID,
                             eta = lo + (hi - lo) * (k / (GRID + 1)) / GRID;
                if (!kind->triangle || xi + eta <= hi)
                    assert_true(square_distance(f, s, xi, eta) >= least * (1 - 1e-12));
            }
        }
        sample_set_free(&set);
    }
}

/* A bilinear segment written with nine nodes has the quintic's answer. */
static void bisection_agrees_with_the_quintic(void **state)
{
    const struct surface *f = surface_find(segment_find("quad9"));
    struct sample_set set = samples_of("quad4");
    (void)state;
    for (size_t i = 0; i < set.n; i++)
        for (int box = 0; box < 3; box++) {
            const double lo[2] = {box == 1 ? 0 : -2, box == 2 ? -0.3 : -2}, hi[2] = {box == 2 ? 0.4 : 2, 2};
            struct sample a = set.s[i], b = set.s[i];
            for (int m = 4; m < 9; m++)
                for (int k = 0; k < 3; k++)
                    b.x[m][k] = m == 8 ? (b.x[0][k] + b.x[1][k] + b.x[2][k] + b.x[3][k]) / 4
                                       : (b.x[m - 4][k] + b.x[(m - 3) % 4][k]) / 2;
            const bool found = foot_bilinear(&a, lo, hi);
            if (found != f->foot(f, &b, lo, hi, NULL))
                fail_msg("sample %zu, box %d: (%a,%a) by the quintic alone: %d", i, box, a.xi, a.eta, found);
            if (found &&
                !(fabs(a.xi - b.xi) + fabs(a.eta - b.eta) < 1e-11 && fabs(a.gap - b.gap) < 1e-9 * (1 + fabs(a.gap))))
                fail_msg("sample %zu, box %d: (%a,%a) instead of (%a,%a)", i, box, b.xi, b.eta, a.xi, a.eta);
        }
    sample_set_free(&set);
}

/* Faces without area and coordinates that are not finite have no foot points. */
static void degenerate_faces_have_none(void **state)
{
    const struct surface *f = surface_find(segment_find("quad9"));
    const double lo[2] = {-1.2, -1.2}, hi[2] = {1.2, 1.2};
    struct sample s = {0};
    (void)state;
    assert_false(f->foot(f, &s, lo, hi, NULL));
    for (int i = 0; i < 9; i++) {
        s.x[i][0] = at_quad[i][0];
        s.x[i][1] = at_quad[i][1];
    }
    s.xs[2] = 0.3;
    assert_true(f->foot(f, &s, lo, hi, NULL));
    assert_true(fabs(s.xi) + fabs(s.eta) < 1e-15 && fabs(s.gap - 0.3) < 1e-15);
    s.xs[1] = NAN;
    assert_false(f->foot(f, &s, lo, hi, NULL));
    for (int i = 0; i < 9; i++) /* flattened to a line */
        s.x[i][1] = 0;
    s.xs[1] = 0;
    assert_false(f->foot(f, &s, lo, hi, NULL));
}

/* Inputs have names; unknown kinds are refused. */
static void vectors_have_names(void **state)
{
    static const struct segment_kind patch = {.name = "patch", .nodes = "ABCD", .normals = "ABCD", .corners = 4};
    static const struct {
        size_t input;
        const char *name, *vector;
    } expected[] = {{0, "xA", "xA"}, {11, "zD", "xD"}, {12, "xnA", "nA"}, {22, "ynD", "nD"}, {26, "zS", "xS"}};
    (void)state;
    assert_int_equal(segment_inputs(&patch), 27);
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        char name[5], vector[4];
        segment_input_name(&patch, expected[i].input, name);
        segment_vector_name(&patch, expected[i].input / 3, vector);
        assert_string_equal(name, expected[i].name);
        assert_string_equal(vector, expected[i].vector);
    }
    assert_null(segment_find("quad5"));
    for (size_t n = 0; n < KINDS; n++)
        assert_int_equal(segment_inputs(segment_find(kinds[n].name)), 3 * (kinds[n].nodes + 1));
}

/* Samples of patches: the slave node lies over its foot point, at the gap; parts share no sample. */
static void patches_hold_their_foot_points(void **state)
{
    static const char *const name[] = {"gregory", "bezier", "paper-gregory"};
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct diag d = {0};
        struct scene *scene = scene_read(".", name[i], &d);
        struct sample_set set = {0};
        double lo[2], hi[2];
        assert_non_null(scene);
        scene->training = scene->heldout = SAMPLES;
        scene_box(scene, lo, hi);
        for (int part = i < 2 ? PART_TRAINING : PART_HELDOUT_RANDOM; part <= PART_HELDOUT_RANDOM; part++)
            assert_true(scene_samples(scene, (enum sample_part)part, &set, &d));
        assert_true(set.n > 3 * SAMPLES / 4);
        for (size_t k = 0; k < set.n; k++) {
            const struct sample *s = &set.s[k];
            struct sample again = *s;
            double x[SEGMENT_VECTORS][3], r[3], n[3];
            memcpy(x, s->x, sizeof x);
            assert_true(s->xi > lo[0] && s->xi <= hi[0] && s->eta > lo[1] && s->eta <= hi[1]);
            assert_true(surface_normal(surface_find(scene->segment), x, s->xi, s->eta, r, n));
            for (int c = 0; c < 3; c++)
                check_near(name[i], r[c] + s->gap * n[c], s->xs[c], 1e-9);
            assert_true(surface_find(scene->segment)->foot(surface_find(scene->segment), &again, lo, hi, NULL));
            check_near(name[i], again.xi, s->xi, 1e-9);
            if (k > 0)
                assert_true(memcmp(set.s[k - 1].xs, s->xs, sizeof s->xs) != 0 ||
                            memcmp(set.s[k - 1].x, s->x, sizeof s->x) != 0);
        }
        sample_set_free(&set);
        scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polynomials_are_reproduced),
        cmocka_unit_test(shape_functions_are_right),
        cmocka_unit_test(labels_are_nearest),
        cmocka_unit_test(bisection_agrees_with_the_quintic),
        cmocka_unit_test(degenerate_faces_have_none),
        cmocka_unit_test(vectors_have_names),
        cmocka_unit_test(patches_hold_their_foot_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
