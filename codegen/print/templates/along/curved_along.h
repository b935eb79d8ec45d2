/* Where a line meets a curved face, by Newton's steps. */

/* What u^2, u v, v^2 and higher powers add, of coefficients k as footpoint_detail_KIND_powers() has them, and its slopes. */
FOOTPOINT_PART REAL footpoint_detail_KIND_bend(const REAL k[9], REAL u, REAL v, REAL slope[2])
{
    REAL square = k[3], mixed = k[4], more = 0.0, bend;
    if (NODES > 6) {
        const REAL top = NODES > 8 ? v * k[8] : 0.0;
        more = NODES > 8 ? u * (k[6] + top + top) + v * k[7] : u * k[6] + v * k[7];
        square += NODES > 8 ? v * (k[6] + top) : v * k[6];
        mixed += v * k[7];
    }
    bend = u * square + v * mixed;
    slope[0] = bend + u * square;
    slope[1] = u * (NODES > 6 ? mixed + more : mixed) + 2.0 * (v * k[5]);
    return u * bend + v * (v * k[5]);
}

/* Bounds of the slopes of footpoint_detail_KIND_bend where |u|, |v| <= wide, no less than reach; |k[3] + k[8] v^2| is
 * largest where v is 0 or wide.  The highest bit of what it returns is set unless |k[0]| is more than |u + bend| where
 * |u|, |v| <= reach. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_bounds(const REAL k[9], REAL reach, REAL wide,
                                                      REAL slope[2])
{
    const REAL top = NODES > 8 ? 0.5 * (wide * wide * k[8]) : 0.0;
    const REAL u = NODES > 8 ? fabs(k[3] + top) + fabs(top) : fabs(k[3]);
    const REAL v = NODES > 8 ? fabs(k[5] + top) + fabs(top) : fabs(k[5]);
    const REAL a = u + fabs(k[4]);
    REAL all = a + v;
    slope[0] = a + u;
    slope[1] = all - u + v;
    if (NODES > 6) {
        const REAL b = fabs(k[6]) + fabs(k[7]);
        slope[0] += wide * (b + fabs(k[6]));
        slope[1] += wide * (b + fabs(k[7]));
        all += reach * b;
    }
    slope[0] *= wide;
    slope[1] *= wide;
    return footpoint_detail_bits(fabs(k[0]) - 1.001 * (reach + reach * reach * all));
}

/* The point at = {u, v} where u + bend = k[0] and v + bend = l[0].  Bends as they are without bends, then a few of Newton's
 * steps.  The highest bit of what it returns is set unless the last one is shorter than the root of `stands` and no other
 * point with |u|, |v| <= reach is proved to be there.  Proofs: with bounds A, B of the slopes of u's bend and C, D of v's as
 * far as `at` lies, two such points would differ by du and dv where (1 - A) |du| <= B |dv| and (1 - D) |dv| <= C |du|, so
 * that (1 - A) (1 - D) > B C leaves one; or u + bend = k[0] or v + bend = l[0] nowhere within reach, and `at` lies beyond. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_meet(const REAL k[9], const REAL l[9], REAL reach,
                                                    REAL stands, REAL at[2])
{
    REAL f[2], g[2], u, v, s, t, wide, over, moved = 0.0;
    REAL_BITS within;
    int i;
    u = k[0] - footpoint_detail_KIND_bend(k, k[0], l[0], f);
    v = l[0] - footpoint_detail_KIND_bend(l, k[0], l[0], g);
    FOOTPOINT_UNROLL
    for (i = 0; i < (NODES > 6 ? 4 : 3); i++) {
        s = k[0] - u - footpoint_detail_KIND_bend(k, u, v, f);
        t = l[0] - v - footpoint_detail_KIND_bend(l, u, v, g);
        over = 1.0 / ((1.0 + f[0]) * (1.0 + g[1]) - f[1] * g[0]);
        f[1] = over * ((1.0 + g[1]) * s - f[1] * t);
        g[0] = over * ((1.0 + f[0]) * t - g[0] * s);
        u += f[1];
        v += g[0];
        moved = f[1] * f[1] + g[0] * g[0];
    }
    at[0] = u;
    at[1] = v;
    wide = footpoint_detail_larger(footpoint_detail_larger(fabs(u), fabs(v)), reach);
    within = footpoint_detail_KIND_bounds(k, reach, wide, f);
    within &= footpoint_detail_KIND_bounds(l, reach, wide, g);
    over = 1.0 - f[0];
    return footpoint_detail_above(moved, stands) |
           (within & (footpoint_detail_bits(over) |
                      footpoint_detail_bits(over * (1.0 - g[1]) - f[1] * g[0] - 0.01)));
}

/* at = {xi, eta, distance times |p|}; status FOOTPOINT_OK or FOOTPOINT_OUTSIDE.  c2 x p and p x c1 are at right angles to p;
 * along them, over the product of c1, c2 and p, the equations are u + bend = k[0] and v + bend = l[0].  The highest bit of
 * what it returns is set where that does not tell; where the point is so far away that bends, fourth powers, make any step
 * short; and where p is in the plane of c1 and c2.  The distance may be infinite. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_along(const REAL *const *x, const REAL p[3],
                                                     REAL at[3], int *status)
{
    REAL c[3][9], k[9], l[9], a[3], b[3], m[3], n[3], w[2], slope[2], across, over;
    const REAL pp = footpoint_detail_dot(p, p);
    REAL_BITS flaw;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        footpoint_detail_KIND_powers(x, i, c[i]);
        a[i] = c[i][1];
        b[i] = c[i][2];
    }
    footpoint_detail_cross(b, p, m);
    footpoint_detail_cross(p, a, n);
    across = footpoint_detail_dot(a, m);
    over = 1.0 / across;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        m[i] *= over;
        n[i] *= over;
    }
    FOOTPOINT_UNROLL
    for (i = 0; i < (NODES > 6 ? 9 : 6); i++) {
        k[i] = m[0] * c[0][i] + m[1] * c[1][i] + m[2] * c[2][i];
        l[i] = n[0] * c[0][i] + n[1] * c[1][i] + n[2] * c[2][i];
    }
    flaw = footpoint_detail_KIND_meet(k, l, NODES > 6 ? 1.0 : 2.0 / 3.0, REAL_MARGIN, w);
    footpoint_detail_SHAPE_start(0, at);
    at[0] += w[0];
    at[1] += w[1];
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        at[2] += p[i] * (c[i][0] - w[0] * a[i] - w[1] * b[i] -
                         footpoint_detail_KIND_bend(c[i], w[0], w[1], slope));
    over = footpoint_detail_dot(a, a) * footpoint_detail_dot(b, b);
    *status = footpoint_detail_SHAPE_beyond(at[0], at[1]) > 0.0 ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
    return flaw | footpoint_detail_outside(across) | footpoint_detail_outside(pp) |
           footpoint_detail_bits(across * across - 100.0 * REAL_FLAT * (over * pp)) |
           footpoint_detail_above(w[0] * w[0] + w[1] * w[1], 1e4);
}
