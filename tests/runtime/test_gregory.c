/* Smoothed segments: Gregory and Bezier patches against (45)-(50) evaluated by de Casteljau's algorithm with 320 bits
 * (MPFR), derivatives against their difference quotients; one tangent plane along shared edges. */
#include "../../evolve/common/stream.h"
#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <mpfr.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define BITS 320

typedef const double (*rows)[3];

/* ---- (45)-(50) in MPFR ----------------------------------------------------------------------------------------- */

static mpfr_t work[4][4], column[4], weight[2], sum;

static void registers(void (*apply)(mpfr_ptr))
{
    for (int i = 0; i < 4; i++) {
        apply(column[i]);
        for (int j = 0; j < 4; j++)
            apply(work[i][j]);
    }
    apply(weight[0]);
    apply(weight[1]);
    apply(sum);
}

static void start_register(mpfr_ptr x)
{
    mpfr_init2(x, BITS);
}

static int start(void **state)
{
    (void)state;
    registers(start_register);
    return 0;
}

static int finish(void **state)
{
    (void)state;
    registers(mpfr_clear);
    mpfr_free_cache();
    return 0;
}

/* Computes a = (1 - t) a + t b. */
static void approach(mpfr_t a, mpfr_t b, mpfr_t t)
{
    mpfr_sub(sum, b, a, MPFR_RNDN);
    mpfr_fma(a, sum, t, a, MPFR_RNDN);
}

static void casteljau(mpfr_t p[4], mpfr_t t)
{
    for (int k = 3; k > 0; k--)
        for (int i = 0; i < k; i++)
            approach(p[i], p[i + 1], t);
}

/* Computes component c of r - A at (u,v). */
static void position(mpfr_t r, const struct footpoint_gregory *g, int c, mpfr_t u, mpfr_t v)
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            mpfr_set_d(work[i][j], g->net.p[i][j][c], MPFR_RNDN);
            if (i % 3 == 0 || j % 3 == 0)
                continue;
            mpfr_set(weight[0], u, MPFR_RNDN);
            mpfr_set(weight[1], v, MPFR_RNDN);
            if (i == 2)
                mpfr_ui_sub(weight[0], 1, u, MPFR_RNDN);
            if (j == 2)
                mpfr_ui_sub(weight[1], 1, v, MPFR_RNDN);
            mpfr_add(sum, weight[0], weight[1], MPFR_RNDN);
            if (mpfr_zero_p(sum))
                continue; /* a corner, where the point has weight 0 */
            mpfr_mul_d(weight[0], weight[0], g->net.p[i][j][c], MPFR_RNDN);
            mpfr_mul_d(weight[1], weight[1], g->twin[i - 1][j - 1][c], MPFR_RNDN);
            mpfr_add(work[i][j], weight[0], weight[1], MPFR_RNDN);
            mpfr_div(work[i][j], work[i][j], sum, MPFR_RNDN);
        }
    for (int i = 0; i < 4; i++) {
        casteljau(work[i], v);
        mpfr_set(column[i], work[i][0], MPFR_RNDN);
    }
    casteljau(column, u);
    mpfr_set(r, column[0], MPFR_RNDN);
}

