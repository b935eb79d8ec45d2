/* Derivatives of footpoint_bezier_derivatives.h and footpoint_gregory_derivatives.h at a foot point, against
 * differences in quadruple precision of patches made from their control points; sums that must be 0; corners and edges,
 * statuses, NULL rows, sizes, arrays. 60 patches a kind, 1e5 with FOOTPOINT_LONG. */
#include "../../evolve/common/stream.h"
#include "../../generated/footpoint_bezier_derivatives.h"
#include "../../generated/footpoint_gregory_derivatives.h"
#include "../support/kind_arguments.h"
#include "../support/long_cases.h"
#include "../support/quad_patch.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 60, SAMPLES_LONG = 100000, ROWS = 24, CORNERS = 12, OTHERS = 15, ALL = PATCH_COORDINATES };
#define STEP 1e-12      /* step of differences */
#define CONDITIONED 1e4 /* of Hessian and metric: derivatives lose as many digits against the coordinates */
#define NEAR 1e-9       /* relative error below that condition */
#define IDENTITY 1e-10  /* sums that must be 0, relative to the sum of magnitudes */
#define UNTOUCHED 77.25

/* All outputs of the functions: derivatives by corners and slave node, and _n by normals. */
struct given {
    double r[3], r_xi[3], r_eta[3], normal[3], gap;
    double d[3][OTHERS], d_n[3][CORNERS]; /* of xi, eta and gap */
};

typedef int place_function(double (*x)[3], const double loc[2], struct given *g);
typedef void loop_function(size_t n, const double *const *x, const double *xi, const double *eta, double *r,
                           double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                           double *d_gap, double *d_xi_n, double *d_eta_n, double *d_gap_n, int *status);

#define FUNCTIONS(kind)                                                                                                \
    static int place_##kind(double(*x)[3], const double loc[2], struct given *g)                                       \
    {                                                                                                                  \
        return footpoint_##kind##_place(NODES_OF_##kind(x, x[8]), loc, g->r, g->r_xi, g->r_eta, g->normal, &g->gap);   \
    }                                                                                                                  \
    static int first_##kind(double(*x)[3], const double loc[2], struct given *g)                                       \
    {                                                                                                                  \
        return footpoint_##kind##_gradients(NODES_OF_##kind(x, x[8]), loc, g->r, g->r_xi, g->r_eta, g->normal,         \
                                            &g->gap, g->d[0], g->d[1], g->d[2], g->d_n[0], g->d_n[1], g->d_n[2]);      \
    }                                                                                                                  \
    static int alone_##kind(double(*x)[3], const double loc[2], struct given *g)                                       \
    {                                                                                                                  \
        return footpoint_##kind##_gradients(NODES_OF_##kind(x, x[8]), loc, NULL, NULL, NULL, NULL, NULL, NULL, NULL,   \
                                            NULL, NULL, NULL, g->d_n[2]);                                              \
    }
FUNCTIONS(bezier)
FUNCTIONS(gregory)

static const struct kind {
    const char *name;
    bool twins;
    place_function *place, *first, *alone; /* alone: the gap of `first`, by normals only */
    loop_function *loop;
} kinds[] = {
    {"bezier", false, place_bezier, first_bezier, alone_bezier, footpoint_bezier_gradients_n},
    {"gregory", true, place_gregory, first_gregory, alone_gregory, footpoint_gregory_gradients_n},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static void widen(double (*x)[3], quadruple *y)
{
    for (int i = 0; i < ALL; i++)
        y[i] = x[i / 3][i % 3];
}

/* Draws a patch about a sphere, and a slave node with its foot point near loc. `wild` scales the motion of corners, the
 * tilt of normals, and the distance of the slave node. */
static void draw(gsl_rng *stream, const struct kind *k, double wild, double (*x)[3], double loc[2])
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    quadruple y[ALL] = {0};
    struct patch_foot at;
    for (int c = 0; c < 4; c++) {
        double length = 0;
        for (int i = 0; i < 3; i++) {
            x[c][i] = (i < 2 ? corner[c][i] : 0) + wild * (2 * gsl_rng_uniform(stream) - 1);
            x[4 + c][i] = (i < 2 ? wild * corner[c][i] : 1) + wild * (2 * gsl_rng_uniform(stream) - 1);
            length = hypot(length, x[4 + c][i]);
        }
        for (int i = 0; i < 3; i++)
            x[4 + c][i] /= length;
    }
    memset(x[8], 0, sizeof x[8]);
    for (int i = 0; i < 2; i++)
        loc[i] = 1.8 * gsl_rng_uniform(stream) - 0.9;
    widen(x, y);
    patch_point(k->twins, y, loc[0], loc[1], &at);
    const double gap = 2 * wild * (2 * gsl_rng_uniform(stream) - 1);
    for (int i = 0; i < 3; i++)
        x[8][i] = (double)(at.r[i] + gap * at.normal[i]);
}

