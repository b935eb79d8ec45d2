/* The certain foot point on a segment r = sum of phi_k x_k whose shape functions are polynomials of degree up to 2 in
 * xi and in eta. Half the squared distance, D = |xs - r|^2 / 2, is a polynomial of degree 4 in each. Its Bernstein
 * coefficients on a box bound D; their differences bound its derivatives. A box contains no stationary point if D_xi or
 * D_eta does not vanish on it, at most one minimum if the Hessian is positive definite on it, and no minimum if the
 * Hessian is positive definite nowhere. Any other box is halved. In a convex box, Newton's iteration in long double
 * finds the minimum, if any. If undecided boxes become as small as rounding, there is no answer. (Lane and Riesenfeld,
 * "Bounds on a polynomial", BIT 21, 1981; bisection with convexity: Hansen, Global Optimization Using Interval
 * Analysis, 1992.) Coordinates are first taken relative to node A and divided by the size of the segment. */
#include "../common/vec3.h"
#include "surface.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { DEGREE = 4, SIDE = DEGREE + 1, DEPTH_MAX = 45, BOXES_MAX = 4000, BOXES_NEAR = 40 };
#define BOUND 1e-12    /* rounding of a coordinate at the bound of a box */
#define WIDER 1e-6     /* how far the search box extends beyond the bounds */
#define CONVERGED 1e-6 /* how far outside its box a minimum may be found if the box is convex with some slack */
#define SLACK 0.99
#define MARGIN 5e-14 /* rounding, in units of the largest of all Bernstein coefficients */

/* v = xs - r as a polynomial: coefficient [i][j] of xi^i eta^j; in units of `size`. */
struct local {
    long double v[3][3][3], size;
};

struct box {
    double lo[2], hi[2], d[SIDE][SIDE];
    int depth;
};

struct subdivision {
    const struct local *local;
    double lo[2], hi[2];
    bool triangle, found, lost;
    long double at[2], least; /* the nearest minimum, and D there */
    double margin;
    int boxes, most;
};

/* ---- the segment ---- */

/* Replaces the values at -1, 0, 1 of a polynomial of degree 2, `step` apart, by its coefficients. */
static void parabola(long double *c, int step)
{
    const long double low = c[0], high = c[2 * step];
    c[0] = c[step];
    c[step] = (high - low) / 2;
    c[2 * step] = (high + low) / 2 - c[0];
}

/* Computes xs - r at nine points, then its coefficients. */
static bool localise(const struct surface *f, const struct sample *s, struct local *l)
{
    double phi[6 * SEGMENT_VECTORS];
    l->size = 0;
    for (size_t n = 1; n < f->nodes; n++)
        for (int k = 0; k < 3; k++)
            l->size = fmaxl(l->size, fabsl((long double)s->x[n][k] - s->x[0][k]));
    for (int i = 0; i < 9; i++) {
        f->shape(i / 3 - 1, i % 3 - 1, phi);
        for (int k = 0; k < 3; k++) {
            long double v = (long double)s->xs[k] - s->x[0][k];
            for (size_t n = 1; n < f->nodes; n++)
                v -= phi[n] * ((long double)s->x[n][k] - s->x[0][k]);
            l->v[k][i / 3][i % 3] = v / l->size;
        }
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            parabola(l->v[k][i], 1);
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            parabola(&l->v[k][0][j], 3);
    const long double sum = l->v[0][0][0] + l->v[1][0][0] + l->v[2][0][0];
    return l->size > 0 && isfinite(l->size) && isfinite(sum);
}

/* Computes v, v_xi, v_eta, v_xixi, v_xieta, v_etaeta. */
static void evaluate(const struct local *l, long double xi, long double eta, long double v[6][3])
{
    for (int k = 0; k < 3; k++) {
        long double a[3], by_eta[3];
        for (int i = 0; i < 3; i++) {
            const long double *c = l->v[k][i];
            a[i] = c[0] + eta * (c[1] + eta * c[2]);
            by_eta[i] = c[1] + 2 * eta * c[2];
        }
        v[0][k] = a[0] + xi * (a[1] + xi * a[2]);
        v[1][k] = a[1] + 2 * xi * a[2];
        v[2][k] = by_eta[0] + xi * (by_eta[1] + xi * by_eta[2]);
        v[3][k] = 2 * a[2];
        v[4][k] = by_eta[1] + 2 * xi * by_eta[2];
        v[5][k] = 2 * (l->v[k][0][2] + xi * (l->v[k][1][2] + xi * l->v[k][2][2]));
    }
}

/* ---- boxes ---- */

/* Converts powers of t in 0..1 to Bernstein coefficients, both of degree 4, `step` apart. */
static void to_bernstein(long double *c, int step)
{
    static const long double binomial[SIDE][SIDE] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    long double b[SIDE] = {0};
    for (int i = 0; i < SIDE; i++)
        for (int k = 0; k <= i; k++)
            b[i] += binomial[i][k] / binomial[DEGREE][k] * c[k * step];
    for (int i = 0; i < SIDE; i++)
        c[i * step] = b[i];
}

static struct box whole_box(struct subdivision *s)
{
    struct box b = {.depth = 0};
    long double v[3][3][3], d[SIDE][SIDE] = {{0}};
    memcpy(v, s->local->v, sizeof v);
    for (int k = 0; k < 2; k++) {
        b.lo[k] = s->lo[k] - WIDER;
        b.hi[k] = s->hi[k] + WIDER;
    }
    const long double w = b.hi[0] - b.lo[0], h = b.hi[1] - b.lo[1], x = b.lo[0], y = b.lo[1];
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j < 3; j++) { /* xi = x + w t */
            v[k][0][j] += x * (v[k][1][j] + x * v[k][2][j]);
            v[k][1][j] = w * (v[k][1][j] + 2 * x * v[k][2][j]);
            v[k][2][j] *= w * w;
        }
        for (int i = 0; i < 3; i++) {
            v[k][i][0] += y * (v[k][i][1] + y * v[k][i][2]);
            v[k][i][1] = h * (v[k][i][1] + 2 * y * v[k][i][2]);
            v[k][i][2] *= h * h;
        }
        for (int i = 0; i < 9; i++)
            for (int j = 0; j < 9; j++)
                d[i / 3 + j / 3][i % 3 + j % 3] += v[k][i / 3][i % 3] * v[k][j / 3][j % 3] / 2;
    }
    for (int i = 0; i < SIDE; i++)
        to_bernstein(&d[0][i], SIDE);
    for (int i = 0; i < SIDE; i++)
        to_bernstein(d[i], 1);
    for (int i = 0; i < SIDE * SIDE; i++) {
        b.d[i / SIDE][i % SIDE] = (double)d[i / SIDE][i % SIDE];
        s->margin = fmax(s->margin, MARGIN * fabs(b.d[i / SIDE][i % SIDE]));
    }
    return b;
}