/* Computes component c of the jet at (xi + offset, eta + offset_eta), from difference quotients over 2^-90. */
static void quotients(const struct footpoint_gregory *g, int c, double xi, double eta, double offset[2], double jet[6])
{
    enum { STEP = 90 };
    static const int weight_of[6][9] = {/* (-,-) (-,0) (-,+) (0,-) (0,0) (0,+) (+,-) (+,0) (+,+) */
                                        {0, 0, 0, 0, 1, 0, 0, 0, 0},   {0, -1, 0, 0, 0, 0, 0, 1, 0},
                                        {0, 0, 0, -1, 0, 1, 0, 0, 0},  {0, 1, 0, 0, -2, 0, 0, 1, 0},
                                        {1, 0, -1, 0, 0, 0, -1, 0, 1}, {0, 0, 0, 1, -2, 1, 0, 0, 0}};
    /* A step of xi is twice a step of u; central first differences span two steps, the mixed difference four. */
    static const int power[6] = {0, STEP - 2, STEP - 2, 2 * STEP - 2, 2 * STEP - 4, 2 * STEP - 2};
    mpfr_t r[9], u, v, total;
    for (int k = 0; k < 9; k++)
        mpfr_init2(r[k], BITS);
    mpfr_inits2(BITS, u, v, total, (mpfr_ptr)0);
    for (int k = 0; k < 9; k++) {
        mpfr_set_si_2exp(u, k / 3 - 1, 1 - STEP, MPFR_RNDN);
        mpfr_set_si_2exp(v, k % 3 - 1, 1 - STEP, MPFR_RNDN);
        mpfr_add_d(u, u, offset[0], MPFR_RNDN);
        mpfr_add_d(v, v, offset[1], MPFR_RNDN);
        mpfr_add_d(u, u, xi, MPFR_RNDN);
        mpfr_add_d(v, v, eta, MPFR_RNDN);
        mpfr_add_ui(u, u, 1, MPFR_RNDN);
        mpfr_add_ui(v, v, 1, MPFR_RNDN);
        mpfr_div_2ui(u, u, 1, MPFR_RNDN);
        mpfr_div_2ui(v, v, 1, MPFR_RNDN);
        position(r[k], g, c, u, v);
    }
    for (int d = 0; d < 6; d++) {
        mpfr_set_zero(total, 1);
        for (int k = 0; k < 9; k++) {
            mpfr_mul_si(u, r[k], weight_of[d][k], MPFR_RNDN);
            mpfr_add(total, total, u, MPFR_RNDN);
        }
        mpfr_mul_2si(total, total, power[d], MPFR_RNDN);
        jet[d] = mpfr_get_d(total, MPFR_RNDN);
    }
    for (int k = 0; k < 9; k++)
        mpfr_clear(r[k]);
    mpfr_clears(u, v, total, (mpfr_ptr)0);
}

/* ---- patches --------------------------------------------------------------------------------------------------- */

static double size_of(const struct footpoint_gregory *g)
{
    double size = 0;
    for (int k = 0; k < 48; k++)
        size = fmax(size, fabs(g->net.p[k / 12][k / 3 % 4][k % 3]));
    return size;
}

static const double *derivative(const struct footpoint_jet *jet, int d)
{
    const double *all[6] = {jet->r, jet->r_xi, jet->r_eta, jet->r_xixi, jet->r_xieta, jet->r_etaeta};
    return all[d];
}

/* Draws a segment with strongly tilted normals. */
static void random_segment(gsl_rng *rng, double x[4][3], double n[4][3])
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int c = 0; c < 4; c++) {
        for (int k = 0; k < 3; k++) {
            x[c][k] = (k < 2 ? corner[c][k] : 0) + gsl_ran_flat(rng, -0.4, 0.4) + 3;
            n[c][k] = gsl_ran_flat(rng, -0.4, 0.4) + (k == 2);
        }
        const double length = hypot(hypot(n[c][0], n[c][1]), n[c][2]);
        for (int k = 0; k < 3; k++)
            n[c][k] /= length;
    }
}

static struct footpoint_gregory patch_of(double x[4][3], double n[4][3])
{
    struct footpoint_gregory g;
    assert_int_equal(footpoint_gregory_points((rows)x, (rows)n, &g), FOOTPOINT_OK);
    return g;
}

