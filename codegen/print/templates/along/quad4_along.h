/* The intersection of a line with the bilinear segment.
 *
 * r = c0 + xi c1 + eta c2 + xi eta c3, d = xS - c0, and [a b] = (a x b) . p, which parts along p do not change. As r
 * and xS differ by a multiple of p,
 *   [c1 c3] xi^2 + ([c1 c2] - [d c3]) xi + [c2 d] = 0,   [c3 c2] eta^2 + ([c1 c2] + [d c3]) eta + [d c1] = 0.
 *
 * Both have the discriminant D, and at a solution J = [r_xi r_eta] = [c1 c2] + [c1 c3] xi + [c3 c2] eta is a root of D;
 * the two solutions have the two roots. J is linear in xi and eta. If its values at the corners have one sign, it has
 * this sign in the segment, and only the solution with this sign of J can lie there. The other solution is the one at
 * which an iteration may end outside.
 *
 * A solution is proved by its residuals in j xi + k2 xi eta = ..., j eta + k1 xi eta = ..., the equations [r c2] and
 * [c1 r], j = [c1 c2], k1 = [c1 c3], k2 = [c3 c2]. */

/* Computes c1, c2, c3 and d, all times 4. */
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

/* Computes the coefficients of both equations, {[c1 c2], [c1 c3], [c3 c2], [d c3], [c2 d], [d c1]}. */
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

/* Returns 4 (xS - r) . p. */
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

/* Bounds rounding errors: of d, over |p|, `away`; of the other vectors, over their size, `units`. Differences of nodes
 * are off by a unit, c1 to c3 by 4, d by 6 and 2 of its own; vectors at right angles to p, their products and sums
 * count for the rest. */
FOOTPOINT_PART REAL footpoint_detail_quad4_rounding(const REAL c1[3], const REAL c2[3],
                                                    const REAL c3[3], const REAL d[3], REAL units)
{
    return footpoint_detail_unit() *
           (20.0 * footpoint_detail_manhattan(d) +
            units * (footpoint_detail_manhattan(c1) + footpoint_detail_manhattan(c2) +
                     footpoint_detail_manhattan(c3)));
}

/* Proves a solution. The highest bit of the result is set unless a solution is proved to lie within the promise of the
 * place at which the equations leave r and s, and no other solution with |xi|, |eta| <= wide. off: rounding errors of
 * the equations there. As a map to xi, eta, r - k2 xi eta and s - k1 xi eta, over j, contract if `room` > 0, in their
 * own norm; then solutions lie within the bound `left`. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_meet(REAL j, REAL k1, REAL k2, REAL r, REAL s,
                                                     const REAL off[2], REAL wide)
{
    const REAL a = wide * fabs(k2) + 2.0 * off[0], b = wide * fabs(k1) + 2.0 * off[1];
    const REAL all = fabs(j), room = all - a - b, most = 0.99 * ALONG_PROMISE * (all * room);
    const REAL first = fabs(r) + off[0], second = fabs(s) + off[1];
    const REAL left = most - 1.01 * ((all - b) * first + a * second);
    const REAL right = most - 1.01 * ((all - a) * second + b * first);
    return footpoint_detail_bits(room) | footpoint_detail_bits(left) |
           footpoint_detail_bits(right) | footpoint_detail_infinite(left + right);
}

/* Finds at = {xi, eta, distance times |p|}, with status FOOTPOINT_OK or FOOTPOINT_OUTSIDE. The highest bit of the
 * result is set unless that is proved: J has one sign in the segment and as far beyond it as (xi, eta) lies. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_along(const REAL *const *x, const REAL p[3],
                                                      REAL at[3], int *status)
{
    REAL c1[3], c2[3], c3[3], d[3], k[6], off[2], root, below_xi, below_eta, over, slope, wide, pp;
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
    wide = 1.002 * (1.0 + footpoint_detail_excess(at[0]) + footpoint_detail_excess(at[1]));
    over = footpoint_detail_manhattan(p) * (wide * wide) *
           footpoint_detail_quad4_rounding(c1, c2, c3, d, 40.0);
    off[0] = over * footpoint_detail_manhattan(c2);
    off[1] = over * footpoint_detail_manhattan(c1);
    *status = (footpoint_detail_above(at[0], 1.0) | footpoint_detail_above(at[1], 1.0)) >> REAL_TOP
                  ? FOOTPOINT_OUTSIDE
                  : footpoint_detail_met();
    return footpoint_detail_quad4_meet(k[0], k[1], k[2], k[4] + at[0] * (k[0] + at[1] * k[2]),
                                       k[5] + at[1] * (k[0] + at[0] * k[1]), off, wide) |
           footpoint_detail_outside(below_xi * below_eta) | footpoint_detail_outside(pp) |
           footpoint_detail_infinite(at[2]);
}

/* Returns the solution of a x^2 + b x + c = 0 for which 2 a x + b is `slope`; 0 if any x is a solution, as on a
 * collapsed edge. */
