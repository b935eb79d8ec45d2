/* The certain closest point on a patch against dense sampling and Newton's iteration from every sample, on patches far
 * worse than a scene's; then the samples made with it. */
#include "../../codegen/base/base.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/samples/samples.h"
#include "../../evolve/surface/foot_patch.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"
#include "../support/smooth_bodies.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { GRID = 40 };
static const double lowest[2] = {-1, -1}, highest[2] = {1, 1};

static double squared_distance(const struct footpoint_gregory *g, const double xs[3], double xi, double eta)
{
    double r[3], sum = 0;
    footpoint_gregory_position(g, xi, eta, r);
    for (int k = 0; k < 3; k++)
        sum += (xs[k] - r[k]) * (xs[k] - r[k]);
    return sum;
}

/* Runs Newton's iteration from (xi,eta); returns true if it converges strictly inside. */
static bool settle(const struct footpoint_gregory *g, const double xs[3], double *xi, double *eta)
{
    for (int i = 0; i < 30; i++) {
        struct footpoint_jet jet;
        double f1 = 0, f2 = 0, a = 0, b = 0, c = 0;
        footpoint_gregory_jet(g, *xi, *eta, &jet);
        for (int k = 0; k < 3; k++) {
            const double d = g->net.origin[k] + jet.r[k] - xs[k];
            f1 += jet.r_xi[k] * d;
            f2 += jet.r_eta[k] * d;
            a += jet.r_xi[k] * jet.r_xi[k] + jet.r_xixi[k] * d;
            b += jet.r_xi[k] * jet.r_eta[k] + jet.r_xieta[k] * d;
            c += jet.r_eta[k] * jet.r_eta[k] + jet.r_etaeta[k] * d;
        }
        const double det = a * c - b * b, dx = (b * f2 - c * f1) / det, dy = (b * f1 - a * f2) / det;
        *xi += dx;
        *eta += dy;
        if (!(fabs(*xi) < 0.9999 && fabs(*eta) < 0.9999))
            return false;
        if (fabs(dx) + fabs(dy) < 1e-13)
            return true;
    }
    return false;
}

/* Draws corners up to `distortion` off a square, normals with tilts up to `tilt`, and a slave node up to `height`
 * above. */
static void draw(gsl_rng *rng, double distortion, double tilt, double height, struct sample *s)
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int c = 0; c < 4; c++) {
        double length = 0;
        for (int k = 0; k < 3; k++) {
            s->x[c][k] = (k < 2 ? corner[c][k] : 0) + gsl_ran_flat(rng, -distortion, distortion);
            s->x[4 + c][k] = gsl_ran_flat(rng, -tilt, tilt) + (k == 2);
            length = hypot(length, s->x[4 + c][k]);
        }
        for (int k = 0; k < 3; k++)
            s->x[4 + c][k] /= length;
    }
    s->xs[0] = gsl_ran_flat(rng, -1.5, 1.5);
    s->xs[1] = gsl_ran_flat(rng, -1.5, 1.5);
    s->xs[2] = gsl_ran_flat(rng, -height, height);
}

static bool known(const struct stationary *found, int n, double xi, double eta)
{
    for (int k = 0; k < n; k++)
        if (fabs(found[k].xi - xi) + fabs(found[k].eta - eta) < 1e-6)
            return true;
    return false;
}

/* Checks that every stationary point that Newton's iteration finds is known, and that no sample is nearer than the
 * closest point. Returns false, without checks, if the reference is uncertain. */