static void compare_jet(const struct footpoint_gregory *g, double xi, double eta, double offset[2])
{
    static const double tolerance[6] = {2e-15, 1e-14, 1e-14, 1e-13, 1e-13, 1e-13};
    struct footpoint_jet jet;
    footpoint_gregory_jet(g, xi, eta, &jet);
    for (int c = 0; c < 3; c++) {
        double reference[6];
        quotients(g, c, xi, eta, offset, reference);
        for (int d = 0; d < 6; d++)
            if (!(fabs(derivative(&jet, d)[c] - reference[d]) <= tolerance[d] * size_of(g)))
                fail_msg("component %d of derivative %d at (%a, %a): %.17g, not %.17g", c, d, xi, eta,
                         derivative(&jet, d)[c], reference[d]);
    }
}

/* Jets are right inside, next to corners and on edges; in corners, as limits from the diagonal. */
static void jets_match_difference_quotients(void **state)
{
    (void)state;
    static const double place[] = {-1, -1 + 1e-12, -0.999, -0.3, 0, 0.7, 1 - 1e-9, 1};
    enum { PLACES = sizeof place / sizeof *place };
    gsl_rng *rng = stream_new();
    double x[4][3], n[4][3], none[2] = {0, 0};
    stream_key(rng, 7, 0, 0, 0);
    for (int trial = 0; trial < 5; trial++) {
        random_segment(rng, x, n);
        const struct footpoint_gregory g = patch_of(x, n);
        for (int k = 0; k < PLACES * PLACES; k++) {
            const double xi = place[k / PLACES], eta = place[k % PLACES];
            double inwards[2] = {-copysign(0x1p-56, xi), -copysign(0x1p-56, eta)};
            compare_jet(&g, xi, eta, fabs(xi) == 1 && fabs(eta) == 1 ? inwards : none);
        }
        for (int k = 0; k < 20; k++) {
            const double xi = gsl_ran_flat(rng, -1, 1);
            compare_jet(&g, xi, gsl_ran_flat(rng, -1, 1), none);
        }
    }
    gsl_rng_free(rng);
}

/* Beyond an edge r continues without poles, with its derivatives. */
static void patches_continue_beyond_edges(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    double x[4][3], n[4][3];
    stream_key(rng, 8, 0, 0, 0);
    random_segment(rng, x, n);
    const struct footpoint_gregory g = patch_of(x, n);
    const double step = 1e-9;
    for (int k = 0; k < 200; k++) {
        const double along = gsl_ran_flat(rng, -0.9, 0.9), side = k % 2 ? 1 : -1;
        struct footpoint_jet in, out;
        footpoint_gregory_jet(&g, k % 4 < 2 ? side : along, k % 4 < 2 ? along : side, &in);
        footpoint_gregory_jet(&g, k % 4 < 2 ? side * (1 + step) : along, k % 4 < 2 ? along : side * (1 + step), &out);
        for (int d = 0; d < 3; d++)
            for (int c = 0; c < 3; c++)
                assert_true(fabs(derivative(&in, d)[c] - derivative(&out, d)[c]) < 1e3 * step);
        footpoint_gregory_jet(&g, gsl_ran_flat(rng, -1.5, 1.5), gsl_ran_flat(rng, -1.5, 1.5), &out);
        assert_true(fabs(out.r[0]) + fabs(out.r_xi[1]) + fabs(out.r_eta[2]) + fabs(out.r_xieta[0]) < 1e3);
    }
    gsl_rng_free(rng);
}

/* Patches contain corners and their normals; a flat parallelogram is the bilinear segment; impossible patches are
 * refused. */
