/* The intersection of a line with a curved face, by Newton's steps. */

/* Returns the part of u^2, u v, v^2 and higher powers, for coefficients k of footpoint_detail_KIND_powers(), and its
 * slopes. */
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

/* Bounds the slopes of footpoint_detail_KIND_bend for |u|, |v| <= wide, which is at least reach; |k[3] + k[8] v^2| is
 * largest at v = 0 or wide. Returns a bound of |u + bend| for |u|, |v| <= reach. */
FOOTPOINT_PART REAL footpoint_detail_KIND_bounds(const REAL k[9], REAL reach, REAL wide,
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
    return 1.001 * (reach + reach * reach * all);
}

/* Returns a bound of all rounding errors of a scalar product of the surface with a vector m = b x p for |u|, |v| <= 1,
 * over |b| |p|, for sums of absolute values. Differences of nodes are off by a unit, coefficients by at most 110 of all
 * sizes, together by 300. m, its products and the power series, moved to a part of the face, and the step that begins
 * at rounded u and v count 170 more. For c[0], which contains xS, it is 20. */
FOOTPOINT_PART REAL footpoint_detail_KIND_rounding(REAL c[3][9])
{
    REAL away = 0.0, size = 0.0;
    int i, k;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        away += fabs(c[i][0]);
        FOOTPOINT_UNROLL
        for (k = 1; k < NODES; k++)
            size += fabs(c[i][k]);
    }
    return footpoint_detail_unit() * (20.0 * away + 500.0 * size);
}

/* Returns a bound of the distance of a point from the end of a Newton step, in maximum norms; above `most` if no point
 * is proved. inverse: the norm of the inverse of the slopes at its start; off, bends: bounds of rounding errors of the
 * equations and of the bends' slopes.
 *
 * Second derivatives are at most 5 bends in all, see below, and errors of slopes are part of bends. By Kantorovich, if
 * h = 5 bends inverse (step + 2 error) <= 1/4, with error = inverse off, then a point lies within 0.7 h step + 1.2
 * error: the bounds hold that far if the step is at most 5e-4. The linear equations are solved to 16 units of the step
 * times inverse and the slopes, 2 + bends. */
FOOTPOINT_PART REAL footpoint_detail_KIND_near(REAL step, REAL inverse, REAL off, REAL bends,
                                               REAL most)
{
    const REAL error = 1.01 * inverse * off, units = 16.0 * footpoint_detail_unit();
    const REAL h = 5.1 * bends * inverse * (step + 2.0 * error);
    const REAL near = 0.72 * h * step + 1.25 * error + units * inverse * (2.0 + bends) * step;
    return footpoint_detail_larger(near, (4.2 * h + 2000.0 * step) * most);
}