/* Halves a row of coefficients (de Casteljau), `step` apart. */
static void halve_row(const double *c, double *first, double *second, int step)
{
    double t[SIDE];
    for (int i = 0; i < SIDE; i++)
        t[i] = c[i * step];
    for (int i = 0; i < SIDE; i++) {
        first[i * step] = t[0];
        second[(DEGREE - i) * step] = t[DEGREE - i];
        for (int k = 0; k < DEGREE - i; k++)
            t[k] = (t[k] + t[k + 1]) / 2;
    }
}

/* Halves a box across its longer direction. */
static void halve(const struct box *b, struct box half[2])
{
    const int along = b->hi[1] - b->lo[1] > b->hi[0] - b->lo[0];
    half[0] = half[1] = *b;
    half[0].depth = half[1].depth = b->depth + 1;
    half[0].hi[along] = half[1].lo[along] = (b->lo[along] + b->hi[along]) / 2;
    for (int i = 0; i < SIDE; i++)
        if (along)
            halve_row(b->d[i], half[0].d[i], half[1].d[i], 1);
        else
            halve_row(&b->d[0][i], &half[0].d[0][i], &half[1].d[0][i], SIDE);
}

struct range {
    double lo, hi;
};

/* Returns the range of the derivative of order (m, n) of D on the box, up to a factor. */
static struct range range_of(const struct box *b, int m, int n)
{
    struct range r = {INFINITY, -INFINITY};
    double c[SIDE][SIDE];
    memcpy(c, b->d, sizeof c);
    for (int k = 0; k < m; k++)
        for (int i = 0; i < DEGREE - k; i++)
            for (int j = 0; j < SIDE; j++)
                c[i][j] = c[i + 1][j] - c[i][j];
    for (int k = 0; k < n; k++)
        for (int i = 0; i < SIDE - m; i++)
            for (int j = 0; j < DEGREE - k; j++)
                c[i][j] = c[i][j + 1] - c[i][j];
    for (int i = 0; i < SIDE - m; i++)
        for (int j = 0; j < SIDE - n; j++) {
            r.lo = c[i][j] < r.lo ? c[i][j] : r.lo;
            r.hi = c[i][j] > r.hi ? c[i][j] : r.hi;
        }
    return r;
}

enum verdict { NO_MINIMUM, CONVEX, UNSETTLED };

static enum verdict verdict_of(const struct subdivision *s, const struct box *b)
{
    const struct range d = range_of(b, 0, 0), x = range_of(b, 1, 0), y = range_of(b, 0, 1);
    const double margin = s->margin, factor = DEGREE - 1; /* D_xixi is 12 times its differences, D_xieta 16 times */
    if (d.lo - margin > (double)s->least || x.lo > margin || x.hi < -margin || y.lo > margin || y.hi < -margin)
        return NO_MINIMUM;
    const struct range xx = range_of(b, 2, 0), yy = range_of(b, 0, 2), xy = range_of(b, 1, 1);
    const double most = fmax(fabs(xy.lo), fabs(xy.hi)) + margin, least = fmax(xy.lo, -xy.hi) - margin;
    const double largest = factor * factor * (xx.hi + margin) * (yy.hi + margin);
    if (xx.hi < -margin || yy.hi < -margin || (least > 0 && largest < DEGREE * DEGREE * least * least))
        return NO_MINIMUM;
    const bool convex = xx.lo > margin && yy.lo > margin &&
                        SLACK * factor * factor * (xx.lo - margin) * (yy.lo - margin) > DEGREE * DEGREE * most * most;
    return convex ? CONVEX : UNSETTLED;
}

