/* The certain closest point on a bilinear segment.  With r = c0 + c1 xi + c2 eta + c3 xi eta and d = xs - c0, equations
 * (7) and (8) of the paper, r_xi.(xs-r) = 0 and r_eta.(xs-r) = 0, are
 *
 *     (7)  N(eta) - xi E(eta) = 0,   E = |c1 + c3 eta|^2,   N = (c1 + c3 eta).(d - c2 eta)
 *     (8)  the same with xi and eta, c1 and c2 exchanged.
 *
 * Putting xi = N/E into (8) and multiplying by E^2 leaves a quintic in eta whose real roots are all stationary points,
 * save where E vanishes.  E vanishes at a real eta only if c1 is parallel to c3 (edges AB and DC are parallel), so the
 * coordinate whose vector is least parallel to c3 is eliminated; then only a saddle at an apex may escape, never a
 * minimum.  Roots come from the companion matrix (gsl_poly_complex_solve) and are polished by Newton's iteration on
 * (7), (8) in long double.  Coordinates are relative to the centre and divided by the size of the segment before
 * anything else.
 *
 * A search from a point near the minimum needs no roots: with a = r_xi, b = r_eta and v = xs - r at a minimum, a step (s, t) changes half the squared
 * distance by |s (a + t c3) + t b|^2 / 2 - s t v.c3, which is positive for every s, as the discriminant in s shows, if
 *
 *     Q(t) = |a + t c3|^2 |b|^2 - (a.b + t b.c3 - v.c3)^2 > 0.
 *
 * Q is convex in t.  Where it is positive on the box, or the same with xi and eta exchanged, no point of the box is nearer. */
#include "foot_bilinear.h"

#include "../common/vec3.h"
#include "surface.h"

#include <float.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_poly.h>
#include <math.h>

#define BOUND 1e-12 /* rounding of a coordinate at the bound of a box */
#define WIDER 1e-6  /* how far a search extends beyond its box */
#define FAINT 1e-6  /* of a leading coefficient over the largest */

/* The scalar products on which (7) and (8) depend. */
struct products {
    long double c11, c22, c33, c12, c13, c23, d1, d2, d3;
};

/* Segment and slave node about the centre, in units of `size`. */
struct local {
    long double c1[3], c2[3], c3[3], d[3], size;
};

static long double square_of_cross(const long double a[3], const long double b[3])
{
    long double c[3];
    long_cross(a, b, c);
    return long_dot(c, c);
}

static bool localise(const double x[4][3], const double xs[3], struct local *l)
{
    l->size = 0;
    for (int k = 0; k < 3; k++) {
        const long double a = x[0][k], b = x[1][k], c = x[2][k], d = x[3][k];
        l->c1[k] = ((b - a) + (c - d)) / 4;
        l->c2[k] = ((d - a) + (c - b)) / 4;
        l->c3[k] = ((a - b) + (c - d)) / 4;
        l->d[k] = ((xs[k] - a) + (xs[k] - b) + (xs[k] - c) + (xs[k] - d)) / 4;
        l->size = fmaxl(l->size, fmaxl(fabsl(l->c1[k]), fmaxl(fabsl(l->c2[k]), fabsl(l->c3[k]))));
    }
    if (!isfinite(l->size) || !(l->size > 0) || !isfinite(l->d[0] + l->d[1] + l->d[2]))
        return false;
    for (int k = 0; k < 3; k++) {
        l->c1[k] /= l->size;
        l->c2[k] /= l->size;
        l->c3[k] /= l->size;
        l->d[k] /= l->size;
    }
    return true;
}

/* Computes the products; with `swap`, for the segment with xi and eta exchanged. */
static struct products multiply(const struct local *l, bool swap)
{
    const long double *c1 = swap ? l->c2 : l->c1, *c2 = swap ? l->c1 : l->c2;
    return (struct products){.c11 = long_dot(c1, c1),
                             .c22 = long_dot(c2, c2),
                             .c33 = long_dot(l->c3, l->c3),
                             .c12 = long_dot(c1, c2),
                             .c13 = long_dot(c1, l->c3),
                             .c23 = long_dot(c2, l->c3),
                             .d1 = long_dot(l->d, c1),
                             .d2 = long_dot(l->d, c2),
                             .d3 = long_dot(l->d, l->c3)};
}

/* Computes r_xi, r_eta and xs - r. */
static void derive(const struct local *l, long double xi, long double eta, long double t1[3], long double t2[3],
                   long double v[3])
{
    for (int k = 0; k < 3; k++) {
        t1[k] = l->c1[k] + l->c3[k] * eta;
        t2[k] = l->c2[k] + l->c3[k] * xi;
        v[k] = l->d[k] - l->c1[k] * xi - t2[k] * eta;
    }
}

