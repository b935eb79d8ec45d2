/* Derivatives of footpoint_KIND_derivatives.h at a foot point, against differences in quadruple precision, which share
 * no code with them; sums that must be 0; statuses, NULL rows, sizes, arrays. 100 faces a kind, 1e5 with
 * FOOTPOINT_LONG. */
#include "../../evolve/common/stream.h"
#include "../../generated/footpoint_quad4_derivatives.h"
#include "../../generated/footpoint_quad8_derivatives.h"
#include "../../generated/footpoint_quad9_derivatives.h"
#include "../../generated/footpoint_tri3_derivatives.h"
#include "../../generated/footpoint_tri6_derivatives.h"
#include "../support/kind_arguments.h"
#include "../support/long_cases.h"
#include "../support/quad_precision.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

enum { SAMPLES = 100, SAMPLES_LONG = 100000, ROWS = 40, C = MOST_COORDINATES, PACKED = C * (C + 1) / 2 };
#define STEP 1e-14      /* step of differences, so small that the largest third derivatives, 1e19, do not matter */
#define CONDITIONED 1e4 /* of Hessian and metric: derivatives lose as many digits against the coordinates */
#define NEAR 1e-9       /* relative error below that condition */
#define IDENTITY 1e-11  /* sums that must be 0, relative to the sum of magnitudes */
#define UNTOUCHED 77.25

/* All outputs of a kind's functions. */
struct given {
    double phi[MOST_NODES], r_xi[3], r_eta[3], normal[3], gap;
    double d_xi[C], d_eta[C], d_gap[C], d_normal[3 * C], hessian[PACKED];
};

typedef int place_function(double (*x)[3], const double loc[2], struct given *g);
typedef void loop_function(size_t n, const double *const *x, const double *xi, const double *eta, double *phi,
                           double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                           double *d_gap, int *status);

#define FUNCTIONS(kind)                                                                                                \
    static int place_##kind(double(*x)[3], const double loc[2], struct given *g)                                       \
    {                                                                                                                  \
        return footpoint_##kind##_place(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), loc, g->phi, g->r_xi, g->r_eta,  \
                                        g->normal, &g->gap);                                                           \
    }                                                                                                                  \
    static int first_##kind(double(*x)[3], const double loc[2], struct given *g)                                       \
    {                                                                                                                  \
        return footpoint_##kind##_gradients(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), loc, g->phi, g->r_xi,        \
                                            g->r_eta, g->normal, &g->gap, g->d_xi, g->d_eta, g->d_gap);                \
    }                                                                                                                  \
    static int second_##kind(double(*x)[3], const double loc[2], struct given *g)                                      \
    {                                                                                                                  \
        return footpoint_##kind##_hessian(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), loc, &g->gap, g->d_xi,         \
                                          g->d_eta, g->d_gap, g->d_normal, g->hessian);                                \
    }                                                                                                                  \
    static int alone_##kind(double(*x)[3], const double loc[2], struct given *g)                                       \
    {                                                                                                                  \
        return footpoint_##kind##_hessian(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), loc, NULL, NULL, NULL, NULL,   \
                                          NULL, g->hessian);                                                           \
    }
FUNCTIONS(tri3)
FUNCTIONS(tri6)
FUNCTIONS(quad4)
FUNCTIONS(quad8)
FUNCTIONS(quad9)

static const struct kind {
    const char *name;
    int nodes;
    place_function *place, *first, *second, *alone; /* alone: only the Hessian of `second` */
    loop_function *loop;
} kinds[] = {
#define KIND(kind)                                                                                                     \
    {                                                                                                                  \
#kind, VECTORS_OF_##kind - 1, place_##kind, first_##kind, second_##kind, alone_##kind,                         \
            footpoint_##kind##_gradients_n                                                                             \
    }
    KIND(tri3), KIND(tri6), KIND(quad4), KIND(quad8), KIND(quad9)};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* ---- faces ---- */

/* Draws a face and a slave node with its foot point near loc. `wild` scales the motion of nodes and the distance of the
 * slave node. */