/* Finds the point at = {u, v} with u + bend = k[0] and v + bend = l[0]: the solution without bends, then a few Newton
 * steps. off: bounds of the rounding errors of both equations for |u|, |v| <= 1. The highest bit of the result is set
 * unless a point is proved to lie within `most` of `at`, and no other point with |u|, |v| <= reach. The highest bit of
 * *hit is set unless it is proved that no point at all lies there. If at[2] <= most, a point is proved to lie within
 * at[2] of `at`; other points may exist.
 *
 * Let bounds of the slopes of u's bend be A, B, of v's C, D for |u|, |v| <= wide. Then u, v -> k[0] - bend, l[0] - bend
 * is a contraction there if A, D < 1 and (1 - A) (1 - D) > B C, in its own norm. So there is at most one point, and a
 * point lies within ((1 - D) r + B s, (1 - A) s + C r) / ((1 - A) (1 - D) - B C) of any place at which the equations
 * are off by r and s. A Newton step leaves half of its square times second derivatives, which are at most 5 (A + B) /
 * wide. The linear equations are solved to 1e5 units of the step, as the determinant is above 0.01; less than a unit
 * and 4e8 units of its square. Errors of coefficients change slopes by twice as much as values, and both grow by the
 * fourth power of wide.
 *
 * By Kantorovich, a point lies within 0.7 h `step` of the end of the last step if h <= 1/4, where h is the step, `most`
 * at first, times the norm of the inverse of the slopes at its start, times the second derivatives. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_meet(const REAL k[9], const REAL l[9],
                                                    const REAL off[2], REAL reach, REAL most,
                                                    REAL at[3], REAL_BITS *hit)
{
    REAL f[2], g[2], u, v, s, t, wide, over, moved = 0.0, step = 0.0, inverse = 0.0, a, d, det;
    int i;
    u = k[0] - footpoint_detail_KIND_bend(k, k[0], l[0], f);
    v = l[0] - footpoint_detail_KIND_bend(l, k[0], l[0], g);
    FOOTPOINT_UNROLL
    for (i = 0; i < (NODES > 6 ? 4 : 3); i++) {
        s = k[0] - u - footpoint_detail_KIND_bend(k, u, v, f);
        t = l[0] - v - footpoint_detail_KIND_bend(l, u, v, g);
        over = 1.0 / ((1.0 + f[0]) * (1.0 + g[1]) - f[1] * g[0]);
        inverse = fabs(over) * footpoint_detail_larger(fabs(1.0 + g[1]) + fabs(f[1]),
                                                       fabs(1.0 + f[0]) + fabs(g[0]));
        f[1] = over * ((1.0 + g[1]) * s - f[1] * t);
        g[0] = over * ((1.0 + f[0]) * t - g[0] * s);
        u += f[1];
        v += g[0];
        moved = f[1] * f[1] + g[0] * g[0];
        step = footpoint_detail_larger(fabs(f[1]), fabs(g[0]));
    }
    at[0] = u;
    at[1] = v;
    wide = 1.002 * footpoint_detail_larger(footpoint_detail_larger(fabs(u), fabs(v)), reach);
    s = fabs(k[0]) - footpoint_detail_KIND_bounds(k, reach, wide, f) - off[0];
    t = fabs(l[0]) - footpoint_detail_KIND_bounds(l, reach, wide, g) - off[1];
    *hit = (footpoint_detail_bits(s) & footpoint_detail_bits(t)) | footpoint_detail_infinite(s + t);
    wide = footpoint_detail_larger(1.0, wide);
    wide *= wide;
    wide *= wide;
    s = wide * off[0];
    t = wide * off[1];
    f[0] += s + s;
    f[1] += s + s;
    g[0] += t + t;
    g[1] += t + t;
    at[2] = footpoint_detail_KIND_near(step, inverse, footpoint_detail_larger(s, t),
                                       footpoint_detail_larger(f[0] + f[1], g[0] + g[1]), most);
    over = 4e8 * footpoint_detail_unit();
    s += (4.0 * (f[0] + f[1]) + over) * moved;
    t += (4.0 * (g[0] + g[1]) + over) * moved;
    a = 1.0 - f[0];
    d = 1.0 - g[1];
    det = a * d - f[1] * g[0];
    u = most * det - 1.01 * (d * s + f[1] * t);
    v = most * det - 1.01 * (a * t + g[0] * s);
    return footpoint_detail_bits(a) | footpoint_detail_bits(det - 0.01) | footpoint_detail_bits(u) |
           footpoint_detail_bits(v) | footpoint_detail_infinite(u + v) |
           footpoint_detail_above(moved, 4e-6);
}

/* Finds at = {xi, eta, distance times |p|}, with status FOOTPOINT_OK or FOOTPOINT_OUTSIDE. c2 x p and p x c1 are at
 * right angles to p; along them, over the product of c1, c2 and p, the equations are u + bend = k[0] and v + bend =
 * l[0]. The highest bit of the result is set if that is not proved, or if the point is so far away that bends, fourth
 * powers, make any step short. The distance may be infinite. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_along(const REAL *const *x, const REAL p[3],
                                                     REAL at[3], int *status)
{
    REAL c[3][9], k[9], l[9], a[3], b[3], m[3], n[3], w[3], off[2], slope[2], across, over, beyond;
    const REAL pp = footpoint_detail_dot(p, p);
    REAL_BITS doubt, hit;
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
    over = fabs(over) * footpoint_detail_manhattan(p) * footpoint_detail_KIND_rounding(c);
    off[0] = over * footpoint_detail_manhattan(b);
    off[1] = over * footpoint_detail_manhattan(a);
    doubt = footpoint_detail_KIND_meet(k, l, off, NODES > 6 ? 1.0 : 2.0 / 3.0, 0.99 * ALONG_PROMISE,
                                       w, &hit);
    footpoint_detail_SHAPE_start(0, at);
    at[0] += w[0];
    at[1] += w[1];
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        at[2] += p[i] * (c[i][0] - w[0] * a[i] - w[1] * b[i] -
                         footpoint_detail_KIND_bend(c[i], w[0], w[1], slope));
    beyond = footpoint_detail_SHAPE_beyond(at[0], at[1]);
    *status = beyond > 0.0 ? FOOTPOINT_OUTSIDE : footpoint_detail_met();
    hit |= footpoint_detail_above(w[2], 0.99 * ALONG_PROMISE) |
           footpoint_detail_bits(beyond - REAL_MIN);
    return (doubt & hit) | footpoint_detail_outside(across) | footpoint_detail_outside(pp) |
           footpoint_detail_above(w[0] * w[0] + w[1] * w[1], 1e4);
}