/* Computes a Newton step on (7), (8) at (xi, eta). Returns false if the Jacobian is singular. */
static bool newton_step(const struct local *l, long double xi, long double eta, long double step[2], bool *minimum)
{
    long double t1[3], t2[3], v[3];
    derive(l, xi, eta, t1, t2, v);
    const long double f1 = long_dot(t1, v), f2 = long_dot(t2, v);
    const long double h11 = long_dot(t1, t1), h22 = long_dot(t2, t2), h12 = long_dot(t1, t2) - long_dot(v, l->c3);
    const long double det = h11 * h22 - h12 * h12;
    *minimum = det > 0 && h11 > 0;
    if (det == 0)
        return false;
    step[0] = (f1 * h22 - f2 * h12) / det;
    step[1] = (f2 * h11 - f1 * h12) / det;
    return true;
}

/* Iterates Newton's method from (xi, eta) until steps are at the level of rounding: tiny, or small and no longer
 * shrinking. Near a double root it converges linearly, so it needs many steps. */
static bool polish(const struct local *l, long double *xi, long double *eta, bool *minimum)
{
    long double last = INFINITY;
    for (int i = 0; i < 100; i++) {
        long double step[2];
        if (!newton_step(l, *xi, *eta, step, minimum))
            return last < 1e-10L;
        *xi += step[0];
        *eta += step[1];
        const long double size = (fabsl(step[0]) + fabsl(step[1])) / (1 + fabsl(*xi) + fabsl(*eta));
        if (!isfinite(size))
            return false;
        if (size <= 4 * LDBL_EPSILON || (size < 1e-10L && size >= last))
            return true;
        last = size;
    }
    return false;
}

/* Adds a b to product. */
static void multiply_quadratics(long double product[5], const long double a[3], const long double b[3])
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            product[i + j] += a[i] * b[j];
}

/* Computes the coefficients of the quintic in eta, divided by the largest; returns false if all are 0 or not finite. */
static bool quintic(const struct products *p, double a[6])
{
    const long double e[3] = {p->c11, 2 * p->c13, p->c33};
    const long double n[3] = {p->d1, p->d3 - p->c12, -p->c23};
    long double ee[5] = {0}, en[5] = {0}, nn[5] = {0}, coefficient[6] = {0}, largest = 0;
    multiply_quadratics(ee, e, e);
    multiply_quadratics(en, e, n);
    multiply_quadratics(nn, n, n);
    for (int k = 0; k <= 5; k++) {
        if (k < 5)
            coefficient[k] += p->d2 * ee[k] + (p->d3 - p->c12) * en[k] - p->c13 * nn[k];
        if (k > 0)
            coefficient[k] -= p->c22 * ee[k - 1] + 2 * p->c23 * en[k - 1] + p->c33 * nn[k - 1];
        largest = fmaxl(largest, fabsl(coefficient[k]));
    }
    for (int k = 0; k <= 5; k++)
        a[k] = (double)(coefficient[k] / largest);
    return isfinite(largest) && largest > 0;
}

/* Computes the roots of a polynomial, real and imaginary parts alternating; returns their number. */
static int polynomial_roots(const double a[6], int degree, double root[10])
{
    gsl_poly_complex_workspace *workspace = gsl_poly_complex_workspace_alloc((size_t)degree + 1);
    gsl_error_handler_t *handler = gsl_set_error_handler_off();
    const int status = gsl_poly_complex_solve(a, (size_t)degree + 1, workspace, root);
    gsl_set_error_handler(handler);
    gsl_poly_complex_workspace_free(workspace);
    return status == GSL_SUCCESS ? degree : 0;
}

static long double distance_at(const struct local *l, long double xi, long double eta)
{
    long double v[3];
    for (int k = 0; k < 3; k++)
        v[k] = l->d[k] - l->c1[k] * xi - l->c2[k] * eta - l->c3[k] * xi * eta;
    return sqrtl(long_dot(v, v));
}

int stationary_insert(struct stationary *found, int n, int most, const struct stationary *s)
{
    int k;
    for (k = 0; k < n; k++)
        if (fabs(found[k].xi - s->xi) + fabs(found[k].eta - s->eta) <= 1e-10 * (1 + fabs(s->xi) + fabs(s->eta))) {
            found[k].minimum = found[k].minimum || s->minimum;
            return n;
        }
    if (n == most)
        return n;
    for (k = n; k > 0 && found[k - 1].distance > s->distance; k--)
        found[k] = found[k - 1];
    found[k] = *s;
    return n + 1;
}

static bool is_degenerate(const struct local *l)
{
    const long double k1 = square_of_cross(l->c1, l->c3), k2 = square_of_cross(l->c2, l->c3);
    return fmaxl(square_of_cross(l->c1, l->c2), fmaxl(k1, k2)) < 1e-28L;
}

