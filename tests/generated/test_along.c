/* Projection along a direction, footpoint_quad4_along and footpoint_tri3_along, against a solver that is certain and shares
 * no code with them: it halves the face, in the plane that the direction is normal to.  Over a box a bilinear function
 * lies between its values at the corners; where the Jacobian has one sign at the corners the box's image is a convex
 * quadrilateral, and holds the origin once or not at all.  Faces ordinary, tapered to triangles, folded and drawn at
 * random; 10,000 samples, 1e6 with FOOTPOINT_LONG. */
#include "../../evolve/common/stream.h"
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_tri3.h"
#include "../../runtime/footpoint.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 10000, SAMPLES_LONG = 1000000, ROWS = 64, MOST_ROOTS = 8 };
#define FINEST 1e-13L /* boxes that a solution is told by */
#define FOLD 1e-5L    /* boxes in which the Jacobian changes sign are not told apart below */
#define CLEAR 1e-7    /* of xi and eta: what lies on an edge, to rounding */

typedef long double real;

/* F = f[0] + xi f[1] + eta f[2] + xi eta f[3], r - xS in the plane. */
struct plane {
    real f[4][2];
};

struct roots {
    real at[MOST_ROOTS][2];
    int count, fold;
};

static real cross2(const real a[2], const real b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

static void value_at(const struct plane *p, real xi, real eta, real f[2])
{
    for (int k = 0; k < 2; k++)
        f[k] = p->f[0][k] + xi * p->f[1][k] + eta * (p->f[2][k] + xi * p->f[3][k]);
}

static real jacobian_at(const struct plane *p, real xi, real eta)
{
    const real u[2] = {p->f[1][0] + eta * p->f[3][0], p->f[1][1] + eta * p->f[3][1]};
    const real v[2] = {p->f[2][0] + xi * p->f[3][0], p->f[2][1] + xi * p->f[3][1]};
    return cross2(u, v);
}

static void add_root(struct roots *r, real xi, real eta)
{
    for (int k = 0; k < r->count; k++)
        if (fabsl(r->at[k][0] - xi) + fabsl(r->at[k][1] - eta) < 1e-9L)
            return;
    if (r->count < MOST_ROOTS) {
        r->at[r->count][0] = xi;
        r->at[r->count++][1] = eta;
    }
}

static void search_box(const struct plane *p, real xi, real eta, real half, struct roots *r)
{
    static const int corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    real f[4][2];
    int positive[2] = {0, 0}, negative[2] = {0, 0}, right = 0, left = 0, inside = 1;
    for (int c = 0; c < 4; c++) {
        const real u = xi + half * corner[c][0], v = eta + half * corner[c][1], j = jacobian_at(p, u, v);
        value_at(p, u, v, f[c]);
        right += j > 0;
        left += j < 0;
        for (int k = 0; k < 2; k++) {
            positive[k] += f[c][k] > 0;
            negative[k] += f[c][k] < 0;
        }
    }
    for (int k = 0; k < 2; k++)
        if (positive[k] == 4 || negative[k] == 4)
            return;
    if (right == 4 || left == 4) {
        for (int c = 0; c < 4; c++) {
            const real *const a = f[c], *const b = f[(c + 1) % 4], side = cross2(a, b);
            inside = inside && (right ? side >= 0 : side <= 0);
        }
        if (!inside)
            return;
    } else if (half < FOLD) {
        r->fold = 1;
        return;
    }
    if (half < FINEST) {
        add_root(r, xi, eta);
        return;
    }
    for (int c = 0; c < 4; c++)
        search_box(p, xi + half / 2 * corner[c][0], eta + half / 2 * corner[c][1], half / 2, r);
}

/* Two axes normal to the direction. */
static void axes_of(const double along[3], real e[2][3])
{
    real length = 0, along_e = 0;
    int least = 0;
    for (int i = 0; i < 3; i++) {
        length += (real)along[i] * along[i];
        least = fabs(along[i]) < fabs(along[least]) ? i : least;
    }
    for (int i = 0; i < 3; i++)
        e[0][i] = (i == least) - along[i] * (real)along[least] / length;
    for (int i = 0; i < 3; i++)
        along_e += e[0][i] * e[0][i];
    for (int i = 0; i < 3; i++)
        e[0][i] /= sqrtl(along_e);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        e[1][i] = (along[j] * e[0][k] - along[k] * e[0][j]) / sqrtl(length);
    }
}

