/* A step to a foot point, proved from scalar products of a search. */

/* Bounds P T and Q T, times `rounding`, see footpoint_detail_quad4_step(), for |xi| and |eta| up to p and q, in
 * Euclidean norms, by Cauchy and Schwarz, from the bounds on coordinates that footpoint_detail_quad4_vectors has. With
 * r->rounding they bound the errors of the slopes r_xi . D and r_eta . D of vectors: tangents are off by k + 2 units of
 * their bounds, D by k + 5 of T and half of |a| + |b| + |c|, the scalar product adds 3, and `rounding` has at least 2 k
 * + 13. */
FOOTPOINT_PART void footpoint_detail_quad4_off(const REAL products[9],
                                               const footpoint_detail_quad4_vectors *r,
                                               REAL rounding, REAL p, REAL q, REAL *f, REAL *g)
{
    const REAL a = footpoint_detail_root_bound(products[0]);
    const REAL b = footpoint_detail_root_bound(products[2]);
    const REAL c = footpoint_detail_root_bound(products[5]);
    const REAL first = a + c + 0.08 * b, second = b + c + 0.08 * a;
    const REAL turn = r->twist == 1 ? first : r->twist == 2 ? second : first + second;
    const REAL u = first + q * turn, v = second + p * turn;
    const REAL d = fabs(r->over) * footpoint_detail_root_bound(footpoint_detail_dot(r->d, r->d));
    const REAL far = rounding * (d + 0.5 * (first + second) + p * first + q * v);
    *f = u * far;
    *g = v * far;
}

/* Takes a step of third order, of second for promises from 1e-3 on, to the foot point, by xi and eta, from products[] =
 * a a, a b, b b, a c, b c, c c, a d, b d, c d. The highest bit of the result is not set if a minimum of the distance is
 * proved to lie within `promise` of the answer.
 *
 * F = (r_xi . D, r_eta . D), D = xS - r, has the Jacobian -H, H = [uu r12; r12 vv]. Newton's step s = H^-1 F leaves
 * N(s) of F, a polynomial; x = -H^-1 N(s) is the correction. In maximum norms, beta = |H^-1|; in a ball of 1/3 about
 * the start H has the Lipschitz constant L = 4 (|r_xi . c| + |r_eta . c|) + 2 c . c. R bounds rounding. Let h = beta L
 * (|s| + 2 |x| + 2 R). In the ball of that radius |1 - H^-1 H(y)| <= h, so Newton's iteration with H kept contracts.
 * Its next correction, at most h |x| + R, bounds the distance of the answer from a root within a factor of 1 / (1 - h),
 * and H is positive definite on the whole way there. Without the correction, |s| / 3 replaces |x|: the next correction
 * is at most beta L |s|^2 / 2 + R.
 *
 * R: let P = |a| + ... bound the errors of coordinates of r_xi, Q of r_eta, C of c, T of D as |d| + |xi a| + .... The
 * products yield F's row xi within k units of P T, and its polynomials add 6, H's within k + 6 units of P P and of P Q
 * + C T. With Cramer's rule, 5 more, H s is off by (k + 11) |s| units of P (P + Q) + C T, and by N's rounding, as 2 |s|
 * |c| is in P, 1.25 times that again: in all by (k + 6) units of P T + 4 |s| (P (P + Q) + C T). P and T for |xi| and
 * |eta| longer by 6 |s| contain that: P grows by 4 |s| C, T by 4 |s| (P + Q). Except for the finest promises a coarser
 * bound for |s| < 1/6 suffices. 0.2, 1.4 and 1.3 leave the margin of 0.25 and 1 / (1 - 0.25) for rounding errors of
 * beta, h and the determinant, which are at most 9 R. */
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
    const REAL step = footpoint_detail_greater_of(r->masked, fabs(s), fabs(t));
    const REAL beta = (footpoint_detail_greater_of(r->masked, fabs(uu), fabs(vv)) + mixed) * per;
    const REAL rounding = r->rounding - 4.0 * REAL_UNIT; /* k + 6 */
    REAL off, left = step * (1.0 / 3.0), h, room, other;
    if (promise < 1e-9) {
        REAL off_f, off_g;
        footpoint_detail_quad4_off(products, r, rounding, fabs(p) + 6.0 * step,
                                   fabs(q) + 6.0 * step, &off_f, &off_g);
        off = per * footpoint_detail_greater_of(r->masked, vv * off_f + mixed * off_g,
                                                uu * off_g + mixed * off_f);
    } else
        off = beta * rounding *
              (2.0 * (r->over * r->over * footpoint_detail_dot(r->d, r->d)) +
               (1.0 + p * p) * (1.0 + q * q) * (300.0 * r->size));
    *xi = p + s;
    *eta = q + t;
    if (promise < 1e-3) {
        const REAL both = cc * s, h12 = r12 * per;
        const REAL m = t * ((2.0 * tu * s + tv * t) + both * t);
        const REAL n = s * ((2.0 * tv * t + tu * s) + both * t);
        const REAL x = h12 * n - (vv * per) * m, y = h12 * m - (uu * per) * n;
        left = footpoint_detail_greater_of(r->masked, fabs(x), fabs(y));
        *xi += x;
        *eta += y;
    }
    h = beta * (4.0 * (fabs(tu) + fabs(tv)) + 2.0 * cc) * (step + 2.0 * (left + off));
    room = 0.999 * promise - (1.4 * h * left + 1.3 * off);
    other = 0.2 - (h + 1.2 * step + 200.0 * off);
    return footpoint_detail_bits(room) | footpoint_detail_bits(other) | footpoint_detail_bits(per) |
           footpoint_detail_infinite(room) | footpoint_detail_fast();
}
