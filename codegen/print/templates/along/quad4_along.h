/* Where a line meets the bilinear segment.
 *
 * r = c0 + xi c1 + eta c2 + xi eta c3, d = xS - c0, and [a b] = (a x b) . p, which the direction p has no part in: as r
 * and xS differ by a multiple of p,
 *     [c1 c3] xi^2 + ([c1 c2] - [d c3]) xi + [c2 d] = 0,   [c3 c2] eta^2 + ([c1 c2] + [d c3]) eta + [d c1] = 0.
 * Both have the discriminant D, and at a solution J = [r_xi r_eta] = [c1 c2] + [c1 c3] xi + [c3 c2] eta is a root of D,
 * the two solutions have the two.  J is linear in xi and eta: where its values at the corners have one sign, so it has in
 * the segment, and of the two solutions that with J of this sign alone can lie there; the other one is what an iteration
 * may end at outside. */

/* c1, c2, c3 and d, all times 4. */
FOOTPOINT_PART void footpoint_detail_quad4_frame(const REAL *const *x, REAL c1[3], REAL c2[3],
                                                 REAL c3[3], REAL d[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        const REAL ab = x[1][i] - x[0][i], dc = x[2][i] - x[3][i];
        const REAL ad = x[3][i] - x[0][i], as = x[4][i] - x[0][i];
        c1[i] = dc + ab;
        c3[i] = dc - ab;
        c2[i] = ad + ad + c3[i];
        d[i] = 4.0 * as - (c1[i] + ad + ad);
    }
}

/* The coefficients of both equations, {[c1 c2], [c1 c3], [c3 c2], [d c3], [c2 d], [d c1]}. */
FOOTPOINT_PART void footpoint_detail_quad4_brackets(const REAL c1[3], const REAL c2[3],
                                                    const REAL c3[3], const REAL d[3],
                                                    const REAL p[3], REAL k[6])
{
    REAL m1[3], m2[3], m3[3];
    footpoint_detail_cross(c1, p, m1);
    footpoint_detail_cross(c2, p, m2);
    footpoint_detail_cross(c3, p, m3);
    k[0] = footpoint_detail_dot(c1, m2);
    k[1] = footpoint_detail_dot(c1, m3);
    k[2] = footpoint_detail_dot(c3, m2);
    k[3] = footpoint_detail_dot(d, m3);
    k[4] = -footpoint_detail_dot(d, m2);
    k[5] = footpoint_detail_dot(d, m1);
}

/* 4 (xS - r) . p */
FOOTPOINT_PART REAL footpoint_detail_quad4_ahead(const REAL c1[3], const REAL c2[3],
                                                 const REAL c3[3], const REAL d[3], const REAL p[3],
                                                 REAL xi, REAL eta)
{
    REAL ahead = 0.0;
    int i;
    for (i = 0; i < 3; i++)
        ahead += p[i] * (d[i] - xi * c1[i] - eta * (c2[i] + xi * c3[i]));
    return ahead;
}