/* Of corners x[0] to x[3], or of the triangle as a parallelogram, and the slave node behind them. */
static void plane_of(double (*x)[3], int corners, const double along[3], struct plane *p)
{
    real e[2][3];
    axes_of(along, e);
    memset(p, 0, sizeof *p);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            const real a = x[0][i], b = x[1][i], c = x[2][i], d = x[3][i], s = x[corners][i];
            const real quad[4] = {(a + b + c + d) / 4 - s, (b + c - a - d) / 4, (c + d - a - b) / 4,
                                  (a + c - b - d) / 4};
            const real flat[4] = {a - s, b - a, c - a, 0};
            for (int m = 0; m < 4; m++)
                p->f[m][k] += e[k][i] * (corners == 4 ? quad[m] : flat[m]);
        }
}

/* ---- samples ---- */

static void draw(gsl_rng *stream, int number, double x[5][3], double along[3])
{
    static const double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    static const double apart[4] = {0.15, 0.7, 1.2, 3};
    const double move = apart[number % 4], size = ldexp(1, (int)(41 * gsl_rng_uniform(stream)) - 20);
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++) {
            const double place = k < 4 && i < 2 ? square[k][i] : 0, drawn = 2 * gsl_rng_uniform(stream) - 1;
            x[k][i] = size * (place + drawn * (k == 4 ? 1.2 : i < 2 ? move : 0.5 * move));
        }
    if (number % 16 == 5) /* a triangle */
        memcpy(x[3], x[2], sizeof x[3]);
    for (int i = 0; i < 3; i++)
        along[i] = (i == 2) + (number % 8 < 4 ? 0.5 : 3) * (2 * gsl_rng_uniform(stream) - 1);
}

static double distance_at(double (*x)[3], int corners, const double along[3], const real at[2])
{
    real ahead = 0, length = 0;
    for (int i = 0; i < 3; i++) {
        const real s = at[0], t = at[1], a = x[0][i], b = x[1][i], c = x[2][i], d = x[3][i];
        const real r =
            corners == 4
                ? ((1 - s) * (1 - t) * a + (1 + s) * (1 - t) * b + (1 + s) * (1 + t) * c + (1 - s) * (1 + t) * d) / 4
                : (1 - s - t) * a + s * b + t * c;
        ahead += (x[corners][i] - r) * along[i];
        length += (real)along[i] * along[i];
    }
    return (double)(ahead / sqrtl(length));
}

static int is_in_face(int corners, const real at[2], double margin)
{
    if (corners == 4)
        return fabsl(at[0]) <= 1 + margin && fabsl(at[1]) <= 1 + margin;
    return at[0] >= -margin && at[1] >= -margin && at[0] + at[1] <= 1 + margin;
}

struct tally {
    long answers, outside, twice, none, unclear;
    double worst;
};

