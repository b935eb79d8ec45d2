/* Gregory patches beyond any scene: repeated nodes, normals along edges, sizes near the ends of double, and tilts up to
 * tan = 2. Patches are finite everywhere; impossible patches have the documented status. */
#include "../../evolve/common/stream.h"
#include "../../evolve/surface/foot_patch.h"
#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../../runtime/geometry/footpoint-node-normals.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

typedef const double (*rows)[3];

static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
static const double square[4][3] = {{0, 0, 0}, {1, 0, 0.1}, {1.2, 0.9, 0}, {-0.1, 1.1, 0.2}};

static void tilt(gsl_rng *rng, double most, double n[3])
{
    const double angle = gsl_ran_flat(rng, 0, 2 * M_PI), slope = most * gsl_rng_uniform(rng);
    const double length = hypot(1, slope);
    n[0] = slope * cos(angle) / length;
    n[1] = slope * sin(angle) / length;
    n[2] = 1 / length;
}

static int all_finite(const void *numbers, size_t n)
{
    const double *x = numbers;
    for (size_t i = 0; i < n; i++)
        if (!isfinite(x[i]))
            return 0;
    return 1;
}

/* Makes a patch, or returns a status without outputs. Checks that a patch has finite jets, and normals that are of unit
 * length or do not exist. */
static int make(const double x[4][3], const double n[4][3], struct footpoint_gregory *g)
{
    static const double place[] = {-1, -1 + 1e-15, -0.9, 0, 0x1p-1000, 0.5, 1 - 1e-12, 1};
    enum { PLACES = sizeof place / sizeof *place };
    memset(g, 0x5a, sizeof *g);
    const struct footpoint_gregory before = *g;
    const int status = footpoint_gregory_points(x, n, g);
    if (status != FOOTPOINT_OK) {
        assert_memory_equal(&before, g, sizeof *g);
        return status;
    }
    assert_true(all_finite(g, sizeof *g / sizeof(double)));
    for (int k = 0; k < PLACES * PLACES; k++) {
        struct footpoint_jet jet;
        double normal[3];
        footpoint_gregory_jet(g, place[k / PLACES], place[k % PLACES], &jet);
        assert_true(all_finite(&jet, sizeof jet / sizeof(double)));
        const int without = footpoint_gregory_normal(g, place[k / PLACES], place[k % PLACES], normal);
        if (without)
            assert_int_equal(without, FOOTPOINT_ERR_DEGENERATE);
        else
            assert_true(fabs(hypot(hypot(normal[0], normal[1]), normal[2]) - 1) < 1e-14);
    }
    return FOOTPOINT_OK;
}

static void draw(gsl_rng *rng, double most, double x[4][3], double n[4][3])
{
    memcpy(x, square, sizeof square);
    for (int c = 0; c < 4; c++)
        tilt(rng, most, n[c]);
}

/* Corners coincide in all ways. If the ends of an edge do, there is no patch; opposite corners may. */
static void repeated_corners_have_statuses(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    stream_key(rng, 1, 0, 0, 0);
    for (int code = 0; code < 256; code++) {
        const int of[4] = {code & 3, code >> 2 & 3, code >> 4 & 3, code >> 6};
        double x[4][3], n[4][3];
        struct footpoint_gregory g;
        int edge = 0;
        draw(rng, 2, x, n);
        for (int c = 0; c < 4; c++) {
            memcpy(x[c], square[of[c]], sizeof x[c]);
            edge |= of[c] == of[(c + 1) % 4];
        }
        assert_int_equal(make((rows)x, (rows)n, &g), edge ? FOOTPOINT_ERR_DEGENERATE : FOOTPOINT_OK);
    }
    gsl_rng_free(rng);
}

/* An edge gets ever shorter; a normal gets ever nearer to an edge. */
static void vanishing_edges_have_statuses(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    int made = 0, refused = 0;
    for (int power = 0; power < 1080; power += 3) {
        double x[4][3], n[4][3];
        struct footpoint_gregory g;
        stream_key(rng, 2, 0, 0, 0);
        draw(rng, 2, x, n);
        memcpy(x[1], (const double[3]){ldexp(1, -power), 0, 0}, sizeof x[1]);
        const int shorter = make((rows)x, (rows)n, &g);
        memcpy(x[1], (const double[3]){1, 0, 0}, sizeof x[1]);
        memcpy(n[1], (const double[3]){1, 0, ldexp(1, -power)}, sizeof n[1]);
        const int nearer = make((rows)x, (rows)n, &g);
        for (int k = 0; k < 2; k++) {
            const int status = k ? nearer : shorter;
            assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_ERR_DEGENERATE);
            assert_true(status == FOOTPOINT_OK || power > 300);
            made += status == FOOTPOINT_OK;
            refused += status != FOOTPOINT_OK;
        }
    }
    assert_true(made > 200 && refused > 100);
    gsl_rng_free(rng);
}

