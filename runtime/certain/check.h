/* Whether an answer of the iteration-free search can be trusted, without a branch, for loops that are vectorised; for
 * the files of this folder alone.  The notation is that of bilinear.h: a = r_xi, b = r_eta, d = xS - r, H the Hessian
 * of |d|^2/2, so that Newton's step is H^-1 (a.d, b.d).
 *
 * 1. By the argument of certify.c, with r the worst error of the banner, a foot point lies within r of (xi,eta) if
 *        |step| <= r (1 - k),   k = |H^-1| |change of H within r|;
 *    the products below are those of the step and of k with the determinant.
 * 2. No point of the segment is nearer than that foot point if, for -1 <= eta' <= 1, the convex parabola
 *        q = b.b |a + c3 (eta' - eta)|^2 - (H12 + b.c3 (eta' - eta))^2
 *    is positive (see certify.c): its tangent at eta tells; or the same with xi and eta exchanged.
 * 3. A foot point outside the segment might hide another inside, a local minimum that is farther away.  There is none if
 *    the distance is convex from the one to all of the segment, where
 *        a.a >= (a.a)(eta) - 2 |a.c3| |eta' - eta|,   b.b >= (b.b)(xi) - 2 |b.c3| |xi' - xi|,
 *        |H12| <= |H12(xi,eta)| + 2 (|a.c3| |xi' - xi| + |b.c3| |eta' - eta| + c3.c3 |xi' - xi| |eta' - eta|). */
#ifndef FOOTPOINT_CHECK_H
#define FOOTPOINT_CHECK_H

#include "../geometry/vector.h"

/** The worst error of xi and eta that the banner of generated/footpoint_quad4.h states for footpoint_quad4_accurate. */
#define FOOTPOINT_CHECK_WORST 1.024e-07
/* Rounding errors of all products together, over squares of lengths; about 500 units. */
#define FOOTPOINT_CHECK_ROUNDING 1e-13

static inline double footpoint_check_larger(double a, double b)
{
    return a > b ? a : b;
}

/* Whether products of what x is made of may leave the range of double, or x is not finite. */
static inline int number_outside(double x)
{
    return (number_bits(x) - ((uint64_t)511 << 52)) >> 62 != 0;
}

/** 1 if (xi,eta) is within FOOTPOINT_CHECK_WORST of a foot point, than which no point of the segment is nearer; 0 if
 *  that is not sure, if any number is not finite, or if the segment is too small or too large for its products. */
static inline int footpoint_check(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                  const double xS[3], double xi, double eta)
{
    double aa = 0.0, ab = 0.0, bb = 0.0, ad = 0.0, bd = 0.0, dd = 0.0, ac = 0.0, bc = 0.0, cc = 0.0, cd = 0.0;
    const double s = 0.5 * (1.0 + xi), t = 0.5 * (1.0 + eta);
    for (int i = 0; i < 3; i++) {
        const double e = xB[i] - xA[i], g = xC[i] - xD[i], f = xD[i] - xA[i], h = xC[i] - xB[i];
        const double a = e + t * (g - e), b = f + s * (h - f), c = g - e, d = (xS[i] - xA[i]) - s * e - t * b;
        aa += a * a;
        ab += a * b;
        bb += b * b;
        ad += a * d;
        bd += b * d;
        dd += d * d;
        ac += a * c;
        bc += b * c;
        cc += c * c;
        cd += c * d;
    }
    /* a and b are twice r_xi and r_eta, c is four times c3: in s and t, from 0 to 1, all of it reads the same. */
    const double r = 0.5 * FOOTPOINT_CHECK_WORST, h12 = ab - cd, determinant = aa * bb - h12 * h12;
    const double high = footpoint_check_larger(aa, bb) + fabs(h12), ac1 = fabs(ac), bc1 = fabs(bc), both = ac1 + bc1;
    const double rounding = FOOTPOINT_CHECK_ROUNDING * high * (aa + bb + cc + dd);
    const double room = r * (determinant - 4.0 * r * (both + cc * r) * high) - rounding;
    const double step_s = fabs(bb * ad - h12 * bd), step_t = fabs(aa * bd - h12 * ad);
    /* how far a shift by r may lower q */
    const double shift = ac1 * bb + bc1 * aa + 2.0 * fabs(h12) * (both + cc) + 4.0 * both * both + cc * (aa + bb);
    const double off = footpoint_check_larger(fabs(s - 0.5), fabs(t - 0.5)), reach = footpoint_check_larger(1.0, off);
    const double least = determinant - (4.0 * r * shift + rounding) * reach;
    const double qt = 2.0 * (bb * ac - h12 * bc), qs = 2.0 * (aa * bc - h12 * ac);
    const int near = (step_s <= room) & (step_t <= room) & !number_outside(rounding * reach);
    const int nearest = ((least - qt * t > 0.0) & (least + qt * (1.0 - t) > 0.0)) |
                        ((least - qs * s > 0.0) & (least + qs * (1.0 - s) > 0.0));
    /* from an answer outside: the Hessian on the way to any point of the segment */
    const double way_s = 0.5 + fabs(s - 0.5), way_t = 0.5 + fabs(t - 0.5);
    const double least_aa = aa - 2.0 * ac1 * way_t, least_bb = bb - 2.0 * bc1 * way_s;
    const double most_ab = fabs(h12) + 2.0 * (ac1 * way_s + bc1 * way_t + cc * way_s * way_t);
    const int alone = (off <= 0.5) | ((least_aa > 0.0) & (least_aa * least_bb > 1.001 * most_ab * most_ab));
    return near & nearest & alone;
}

#endif