FOOTPOINT_PART REAL footpoint_detail_root(REAL a, REAL b, REAL c, REAL slope)
{
    if (a == 0.0 && b == 0.0 && c == 0.0)
        return 0.0;
    return b * slope > 0.0 ? -2.0 * c / (b + slope) : (slope - b) / (2.0 * a);
}

/* The highest bit of the result is set unless a solution is proved to lie within the promise of (xi,eta), with J of the
 * sign of `slope`: there, tangents replace c1 and c2, and xS - r replaces d. */
FOOTPOINT_FN REAL_BITS footpoint_detail_quad4_line_near(const REAL c1[3], const REAL c2[3],
                                                        const REAL c3[3], const REAL d[3],
                                                        const REAL p[3], REAL xi, REAL eta,
                                                        REAL slope)
{
    const REAL wide = 1.0 + footpoint_detail_excess(xi) + footpoint_detail_excess(eta);
    const REAL over = footpoint_detail_manhattan(p) * (wide * wide) *
                      footpoint_detail_quad4_rounding(c1, c2, c3, d, 100.0);
    REAL a[3], b[3], e[3], k[6], off[2];
    int i;
    for (i = 0; i < 3; i++) {
        a[i] = c1[i] + eta * c3[i];
        b[i] = c2[i] + xi * c3[i];
        e[i] = d[i] - xi * c1[i] - eta * b[i];
    }
    footpoint_detail_quad4_brackets(a, b, c3, e, p, k);
    off[0] = over * footpoint_detail_manhattan(b);
    off[1] = over * footpoint_detail_manhattan(a);
    return footpoint_detail_quad4_meet(k[0], k[1], k[2], k[4], k[5], off, ALONG_PROMISE) |
           footpoint_detail_bits(k[0] * slope);
}

/* Computes both solutions: z, xi, eta and the distance, their largest xi and eta, and whether a solution is proved to
 * be there. Returns FOOTPOINT_ERR_DOMAIN if there is none. The discriminant is computed in the way, of two, that loses
 * fewer digits, for example near a collapsed edge. */
FOOTPOINT_FN int footpoint_detail_quad4_solve(const REAL c1[3], const REAL c2[3], const REAL c3[3],
                                              const REAL d[3], const REAL p[3], const REAL k[6],
                                              REAL z[2][3], REAL reach[2], int proved[2])
{
    const REAL a = k[0] - k[3], b = k[0] + k[3];
    const REAL discriminant = a * a + fabs(k[1] * k[4]) < b * b + fabs(k[2] * k[5])
                                  ? a * a - 4.0 * (k[1] * k[4])
                                  : b * b - 4.0 * (k[2] * k[5]);
    const REAL size = footpoint_detail_manhattan(c1) + footpoint_detail_manhattan(c2) +
                      footpoint_detail_manhattan(c3);
    const REAL off =
        size * footpoint_detail_manhattan(p) * footpoint_detail_quad4_rounding(c1, c2, c3, d, 40.0);
    const REAL all = footpoint_detail_manhattan(k) + footpoint_detail_manhattan(k + 3) + off;
    const REAL root = sqrt(discriminant > 0.0 ? discriminant : 0.0);
    int i, found = 0;
    if (discriminant + 8.0 * off * all < 0.0)
        return FOOTPOINT_ERR_DOMAIN;
    for (i = 0; i < 2; i++) {
        const REAL slope = i ? -root : root;
        z[i][0] = footpoint_detail_root(k[1], a, k[4], slope);
        z[i][1] = footpoint_detail_root(k[2], b, k[5], slope);
        z[i][2] = 0.25 * footpoint_detail_quad4_ahead(c1, c2, c3, d, p, z[i][0], z[i][1]) /
                  sqrt(footpoint_detail_dot(p, p));
        reach[i] = fabs(z[i][0]) > fabs(z[i][1]) ? fabs(z[i][0]) : fabs(z[i][1]);
        proved[i] = 0;
        if (footpoint_detail_infinite(z[i][0] + z[i][1] + z[i][2]) >> REAL_TOP) {
            reach[i] = 1.0 / REAL_MIN;
            continue;
        }
        found++;
        proved[i] = !(footpoint_detail_quad4_line_near(c1, c2, c3, d, p, z[i][0], z[i][1], slope) >>
                      REAL_TOP);
    }
    return found ? FOOTPOINT_OK : FOOTPOINT_ERR_DOMAIN;
}