/* Sizes range from 1e-320 to 1e308. A patch is made if squares of lengths are numbers, and only then. */
static void sizes_have_statuses(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    stream_key(rng, 3, 0, 0, 0);
    for (int power = -320; power <= 308; power++) {
        const double size = pow(10, power);
        double x[4][3], n[4][3];
        struct footpoint_gregory g;
        draw(rng, 2, x, n);
        for (int c = 0; c < 4; c++)
            for (int k = 0; k < 3; k++)
                x[c][k] *= size;
        int status = make((rows)x, (rows)n, &g);
        if (abs(power) < 150)
            assert_int_equal(status, FOOTPOINT_OK);
        else
            assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_ERR_DEGENERATE);
        status = footpoint_node_normals(4, x[0], 1, (const int[4]){0, 1, 2, 3}, n[0]);
        assert_int_equal(status, FOOTPOINT_OK);
        for (int c = 0; c < 4; c++) {
            const double length = hypot(hypot(n[c][0], n[c][1]), n[c][2]);
            assert_true(fabs(length - 1) < 1e-14 || (length == 0 && abs(power) > 75));
        }
    }
    gsl_rng_free(rng);
}

static void bad_normals_have_statuses(void **state)
{
    (void)state;
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    gsl_rng *rng = stream_new();
    double in[2][4][3];
    struct footpoint_gregory g;
    stream_key(rng, 4, 0, 0, 0);
    for (int k = 0; k < 3 * 24; k++) {
        draw(rng, 2, in[0], in[1]);
        in[k / 12 % 2][k / 3 % 4][k % 3] = bad[k / 24];
        assert_int_equal(make((rows)in[0], (rows)in[1], &g), FOOTPOINT_ERR_NOT_FINITE);
    }
    for (int c = 0; c < 4; c++) {
        draw(rng, 2, in[0], in[1]);
        memset(in[1][c], 0, sizeof in[1][c]); /* the output of footpoint_node_normals for a node without a normal */
        assert_int_equal(make((rows)in[0], (rows)in[1], &g), FOOTPOINT_ERR_DEGENERATE);
        draw(rng, 2, in[0], in[1]);
        memcpy(in[0], (const double[4][3]){{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, sizeof in[0]);
        memcpy(in[1][c], (const double[3]){c % 2, (c + 1) % 2, 0}, sizeof in[1][c]); /* along an edge */
        assert_int_equal(make((rows)in[0], (rows)in[1], &g), FOOTPOINT_ERR_DEGENERATE);
    }
    gsl_rng_free(rng);
}

/* ---- tilts up to tan = 2 --------------------------------------------------------------------------------------- */

/* Patches contain corners and their normals; beside a corner the normal is nearly the corner's. */
static void corners_and_normals_are_interpolated(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    double x[4][3], n[4][3];
    struct footpoint_gregory g;
    for (int trial = 0; trial < 2000; trial++) {
        stream_key(rng, 5, (uint64_t)trial, 0, 0);
        draw(rng, 2, x, n);
        assert_int_equal(make((rows)x, (rows)n, &g), FOOTPOINT_OK);
        for (int c = 0; c < 4; c++) {
            const double in = 1e-9 * gsl_rng_uniform(rng), across = 1e-9 * gsl_rng_uniform(rng);
            double r[3], normal[3], beside[3], gap, above[3];
            footpoint_gregory_position(&g, corner[c][0], corner[c][1], r);
            assert_int_equal(footpoint_gregory_normal(&g, corner[c][0], corner[c][1], normal), FOOTPOINT_OK);
            assert_int_equal(footpoint_gregory_normal(&g, corner[c][0] * (1 - in), corner[c][1] * (1 - across), beside),
                             FOOTPOINT_OK);
            const double side = normal[2] > 0 ? 1 : -1; /* tangents may be turned over */
            for (int k = 0; k < 3; k++) {
                assert_true(fabs(r[k] - x[c][k]) < 1e-15 && fabs(side * normal[k] - n[c][k]) < 1e-12);
                assert_true(fabs(beside[k] - normal[k]) < 1e-6);
                above[k] = x[c][k] + 0.3 * normal[k];
            }
            assert_int_equal(footpoint_gregory_gap(&g, above, corner[c][0], corner[c][1], &gap), FOOTPOINT_OK);
            assert_true(fabs(gap - 0.3) < 1e-14);
        }
    }
    gsl_rng_free(rng);
}

/* Neighbours over the edge BC, each with its own normals at its far corners: one curve, one tangent plane, also at its
 * ends. */
static void neighbours_share_tangent_planes(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    int compared = 0;
    for (int trial = 0; trial < 500; trial++) {
        double x[4][3], n[4][3], y[4][3], m[4][3];
        struct footpoint_gregory g, h;
        stream_key(rng, 6, (uint64_t)trial, 0, 0);
        draw(rng, 2, x, n);
        draw(rng, 2, y, m);
        for (int c = 0; c < 4; c++)
            y[c][0] += 1;
        memcpy(y[0], x[1], sizeof y[0]);
        memcpy(m[0], n[1], sizeof m[0]);
        memcpy(y[3], x[2], sizeof y[3]);
        memcpy(m[3], n[2], sizeof m[3]);
        assert_int_equal(make((rows)x, (rows)n, &g), FOOTPOINT_OK);
        assert_int_equal(make((rows)y, (rows)m, &h), FOOTPOINT_OK);
        for (int k = 0; k <= 32; k++) {
            const double eta = k == 1 ? -1 + 1e-12 : k == 31 ? 1 - 1e-12 : k / 16.0 - 1;
            double r[3], s[3], a[3], b[3], sine[3];
            footpoint_gregory_position(&g, 1, eta, r);
            footpoint_gregory_position(&h, -1, eta, s);
            for (int i = 0; i < 3; i++)
                assert_true(fabs(r[i] - s[i]) < 1e-14);
            if (footpoint_gregory_normal(&g, 1, eta, a) != FOOTPOINT_OK ||
                footpoint_gregory_normal(&h, -1, eta, b) != FOOTPOINT_OK)
                continue;
            for (int i = 0; i < 3; i++) /* of the plane, on either side */
                sine[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
            assert_true(hypot(hypot(sine[0], sine[1]), sine[2]) < 1e-9);
            compared++;
        }
    }
    assert_true(compared > 16000);
    gsl_rng_free(rng);
}

/* Slave nodes lie above and below corners and edges. The certain closest point is nearer than any point of a lattice,
 * or is not found; on slightly bent surfaces it is found. */
static void closest_points_are_certain(void **state)
{
    (void)state;
    enum { LATTICE = 24 };
    gsl_rng *rng = stream_new();
    int told[2] = {0, 0};
    for (int trial = 0; trial < 400; trial++) {
        const double most = trial % 2 ? 2 : 0.3, along = gsl_ran_flat(rng, -1, 1);
        const double xi = trial % 8 < 4 ? 1 : corner[trial / 8 % 4][0], eta = trial % 8 < 4 ? along : xi;
        double x[4][3], n[4][3], normal[3], xs[3];
        struct footpoint_gregory g;
        struct stationary s;
        stream_key(rng, 7, (uint64_t)trial, 0, 0);
        draw(rng, most, x, n);
        assert_int_equal(make((rows)x, (rows)n, &g), FOOTPOINT_OK);
        footpoint_gregory_position(&g, xi, eta, xs);
        if (footpoint_gregory_normal(&g, xi, eta, normal) != FOOTPOINT_OK)
            continue;
        const double gap = gsl_ran_flat(rng, -0.1, 0.1);
        for (int k = 0; k < 3; k++)
            xs[k] += gap * normal[k];
        if (!foot_patch_closest(&g, xs, &s))
            continue;
        told[trial % 2]++;
        double r[3], nearest = INFINITY;
        footpoint_gregory_position(&g, s.xi, s.eta, r);
        const double found = hypot(hypot(xs[0] - r[0], xs[1] - r[1]), xs[2] - r[2]);
        assert_true(fabs(s.xi) < 1 + 1e-14 && fabs(s.eta) < 1 + 1e-14 && found <= fabs(gap) + 1e-13);
        for (int k = 0; k < (LATTICE + 1) * (LATTICE + 1); k++) {
            const double u = 2.0 * (k / (LATTICE + 1)) / LATTICE - 1, v = 2.0 * (k % (LATTICE + 1)) / LATTICE - 1;
            footpoint_gregory_position(&g, u, v, r);
            nearest = fmin(nearest, hypot(hypot(xs[0] - r[0], xs[1] - r[1]), xs[2] - r[2]));
        }
        assert_true(found <= nearest + 1e-13);
    }
    print_message("closest points told: %d of 200 gently tilted, %d of 200 up to tan 2\n", told[0], told[1]);
    gsl_rng_free(rng);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(repeated_corners_have_statuses),
        cmocka_unit_test(vanishing_edges_have_statuses),
        cmocka_unit_test(sizes_have_statuses),
        cmocka_unit_test(bad_normals_have_statuses),
        cmocka_unit_test(corners_and_normals_are_interpolated),
        cmocka_unit_test(neighbours_share_tangent_planes),
        cmocka_unit_test(closest_points_are_certain),
    };
    return cmocka_run_group_tests_name("gregory_hard", tests, NULL, NULL);
}