static bool compare(const struct sample *s, int *points)
{
    struct footpoint_gregory g;
    struct stationary found[PATCH_STATIONARY_MAX], closest;
    assert_int_equal(footpoint_gregory_points((const double(*)[3])s->x, (const double(*)[3])s->x + 4, &g),
                     FOOTPOINT_OK);
    const int n = foot_patch_stationary(&g, s->xs, lowest, highest, found);
    const bool told = foot_patch_closest(&g, s->xs, &closest);
    double nearest = INFINITY;
    if (n == PATCH_UNCERTAIN) {
        assert_false(told);
        return false;
    }
    *points += n;
    for (int k = 0; k < n; k++) {
        double xi = found[k].xi, eta = found[k].eta;
        assert_true(k == 0 || found[k].distance >= found[k - 1].distance);
        assert_true(fabs(xi) <= 1 + 1e-8 && fabs(eta) <= 1 + 1e-8);
        assert_true(fabs(found[k].distance - sqrt(squared_distance(&g, s->xs, xi, eta))) < 1e-14);
        if (fabs(xi) < 0.9999 && fabs(eta) < 0.9999) {
            assert_true(settle(&g, s->xs, &xi, &eta));
            assert_true(fabs(xi - found[k].xi) + fabs(eta - found[k].eta) < 1e-7);
        }
    }
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= GRID; j++) {
            double xi = 2.0 * i / GRID - 1, eta = 2.0 * j / GRID - 1;
            nearest = fmin(nearest, squared_distance(&g, s->xs, xi, eta));
            if (i % 4 == 0 && j % 4 == 0 && settle(&g, s->xs, &xi, &eta) && !known(found, n, xi, eta))
                fail_msg("stationary point (%.17g, %.17g) is missing", xi, eta);
        }
    for (int k = 0; k < n; k++) { /* a point that is proved from anywhere is the closest point */
        const double near[2] = {found[k].xi, found[k].eta};
        struct stationary proved;
        if (told && foot_patch_closest_near(&g, s->xs, lowest, highest, near, &proved))
            assert_true(proved.minimum && fabs(proved.distance - closest.distance) < 1e-14);
    }
    if (told) {
        assert_true(closest.distance <= sqrt(nearest) + 1e-14);
        assert_true(closest.distance >= sqrt(nearest) - 8.0 / GRID);
    }
    return told;
}

static void no_sample_is_nearer(void **state)
{
    (void)state;
    static const struct {
        double distortion, tilt, height;
    } kind[] = {{0.1, 0.1, 0.3}, {0.5, 0.5, 1}, {0.9, 1.5, 3}};
    gsl_rng *rng = stream_new();
    for (size_t i = 0; i < sizeof kind / sizeof *kind; i++) {
        int told = 0, points = 0;
        const int trials = 250;
        for (int k = 0; k < trials; k++) {
            struct sample s;
            stream_key(rng, 21, i, (uint64_t)k, 0);
            draw(rng, kind[i].distortion, kind[i].tilt, kind[i].height, &s);
            told += compare(&s, &points);
        }
        assert_true(told >= (i < 2 ? trials : trials * 98 / 100));
        assert_true(points > trials / 3);
    }
    gsl_rng_free(rng);
}

