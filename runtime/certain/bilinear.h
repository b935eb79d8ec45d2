/* The bilinear segment as r = c0 + c1 xi + c2 eta + c3 xi eta, computed from differences of nodes; only for the files of this
 * folder.  With d = xS - r, a = r_xi = c1 + c3 eta and b = r_eta = c2 + c3 xi, (7) and (8) are a . d = b . d = 0,
 * and the Hessian of |d|^2/2 is
 *     [ a . a           a . b - c3 . d ]
 *     [ a . b - c3 . d  b . b          ].
 * From a point to the point (u,v) further, exactly,
 *     |d'|^2 = |d|^2 - 2 (u a . d + v b . d) + |u a + v b + u v c3|^2 - 2 u v c3 . d. */
#ifndef FOOTPOINT_BILINEAR_H
#define FOOTPOINT_BILINEAR_H

#include "../footpoint.h"
#include "../geometry/vector.h"
#include "ieee.h"
#include "twofold.h"

#include <float.h>

/* Only for files of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/* Half the distance from 1 to the next number: the relative error of an operation, fused or not. */
#define BILINEAR_UNIT (0.5 * DBL_EPSILON)
#define BILINEAR_LEAST 0x1p-100 /* edges for which no important product under- or overflows, unscaled */
#define BILINEAR_MOST 0x1p100
#define BILINEAR_FARTHEST 0x1p40 /* |xS - xA| over the longest edge; beyond, no digit of xi and eta is left */

/* Lengths are in 2^exponent mesh lengths. */
struct bilinear {
    double ab[3], dc[3], ad[3], bc[3], as[3]; /* AB, DC, AD, BC, from A to xS */
    double c1[3], c2[3], c3[3], d0[3];        /* d0 = xS - c0 */
    double m1, m2, s;                         /* largest components of AB and DC, of AD and BC, of xS - xA */
    double m;                                 /* the larger of m1 and m2 */
    int exponent;
};

/* A point.  Products use m1 xi and m2 eta, which are lengths for any aspect: in them a stands for a/m1, b for b/m2 and c3 for
 * c3/(m1 m2). */
struct bilinear_point {
    double a[3], b[3], d[3];
    double f1, f2;        /* a . d, b . d; lengths */
    double h11, h12, h22; /* the Hessian; numbers */
    double ac, bc, cc;    /* a . c3, b . c3, 1 over length; c3 . c3, 1 over its square */
    double error;         /* rounding error of h11, h12, h22; times m: of f1, f2; over m, m^2: of ac, bc; cc */
};

/* The statement that Newton's step from a point proves, see footpoint_bilinear_prove: exactly one stationary point lies within
 * `radius` of the point and within `radius_after` of the step's end; lengths, of m1 xi and m2 eta each. */
struct bilinear_proof {
    double move[2]; /* of xi and eta */
    double radius, radius_after;
};

static inline double bilinear_larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double bilinear_smaller(double a, double b)
{
    return a < b ? a : b;
}

static inline double bilinear_largest(const double v[3])
{
    return bilinear_larger(bilinear_larger(fabs(v[0]), fabs(v[1])), fabs(v[2]));
}

static inline double bilinear_clamp(double x)
{
    return x < -1.0 ? -1.0 : x > 1.0 ? 1.0 : x;
}

/* Returns y - x, exactly except for underflow, in 2^exponent mesh lengths. */
static inline struct twofold bilinear_difference(double y, double x, int exponent)
{
    struct twofold d;
    if (exponent == 0)
        return twofold_sum(y, -x);
    const double by = exponent > 0 ? 0.25 : 1.0; /* differences may overflow or underflow */
    d = twofold_sum(by * y, -by * x);
    d.high = ldexp(d.high, (exponent > 0 ? 2 : 0) - exponent);
    d.low = ldexp(d.low, (exponent > 0 ? 2 : 0) - exponent);
    return d;
}

/** Expands the segment, in scaled lengths if the edges are extreme.
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE (all corners coincide),
 *          FOOTPOINT_ERR_DOMAIN (xS is too far away) */
int footpoint_bilinear_of(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                          const double xS[3], struct bilinear *f);

/** Returns 0 if the edges are parallel, to rounding, so that there is no normal anywhere. */
int footpoint_bilinear_has_area(const struct bilinear *f);

