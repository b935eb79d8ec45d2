/* Checks answers of the iteration-free search without a branch, for vectorised loops; only for files of the library.  The notation
 * follows bilinear.h: a = r_xi, b = r_eta, d = xS - r, H the Hessian of |d|^2/2, so that Newton's step is H^-1 (a.d, b.d).
 *
 * 1. By the argument of certify.c, a foot point lies within r of (xi,eta) if
 *        |step| <= r (1 - k),   k = |H^-1| |change of H within r|.
 *    The products below are the step's and k's, times the determinant.
 * 2. No point of the segment is nearer than that foot point if, for -1 <= eta' <= 1, the convex parabola
 *        q = b.b |a + c3 (eta' - eta)|^2 - (H12 + b.c3 (eta' - eta))^2
 *    is positive (see certify.c), which its tangent at eta proves; or the same with xi and eta exchanged.
 * 3. A foot point outside the segment might hide another inside, a local minimum that is farther away.  This is impossible if
 *    the distance is convex between the foot point and all of the segment, with
 *        a.a >= (a.a)(eta) - 2 |a.c3| |eta' - eta|,   b.b >= (b.b)(xi) - 2 |b.c3| |xi' - xi|,
 *        |H12| <= |H12(xi,eta)| + 2 (|a.c3| |xi' - xi| + |b.c3| |eta' - eta| + c3.c3 |xi' - xi| |eta' - eta|). */
#ifndef FOOTPOINT_CHECK_H
#define FOOTPOINT_CHECK_H

#include "../geometry/vector.h"

/** The largest error of xi and eta of an answer that passes the check. */
#define FOOTPOINT_CHECK_WORST 1.024e-07
/* Rounding errors of all products together, over squares of lengths; about 500 units. */
#define FOOTPOINT_CHECK_ROUNDING 1e-13

static inline double footpoint_check_larger(double a, double b)
{
    return a > b ? a : b;
}

/* Returns 1 if products of several numbers such as x may leave the range of double, or if x is not finite. */
static inline int number_outside(double x)
{
    return (number_bits(x) - ((uint64_t)511 << 52)) >> 62 != 0;
}

/* Scalar products at (xi,eta), in s = (1 + xi)/2 and t = (1 + eta)/2: here a and b are twice r_xi and r_eta, and c is four
 * times c3; the statements above keep their form. */
struct check {
    double s, t, aa, bb, ad, bd, dd, ac, bc, cc, h12, determinant;
};

static inline void footpoint_check_at(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                      const double xS[3], double xi, double eta, struct check *p)
{
    double aa = 0.0, ab = 0.0, bb = 0.0, ad = 0.0, bd = 0.0, dd = 0.0, ac = 0.0, bc = 0.0, cc = 0.0, cf = 0.0;
    const double s = 0.5 * (1.0 + xi), t = 0.5 * (1.0 + eta);
    for (int i = 0; i < 3; i++) {
        const double e = xB[i] - xA[i], f = xS[i] - xA[i], c = (xC[i] - xD[i]) - e;
        const double a = e + t * c, b = (xD[i] - xA[i]) + s * c, d = f - s * e - t * b;
        aa += a * a;
        ab += a * b;
        bb += b * b;
        ad += a * d;
        bd += b * d;
        dd += d * d;
        ac += a * c;
        bc += b * c;
        cc += c * c;
        cf += c * f;
    }
    const double cd = cf - s * (ac - t * cc) - t * bc, h12 = ab - cd;
    *p = (struct check){s, t, aa, bb, ad, bd, dd, ac, bc, cc, h12, aa * bb - h12 * h12};
}

/* Return an upper bound on |H| and the rounding error of the determinant. */
static inline double footpoint_check_high(const struct check *p)
{
    return footpoint_check_larger(p->aa, p->bb) + fabs(p->h12);
}

static inline double footpoint_check_rounding(const struct check *p)
{
    return FOOTPOINT_CHECK_ROUNDING * footpoint_check_high(p) * (p->aa + p->bb + p->cc + p->dd);
}

/* 1.: returns 1 if a foot point lies within FOOTPOINT_CHECK_WORST. */
static inline int footpoint_check_near(const struct check *p)
{
    const double r = 0.5 * FOOTPOINT_CHECK_WORST, change = fabs(p->ac) + fabs(p->bc) + p->cc * r;
    const double room = r * (p->determinant - 4.0 * r * change * footpoint_check_high(p)) - footpoint_check_rounding(p);
    return (fabs(p->bb * p->ad - p->h12 * p->bd) <= room) & (fabs(p->aa * p->bd - p->h12 * p->ad) <= room);
}

/* 2.: returns 1 if no point of the segment is nearer than a foot point within r of s and t. */
static inline int footpoint_check_nearest(const struct check *p, double r)
{
    const double s = p->s, t = p->t, both = fabs(p->ac) + fabs(p->bc);
    const double off = footpoint_check_larger(fabs(s - 0.5), fabs(t - 0.5)), reach = footpoint_check_larger(1.0, off);
    /* bound on the decrease of q by a shift by r */
    const double shift = 4.0 * r * (both + p->cc) * (p->aa + p->bb + 2.0 * fabs(p->h12) + 4.0 * both);
    const double margin = (shift + footpoint_check_rounding(p)) * reach, least = p->determinant - margin;
    const double qt = 2.0 * (p->bb * p->ac - p->h12 * p->bc), qs = 2.0 * (p->aa * p->bc - p->h12 * p->ac);
    const int nearest = ((least - qt * t > 0.0) & (least + qt * (1.0 - t) > 0.0)) |
                        ((least - qs * s > 0.0) & (least + qs * (1.0 - s) > 0.0));
    return nearest & !number_outside(margin);
}

/* 3.: returns 1 if a foot point outside the segment hides no other. */
static inline int footpoint_check_alone(const struct check *p)
{
    const double way_s = 0.5 + fabs(p->s - 0.5), way_t = 0.5 + fabs(p->t - 0.5), ac = fabs(p->ac), bc = fabs(p->bc);
    const double least_aa = p->aa - 2.0 * ac * way_t, least_bb = p->bb - 2.0 * bc * way_s;
    const double most_ab = fabs(p->h12) + 2.0 * (ac * way_s + bc * way_t + p->cc * way_s * way_t);
    return ((way_s <= 1.0) & (way_t <= 1.0)) | ((least_aa > 0.0) & (least_aa * least_bb > 1.001 * most_ab * most_ab));
}

/** Returns 1 if (xi,eta) is within FOOTPOINT_CHECK_WORST of a foot point, and no point of the segment is nearer than that foot
 *  point.  Returns 0 if this is not proved, if any number is not finite, or if the segment is too small or too large for its
 *  products. */
static inline int footpoint_check(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                  const double xS[3], double xi, double eta)
{
    struct check p;
    footpoint_check_at(xA, xB, xC, xD, xS, xi, eta, &p);
    return footpoint_check_near(&p) & footpoint_check_nearest(&p, 0.5 * FOOTPOINT_CHECK_WORST) &
           footpoint_check_alone(&p);
}

#endif