static void draw(gsl_rng *stream, const struct exact_face *f, double wild, double (*x)[3], double loc[2])
{
    const int triangle = f->nodes % 3 == 0 && f->nodes < 9;
    quadruple at[C], r[3], normal[3];
    for (int k = 0; k < f->nodes; k++)
        for (int i = 0; i < 3; i++)
            x[k][i] = (i < 2 ? f->place[k][i] : 0) + wild * (2 * gsl_rng_uniform(stream) - 1);
    const double u = gsl_rng_uniform(stream), v = gsl_rng_uniform(stream);
    loc[0] = triangle ? u : 2.2 * u - 1.1;
    loc[1] = triangle ? (1 - u) * v : 2.2 * v - 1.1;
    for (int i = 0; i < 3 * f->nodes; i++)
        at[i] = x[i / 3][i % 3];
    exact_point(f, at, loc[0], loc[1], r, normal);
    const double gap = 2 * wild * (2 * gsl_rng_uniform(stream) - 1);
    for (int i = 0; i < 3; i++)
        x[f->nodes][i] = (double)(r[i] + gap * normal[i]);
}

static int coordinates(const struct kind *k)
{
    return 3 * (k->nodes + 1);
}

/* Returns element (r, c) of the Hessian. */
static double hessian_at(const struct given *g, int r, int c)
{
    return r < c ? hessian_at(g, c, r) : g->hessian[r * (r + 1) / 2 + c];
}

/* ---- differences ---- */

static void expect_near(const struct kind *k, const char *what, int element, double value, double truth, double scale)
{
    if (!(fabs(value - truth) <= NEAR * scale)) {
        print_error("%s %s %d: %.17g, not %.17g, of %g\n", k->name, what, element, value, truth, scale);
        fail();
    }
}

struct slopes {
    double xi[C], eta[C], gap[C], normal[3][C], force[C][C]; /* force: of the derivatives of the gap */
};

/* Computes central differences by all coordinates; returns false if a foot point gets lost: those on both sides must be
 * about equally far from the known foot point. */
static bool differences(const struct kind *k, const struct exact_face *f, quadruple *x, const struct exact_foot *foot,
                        struct slopes *s)
{
    const int n = coordinates(k);
    for (int c = 0; c < n; c++) {
        const quadruple here = x[c];
        struct exact_foot to[2];
        x[c] = here + STEP;
        if (!exact_foot_beside(f, x, foot->xi, foot->eta, foot, &to[0]))
            return false;
        x[c] = here - STEP;
        if (!exact_foot_beside(f, x, 2 * foot->xi - to[0].xi, 2 * foot->eta - to[0].eta, foot, &to[1]))
            return false;
        x[c] = here;
        s->xi[c] = (double)(to[0].xi - to[1].xi) / (2 * STEP);
        s->eta[c] = (double)(to[0].eta - to[1].eta) / (2 * STEP);
        s->gap[c] = (double)(to[0].gap - to[1].gap) / (2 * STEP);
        for (int i = 0; i < 3; i++)
            s->normal[i][c] = (double)(to[0].normal[i] - to[1].normal[i]) / (2 * STEP);
        for (int r = 0; r < n; r++) { /* -phi n, and n for the slave node */
            const int node = r / 3, i = r % 3;
            s->force[r][c] =
                node == k->nodes
                    ? s->normal[i][c]
                    : (double)(to[1].phi[node] * to[1].normal[i] - to[0].phi[node] * to[0].normal[i]) / (2 * STEP);
        }
    }
    return true;
}

static double greatest(const double *x, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

static void compare(const struct kind *k, const struct given *g, const struct exact_foot *foot, const struct slopes *s)
{
    const int n = coordinates(k);
    double most = 1;
    expect_near(k, "gap", 0, g->gap, (double)foot->gap, 1);
    for (int i = 0; i < 3; i++)
        expect_near(k, "normal", i, g->normal[i], (double)foot->normal[i], 1);
    for (int i = 0; i < k->nodes; i++)
        expect_near(k, "phi", i, g->phi[i], (double)foot->phi[i], 1);
    for (int c = 0; c < n; c++) {
        expect_near(k, "d_xi", c, g->d_xi[c], s->xi[c], greatest(s->xi, n));
        expect_near(k, "d_eta", c, g->d_eta[c], s->eta[c], greatest(s->eta, n));
        expect_near(k, "d_gap", c, g->d_gap[c], s->gap[c], 1);
        most = fmax(most, greatest(s->force[c], n));
    }
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < n; c++)
            expect_near(k, "d_normal", n * i + c, g->d_normal[n * i + c], s->normal[i][c], most);
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++)
            expect_near(k, "hessian", n * r + c, hessian_at(g, r, c), s->force[r][c], most);
}

/* ---- identities ---- */

