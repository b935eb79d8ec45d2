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

/* at = {xi, eta, distance times |p|}; status FOOTPOINT_OK or FOOTPOINT_OUTSIDE.  c2 x p and p x c1 are at right angles to p;
 * along them, over the product of c1, c2 and p, the equations are u + bend = k[0] and v + bend = l[0].  Bends as they are
 * without bends, then a few of Newton's steps.  The highest bit of what it returns is set unless the last one is so short
 * that the next one would be of the size of rounding errors, and the face is far from folded there; not where it is so
 * far away that its bends, fourth powers, make any step short. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_along(const REAL *const *x, const REAL p[3],
                                                     REAL at[3], int *status)
{
    REAL c[3][9], k[9], l[9], a[3], b[3], m[3], n[3], f[2], g[2];
    REAL u, v, s, t, over, folds = 0.0, moved = 0.0, size;
    const REAL pp = footpoint_detail_dot(p, p);
    REAL across;
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
    for (i = 0; i < 9; i++) {
        k[i] = over * (m[0] * c[0][i] + m[1] * c[1][i] + m[2] * c[2][i]);
        l[i] = over * (n[0] * c[0][i] + n[1] * c[1][i] + n[2] * c[2][i]);
    }
    u = k[0] - footpoint_detail_KIND_bend(k, k[0], l[0], f);
    v = l[0] - footpoint_detail_KIND_bend(l, k[0], l[0], g);
    FOOTPOINT_UNROLL
    for (i = 0; i < (NODES > 6 ? 4 : 3); i++) {
        s = k[0] - u - footpoint_detail_KIND_bend(k, u, v, f);
        t = l[0] - v - footpoint_detail_KIND_bend(l, u, v, g);
        folds = (1.0 + f[0]) * (1.0 + g[1]) - f[1] * g[0];
        over = 1.0 / folds;
        f[1] = over * ((1.0 + g[1]) * s - f[1] * t);
        g[0] = over * ((1.0 + f[0]) * t - g[0] * s);
        u += f[1];
        v += g[0];
        moved = f[1] * f[1] + g[0] * g[0];
    }
    footpoint_detail_SHAPE_start(0, at);
    at[0] += u;
    at[1] += v;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        at[2] += p[i] * (c[i][0] - u * a[i] - v * b[i] - footpoint_detail_KIND_bend(c[i], u, v, f));
    size = footpoint_detail_dot(a, a) + footpoint_detail_dot(b, b);
    *status = footpoint_detail_SHAPE_beyond(at[0], at[1]) > 0.0 ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
    return footpoint_detail_outside(across) | footpoint_detail_outside(pp) |
           footpoint_detail_bits(across * across - 100.0 * REAL_FLAT * (size * size * pp)) |
           footpoint_detail_bits(folds - 0.1) | footpoint_detail_above(moved, REAL_MARGIN) |
           footpoint_detail_above(u * u + v * v, 1e4) |
           footpoint_detail_infinite(at[0] + at[1] + at[2]);
}

/* One step of (xi,eta) = at to where xS - r is a multiple of p; at[2] becomes their distance, to second order in the step,
 * whose square is *moved.  The highest bit of what it returns is set if p is in the plane of the tangents. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_along_step(const REAL *const *x, const REAL p[3],
                                                          REAL most, REAL at[3], REAL *moved)
{
    const REAL pp = footpoint_detail_dot(p, p);
    REAL u[3], v[3], d[3], n[3], m[3], across, size, a, b, less;
    footpoint_detail_KIND_surface(x, at[0], at[1], u, v, d);
    footpoint_detail_cross(u, v, n);
    footpoint_detail_cross(p, d, m);
    across = footpoint_detail_dot(n, p);
    size = footpoint_detail_dot(u, u) * footpoint_detail_dot(v, v) * pp;
    a = footpoint_detail_dot(m, v) / across;
    b = -footpoint_detail_dot(m, u) / across;
    *moved = a * a + b * b;
    less = *moved > most ? sqrt(most / *moved) : 1.0;
    at[0] += less * a;
    at[1] += less * b;
    at[2] = footpoint_detail_dot(n, d) / across * sqrt(pp);
    return footpoint_detail_outside(across) |
           footpoint_detail_bits(across * across - 100.0 * REAL_FLAT * size);
}

/* In full: short steps from five points.  Of what they find that in the segment, of two there the nearer one, of none the
 * one less far outside. */
FOOTPOINT_COLD int footpoint_detail_KIND_along_full(const REAL *const *x, const REAL p[3],
                                                    REAL at[3])
{
    int found = FOOTPOINT_ERR_NO_CONVERGENCE, flat = 0, i, k;
    REAL beyond = 0.0;
    for (k = 0; k < 5; k++) {
        REAL y[3], moved = 1.0, over;
        REAL_BITS flaw = 0;
        footpoint_detail_SHAPE_start(k, y);
        for (i = 0; i < 50 && !(flaw >> REAL_TOP) &&
                    footpoint_detail_above(moved, REAL_MARGIN) >> REAL_TOP;
             i++)
            flaw = footpoint_detail_KIND_along_step(x, p, 0.25, y, &moved);
        flat += i == 1 && flaw >> REAL_TOP;
        if ((flaw | footpoint_detail_above(moved, REAL_MARGIN) |
             footpoint_detail_infinite(y[0] + y[1] + y[2])) >>
            REAL_TOP)
            continue;
        over = footpoint_detail_SHAPE_beyond(y[0], y[1]);
        if (found == FOOTPOINT_OK || found == FOOTPOINT_NOT_UNIQUE) {
            const REAL apart = fabs(y[0] - at[0]) + fabs(y[1] - at[1]);
            if (over > 0.0 || apart < 1e-3)
                continue;
            found = FOOTPOINT_NOT_UNIQUE;
            if (fabs(y[2]) > fabs(at[2]))
                continue;
        } else if (found == FOOTPOINT_OUTSIDE && over > beyond)
            continue;
        else
            found = over > 0.0 ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
        beyond = over;
        at[0] = y[0];
        at[1] = y[1];
        at[2] = y[2];
    }
    return flat == 5 ? FOOTPOINT_ERR_DEGENERATE : found;
}