static void corners_and_normals_are_interpolated(void **state)
{
    (void)state;
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double flat[4][3] = {{5, 1, 2}, {7, 1, 2}, {8, 4, 2}, {6, 4, 2}};
    double up[4][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, x[4][3], n[4][3];
    gsl_rng *rng = stream_new();
    stream_key(rng, 9, 0, 0, 0);
    random_segment(rng, x, n);
    struct footpoint_gregory g = patch_of(x, n);
    for (int c = 0; c < 4; c++) {
        double r[3], normal[3], gap, above[3];
        footpoint_gregory_position(&g, corner[c][0], corner[c][1], r);
        assert_int_equal(footpoint_gregory_normal(&g, corner[c][0], corner[c][1], normal), FOOTPOINT_OK);
        for (int k = 0; k < 3; k++) {
            assert_true(fabs(r[k] - x[c][k]) < 1e-15 * 8 && fabs(normal[k] - n[c][k]) < 1e-14);
            above[k] = x[c][k] - 0.3 * n[c][k];
        }
        assert_int_equal(footpoint_gregory_gap(&g, above, corner[c][0], corner[c][1], &gap), FOOTPOINT_OK);
        assert_true(fabs(gap + 0.3) < 1e-14);
    }
    g = patch_of(flat, up);
    for (int k = 0; k < 100; k++) {
        const double xi = gsl_ran_flat(rng, -1, 1), eta = gsl_ran_flat(rng, -1, 1);
        double r[3], facet[3];
        footpoint_gregory_position(&g, xi, eta, r);
        footpoint_quad4_position(flat[0], flat[1], flat[2], flat[3], xi, eta, facet);
        for (int c = 0; c < 3; c++)
            assert_true(fabs(r[c] - facet[c]) < 1e-14);
    }
    const struct footpoint_gregory before = g;
    up[2][0] = NAN;
    assert_int_equal(footpoint_gregory_points((rows)flat, (rows)up, &g), FOOTPOINT_ERR_NOT_FINITE);
    up[2][0] = 0;
    memcpy(up[1], (const double[3]){1, 0, 0}, sizeof up[1]); /* along the edge AB */
    assert_int_equal(footpoint_gregory_points((rows)flat, (rows)up, &g), FOOTPOINT_ERR_DEGENERATE);
    memcpy(flat[1], flat[0], sizeof flat[1]);
    assert_int_equal(footpoint_gregory_points((rows)flat, (rows)up, &g), FOOTPOINT_ERR_DEGENERATE);
    assert_memory_equal(&before, &g, sizeof g);
    gsl_rng_free(rng);
}

/* Renumbering the corners only turns (xi,eta). */
static void renumbering_only_turns_coordinates(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    double x[4][3], n[4][3], xt[4][3], nt[4][3];
    stream_key(rng, 10, 0, 0, 0);
    for (int trial = 0; trial < 50; trial++) {
        random_segment(rng, x, n);
        for (int c = 0; c < 4; c++) {
            memcpy(xt[c], x[(c + 1) % 4], sizeof xt[c]);
            memcpy(nt[c], n[(c + 1) % 4], sizeof nt[c]);
        }
        const struct footpoint_gregory g = patch_of(x, n), turned = patch_of(xt, nt);
        const double xi = gsl_ran_flat(rng, -1, 1), eta = gsl_ran_flat(rng, -1, 1);
        double a[3], b[3];
        footpoint_gregory_position(&g, xi, eta, a);
        footpoint_gregory_position(&turned, eta, -xi, b);
        for (int c = 0; c < 3; c++)
            assert_true(fabs(a[c] - b[c]) < 1e-14);
    }
    gsl_rng_free(rng);
}

/* ---- neighbours ------------------------------------------------------------------------------------------------ */

/* Largest distance and largest angle between two patches along the edge from corner a to corner b of the first, which
 * is the edge from c to d of the second. */
struct joint {
    double distance, angle;
};

static void jet_between(const struct footpoint_gregory *g, int smooth, int a, int b, double t, double r[3], double n[3])
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double xi = (1 - t) * corner[a][0] + t * corner[b][0], eta = (1 - t) * corner[a][1] + t * corner[b][1];
    struct footpoint_jet jet;
    if (smooth)
        footpoint_gregory_jet(g, xi, eta, &jet);
    else
        footpoint_bezier_jet(&g->net, xi, eta, &jet);
    assert_int_equal(footpoint_jet_normal(g->net.origin, &jet, NULL, n, NULL), FOOTPOINT_OK);
    for (int k = 0; k < 3; k++)
        r[k] = g->net.origin[k] + jet.r[k];
}