/* Checks that the sum of a row's elements over all nodes, and of their moments about the origin, is 0. */
static void expect_balance(const struct kind *k, const double *row, double (*x)[3])
{
    for (int i = 0; i < 3; i++) {
        double sum = 0, moment = 0, sums = 0, moments = 0;
        for (int node = 0; node <= k->nodes; node++) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            const double a = x[node][j] * row[3 * node + l], b = x[node][l] * row[3 * node + j];
            sum += row[3 * node + i];
            sums += fabs(row[3 * node + i]);
            moment += a - b;
            moments += fabs(a) + fabs(b);
        }
        if (!(fabs(sum) <= IDENTITY * sums && fabs(moment) <= CONDITIONED * IDENTITY * moments)) {
            print_error("%s: sum %g of %g, moment %g of %g\n", k->name, sum, sums, moment, moments);
            fail();
        }
    }
}

static void expect_identities(const struct kind *k, const struct given *g, double (*x)[3])
{
    const int n = coordinates(k);
    expect_balance(k, g->d_xi, x);
    expect_balance(k, g->d_eta, x);
    expect_balance(k, g->d_gap, x);
    for (int r = 0; r < n; r++) { /* for the Hessian only the sums, because a rotation turns forces, too */
        for (int i = 0; i < 3; i++) {
            double sum = 0, sums = 0;
            for (int node = 0; node <= k->nodes; node++) {
                sum += hessian_at(g, r, 3 * node + i);
                sums += fabs(hessian_at(g, r, 3 * node + i));
            }
            assert_true(fabs(sum) <= CONDITIONED * IDENTITY * (1 + sums));
        }
        for (int i = 0; i < 3 && r == 0; i++)
            for (int c = 0; c < n; c++) /* n is the derivative by the slave node */
                assert_true(fabs(g->d_normal[n * i + c] - hessian_at(g, 3 * k->nodes + i, c)) <=
                            CONDITIONED * IDENTITY * (1 + fabs(g->d_normal[n * i + c])));
    }
    for (int i = 0; i < 3; i++) {
        assert_true(fabs(g->d_gap[3 * k->nodes + i] - g->normal[i]) <= 1e-14);
        for (int node = 0; node < k->nodes; node++)
            assert_true(fabs(g->d_gap[3 * node + i] + g->phi[node] * g->normal[i]) <= 1e-14);
    }
}

static void derivatives_are_right(void **state)
{
    const long samples = long_cases(SAMPLES, SAMPLES_LONG);
    (void)state;
    gsl_rng *stream = stream_new();
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        const struct exact_face f = exact_face_of(k->nodes);
        long judged = 0;
        for (long sample = 0; sample < samples; sample++) {
            double x[MOST_NODES + 1][3], loc[2];
            quadruple y[C];
            struct exact_foot foot;
            static struct slopes slopes;
            static struct given g;
            stream_key(stream, 20241, (uint64_t)k->nodes, (uint64_t)sample, 0);
            draw(stream, &f, sample % 2 ? 0.1 : 0.25, x, loc);
            for (int i = 0; i < coordinates(k); i++)
                y[i] = x[i / 3][i % 3];
            if (!exact_foot_near(&f, y, loc[0], loc[1], &foot) || foot.condition > CONDITIONED ||
                !differences(k, &f, y, &foot, &slopes))
                continue;
            loc[0] = (double)foot.xi;
            loc[1] = (double)foot.eta;
            assert_int_equal(k->first(x, loc, &g), FOOTPOINT_OK);
            const struct given first = g;
            assert_int_equal(k->place(x, loc, &g), FOOTPOINT_OK);
            assert_true(fabs(g.gap - first.gap) <= 1e-13);
            for (int i = 0; i < 3; i++)
                assert_true(fabs(g.r_xi[i] - first.r_xi[i]) + fabs(g.r_eta[i] - first.r_eta[i]) +
                                fabs(g.normal[i] - first.normal[i]) <=
                            1e-13);
            for (int i = 0; i < k->nodes; i++)
                assert_true(fabs(g.phi[i] - first.phi[i]) <= 1e-13);
            assert_int_equal(k->second(x, loc, &g), FOOTPOINT_OK);
            compare(k, &g, &foot, &slopes);
            expect_identities(k, &g, x);
            for (int c = 0; c < coordinates(k); c++) {
                expect_near(k, "first d_xi", c, first.d_xi[c], g.d_xi[c], 1 + greatest(g.d_xi, coordinates(k)));
                expect_near(k, "first d_eta", c, first.d_eta[c], g.d_eta[c], 1 + greatest(g.d_eta, coordinates(k)));
                expect_near(k, "first d_gap", c, first.d_gap[c], g.d_gap[c], 1);
            }
            judged++;
        }
        print_message("%s: %ld of %ld\n", k->name, judged, samples);
        assert_true(judged > samples / 2);
    }
    gsl_rng_free(stream);
}