/* Returns the derivative of output o by coordinate c of all. */
static double *derivative(struct given *g, int o, int c)
{
    return c < CORNERS ? &g->d[o][c] : c < 2 * CORNERS ? &g->d_n[o][c - CORNERS] : &g->d[o][c - CORNERS];
}

/* Computes central differences; returns false if a foot point gets lost: those on both sides must be about equally far
 * from the known foot point. */
static bool differences(const struct kind *k, quadruple *x, const struct patch_foot *foot, double slope[3][ALL])
{
    for (int c = 0; c < ALL; c++) {
        const quadruple here = x[c];
        struct patch_foot to[2];
        x[c] = here + STEP;
        if (!patch_foot_beside(k->twins, x, foot->xi, foot->eta, foot, &to[0]))
            return false;
        x[c] = here - STEP;
        if (!patch_foot_beside(k->twins, x, 2 * foot->xi - to[0].xi, 2 * foot->eta - to[0].eta, foot, &to[1]))
            return false;
        x[c] = here;
        slope[0][c] = (double)(to[0].xi - to[1].xi) / (2 * STEP);
        slope[1][c] = (double)(to[0].eta - to[1].eta) / (2 * STEP);
        slope[2][c] = (double)(to[0].gap - to[1].gap) / (2 * STEP);
    }
    return true;
}

static void expect_near(const struct kind *k, const char *what, int element, double value, double truth, double scale)
{
    if (!(fabs(value - truth) <= NEAR * scale)) {
        print_error("%s %s %d: %.17g, not %.17g, of %g\n", k->name, what, element, value, truth, scale);
        fail();
    }
}

static void compare(const struct kind *k, struct given *g, const struct patch_foot *foot, double slope[3][ALL])
{
    static const char *const name[3] = {"d_xi", "d_eta", "d_gap"};
    expect_near(k, "gap", 0, g->gap, (double)foot->gap, 1);
    for (int i = 0; i < 3; i++) {
        expect_near(k, "r", i, g->r[i], (double)foot->r[i], 1);
        expect_near(k, "r_xi", i, g->r_xi[i], (double)foot->r_xi[i], 1);
        expect_near(k, "r_eta", i, g->r_eta[i], (double)foot->r_eta[i], 1);
        expect_near(k, "normal", i, g->normal[i], (double)foot->normal[i], 1);
    }
    for (int o = 0; o < 3; o++) {
        double most = o == 2;
        for (int c = 0; c < ALL; c++)
            most = fmax(most, fabs(slope[o][c]));
        for (int c = 0; c < ALL; c++)
            expect_near(k, name[o], c, *derivative(g, o, c), slope[o][c], most);
    }
}

/* Checks that moving all corners and the slave node changes nothing, nor does turning them with the normals; and that d
 * gap / d xS is n. */
static void expect_identities(struct given *g, double (*x)[3])
{
    for (int o = 0; o < 3; o++)
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            double sum = 0, sums = 0, moment = 0, moments = 0;
            for (int v = 0; v < ALL / 3; v++) {
                const double a = x[v][j] * *derivative(g, o, 3 * v + l), b = x[v][l] * *derivative(g, o, 3 * v + j);
                const double d = v < 4 || v == 8 ? *derivative(g, o, 3 * v + i) : 0;
                sum += d;
                sums += fabs(d);
                moment += a - b;
                moments += fabs(a) + fabs(b);
            }
            assert_true(fabs(sum) <= IDENTITY * sums);
            assert_true(fabs(moment) <= CONDITIONED * IDENTITY * moments);
        }
    for (int i = 0; i < 3; i++)
        assert_true(fabs(g->d[2][CORNERS + i] - g->normal[i]) <= 1e-14);
}

