/* Steps to a foot point, proved from scalar products that a search has. */

/* What the proof knows of the vectors of r = c0 + xi a + eta b + xi eta c and d = xS - c0, `over` of the d here: size = a . a +
 * b . b + c . c, and of what their rounding errors are.  Coordinates of a are off by some units of rounding of those of |a| + |c| + 0.08 |b|,
 * of b, of |b| + |c| + 0.08 |a|, of c, of those with twist = 1, of these with 2, of both with 3; of d, of |a| + |b| + |c| + |d|; products
 * of two, by as many units as `rounding`, less 10, has, of the product of what bounds the two, where that of d has 0.4 (|a| + |b| +
 * |c|) + |d|. */
typedef struct {
    const REAL *a, *b, *c, *d;
    REAL over, size, rounding;
    int twist;
} footpoint_detail_quad4_vectors;

/* Not less than the root of x >= 0, and at most 1.061 times that: half of its exponent, as logarithms have it. */
FOOTPOINT_PART REAL footpoint_detail_root_bound(REAL x)
{
    union {
        REAL number;
        REAL_BITS bits;
    } both;
    both.bits = (footpoint_detail_bits(x) >> 1) + (footpoint_detail_bits(1.0) >> 1);
    return both.number;
}

/* A bound on P T, see footpoint_detail_quad4_step(), by row through |H^-1|, with |xi| and |eta| up to p and q; of Euclidean
 * norms, by Cauchy and Schwarz. */
FOOTPOINT_PART REAL footpoint_detail_quad4_off(const REAL products[9],
                                               const footpoint_detail_quad4_vectors *r, REAL p,
                                               REAL q, REAL uu, REAL mixed, REAL vv)
{
    const REAL a = footpoint_detail_root_bound(products[0]);
    const REAL b = footpoint_detail_root_bound(products[2]);
    const REAL c = footpoint_detail_root_bound(products[5]);
    const REAL first = a + c + 0.08 * b, second = b + c + 0.08 * a;
    const REAL turn = r->twist == 1 ? first : r->twist == 2 ? second : first + second;
    const REAL u = first + q * turn, v = second + p * turn;
    const REAL d = fabs(r->over) * footpoint_detail_root_bound(footpoint_detail_dot(r->d, r->d));
    const REAL far = d + 0.4 * (first + second) + p * first + q * v;
    return far * footpoint_detail_greater(vv * u + mixed * v, uu * v + mixed * u);
}