/* ---- minima ---- */

/* Iterates Newton's method from *at; returns false if it does not converge to a minimum. */
static bool newton(const struct local *l, long double at[2])
{
    long double last = INFINITY;
    for (int i = 0; i < 60; i++) {
        long double v[6][3];
        evaluate(l, at[0], at[1], v);
        const long double f1 = long_dot(v[0], v[1]), f2 = long_dot(v[0], v[2]);
        const long double h11 = long_dot(v[1], v[1]) + long_dot(v[0], v[3]),
                          h22 = long_dot(v[2], v[2]) + long_dot(v[0], v[5]);
        const long double h12 = long_dot(v[1], v[2]) + long_dot(v[0], v[4]), det = h11 * h22 - h12 * h12;
        if (!(det > 0 && h11 > 0))
            return false;
        const long double step[2] = {(f2 * h12 - f1 * h22) / det, (f1 * h12 - f2 * h11) / det};
        at[0] += step[0];
        at[1] += step[1];
        const long double size = fabsl(step[0]) + fabsl(step[1]);
        if (!(size < 10))
            return false;
        if (size <= 4 * LDBL_EPSILON || (size < 1e-12L && size >= last))
            return true;
        last = size;
    }
    return false;
}

static bool inside(const struct subdivision *s, const long double at[2])
{
    for (int k = 0; k < 2; k++)
        if (!(at[k] > s->lo[k] + BOUND && at[k] <= s->hi[k] + BOUND))
            return false;
    return !s->triangle || at[0] + at[1] <= s->hi[0] + BOUND;
}

static bool belongs(const struct box *b, const long double at[2])
{
    bool own = true;
    for (int k = 0; k < 2; k++)
        own = own && at[k] > b->lo[k] - CONVERGED && at[k] < b->hi[k] + CONVERGED;
    return own;
}

/* Adds the minimum to which Newton's iteration converges from *at, if it belongs to the box. */
static bool take_minimum(struct subdivision *s, const struct box *b, long double at[2])
{
    long double v[6][3];
    if (!newton(s->local, at) || !belongs(b, at))
        return false;
    evaluate(s->local, at[0], at[1], v);
    const long double d = long_dot(v[0], v[0]) / 2;
    if (inside(s, at) && d < s->least) {
        memcpy(s->at, at, sizeof s->at);
        s->least = d;
        s->found = true;
    }
    return true;
}

/* Takes the only minimum of a convex box; returns false if it is not found. */
static bool take_only(struct subdivision *s, const struct box *b)
{
    long double middle[2] = {(b->lo[0] + b->hi[0]) / 2, (b->lo[1] + b->hi[1]) / 2};
    return (s->found && belongs(b, s->at)) || take_minimum(s, b, middle);
}

static void search_box(struct subdivision *s, const struct box *b)
{
    const enum verdict verdict = verdict_of(s, b);
    struct box half[2];
    if (verdict == NO_MINIMUM || (verdict == CONVEX && take_only(s, b)))
        return;
    s->lost = s->lost || b->depth == DEPTH_MAX || ++s->boxes > s->most;
    if (s->lost)
        return;
    halve(b, half);
    search_box(s, &half[0]);
    search_box(s, &half[1]);
}

bool surface_foot_quadratic(const struct surface *f, struct sample *s, const double lo[2], const double hi[2],
                            const double near[2])
{
    struct local l;
    struct subdivision sub = {
        .local = &l, .triangle = f->triangle, .least = INFINITY, .most = near ? BOXES_NEAR : BOXES_MAX};
    long double v[6][3], n[3];
    if (!localise(f, s, &l))
        return false;
    memcpy(sub.lo, lo, sizeof sub.lo);
    memcpy(sub.hi, hi, sizeof sub.hi);
    const struct box all = whole_box(&sub);
    if (near)
        take_minimum(&sub, &all, (long double[]){near[0], near[1]});
    search_box(&sub, &all);
    if (sub.lost && near)
        return surface_foot_quadratic(f, s, lo, hi, NULL);
    if (sub.lost || !sub.found)
        return false;
    evaluate(&l, sub.at[0], sub.at[1], v);
    long_cross(v[1], v[2], n);
    const long double length = sqrtl(long_dot(n, n));
    if (!(length > 0))
        return false;
    s->xi = (double)sub.at[0];
    s->eta = (double)sub.at[1];
    s->gap = (double)(l.size * long_dot(v[0], n) / length);
    return true;
}