/* All corners lie on one line: a curve of stationary points, which cannot be separated. */
static void curves_of_points_are_uncertain(void **state)
{
    (void)state;
    const struct surface *gregory = surface_find(segment_find("gregory"));
    struct sample s = {.x = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {1.5, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
                       .xs = {1.2, 0.3, 0.1}};
    struct footpoint_gregory g;
    struct stationary found[PATCH_STATIONARY_MAX], closest;
    assert_int_equal(footpoint_gregory_points((const double(*)[3])s.x, (const double(*)[3])s.x + 4, &g), FOOTPOINT_OK);
    assert_int_equal(foot_patch_stationary(&g, s.xs, lowest, highest, found), PATCH_UNCERTAIN);
    assert_false(foot_patch_closest(&g, s.xs, &closest));
    assert_false(gregory->foot(gregory, &s, lowest, highest, NULL));
    s.xs[1] = NAN;
    assert_false(foot_patch_closest(&g, s.xs, &closest));
    assert_false(gregory->foot(gregory, &s, lowest, highest, NULL));
}

/* A corner is the closest point of all points that lie beyond it, an edge of points beside it. */
static void borders_are_closest_points_beyond(void **state)
{
    (void)state;
    struct sample s = {.x = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    struct footpoint_gregory g;
    struct stationary closest;
    assert_int_equal(footpoint_gregory_points((const double(*)[3])s.x, (const double(*)[3])s.x + 4, &g), FOOTPOINT_OK);
    assert_true(foot_patch_closest(&g, (const double[]){2.3, 2.1, 0.5}, &closest));
    assert_true(closest.xi == 1 && closest.eta == 1 && !closest.minimum);
    assert_true(foot_patch_closest(&g, (const double[]){0.5, -3, 0.5}, &closest));
    assert_true(fabs(closest.xi + 0.5) < 1e-11 && closest.eta == -1 && !closest.minimum);
    assert_true(foot_patch_closest(&g, (const double[]){0.5, 1.75, 0.5}, &closest));
    assert_true(fabs(closest.xi + 0.5) < 1e-15 && fabs(closest.eta - 0.75) < 1e-15 && closest.minimum);
}

/* ---- samples --------------------------------------------------------------------------------------------------- */

/* Checks that the label solves (7), (8) to rounding, and that the gap lies along the normal. */
static void check_label(const struct sample *s)
{
    struct footpoint_gregory g;
    struct footpoint_jet jet;
    double n[3], gap, along_xi = 0, along_eta = 0, size = 0;
    assert_int_equal(footpoint_gregory_points((const double(*)[3])s->x, (const double(*)[3])s->x + 4, &g),
                     FOOTPOINT_OK);
    footpoint_gregory_jet(&g, s->xi, s->eta, &jet);
    assert_int_equal(footpoint_jet_normal(g.net.origin, &jet, s->xs, n, &gap), FOOTPOINT_OK);
    for (int k = 0; k < 3; k++) {
        const double d = (s->xs[k] - g.net.origin[k]) - jet.r[k];
        along_xi += d * jet.r_xi[k];
        along_eta += d * jet.r_eta[k];
        size = fmax(size, fabs(g.net.p[3][3][k]));
    }
    assert_true(fabs(along_xi) + fabs(along_eta) < 1e-14 * (1 + size * size));
    assert_true(fabs(gap - s->gap) < 1e-14 * (1 + size));
}

static void same_samples(const struct sample_set *a, const struct sample_set *b, size_t n)
{
    assert_true(a->n >= n && b->n >= n);
    for (size_t i = 0; i < n; i++)
        assert_memory_equal(&a->s[i], &b->s[i], sizeof *a->s);
}

static void lattice_labels_are_certain(void **state)
{
    (void)state;
    struct diag d;
    struct scene *scene = scene_read(".", "paper-quad4", &d);
    assert_non_null(scene);
    scene->lattice.xy.step = 0.5; /* a coarse lattice, for speed */
    scene->segment = segment_find("gregory");
    scene->lattice.normal_sets = 20;
    scene->lattice.tilt = 0.2;
    scene->training = 2000;
    struct sample_set set = {0}, again = {0};
    assert_true(scene_samples(scene, PART_TRAINING, &set, &d) && scene_samples(scene, PART_TRAINING, &again, &d));
    assert_true(set.n == again.n && set.n > 1600 && set.n <= 2000);
    same_samples(&set, &again, set.n);
    double steepest = 0;
    for (size_t i = 0; i < set.n; i++) {
        const struct sample *s = &set.s[i];
        check_label(s);
        assert_true(s->xi > -1 && s->xi <= 0 && s->eta > -1 && s->eta <= 0);
        for (int c = 0; c < 4; c++) {
            static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
            double m[3], cosine = 0;
            assert_int_equal(footpoint_quad4_normal(s->x[0], s->x[1], s->x[2], s->x[3], corner[c][0], corner[c][1], m),
                             FOOTPOINT_OK);
            for (int k = 0; k < 3; k++)
                cosine += m[k] * s->x[4 + c][k];
            steepest = fmax(steepest, sqrt(1 / (cosine * cosine) - 1));
        }
    }
    assert_true(steepest > 0.19 && steepest < 0.2 + 1e-9);
    sample_set_free(&set);
    sample_set_free(&again);
    scene_free(scene);
}

static void body_labels_are_certain(void **state)
{
    (void)state;
    struct scene scene = smooth_bodies("gregory", 3, 2000);
    struct sample_set training = {0}, again = {0}, heldout = {0};
    struct diag d;
    assert_true(scene_samples(&scene, PART_TRAINING, &training, &d));
    scene.training = scene.heldout = 1000;
    assert_true(scene_samples(&scene, PART_TRAINING, &again, &d) && scene_samples(&scene, PART_HELDOUT, &heldout, &d));
    same_samples(&training, &again, 1000);
    assert_memory_not_equal(training.s, heldout.s, sizeof *training.s);
    for (size_t i = 0; i < training.n; i++) {
        check_label(&training.s[i]);
        assert_true(fabs(training.s[i].xi) <= 1 && fabs(training.s[i].eta) <= 1);
    }
    sample_set_free(&training);
    sample_set_free(&again);
    sample_set_free(&heldout);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_sample_is_nearer),
        cmocka_unit_test(curves_of_points_are_uncertain),
        cmocka_unit_test(borders_are_closest_points_beyond),
        cmocka_unit_test(lattice_labels_are_certain),
        cmocka_unit_test(body_labels_are_certain),
    };
    return cmocka_run_group_tests_name("reference_patch", tests, NULL, NULL);
}