static void derivatives_are_right(void **state)
{
    const long samples = long_cases(SAMPLES, SAMPLES_LONG);
    gsl_rng *stream = stream_new();
    (void)state;
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        long judged = 0;
        for (long sample = 0; sample < samples; sample++) {
            double x[ALL / 3][3], loc[2], slope[3][ALL];
            quadruple y[ALL];
            struct patch_foot foot;
            struct given g, place;
            stream_key(stream, 20245, (uint64_t)k->twins, (uint64_t)sample, 0);
            draw(stream, k, sample % 2 ? 0.1 : 0.25, x, loc);
            widen(x, y);
            if (!patch_foot_near(k->twins, y, loc[0], loc[1], &foot) || foot.condition > CONDITIONED ||
                !differences(k, y, &foot, slope))
                continue;
            loc[0] = (double)foot.xi;
            loc[1] = (double)foot.eta;
            assert_int_equal(k->first(x, loc, &g), FOOTPOINT_OK);
            compare(k, &g, &foot, slope);
            expect_identities(&g, x);
            assert_int_equal(k->place(x, loc, &place), FOOTPOINT_OK);
            assert_true(fabs(place.gap - g.gap) <= 1e-13);
            for (int i = 0; i < 3; i++)
                assert_true(fabs(place.r[i] - g.r[i]) + fabs(place.r_xi[i] - g.r_xi[i]) +
                                fabs(place.r_eta[i] - g.r_eta[i]) + fabs(place.normal[i] - g.normal[i]) <=
                            1e-13);
            judged++;
        }
        print_message("%s: %ld of %ld\n", k->name, judged, samples);
        assert_true(judged > samples / 2);
    }
    gsl_rng_free(stream);
}

/* Derivatives are right at corners, where the points of a Gregory patch are 0/0, and on edges. */
static void corners_and_edges(void **state)
{
    gsl_rng *stream = stream_new();
    (void)state;
    stream_key(stream, 20246, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++)
        for (int i = -1; i <= 1; i++)
            for (int j = -1; j <= 1; j++) {
                double x[ALL / 3][3], loc[2];
                struct given g, near;
                draw(stream, k, 0.1, x, loc);
                loc[0] = i;
                loc[1] = j;
                assert_int_equal(k->place(x, loc, &g), FOOTPOINT_OK);
                for (int c = 0; c < 3 && i && j; c++)
                    assert_true(fabs(g.r[c] - x[j < 0 ? (i + 1) / 2 : 3 - (i + 1) / 2][c]) <= 1e-15);
                for (int c = 0; c < 3; c++)
                    x[8][c] = g.r[c] + 0.1 * g.normal[c];
                assert_int_equal(k->first(x, loc, &g), FOOTPOINT_OK);
                if (i && j && k->twins)
                    continue;
                loc[0] *= 1 - 1e-9;
                loc[1] *= 1 - 1e-9;
                assert_int_equal(k->first(x, loc, &near), FOOTPOINT_OK);
                for (int o = 0; o < 3; o++)
                    for (int c = 0; c < ALL; c++)
                        assert_true(fabs(*derivative(&g, o, c) - *derivative(&near, o, c)) <= 1e-6);
            }
    gsl_rng_free(stream);
}

static void expect_status(const struct kind *k, double (*x)[3], const double loc[2], int expected)
{
    place_function *const function[] = {k->first, k->place};
    for (int i = 0; i < 2; i++) {
        struct given g;
        double *const all = (double *)&g;
        for (size_t j = 0; j < sizeof g / sizeof *all; j++)
            all[j] = UNTOUCHED;
        assert_int_equal(function[i](x, loc, &g), expected);
        for (size_t j = 0; j < sizeof g / sizeof *all && expected != FOOTPOINT_OK; j++)
            assert_true(all[j] == UNTOUCHED);
    }
}

static void statuses_are_right(void **state)
{
    gsl_rng *stream = stream_new();
    (void)state;
    stream_key(stream, 20247, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        double x[ALL / 3][3], loc[2];
        for (int c = 0; c < ALL + 2; c++) {
            draw(stream, k, 0.1, x, loc);
            expect_status(k, x, loc, FOOTPOINT_OK);
            *(c < 2 ? &loc[c] : &x[(c - 2) / 3][(c - 2) % 3]) = c % 2 ? (double)NAN : -(double)INFINITY;
            expect_status(k, x, loc, FOOTPOINT_ERR_NOT_FINITE);
        }
        draw(stream, k, 0.1, x, loc);
        for (int c = 1; c < 4; c++) /* all corners on one line, normals across it */
            for (int i = 0; i < 3; i++) {
                x[c][i] = x[0][i] + (i == 0) * c;
                x[4 + c][i] = x[4][i] = i == 2;
            }
        expect_status(k, x, loc, FOOTPOINT_ERR_DEGENERATE);
        draw(stream, k, 0.1, x, loc);
        memcpy(x[1], x[0],
               sizeof x[0]); /* an edge of length 0: on a Bezier patch, points away from it are unaffected */
        if (k->twins)
            expect_status(k, x, loc, FOOTPOINT_ERR_DEGENERATE);
    }
    gsl_rng_free(stream);
}