/* ---- statuses ---- */

static void fill(double *x, size_t bytes)
{
    for (size_t i = 0; i < bytes / sizeof *x; i++)
        x[i] = UNTOUCHED;
}

static void expect_status_of(const struct kind *k, double (*x)[3], const double loc[2], int expected, bool flat)
{
    place_function *const function[] = {k->first, k->second, k->place};
    for (int i = 0; i < 3; i++) {
        if (function[i] == k->place && expected == FOOTPOINT_ERR_DEGENERATE && !flat)
            continue; /* it needs no Hessian */
        static struct given g;
        fill((double *)&g, sizeof g);
        assert_int_equal(function[i](x, loc, &g), expected);
        const double *all = (const double *)&g;
        for (size_t j = 0; j < sizeof g / sizeof *all && expected != FOOTPOINT_OK; j++)
            assert_true(all[j] == UNTOUCHED);
    }
}

static void expect_status(const struct kind *k, double (*x)[3], const double loc[2], int expected)
{
    expect_status_of(k, x, loc, expected, false);
}

static void statuses_are_right(void **state)
{
    (void)state;
    gsl_rng *stream = stream_new();
    stream_key(stream, 20242, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        const struct exact_face f = exact_face_of(k->nodes);
        for (int c = 0; c < coordinates(k) + 2; c++) {
            double x[MOST_NODES + 1][3], loc[2];
            draw(stream, &f, 0.1, x, loc);
            expect_status(k, x, loc, FOOTPOINT_OK);
            *(c < 2 ? &loc[c] : &x[(c - 2) / 3][(c - 2) % 3]) = c % 2 ? (double)NAN : -(double)INFINITY;
            expect_status(k, x, loc, FOOTPOINT_ERR_NOT_FINITE);
        }
        /* all nodes on a line; then z = xi eta with the slave node in its centre of curvature, where the Hessian is
         * singular */
        double x[MOST_NODES + 1][3] = {{0}}, loc[2] = {0, 0};
        for (int node = 0; node < k->nodes; node++)
            x[node][0] = x[node][1] = f.place[node][0] + 3 * f.place[node][1];
        expect_status(k, x, loc, FOOTPOINT_ERR_DEGENERATE);
        for (int node = 0; node < k->nodes; node++) {
            x[node][0] = f.place[node][0];
            x[node][1] = f.place[node][1];
            x[node][2] = f.place[node][0] * f.place[node][1];
        }
        x[k->nodes][2] = 1;
        expect_status(k, x, loc, k->nodes == 3 ? FOOTPOINT_OK : FOOTPOINT_ERR_DEGENERATE);
        x[k->nodes][2] = 0.5;
        expect_status(k, x, loc, FOOTPOINT_OK);
    }
    gsl_rng_free(stream);
}

/* Returns the slope by xi or eta (0 or 1) of the position along the line of a face whose nodes are on it. */
static quadruple slope_on_line(const struct exact_face *f, const quadruple *at, const double along[3],
                               const double loc[2], int variable)
{
    quadruple r[2][3], normal[3], slope = 0;
    for (int side = 0; side < 2; side++) {
        quadruple place[2] = {loc[0], loc[1]};
        place[variable] += side ? STEP : -STEP;
        exact_point(f, at, place[0], place[1], r[side], normal);
    }
    for (int i = 0; i < 3; i++)
        slope += (r[1][i] - r[0][i]) * along[i];
    return slope;
}

/* Nodes on a line up to rounding, in any order; and places at which one tangent vanishes, if they exist, where the face
 * turns back. Rounding leaves some area there. */