/* Whether an answer and its status are right; *clear: whether rounding lets that be told. */
static int is_right(double (*x)[3], int corners, const double along[3], int status, const double loc[2], double dist,
                    struct tally *t)
{
    struct plane p;
    struct roots face = {0}, wide = {0};
    int inside = 0, at_edge = 0, best = -1, match = -1;
    double size = 0, least = INFINITY;
    plane_of(x, corners, along, &p);
    search_box(&p, corners == 4 ? 0 : 0.5L, corners == 4 ? 0 : 0.5L, corners == 4 ? 1.01L : 0.51L, &face);
    for (int k = 0; k < corners; k++)
        for (int i = 0; i < 3; i++)
            size = fmax(size, fabs(x[k][i] - x[corners][i]));
    if (face.fold) {
        t->unclear++;
        return 1;
    }
    for (int k = 0; k < face.count; k++) {
        const int in = is_in_face(corners, face.at[k], 0), strictly = is_in_face(corners, face.at[k], -CLEAR);
        at_edge += is_in_face(corners, face.at[k], CLEAR) && !strictly;
        inside += in;
        const double d = fabs(distance_at(x, corners, along, face.at[k]));
        if (in && d < least) {
            least = d;
            best = k;
        }
        if (status >= 0 && fabs((double)face.at[k][0] - loc[0]) + fabs((double)face.at[k][1] - loc[1]) < 1e-6)
            match = k;
    }
    if (at_edge) {
        t->unclear++;
        return 1;
    }
    t->answers += inside == 1;
    t->twice += inside == 2;
    t->outside += status == FOOTPOINT_OUTSIDE;
    t->none += status == FOOTPOINT_ERR_DOMAIN;
    if (inside == 0 && status == FOOTPOINT_OUTSIDE) { /* a solution all the same */
        real f[2];
        value_at(&p, loc[0], loc[1], f);
        const double reach = 1 + fabs(loc[0]) * fabs(loc[1]) + fabs(loc[0]) + fabs(loc[1]);
        return (double)(fabsl(f[0]) + fabsl(f[1])) <= 1e-9 * size * reach;
    }
    if (inside == 0) {
        search_box(&p, 0, 0, 6, &wide);
        if (wide.fold)
            t->unclear++;
        return status == FOOTPOINT_ERR_DOMAIN && (wide.count == 0 || wide.fold);
    }
    if (status != (inside == 2 ? FOOTPOINT_NOT_UNIQUE : FOOTPOINT_OK) || match < 0)
        return 0;
    const double d = distance_at(x, corners, along, face.at[match]);
    t->worst = fmax(t->worst, fabs(d - dist) / size);
    return fabs(d - dist) <= 1e-9 * size && (match == best || fabs(fabs(d) - least) < 1e-9 * size);
}

static void compare(int corners, long samples)
{
    struct tally t = {0};
    gsl_rng *stream = stream_new();
    stream_key(stream, 20119, 0, 0, 0);
    long wrong = 0;
    for (long n = 0; n < samples; n++) {
        double x[5][3], along[3], loc[2] = {7, 7}, dist = 7;
        draw(stream, (int)(n % 16), x, along);
        if (corners == 3)
            memcpy(x[3], x[4], sizeof x[3]);
        const int status = corners == 4 ? footpoint_quad4_along(x[0], x[1], x[2], x[3], x[4], along, loc, &dist)
                                        : footpoint_tri3_along(x[0], x[1], x[2], x[3], along, loc, &dist);
        if (is_right(x, corners, along, status, loc, dist, &t) && (status >= FOOTPOINT_OK || dist == 7))
            continue;
        if (wrong++ < 10)
            printf("# %d corners, sample %ld: status %d, %.17g %.17g, %.17g\n", corners, n, status, loc[0], loc[1],
                   dist);
    }
    printf("# %d corners: %ld of %ld wrong; %ld in the face, %ld twice, %ld beside it, %ld nowhere; %ld at an edge or "
           "fold; distance off by %.1e\n",
           corners, wrong, samples, t.answers, t.twice, t.outside, t.none, t.unclear, t.worst);
    gsl_rng_free(stream);
    assert_int_equal(wrong, 0);
    assert_true(t.unclear < samples / 50 && t.answers > samples / 5 && t.outside > samples / 20);
    assert_true(corners == 3 || (t.twice > samples / 500 && t.none > samples / 500));
}

static long samples(void)
{
    return getenv("FOOTPOINT_LONG") ? SAMPLES_LONG : SAMPLES;
}

static void quad4_is_right(void **state)
{
    (void)state;
    compare(4, samples());
}

static void tri3_is_right(void **state)
{
    (void)state;
    compare(3, samples());
}

