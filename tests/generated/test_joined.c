/* Searches joined with derivatives, FOOTPOINT_KIND_GENOME_OF(search), equal the two calls in sequence, for a pair and
 * over arrays, including bad, very large and degenerate pairs. */
#include "../../evolve/common/stream.h"
#include "../../generated/footpoint_bezier.h"
#include "../../generated/footpoint_bezier_derivatives.h"
#include "../../generated/footpoint_gregory.h"
#include "../../generated/footpoint_gregory_derivatives.h"
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_derivatives.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad8_derivatives.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_quad9_derivatives.h"
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri3_derivatives.h"
#include "../../generated/footpoint_tri6.h"
#include "../../generated/footpoint_tri6_derivatives.h"
#include "../support/kind_arguments.h"
#include "../support/quad_precision.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum { PAIRS = 67, C = MOST_COORDINATES, NORMALS = 12, NODES = 9 };
#define SAME 1e-12 /* relative: a compiler may fuse operations differently */
#define UNTOUCHED 77.25

struct given {
    double loc[2], gap, d[3][C], d_n[3][NORMALS]; /* of xi, eta, gap: by nodes, and for patches by normals */
};

struct arrays {
    double xi[PAIRS], eta[PAIRS], gap[PAIRS], d[3][C * PAIRS], d_n[3][NORMALS * PAIRS];
    double rest[4][NODES * PAIRS];
    int status[PAIRS];
};

typedef int one_function(double (*x)[3], struct given *g);
typedef void loop_function(const double *const *x, struct arrays *a);

#define ARGUMENTS(kind) NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), g->loc
#define OF_FACE NULL, NULL, NULL, NULL, &g->gap, g->d[0], g->d[1], g->d[2]
#define OF_PATCH OF_FACE, g->d_n[0], g->d_n[1], g->d_n[2]
#define ARRAYS_OF_FACE a->rest[0], a->rest[1], a->rest[2], a->rest[3], a->gap, a->d[0], a->d[1], a->d[2]
#define ARRAYS_OF_PATCH ARRAYS_OF_FACE, a->d_n[0], a->d_n[1], a->d_n[2]

#define FUNCTIONS(kind, KIND, tier, what)                                                                              \
    FOOTPOINT_##KIND##_GRADIENTS_OF(footpoint_##kind##_##tier) static int joined_##kind(double(*x)[3],                 \
                                                                                        struct given *g)               \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_gradients(ARGUMENTS(kind), OF_##what);                                      \
    }                                                                                                                  \
    static int apart_##kind(double(*x)[3], struct given *g)                                                            \
    {                                                                                                                  \
        double distance;                                                                                               \
        const int status = footpoint_##kind##_##tier(ARGUMENTS(kind), &distance);                                      \
        const int placed = status < 0 ? FOOTPOINT_OK : footpoint_##kind##_gradients(ARGUMENTS(kind), OF_##what);       \
        return placed == FOOTPOINT_OK ? status : placed;                                                               \
    }                                                                                                                  \
    static void loop_##kind(const double *const *x, struct arrays *a)                                                  \
    {                                                                                                                  \
        footpoint_##kind##_##tier##_gradients_n(PAIRS, x, a->xi, a->eta, ARRAYS_OF_##what, a->status);                 \
    }
FUNCTIONS(tri3, TRI3, exact, FACE)
FUNCTIONS(tri6, TRI6, accurate, FACE)
FUNCTIONS(quad4, QUAD4, accurate, FACE)
FUNCTIONS(quad8, QUAD8, accurate, FACE)
FUNCTIONS(quad9, QUAD9, accurate, FACE)
FUNCTIONS(bezier, BEZIER, exact, PATCH)
FUNCTIONS(gregory, GREGORY, exact, PATCH)
FOOTPOINT_QUAD4_PLACE_OF(footpoint_quad4_full)
FOOTPOINT_QUAD4_HESSIAN_OF(footpoint_quad4_full)

static const struct kind {
    const char *name;
    int nodes, vectors;
    one_function *joined, *apart;
    loop_function *loop;
} kinds[] = {
#define KIND(kind, nodes)                                                                                              \
    {                                                                                                                  \
#kind, nodes, VECTORS_OF_##kind, joined_##kind, apart_##kind, loop_##kind                                      \
    }
    KIND(tri3, 3), KIND(tri6, 6), KIND(quad4, 4), KIND(quad8, 8), KIND(quad9, 9), KIND(bezier, 4), KIND(gregory, 4)};