static void lines_have_no_normal(void **state)
{
    const long faces = long_cases(200, 2000);
    (void)state;
    gsl_rng *stream = stream_new();
    stream_key(stream, 20245, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        const struct exact_face f = exact_face_of(k->nodes);
        for (int face = 0; face < faces; face++) {
            double x[MOST_NODES + 1][3], loc[2], along[3], from[3];
            quadruple at[C];
            draw(stream, &f, 0.1, x, loc);
            for (int i = 0; i < 3; i++) {
                along[i] = gsl_rng_uniform(stream) - 0.5;
                from[i] = 2 * gsl_rng_uniform(stream) - 1;
            }
            for (int node = 0; node < k->nodes; node++) {
                const double t = 2 * gsl_rng_uniform(stream) - 1;
                for (int i = 0; i < 3; i++)
                    at[3 * node + i] = x[node][i] = from[i] + t * along[i];
            }
            const int variable = face % 2;
            double end[2][2] = {{loc[0], loc[1]}, {loc[0], loc[1]}};
            end[0][variable] = -1.5;
            end[1][variable] = 1.5;
            const int rises = slope_on_line(&f, at, along, end[1], variable) > 0;
            for (int halves = 0; halves < 60; halves++) {
                loc[variable] = 0.5 * (end[0][variable] + end[1][variable]);
                end[(slope_on_line(&f, at, along, loc, variable) > 0) == rises][variable] = loc[variable];
            }
            expect_status_of(k, x, loc, FOOTPOINT_ERR_DEGENERATE, true);
        }
    }
    gsl_rng_free(stream);
}

/* The same at places up to 1e9 away, where a tangent is a sum of large terms that cancel. */
static void lines_have_no_normal_far_away(void **state)
{
    const long faces = long_cases(100, 1000);
    (void)state;
    gsl_rng *stream = stream_new();
    stream_key(stream, 20246, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        const struct exact_face f = exact_face_of(k->nodes);
        for (int face = 0; face < faces; face++) {
            double x[MOST_NODES + 1][3], loc[2], along[3], from[3], low = -1e9, high = 1e9;
            quadruple at[C];
            draw(stream, &f, 0.1, x, loc);
            for (int i = 0; i < 3; i++) {
                along[i] = gsl_rng_uniform(stream) - 0.5;
                from[i] = 2 * gsl_rng_uniform(stream) - 1;
            }
            for (int node = 0; node < k->nodes; node++) {
                const double t = 2 * gsl_rng_uniform(stream) - 1;
                for (int i = 0; i < 3; i++)
                    at[3 * node + i] = x[node][i] = from[i] + t * along[i];
            }
            const int slope = face % 2, variable = face / 2 % 2;
            loc[!variable] = (face % 3 ? 1 : -1) * pow(10, 9 * gsl_rng_uniform(stream));
            loc[variable] = high;
            const int rises = slope_on_line(&f, at, along, loc, slope) > 0;
            for (int halves = 0; halves < 100; halves++) {
                loc[variable] = 0.5 * (low + high);
                *((slope_on_line(&f, at, along, loc, slope) > 0) == rises ? &high : &low) = loc[variable];
            }
            expect_status_of(k, x, loc, FOOTPOINT_ERR_DEGENERATE, true);
        }
    }
    gsl_rng_free(stream);
}

/* Faces and slave nodes of sizes from 1e-300 to 1e300, places up to 1e300 away: all rows are finite, or no row is
 * written. */
static void rows_are_finite_or_untouched(void **state)
{
    const long samples = long_cases(3000, 100000);
    (void)state;
    gsl_rng *stream = stream_new();
    stream_key(stream, 20247, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        const struct exact_face f = exact_face_of(k->nodes);
        place_function *const function[] = {k->place, k->first, k->second};
        for (int sample = 0; sample < samples; sample++) {
            double x[MOST_NODES + 1][3], loc[2];
            draw(stream, &f, 0.2, x, loc);
            const double size = sample % 2 ? pow(10, 600 * gsl_rng_uniform(stream) - 300) : 1;
            const double away = sample % 3 ? size : pow(10, 600 * gsl_rng_uniform(stream) - 300);
            for (int i = 0; i < coordinates(k); i++)
                x[i / 3][i % 3] *= i < 3 * k->nodes ? size : away;
            for (int i = 0; i < 2 && sample % 5; i++)
                loc[i] *= pow(10, (sample % 5 < 3 ? 6 : 300) * gsl_rng_uniform(stream));
            for (int i = 0; i < 3; i++) {
                static struct given g;
                fill((double *)&g, sizeof g);
                const int status = function[i](x, loc, &g);
                const double *all = (const double *)&g;
                for (size_t j = 0; j < sizeof g / sizeof *all; j++)
                    assert_true(status == FOOTPOINT_OK ? isfinite(all[j]) : all[j] == UNTOUCHED);
            }
        }
    }
    gsl_rng_free(stream);
}