/* Adds the stationary point to which polishing leads from a root (re, im); returns the number found. */
static int add_stationary(const struct local *l, const struct products *q, bool swap, double re, double im,
                          struct stationary found[5], int n)
{
    struct stationary s;
    /* Rounding may turn two close real roots into a conjugate pair: start on both sides of it. */
    long double v = (long double)re + im, u = 0;
    const long double e = q->c11 + v * (2 * q->c13 + v * q->c33);
    long double *xi = swap ? &v : &u, *eta = swap ? &u : &v;
    if (fabs(im) > 1e-2 * (1 + fabs(re)) || !(e > 0))
        return n;
    u = (q->d1 + v * (q->d3 - q->c12 - q->c23 * v)) / e;
    if (!polish(l, xi, eta, &s.minimum))
        return n;
    s.xi = (double)*xi;
    s.eta = (double)*eta;
    s.distance = (double)(l->size * distance_at(l, *xi, *eta));
    return stationary_insert(found, n, 5, &s);
}

/* A leading coefficient that is faint, or only rounding, has a far root, which costs the others their digits: those are
 * found once more without it. */
static int all_stationary(const struct local *l, struct stationary found[5])
{
    const bool swap = square_of_cross(l->c2, l->c3) > square_of_cross(l->c1, l->c3);
    const struct products q = multiply(l, swap);
    double a[6], root[10];
    int n = 0;
    if (is_degenerate(l))
        return -1;
    if (!quintic(&q, a))
        return 0;
    for (int degree = 5; degree > 0; degree--) {
        const int roots = fabs(a[degree]) > 1e-60 ? polynomial_roots(a, degree, root) : 0;
        for (int i = 0; i < roots; i++)
            n = add_stationary(l, &q, swap, root[2 * i], root[2 * i + 1], found, n);
        if (fabs(a[degree]) > FAINT)
            break;
    }
    return n;
}

int foot_bilinear_stationary(const double x[4][3], const double xs[3], struct stationary found[5])
{
    struct local l;
    return localise(x, xs, &l) ? all_stationary(&l, found) : -1;
}

/* Fills xi, eta and the gap (xs - r).n; returns false if the surface has no normal. */
static bool label(const struct local *l, long double xi, long double eta, struct sample *s)
{
    long double v[3], t1[3], t2[3], n[3];
    derive(l, xi, eta, t1, t2, v);
    long_cross(t1, t2, n);
    const long double length = sqrtl(long_dot(n, n));
    if (!(length > 0))
        return false;
    s->xi = (double)xi;
    s->eta = (double)eta;
    s->gap = (double)(l->size * long_dot(v, n) / length);
    return true;
}

bool stationary_inside(const struct stationary *s, const double lo[2], const double hi[2])
{
    return s->xi > lo[0] + BOUND && s->xi <= hi[0] + BOUND && s->eta > lo[1] + BOUND && s->eta <= hi[1] + BOUND;
}

/* Returns true if the left side of (7) does not change its sign on the box. It is linear in the first coordinate and
 * quadratic in the second, so its Bernstein coefficients decide. Signs count only beyond a margin for rounding. */
static bool one_sign(const double c1[3], const double c2[3], const double c3[3], const double d[3],
                     const double first[2], const double second[2])
{
    const double c11 = vector_dot(c1, c1), c12 = vector_dot(c1, c2), c13 = vector_dot(c1, c3), c23 = vector_dot(c2, c3);
    const double c33 = vector_dot(c3, c3), d1 = vector_dot(d, c1), d3 = vector_dot(d, c3);
    const double reach = 1 + fmax(fmax(-first[0], first[1]), fmax(-second[0], second[1]));
    const double margin = 1e-12 * reach * reach * reach * (c11 + c33 + fabs(c12) + fabs(c23) + fabs(d1) + fabs(d3));
    bool above = true, below = true;
    for (int i = 0; i < 2; i++) {
        const double t = first[i], u = second[0], width = second[1] - second[0];
        const double k0 = d1 - t * c11, k1 = d3 - c12 - 2 * t * c13, k2 = -c23 - t * c33;
        const double start = k0 + u * (k1 + u * k2), middle = start + width / 2 * (k1 + 2 * u * k2);
        const double end = k0 + second[1] * (k1 + second[1] * k2);
        above = above && fmin(start, fmin(middle, end)) > margin;
        below = below && fmax(start, fmax(middle, end)) < -margin;
    }
    return above || below;
}

/* Returns true if the box has no stationary point: an equation does not change its sign on it, or each of its quarters
 * has no stationary point, to a depth of `depth` subdivisions. */