/* at = {xi, eta, distance times |p|}; status FOOTPOINT_OK or FOOTPOINT_OUTSIDE.  The highest bit of what it returns is set unless J
 * is far from 0 and has one sign in the segment and as far beyond it as (xi, eta) lies. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_along(const REAL *const *x, const REAL p[3],
                                                      REAL at[3], int *status)
{
    REAL c1[3], c2[3], c3[3], d[3], k[6], root, below_xi, below_eta, over, slope, size, pp;
    footpoint_detail_quad4_frame(x, c1, c2, c3, d);
    footpoint_detail_quad4_brackets(c1, c2, c3, d, p, k);
    slope = k[0] + k[3];
    root = fabs(k[0]) * sqrt(slope * slope - 4.0 * (k[2] * k[5]));
    below_xi = k[0] * (k[0] - k[3]) + root;
    below_eta = k[0] * slope + root;
    over = -2.0 * k[0] / (below_xi * below_eta);
    at[0] = k[4] * (below_eta * over);
    at[1] = k[5] * (below_xi * over);
    pp = footpoint_detail_dot(p, p);
    at[2] = 0.25 * footpoint_detail_quad4_ahead(c1, c2, c3, d, p, at[0], at[1]);
    size = footpoint_detail_dot(c1, c1) + footpoint_detail_dot(c2, c2);
    *status = FOOTPOINT_OUTSIDE *
              (int)((footpoint_detail_above(at[0], 1.0) | footpoint_detail_above(at[1], 1.0)) >>
                    REAL_TOP);
    return footpoint_detail_outside(below_xi * below_eta) | footpoint_detail_outside(pp) |
           footpoint_detail_infinite(at[0] + at[1] + at[2]) |
           footpoint_detail_bits(k[0] * k[0] - 100.0 * REAL_FLAT * (size * size * pp)) |
           footpoint_detail_bits(fabs(k[0]) - 1.0001 * (fabs(k[1]) + fabs(k[2])) *
                                                  (1.0 + footpoint_detail_excess(at[0]) +
                                                   footpoint_detail_excess(at[1])));
}

/* A solution of a x^2 + b x + c = 0 where 2 a x + b is `slope`; 0 where any x is one, as on a collapsed edge. */
FOOTPOINT_PART REAL footpoint_detail_root(REAL a, REAL b, REAL c, REAL slope)
{
    if (a == 0.0 && b == 0.0 && c == 0.0)
        return 0.0;
    return b * slope > 0.0 ? -2.0 * c / (b + slope) : (slope - b) / (2.0 * a);
}

/* Both solutions in full: that in the segment, of two there the nearer one, of none the one less far outside.  Of the two
 * ways to compute the discriminant the one that loses fewer digits, as near a collapsed edge. */
FOOTPOINT_COLD int footpoint_detail_quad4_along_full(const REAL *const *x, const REAL p[3],
                                                     REAL at[3])
{
    REAL c1[3], c2[3], c3[3], d[3], k[6], z[2][3], reach[2], length, size, wide, a, b, discriminant;
    int i, found = 0, inside[2], best;
    footpoint_detail_quad4_frame(x, c1, c2, c3, d);
    footpoint_detail_quad4_brackets(c1, c2, c3, d, p, k);
    length = sqrt(footpoint_detail_dot(p, p));
    size =
        footpoint_detail_dot(c1, c1) + footpoint_detail_dot(c2, c2) + footpoint_detail_dot(c3, c3);
    wide = fabs(k[0]) + fabs(k[1]) + fabs(k[2]);
    if (footpoint_detail_bits(wide * wide - 10.0 * REAL_FLAT * (size * size) * (length * length)) >>
        REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    a = k[0] - k[3];
    b = k[0] + k[3];
    discriminant = a * a + fabs(k[1] * k[4]) < b * b + fabs(k[2] * k[5])
                       ? a * a - 4.0 * (k[1] * k[4])
                       : b * b - 4.0 * (k[2] * k[5]);
    if (discriminant < 0.0)
        return FOOTPOINT_ERR_DOMAIN;
    for (i = 0; i < (discriminant > 0.0 ? 2 : 1); i++) {
        const REAL slope = i ? -sqrt(discriminant) : sqrt(discriminant);
        REAL *const y = z[found];
        y[0] = footpoint_detail_root(k[1], a, k[4], slope);
        y[1] = footpoint_detail_root(k[2], b, k[5], slope);
        y[2] = 0.25 * footpoint_detail_quad4_ahead(c1, c2, c3, d, p, y[0], y[1]) / length;
        reach[found] = fabs(y[0]) > fabs(y[1]) ? fabs(y[0]) : fabs(y[1]);
        inside[found] = reach[found] <= 1.0;
        found += !((footpoint_detail_infinite(y[0]) | footpoint_detail_infinite(y[1]) |
                    footpoint_detail_infinite(y[2])) >>
                   REAL_TOP);
    }
    if (found == 0)
        return FOOTPOINT_ERR_DOMAIN;
    best = found == 2 &&
           (inside[0] && inside[1] ? fabs(z[1][2]) < fabs(z[0][2]) : reach[1] < reach[0]);
    for (i = 0; i < 3; i++)
        at[i] = z[best][i];
    if (!inside[best])
        return FOOTPOINT_OUTSIDE;
    return found == 2 && inside[0] && inside[1] ? FOOTPOINT_NOT_UNIQUE : FOOTPOINT_OK;
}