/* A single row is the same, and in another unit of length all rows change by their power of lengths. */
static void rows_and_sizes(void **state)
{
    gsl_rng *stream = stream_new();
    (void)state;
    stream_key(stream, 20248, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        double x[ALL / 3][3], y[ALL / 3][3], loc[2];
        struct given g, alone, scaled;
        draw(stream, k, 0.1, x, loc);
        assert_int_equal(k->first(x, loc, &g), FOOTPOINT_OK);
        assert_int_equal(k->alone(x, loc, &alone), FOOTPOINT_OK);
        for (int i = 0; i < CORNERS; i++)
            assert_true(fabs(alone.d_n[2][i] - g.d_n[2][i]) <= 1e-12);
        for (int power = -900; power <= 900; power += 150) {
            memcpy(y, x, sizeof y);
            for (int i = 0; i < ALL; i++)
                y[i / 3][i % 3] = i >= CORNERS && i < 2 * CORNERS ? x[i / 3][i % 3] : ldexp(x[i / 3][i % 3], power);
            assert_int_equal(k->first(y, loc, &scaled), FOOTPOINT_OK);
            assert_true(fabs(ldexp(scaled.gap, -power) - g.gap) <= 1e-12);
            for (int c = 0; c < ALL; c++) {
                const int length = c >= CORNERS && c < 2 * CORNERS;
                for (int o = 0; o < 3; o++)
                    assert_true(fabs(ldexp(*derivative(&scaled, o, c), -power * (length - (o < 2))) -
                                     *derivative(&g, o, c)) <= 1e-9 * (1 + fabs(*derivative(&g, o, c))));
            }
        }
    }
    gsl_rng_free(stream);
}

/* Arrays equal single calls, with bad and very large pairs among them. */
static void arrays_are_the_same(void **state)
{
    gsl_rng *stream = stream_new();
    (void)state;
    stream_key(stream, 20249, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        static double x[ROWS][ALL / 3][3], column[ALL][ROWS], xi[ROWS], eta[ROWS], gap[ROWS], rest[4][3 * ROWS];
        static double d[3][OTHERS * ROWS], d_n[3][CORNERS * ROWS];
        const double *columns[ALL];
        int status[ROWS];
        for (int p = 0; p < ROWS; p++) {
            double loc[2];
            draw(stream, k, 0.1, x[p], loc);
            xi[p] = loc[0];
            eta[p] = loc[1];
            if (p % 8 == 5)
                x[p][p % 9][p % 3] = (double)NAN;
            for (int i = 0; i < ALL; i++) {
                x[p][i / 3][i % 3] *= p % 8 == 3 && (i < CORNERS || i >= 2 * CORNERS) ? 1e200 : 1;
                column[i][p] = x[p][i / 3][i % 3];
            }
        }
        for (int i = 0; i < ALL; i++)
            columns[i] = column[i];
        k->loop(ROWS, columns, xi, eta, rest[0], rest[1], rest[2], rest[3], gap, d[0], d[1], d[2], d_n[0], d_n[1],
                d_n[2], status);
        for (int p = 0; p < ROWS; p++) {
            const double loc[2] = {xi[p], eta[p]};
            struct given g;
            assert_int_equal(k->first(x[p], loc, &g), status[p]);
            assert_int_equal(status[p], p % 8 == 5 ? FOOTPOINT_ERR_NOT_FINITE : FOOTPOINT_OK);
            for (int i = 0; i < CORNERS && status[p] == FOOTPOINT_OK; i++)
                for (int o = 0; o < 3; o++) {
                    assert_true(fabs(d[o][i * ROWS + p] - g.d[o][i]) <= 1e-9 * fabs(g.d[o][i]) + 1e-12 * (p % 8 != 3));
                    assert_true(fabs(d_n[o][i * ROWS + p] - g.d_n[o][i]) <= 1e-9 * fabs(g.d_n[o][i]) + 1e-12);
                }
        }
    }
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_are_right), cmocka_unit_test(corners_and_edges),
        cmocka_unit_test(statuses_are_right),    cmocka_unit_test(rows_and_sizes),
        cmocka_unit_test(arrays_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