static bool empty_box(const double c[3][3], const double d[3], const double xi[2], const double eta[2], int depth)
{
    if (one_sign(c[0], c[1], c[2], d, xi, eta) || one_sign(c[1], c[0], c[2], d, eta, xi))
        return true;
    if (depth == 0)
        return false;
    const double u[3] = {xi[0], (xi[0] + xi[1]) / 2, xi[1]}, v[3] = {eta[0], (eta[0] + eta[1]) / 2, eta[1]};
    for (int i = 0; i < 4; i++)
        if (!empty_box(c, d, &u[i % 2], &v[i / 2], depth - 1))
            return false;
    return true;
}

void bilinear_vectors(const double x[4][3], double c[3][3])
{
    for (int k = 0; k < 3; k++) {
        const double ab = x[1][k] - x[0][k], dc = x[2][k] - x[3][k], ad = x[3][k] - x[0][k], bc = x[2][k] - x[1][k];
        c[0][k] = (ab + dc) / 4;
        c[1][k] = (ad + bc) / 4;
        c[2][k] = (dc - ab) / 4;
    }
}

/* Excludes stationary points in the box, quickly and with certainty. Most pairs of a search end here. */
static bool excluded(const double x[4][3], const double xs[3], const double lo[2], const double hi[2])
{
    const double xi[2] = {lo[0] - WIDER, hi[0] + WIDER}, eta[2] = {lo[1] - WIDER, hi[1] + WIDER};
    double c[3][3], d[3];
    bilinear_vectors(x, c);
    for (int k = 0; k < 3; k++)
        d[k] = ((xs[k] - x[0][k]) + (xs[k] - x[1][k]) + (xs[k] - x[2][k]) + (xs[k] - x[3][k])) / 4;
    return empty_box((const double(*)[3])c, d, xi, eta, 6);
}

/* Returns true if Q(t) exceeds a margin for rounding for all t in low..high. */
static bool is_positive(const long double a[3], const long double b[3], const long double m[3], const long double v[3],
                        long double low, long double high)
{
    const long double aa = long_dot(a, a), bb = long_dot(b, b), am = long_dot(a, m), mm = long_dot(m, m);
    const long double ab = long_dot(a, b), bm = long_dot(b, m), vm = long_dot(v, m), far = fmaxl(-low, high);
    const long double q0 = aa * bb - (ab - vm) * (ab - vm), q1 = bb * am - (ab - vm) * bm, q2 = bb * mm - bm * bm;
    const long double largest = fabsl(ab) + fabsl(vm) + far * fabsl(bm);
    const long double margin = 1e-14L * (bb * (aa + far * (2 * fabsl(am) + far * mm)) + largest * largest);
    const long double lowest = q2 > 0 ? fminl(fmaxl(-q1 / q2, low), high) : low;
    return q0 + lowest * (2 * q1 + lowest * q2) > margin && q0 + low * (2 * q1 + low * q2) > margin &&
           q0 + high * (2 * q1 + high * q2) > margin;
}

/* Finds a minimum from a point near it, if it lies inside and no other point of the box is nearer. */
static bool find_nearest(const struct local *l, const double lo[2], const double hi[2], const double near[2],
                         struct sample *s)
{
    long double xi = near[0], eta = near[1], a[3], b[3], v[3];
    bool minimum;
    if (!polish(l, &xi, &eta, &minimum) || !minimum ||
        !stationary_inside(&(struct stationary){.xi = (double)xi, .eta = (double)eta}, lo, hi))
        return false;
    derive(l, xi, eta, a, b, v);
    return (is_positive(a, b, l->c3, v, lo[1] - WIDER - eta, hi[1] + WIDER - eta) ||
            is_positive(b, a, l->c3, v, lo[0] - WIDER - xi, hi[0] + WIDER - xi)) &&
           label(l, xi, eta, s);
}

bool surface_foot_bilinear(const struct surface *f, struct sample *s, const double lo[2], const double hi[2],
                           const double near[2])
{
    const double(*x)[3] = (const double(*)[3])s->x;
    struct local l;
    struct stationary found[5];
    (void)f;
    if ((!near && excluded(x, s->xs, lo, hi)) || !localise(x, s->xs, &l) || is_degenerate(&l))
        return false;
    if (near && find_nearest(&l, lo, hi, near, s))
        return true;
    const int n = all_stationary(&l, found);
    for (int k = 0; k < n; k++) {
        const struct stationary *p = &found[k];
        if (p->minimum && stationary_inside(p, lo, hi) && label(&l, p->xi, p->eta, s))
            return true;
    }
    return false;
}

bool foot_bilinear(struct sample *s, const double lo[2], const double hi[2])
{
    return surface_foot_bilinear(NULL, s, lo, hi, NULL);
}