static struct joint join(const struct footpoint_gregory *p, const int from[2], const struct footpoint_gregory *q,
                         const int to[2], int smooth)
{
    struct joint most = {0, 0};
    for (int k = 0; k <= 64; k++) {
        double r[3], s[3], n[3], m[3], sine = 0;
        jet_between(p, smooth, from[0], from[1], k / 64.0, r, n);
        jet_between(q, smooth, to[0], to[1], k / 64.0, s, m);
        for (int c = 0; c < 3; c++) {
            most.distance = fmax(most.distance, fabs(r[c] - s[c]));
            sine += fabs(n[c] - m[c]);
        }
        most.angle = fmax(most.angle, sine);
    }
    return most;
}

/* Makes `valence` segments around a node with random heights and normals, and returns the worst joint. */
static struct joint fan(gsl_rng *rng, int valence, int smooth)
{
    double x[13][3], normal[13][3];
    struct footpoint_gregory patch[6];
    struct joint most = {0, 0};
    for (int i = 0; i <= 2 * valence; i++) { /* node 0 is the middle; odd nodes end edges that meet there */
        const double radius = i == 0 ? 0 : i % 2 ? 1 : 1.3, angle = M_PI * (i - 1) / valence;
        double length = 0;
        for (int k = 0; k < 3; k++) {
            x[i][k] = (k == 0 ? radius * cos(angle) : k == 1 ? radius * sin(angle) : 0) + gsl_ran_flat(rng, -0.2, 0.2);
            normal[i][k] = gsl_ran_flat(rng, -0.3, 0.3) + (k == 2);
            length = hypot(length, normal[i][k]);
        }
        for (int k = 0; k < 3; k++)
            normal[i][k] /= length;
    }
    for (int i = 0; i < valence; i++) {
        const int node[4] = {0, 2 * i + 1, 2 * i + 2, (2 * i + 2) % (2 * valence) + 1};
        double corner[4][3], n[4][3];
        for (int c = 0; c < 4; c++) { /* numbered from any corner */
            memcpy(corner[c], x[node[(c + i) % 4]], sizeof corner[c]);
            memcpy(n[c], normal[node[(c + i) % 4]], sizeof n[c]);
        }
        patch[i] = patch_of(corner, n);
        if (!smooth)
            assert_int_equal(footpoint_bezier_points((rows)corner, (rows)n, &patch[i].net), FOOTPOINT_OK);
    }
    for (int i = 0; i < valence; i++) { /* the edge from the middle to this segment's D is AB of the next */
        const int next = (i + 1) % valence;
        const int from[2] = {(4 - i % 4) % 4, (3 + 4 - i % 4) % 4};
        const int to[2] = {(4 - next % 4) % 4, (1 + 4 - next % 4) % 4};
        const struct joint j = join(&patch[i], from, &patch[next], to, smooth);
        most.distance = fmax(most.distance, j.distance);
        most.angle = fmax(most.angle, j.angle);
    }
    return most;
}

static void neighbours_share_tangent_planes(void **state)
{
    (void)state;
    gsl_rng *rng = stream_new();
    stream_key(rng, 11, 0, 0, 0);
    for (int valence = 3; valence <= 6; valence++)
        for (int trial = 0; trial < 20; trial++) {
            const struct joint smooth = fan(rng, valence, 1), bezier = fan(rng, valence, 0);
            assert_true(smooth.distance < 1e-14 && smooth.angle < 1e-13);
            assert_true(bezier.distance < 1e-14 && bezier.angle > 1e-3);
        }
    gsl_rng_free(rng);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(jets_match_difference_quotients),      cmocka_unit_test(patches_continue_beyond_edges),
        cmocka_unit_test(corners_and_normals_are_interpolated), cmocka_unit_test(renumbering_only_turns_coordinates),
        cmocka_unit_test(neighbours_share_tangent_planes),
    };
    return cmocka_run_group_tests_name("gregory", tests, start, finish);
}