enum { KINDS = sizeof kinds / sizeof *kinds };

static double about(gsl_rng *stream, double value, double most)
{
    return value + most * (2 * gsl_rng_uniform(stream) - 1);
}

/* Draws a segment near the plane face of its kind, with normals near z and the slave node above its middle. */
static void draw(gsl_rng *stream, const struct kind *k, double (*x)[3])
{
    const struct exact_face f = exact_face_of(k->nodes);
    double middle[2] = {0, 0};
    for (int v = 0; v < k->vectors - 1; v++) {
        double square = 0;
        for (int i = 0; i < 3; i++) {
            x[v][i] = about(stream, v < k->nodes && i < 2 ? f.place[v][i] : v >= k->nodes && i == 2, 0.05);
            square += x[v][i] * x[v][i];
        }
        for (int i = 0; i < 2 && v < k->nodes; i++)
            middle[i] += x[v][i] / k->nodes;
        for (int i = 0; i < 3 && v >= k->nodes; i++)
            x[v][i] /= sqrt(square);
    }
    for (int i = 0; i < 3; i++)
        x[k->vectors - 1][i] = about(stream, i < 2 ? middle[i] : 0, 0.2);
}

/* Draws pair p: one in eight 1e200 times as large, one with a NaN, one with all corners in one point. */
static void draw_pair(gsl_rng *stream, const struct kind *k, int p, double (*x)[3])
{
    draw(stream, k, x);
    for (int v = 0; v < k->vectors; v++)
        for (int i = 0; i < 3; i++)
            if (v < k->nodes || v == k->vectors - 1)
                x[v][i] *= p % 8 == 3 ? 1e200 : p % 8 == 6 && v < k->nodes ? 0 : 1;
    if (p % 8 == 5)
        x[p % k->vectors][p % 3] = (double)NAN;
}

static void expect_same(const struct kind *k, const char *what, double value, double expected, double scale)
{
    if (!(fabs(value - expected) <= SAME * scale)) {
        print_error("%s %s: %.17g, not %.17g\n", k->name, what, value, expected);
        fail();
    }
}

static double greatest(const double *x, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

static void compare(const struct kind *k, const struct given *g, const struct given *expected)
{
    const int n = 3 * (k->nodes + 1);
    expect_same(k, "xi", g->loc[0], expected->loc[0], 1);
    expect_same(k, "eta", g->loc[1], expected->loc[1], 1);
    expect_same(k, "gap", g->gap, expected->gap, fabs(expected->gap) + greatest(expected->d[2], n));
    for (int o = 0; o < 3; o++) {
        for (int c = 0; c < n; c++)
            expect_same(k, "derivative", g->d[o][c], expected->d[o][c], 1e3 * greatest(expected->d[o], n));
        for (int c = 0; c < NORMALS && k->vectors > k->nodes + 1; c++)
            expect_same(k, "derivative by a normal", g->d_n[o][c], expected->d_n[o][c],
                        1e3 * greatest(expected->d_n[o], NORMALS));
    }
}

static struct given element(const struct arrays *a, const struct kind *k, int p)
{
    struct given g = {{a->xi[p], a->eta[p]}, a->gap[p], {{0}}, {{0}}};
    for (int o = 0; o < 3; o++) {
        for (int c = 0; c < 3 * (k->nodes + 1); c++)
            g.d[o][c] = a->d[o][c * PAIRS + p];
        for (int c = 0; c < NORMALS; c++)
            g.d_n[o][c] = a->d_n[o][c * PAIRS + p];
    }
    return g;
}

static void joined_calls_match_separate_calls(void **state)
{
    static double x[PAIRS][NODES + 1][3], column[C][PAIRS];
    static struct arrays a;
    const double *columns[C];
    gsl_rng *stream = stream_new();
    (void)state;
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        stream_key(stream, 20250, (uint64_t)(k - kinds), 0, 0);
        for (int p = 0; p < PAIRS; p++) {
            draw_pair(stream, k, p, x[p]);
            for (int i = 0; i < 3 * k->vectors; i++)
                column[i][p] = x[p][i / 3][i % 3];
        }
        for (int i = 0; i < 3 * k->vectors; i++)
            columns[i] = column[i];
        k->loop(columns, &a);
        for (int p = 0; p < PAIRS; p++) {
            struct given g, apart, entry = element(&a, k, p);
            double *const all = (double *)&g;
            for (size_t i = 0; i < sizeof g / sizeof *all; i++)
                all[i] = UNTOUCHED;
            const int status = k->apart(x[p], &apart);
            assert_int_equal(status, p % 8 == 5   ? FOOTPOINT_ERR_NOT_FINITE
                                     : p % 8 == 6 ? FOOTPOINT_ERR_DEGENERATE
                                                  : FOOTPOINT_OK);
            assert_int_equal(k->joined(x[p], &g), status);
            assert_int_equal(a.status[p], status);
            if (status == FOOTPOINT_OK) {
                compare(k, &g, &apart);
                compare(k, &entry, &apart);
            } else
                for (size_t i = 2; i < sizeof g / sizeof *all; i++)
                    assert_true(all[i] == UNTOUCHED);
        }
    }
    gsl_rng_free(stream);
}