/* What is not finite, without area, or along the face; and that arrays are answered as one. */
static void statuses_are_right(void **state)
{
    (void)state;
    static double x[ROWS][5][3], along[ROWS][3], column[15][ROWS], q[3][ROWS];
    const double *columns[15], *const directions[3] = {q[0], q[1], q[2]};
    double xi[ROWS], eta[ROWS], dist[ROWS];
    int status[ROWS];
    gsl_rng *stream = stream_new();
    stream_key(stream, 20120, 0, 0, 0);
    for (int n = 0; n < ROWS; n++) {
        draw(stream, n % 16, x[n], along[n]);
        if (n % 8 == 1)
            x[n][n % 5][n % 3] = n % 16 == 1 ? NAN : -INFINITY;
        if (n % 8 == 2)
            along[n][n % 3] = n % 16 == 2 ? NAN : INFINITY;
        for (int i = 0; i < 3; i++) {
            if (n % 8 == 3)
                along[n][i] = 0;
            for (int k = 0; k < 4 && n % 8 == 4; k++)
                x[n][k][i] = k * (i + 1);
            if (n % 8 == 5) /* a plane and a direction in it */
                along[n][i] = x[n][1][i] - x[n][0][i], x[n][3][i] = x[n][0][i] + x[n][2][i] - x[n][1][i];
        }
        for (int k = 0; k < 15; k++)
            column[k][n] = x[n][k / 3][k % 3];
        for (int i = 0; i < 3; i++)
            q[i][n] = along[n][i];
    }
    gsl_rng_free(stream);
    for (int k = 0; k < 15; k++)
        columns[k] = column[k];
    footpoint_quad4_along_n(ROWS, columns, directions, xi, eta, dist, status);
    for (int n = 0; n < ROWS; n++) {
        double loc[2] = {7, 7}, d = 7;
        const int one = footpoint_quad4_along(x[n][0], x[n][1], x[n][2], x[n][3], x[n][4], along[n], loc, &d);
        assert_int_equal(one, status[n]);
        if (n % 8 >= 1 && n % 8 <= 5)
            assert_int_equal(one, n % 8 <= 2 ? FOOTPOINT_ERR_NOT_FINITE : FOOTPOINT_ERR_DEGENERATE);
        if (one < FOOTPOINT_OK)
            assert_true(loc[0] == 7 && loc[1] == 7 && d == 7);
        else
            assert_true(fabs(loc[0] - xi[n]) + fabs(loc[1] - eta[n]) <= 1e-9 * (1 + fabs(xi[n]) + fabs(eta[n])) &&
                        fabs(d - dist[n]) <= 1e-9 * fabs(d));
    }
}

/* The same bits in any unit of length, and of any length of the direction. */
static void size_does_not_matter(void **state)
{
    (void)state;
    gsl_rng *stream = stream_new();
    stream_key(stream, 20121, 0, 0, 0);
    for (int n = 0; n < ROWS; n++) {
        double x[5][3], along[3], loc[2] = {7, 7}, d = 7;
        draw(stream, n % 16, x, along);
        const int usual = footpoint_quad4_along(x[0], x[1], x[2], x[3], x[4], along, loc, &d);
        for (int power = -900; power <= 900; power += 150) {
            double y[5][3], q[3], l[2] = {7, 7}, g = 7;
            for (int k = 0; k < 15; k++)
                y[k / 3][k % 3] = ldexp(x[k / 3][k % 3], power);
            for (int i = 0; i < 3; i++)
                q[i] = ldexp(along[i], -power);
            const int status = footpoint_quad4_along(y[0], y[1], y[2], y[3], y[4], q, l, &g);
            assert_int_equal(status, usual);
            if (status >= FOOTPOINT_OK)
                assert_true(fabs(l[0] - loc[0]) + fabs(l[1] - loc[1]) <= 1e-9 * (1 + fabs(l[0]) + fabs(l[1])) &&
                            fabs(ldexp(g, -power) - d) <= 1e-9 * fabs(d));
        }
    }
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quad4_is_right),
        cmocka_unit_test(tri3_is_right),
        cmocka_unit_test(statuses_are_right),
        cmocka_unit_test(size_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