/* Returns 1 if `other` cannot lie in the segment, because z is proved with J of the sign in the middle: there J is -J
 * of z, and in the segment it is more. */
FOOTPOINT_FN int footpoint_detail_quad4_excludes(const REAL k[6], const REAL z[3], REAL reach,
                                                 REAL off)
{
    const REAL bends = fabs(k[1]) + fabs(k[2]), turn = k[0] + (k[1] * z[0] + k[2] * z[1]);
    const REAL apart = fabs(k[0]) - bends + fabs(turn);
    return turn * k[0] > 0.0 && apart > 2.0 * ALONG_PROMISE * bends + 3.0 * off * (2.0 + reach);
}

/* Returns 1 if rounding errors may hide that p lies in the planes of the tangents everywhere. */
FOOTPOINT_FN int footpoint_detail_quad4_edge_on(const REAL c1[3], const REAL c2[3],
                                                const REAL c3[3], const REAL p[3], const REAL k[6])
{
    const REAL off =
        footpoint_detail_manhattan(p) * footpoint_detail_quad4_rounding(c1, c2, c3, c3, 40.0);
    const REAL a = footpoint_detail_manhattan(c1), b = footpoint_detail_manhattan(c2);
    const REAL c = footpoint_detail_manhattan(c3);
    return !(fabs(k[0]) > off * (a + b) || fabs(k[1]) > off * (a + c) ||
             fabs(k[2]) > off * (b + c));
}

/* Returns the solution in the segment, the nearer of two there, or otherwise the proved solution less far outside. If
 * both are proved, there is no other. */
FOOTPOINT_COLD int footpoint_detail_quad4_along_full(const REAL *const *x, const REAL p[3],
                                                     REAL at[3])
{
    REAL c1[3], c2[3], c3[3], d[3], k[6], z[2][3], reach[2], size, off;
    int i, best, proved[2], could[2], inside[2], near = 0, surely = 0;
    footpoint_detail_quad4_frame(x, c1, c2, c3, d);
    footpoint_detail_quad4_brackets(c1, c2, c3, d, p, k);
    size =
        footpoint_detail_dot(c1, c1) + footpoint_detail_dot(c2, c2) + footpoint_detail_dot(c3, c3);
    if (footpoint_detail_quad4_edge_on(c1, c2, c3, p, k))
        return FOOTPOINT_ERR_DEGENERATE;
    if (footpoint_detail_quad4_solve(c1, c2, c3, d, p, k, z, reach, proved) != FOOTPOINT_OK)
        return FOOTPOINT_ERR_DOMAIN;
    off = footpoint_detail_manhattan(p) * sqrt(3.0 * size) *
          footpoint_detail_quad4_rounding(c1, c2, c3, c3, 40.0);
    for (i = 0; i < 2; i++) {
        could[i] = !proved[!i] || !footpoint_detail_quad4_excludes(k, z[!i], reach[!i], off);
        inside[i] = could[i] && reach[i] <= 1.0;
        near += could[i] && reach[i] <= 1.0 + ALONG_PROMISE;
        surely += could[i] && reach[i] < 1.0 - ALONG_PROMISE;
    }
    if (inside[0] != inside[1])
        best = inside[1];
    else if (inside[0])
        best = fabs(z[1][2]) < fabs(z[0][2]);
    else
        best = proved[0] == proved[1] ? reach[1] < reach[0] : proved[1];
    for (i = 0; i < 3; i++)
        at[i] = z[best][i];
    if ((could[0] && !proved[0]) || (could[1] && !proved[1]) || (near == 2 && surely < 2))
        return FOOTPOINT_UNPROVED;
    return near == 2      ? FOOTPOINT_NOT_UNIQUE
           : inside[best] ? footpoint_detail_met()
                          : FOOTPOINT_OUTSIDE;
}