/* For a sliver, whose answer is not proved, derivatives are computed, and the search's status is returned. */
static void unproved_stays_unproved(void **state)
{
    static double column[C][PAIRS];
    static struct arrays a;
    const double *columns[C];
    double x[NODES + 1][3] = {{-1e6, -1, 0}, {1e6, -1, 0.1}, {1e6, 1, 0}, {-1e6, 1, 0.1}, {3e5, 0.2, 0.4}};
    const struct kind *const k = &kinds[2]; /* quad4 */
    struct given g, apart;
    (void)state;
    assert_int_equal(k->apart(x, &apart), FOOTPOINT_UNPROVED);
    assert_int_equal(k->joined(x, &g), FOOTPOINT_UNPROVED);
    for (int i = 0; i < 3 * k->vectors; i++) {
        columns[i] = column[i];
        for (int p = 0; p < PAIRS; p++)
            column[i][p] = x[i / 3][i % 3];
    }
    k->loop(columns, &a);
    assert_int_equal(a.status[0], FOOTPOINT_UNPROVED);
    const struct given entry = element(&a, k, 0);
    assert_memory_equal(g.loc, apart.loc, sizeof g.loc);
    assert_memory_equal(entry.loc, apart.loc, sizeof g.loc);
    assert_memory_equal(g.d[2], apart.d[2], 15 * sizeof(double));
    assert_true(isfinite(g.d[2][0]) && isfinite(entry.d[2][14]));
}

/* Another search, and the other functions. */
static void place_and_hessian(void **state)
{
    const struct kind *k = &kinds[2];
    gsl_rng *stream = stream_new();
    (void)state;
    stream_key(stream, 20251, 0, 0, 0);
    for (int p = 0; p < PAIRS; p++) {
        double x[5][3], loc[3][2], gap[3], phi[2][4], hessian[2][120];
        draw(stream, k, x);
        assert_int_equal(footpoint_quad4_full(NODES_OF_quad4(x, x[4]), loc[0], &gap[0]), FOOTPOINT_OK);
        assert_int_equal(footpoint_quad4_place(NODES_OF_quad4(x, x[4]), loc[0], phi[0], NULL, NULL, NULL, NULL),
                         FOOTPOINT_OK);
        assert_int_equal(
            footpoint_quad4_hessian(NODES_OF_quad4(x, x[4]), loc[0], &gap[0], NULL, NULL, NULL, NULL, hessian[0]),
            FOOTPOINT_OK);
        assert_int_equal(footpoint_quad4_full_place(NODES_OF_quad4(x, x[4]), loc[1], phi[1], NULL, NULL, NULL, &gap[1]),
                         FOOTPOINT_OK);
        assert_int_equal(
            footpoint_quad4_full_hessian(NODES_OF_quad4(x, x[4]), loc[2], &gap[2], NULL, NULL, NULL, NULL, hessian[1]),
            FOOTPOINT_OK);
        for (int i = 1; i < 3; i++) {
            expect_same(k, "xi", loc[i][0], loc[0][0], 1);
            expect_same(k, "eta", loc[i][1], loc[0][1], 1);
            expect_same(k, "gap", gap[i], gap[0], 1);
        }
        for (int i = 0; i < 4; i++)
            expect_same(k, "phi", phi[1][i], phi[0][i], 1);
        for (int i = 0; i < 120; i++)
            expect_same(k, "hessian", hessian[1][i], hessian[0][i], 1e3 * greatest(hessian[0], 120));
    }
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joined_calls_match_separate_calls),
        cmocka_unit_test(unproved_stays_unproved),
        cmocka_unit_test(place_and_hessian),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