/** Computes Newton's step from (xi,eta) and tries to prove it.
 *  @param[out] p      the point
 *  @param[out] proof  the radii only if proved
 *  @return 1 if proved, 0 if not, -1 if the step is not finite */
int footpoint_bilinear_prove(const struct bilinear *f, double xi, double eta, struct bilinear_point *p,
                             struct bilinear_proof *proof);

/** Does the same from the products at (xi,eta), if f1 and f2 are within `error` of the exact values. */
int footpoint_bilinear_prove_from(const struct bilinear *f, double xi, double eta, const struct bilinear_point *p,
                                  double error, struct bilinear_proof *proof);

/* A point with twice the digits: r_xi, r_eta, c3 and xS - r; lengths. */
struct bilinear_wide {
    struct twofold a[3], b[3], c[3], d[3];
};

/** Evaluates a point with twice the digits.
 *  @param[in] x         the nodes A, B, C, D, S
 *  @param[in] exponent  lengths are in 2^exponent mesh lengths */
void footpoint_bilinear_wide_at(const double *const x[5], int exponent, const double z[2], struct bilinear_wide *p);

/** Moves z to the nearby stationary point, to rounding, by residuals of twice the precision.
 *  @param[in]  x       the nodes A, B, C, D, S
 *  @param[out] radius  proved bound on the errors of m1 xi and m2 eta; a length
 *  @return 1, or 0 with z and *radius untouched if no point can be separated from others */
int footpoint_bilinear_refine(const double *const x[5], const struct bilinear *f, double z[2], double *radius);

/* Computes products at (xi,eta).  Their errors: let u be the unit, X = 1 + |xi|, Y = 1 + |eta|, D = s + 2 m X Y >= |d_i|, and
 * mm the smaller of m1, m2.  The error of c1 is at most u m1, of c2 u m2, of c3 u mm (from the shorter edges), of d0
 * u (2 s + 7 m).  So the error of a is at most 2 u m1 Y, of b 2 u m2 X, of d 5 u D, and the errors of the products are at most
 *     a.d: 18 u m1 Y D    a.a: 9 u (m1 Y)^2    a.b - c3.d: 10 u m1 m2 X Y + 17 u mm D    a.c3: 8 u m1 mm Y
 * and the like.  After the division all are below 24 u max(X,Y) D/m; 32 leaves room for the division and for terms
 * in u^2.  Fusing or reordering operations raises no error above these bounds. */
static inline void bilinear_at(const struct bilinear *f, double xi, double eta, struct bilinear_point *p)
{
    const double per1 = 1.0 / f->m1, per2 = 1.0 / f->m2, per12 = per1 * per2;
    for (int i = 0; i < 3; i++) {
        p->a[i] = f->c1[i] + f->c3[i] * eta;
        p->b[i] = f->c2[i] + f->c3[i] * xi;
        p->d[i] = f->d0[i] - f->c1[i] * xi - p->b[i] * eta;
    }
    p->f1 = vector_dot(p->a, p->d) * per1;
    p->f2 = vector_dot(p->b, p->d) * per2;
    p->h11 = vector_dot(p->a, p->a) * (per1 * per1);
    p->h22 = vector_dot(p->b, p->b) * (per2 * per2);
    p->h12 = (vector_dot(p->a, p->b) - vector_dot(f->c3, p->d)) * per12;
    p->ac = vector_dot(p->a, f->c3) * (per1 * per12);
    p->bc = vector_dot(p->b, f->c3) * (per2 * per12);
    p->cc = vector_dot(f->c3, f->c3) * (per12 * per12);
    const double x = 1.0 + fabs(xi), y = 1.0 + fabs(eta);
    p->error = 32.0 * BILINEAR_UNIT * bilinear_larger(x, y) * (f->s / f->m + 2.0 * x * y);
}

/** Returns 1 if no point of the segment [-1,1]^2 is nearer to xS than the point (xi,eta).  The point must be stationary, or lie on
 *  the edge with all moves into the segment leading away from xS.  0 proves nothing.
 *  @param[in] slack  largest distance of m1 xi and m2 eta from the exact point; a length
 *  @param[in] floor  least gain of the squared distance over the square of such a move */
int footpoint_bilinear_is_nearest(const struct bilinear *f, const struct bilinear_point *p, double xi, double eta,
                                  double slack, double floor);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
