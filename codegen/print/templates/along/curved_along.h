/* Where a line meets a curved face, by Newton's steps. */

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

/* at = {xi, eta, distance}; status FOOTPOINT_OK or FOOTPOINT_OUTSIDE.  The highest bit of what it returns is set unless
 * the last of up to five steps from the middle is so short that the next one would be of the size of rounding errors. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_along(const REAL *const *x, const REAL p[3],
                                                     REAL at[3], int *status)
{
    REAL_BITS flaw = 0;
    REAL moved = 1.0;
    int k;
    footpoint_detail_SHAPE_start(0, at);
    for (k = 0; k < 5 && footpoint_detail_above(moved, REAL_MARGIN) >> REAL_TOP; k++)
        flaw = footpoint_detail_KIND_along_step(x, p, 4.0, at, &moved);
    *status = footpoint_detail_SHAPE_beyond(at[0], at[1]) > 0.0 ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
    return flaw | footpoint_detail_above(moved, REAL_MARGIN) |
           footpoint_detail_infinite(at[0] + at[1] + at[2]);
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