/* A single Hessian is the same, and in another unit of length all rows change by their power of lengths. */
static void rows_and_sizes(void **state)
{
    (void)state;
    gsl_rng *stream = stream_new();
    stream_key(stream, 20243, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        const struct exact_face f = exact_face_of(k->nodes);
        const int n = coordinates(k);
        static struct given g, alone, scaled;
        double x[MOST_NODES + 1][3], y[MOST_NODES + 1][3], loc[2];
        draw(stream, &f, 0.1, x, loc);
        assert_int_equal(k->second(x, loc, &g), FOOTPOINT_OK);
        assert_int_equal(k->alone(x, loc, &alone), FOOTPOINT_OK);
        for (int i = 0; i < n * (n + 1) / 2; i++)
            assert_true(fabs(alone.hessian[i] - g.hessian[i]) <= 1e-12 * (1 + fabs(g.hessian[i])));
        for (int power = -900; power <= 900; power += 150) {
            for (int i = 0; i < n; i++)
                y[i / 3][i % 3] = ldexp(x[i / 3][i % 3], power);
            assert_int_equal(k->second(y, loc, &scaled), FOOTPOINT_OK);
            assert_true(fabs(ldexp(scaled.gap, -power) - g.gap) <= 1e-12);
            for (int i = 0; i < n; i++) {
                assert_true(fabs(ldexp(scaled.d_xi[i], power) - g.d_xi[i]) <= 1e-9 * (1 + fabs(g.d_xi[i])));
                assert_true(fabs(scaled.d_gap[i] - g.d_gap[i]) <= 1e-12);
            }
            for (int i = 0; i < n * (n + 1) / 2; i++)
                assert_true(fabs(ldexp(scaled.hessian[i], power) - g.hessian[i]) <= 1e-9 * (1 + fabs(g.hessian[i])));
        }
    }
    gsl_rng_free(stream);
}

/* Arrays equal single calls, with bad and very large pairs among them. */
static void arrays_are_the_same(void **state)
{
    (void)state;
    gsl_rng *stream = stream_new();
    stream_key(stream, 20244, 0, 0, 0);
    for (const struct kind *k = kinds; k < kinds + KINDS; k++) {
        const struct exact_face f = exact_face_of(k->nodes);
        const int n = coordinates(k);
        static double x[ROWS][MOST_NODES + 1][3], column[C][ROWS], xi[ROWS], eta[ROWS], gap[ROWS];
        static double rest[4][C * ROWS], d_xi[C * ROWS], d_eta[C * ROWS], d_gap[C * ROWS];
        const double *columns[C];
        int status[ROWS];
        for (int p = 0; p < ROWS; p++) {
            double loc[2];
            draw(stream, &f, 0.1, x[p], loc);
            xi[p] = loc[0];
            eta[p] = loc[1];
            for (int i = 0; i < n; i++)
                x[p][i / 3][i % 3] *= p % 8 == 3 ? 1e200 : 1;
            if (p % 8 == 5)
                x[p][p % k->nodes][p % 3] = (double)NAN;
            for (int i = 0; i < n; i++)
                column[i][p] = x[p][i / 3][i % 3];
        }
        for (int i = 0; i < n; i++)
            columns[i] = column[i];
        k->loop(ROWS, columns, xi, eta, rest[0], rest[1], rest[2], rest[3], gap, d_xi, d_eta, d_gap, status);
        for (int p = 0; p < ROWS; p++) {
            static struct given g;
            const double loc[2] = {xi[p], eta[p]};
            assert_int_equal(k->first(x[p], loc, &g), status[p]);
            assert_int_equal(status[p], p % 8 == 5 ? FOOTPOINT_ERR_NOT_FINITE : FOOTPOINT_OK);
            for (int i = 0; i < n && status[p] == FOOTPOINT_OK; i++) {
                assert_true(fabs(d_xi[i * ROWS + p] - g.d_xi[i]) <= 1e-9 * fabs(g.d_xi[i]) + 1e-220);
                assert_true(fabs(d_gap[i * ROWS + p] - g.d_gap[i]) <= 1e-12);
            }
        }
    }
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_are_right),        cmocka_unit_test(statuses_are_right),
        cmocka_unit_test(lines_have_no_normal),         cmocka_unit_test(rows_and_sizes),
        cmocka_unit_test(arrays_are_the_same),          cmocka_unit_test(lines_have_no_normal_far_away),
        cmocka_unit_test(rows_are_finite_or_untouched),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