/* A step of third order, of second for promises from 1e-3 on, to the foot point, by xi and eta, from products[] = a a, a b, b b,
 * a c, b c, c c, a d, b d, c d.  The highest bit of the result is not set if a minimum of the distance is proved to lie within
 * `promise` of the answer.
 *
 * F = (r_xi . D, r_eta . D), D = xS - r, has the Jacobian -H, H = [uu r12; r12 vv].  Newton's step s = H^-1 F leaves N(s) of F, a
 * polynomial; x = -H^-1 N(s) is the correction.  In maximum norms, beta = |H^-1|; in a ball of 1/3 about the start H has the
 * Lipschitz constant L = 4 (|r_xi . c| + |r_eta . c|) + 2 c . c.  R bounds rounding.  Let h = beta L (|s| + 2 |x| + 2 R); in the ball
 * of that radius |1 - H^-1 H(y)| <= h, so that Newton's iteration with H kept contracts.  Its next correction, at most h |x| + R,
 * bounds the distance of the answer from a root within a factor of 1 / (1 - h), and H is positive definite all the way there.
 * Without the correction, |s| / 3 stands for |x|: the next one is at most beta L |s|^2 / 2 + R.
 *
 * R: with P' = |a| + ..., what bounds the errors of coordinates of r_xi, Q' of r_eta, C' of c, T' of D as |d| + |xi a| + ..., the
 * products give F's row xi within k units of P' T', and its polynomials add 6, H's within k + 6 units of P' P' and of P' Q' + C' T'.
 * With Cramer's rule, 5 more, H s is off by (k + 11) |s| units of P' (P' + Q') + C' T', and by N's rounding, as 2 |s| |c| is in P',
 * 1.25 times that again: in all by (k + 6) units of P' T' + 4 |s| (P' (P' + Q') + C' T').  P' and T' of |xi| and |eta| longer by 6 |s|
 * contain that: P' grows by 4 |s| C', T' by 4 |s| (P' + Q').  Off the finest promises a coarser bound is enough, of |s| < 1/6.  0.2,
 * 1.4 and 1.3 leave for rounding errors of beta, h and the determinant, which are 9 R at most, what 0.25 and 1 / (1 - 0.25) allow. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_step(const REAL products[9],
                                                     const footpoint_detail_quad4_vectors *r,
                                                     REAL promise, REAL *xi, REAL *eta)
{
    const REAL e11 = products[0], e12 = products[1] - products[8], e22 = products[2],
               c1 = products[3];
    const REAL c2 = products[4], cc = products[5], p = *xi, q = *eta;
    const REAL tu = c1 + q * cc, tv = c2 + p * cc, u = e11 + q * c1, v = e22 + p * c2;
    const REAL z = (e12 + p * c1) + q * tv, uu = u + q * tu, vv = v + p * tv;
    const REAL r12 = (e12 + 2.0 * p * c1) + 2.0 * q * tv, mixed = fabs(r12);
    const REAL f = (products[6] - p * u) - q * z, g = (products[7] - q * v) - p * z;
    const REAL per = 1.0 / (uu * vv - r12 * r12);
    const REAL s = (vv * f - r12 * g) * per, t = (uu * g - r12 * f) * per;
    const REAL step = footpoint_detail_greater(fabs(s), fabs(t));
    const REAL beta = (footpoint_detail_greater(fabs(uu), fabs(vv)) + mixed) * per;
    REAL off, left = step * (1.0 / 3.0), h, room, other;
    if (promise < 1e-9)
        off = per * footpoint_detail_quad4_off(products, r, fabs(p) + 6.0 * step,
                                               fabs(q) + 6.0 * step, uu, mixed, vv);
    else
        off = beta * (2.0 * (r->over * r->over * footpoint_detail_dot(r->d, r->d)) +
                      (1.0 + p * p) * (1.0 + q * q) * (300.0 * r->size));
    off *= r->rounding - 4.5e-16;
    *xi = p + s;
    *eta = q + t;
    if (promise < 1e-3) {
        const REAL both = cc * s, h12 = r12 * per;
        const REAL m = t * ((2.0 * tu * s + tv * t) + both * t);
        const REAL n = s * ((2.0 * tv * t + tu * s) + both * t);
        const REAL x = h12 * n - (vv * per) * m, y = h12 * m - (uu * per) * n;
        left = footpoint_detail_greater(fabs(x), fabs(y));
        *xi += x;
        *eta += y;
    }
    h = beta * (4.0 * (fabs(tu) + fabs(tv)) + 2.0 * cc) * (step + 2.0 * (left + off));
    room = 0.999 * promise - (1.4 * h * left + 1.3 * off);
    other = 0.2 - (h + 1.2 * step + 200.0 * off);
    return footpoint_detail_bits(room) | footpoint_detail_bits(other) | footpoint_detail_bits(per) |
           footpoint_detail_infinite(room) | footpoint_detail_fast();
}

/* Steps until one is proved, or they are too short to matter, up to four, of finite xi and eta; in a loop over arrays, fixed = 1 or 2 of them, with the same answer where
 * these are enough. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_steps(const REAL products[9],
                                                      const footpoint_detail_quad4_vectors *r,
                                                      REAL promise, int fixed, REAL *xi, REAL *eta)
{
    REAL_BITS doubt = footpoint_detail_infinite(*xi + *eta);
    int k = 0;
    if (fixed) {
        const REAL p = *xi, q = *eta;
        REAL u, v;
        REAL_BITS still;
        doubt = footpoint_detail_quad4_step(products, r, promise, xi, eta);
        if (fixed < 2)
            return doubt;
        u = *xi;
        v = *eta;
        /* as below: if the first step was that short, the second is none */
        still = footpoint_detail_bits(fabs(u - p) + fabs(v - q) - 0.01 * promise);
        still |= footpoint_detail_quad4_step(products, r, promise, &u, &v);
        *xi = doubt >> REAL_TOP ? u : *xi;
        *eta = doubt >> REAL_TOP ? v : *eta;
        return doubt & still;
    }
    while (!(doubt >> REAL_TOP) && k++ < 4) {
        const REAL u = *xi, v = *eta;
        const REAL_BITS unproved = footpoint_detail_quad4_step(products, r, promise, xi, eta);
        if (!(unproved >> REAL_TOP))
            return unproved;
        doubt = footpoint_detail_infinite(*xi + *eta) |
                footpoint_detail_bits(fabs(*xi - u) + fabs(*eta - v) - 0.01 * promise);
    }
    /* where products have lost too many digits, vectors have not; their own rounding is 8 units more than (k - 3) / 2 */
    if (promise < 1e-9 && !(footpoint_detail_infinite(*xi + *eta) >> REAL_TOP))
        return footpoint_detail_quad4_prove(r->a, r->b, r->c, r->d, r->over, 0.65 * r->rounding,
                                            promise, xi, eta);
    return (REAL_BITS)1 << REAL_TOP;
}
