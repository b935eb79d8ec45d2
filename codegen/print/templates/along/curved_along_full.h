/* Where a line meets a curved face, in full. */

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

/* 1 if p is in the plane of the tangents at 16 places: then it is everywhere, as the volume that the three span is of
 * degree 3 in xi and in eta. */
FOOTPOINT_FN int footpoint_detail_KIND_edge_on(const REAL *const *x, const REAL p[3])
{
    const REAL low = NODES > 6 ? -1.0 : 0.0, third = (1.0 - low) / 3.0;
    REAL u[3], v[3], d[3], n[3], across, size;
    int i;
    for (i = 0; i < 16; i++) {
        footpoint_detail_KIND_surface(x, low + third * (REAL)(i & 3), low + third * (REAL)(i >> 2),
                                      u, v, d);
        footpoint_detail_cross(u, v, n);
        across = footpoint_detail_dot(n, p);
        size = footpoint_detail_dot(u, u) * footpoint_detail_dot(v, v) * footpoint_detail_dot(p, p);
        if (across * across > 100.0 * REAL_FLAT * size)
            return 0;
    }
    return 1;
}

/* The face as two polynomials, along two directions at right angles to p and each other.  A line that passes a face of size 1
 * by more than 1e3 passes it by 1e3, so that products stay in the range of numbers. */
FOOTPOINT_FN void footpoint_detail_KIND_seen(const REAL *const *x, const REAL p[3], REAL q[2][9])
{
    REAL c[3][9], e[2][3], far;
    const int least = fabs(p[0]) < fabs(p[1]) ? (fabs(p[2]) < fabs(p[0]) ? 2 : 0)
                                              : (fabs(p[2]) < fabs(p[1]) ? 2 : 1);
    int i, k;
    for (i = 0; i < 3; i++) {
        footpoint_detail_KIND_powers(x, i, c[i]);
        e[0][i] = i == least ? 1.0 : 0.0;
    }
    footpoint_detail_cross(p, e[0], e[1]);
    footpoint_detail_cross(e[1], p, e[0]);
    for (k = 0; k < 2; k++)
        for (i = 0; i < (NODES > 6 ? 9 : 6); i++)
            q[k][i] = e[k][0] * c[0][i] + e[k][1] * c[1][i] + e[k][2] * c[2][i];
    far = 1e-3 * (fabs(q[0][0]) + fabs(q[1][0]));
    for (k = 0; k < 2; k++)
        q[k][0] = far > 1.0 ? q[k][0] / far : q[k][0];
}

/* Where the line meets the surface beyond the edges: of short steps from five places, the first that lead to a point. */
FOOTPOINT_FN int footpoint_detail_KIND_beside(const REAL *const *x, const REAL p[3], REAL at[3])
{
    int i, k;
    for (k = 0; k < 5; k++) {
        REAL y[3], moved = 1.0;
        REAL_BITS flaw = 0;
        footpoint_detail_SHAPE_start(k, y);
        for (i = 0; i < 50 && !(flaw >> REAL_TOP) &&
                    footpoint_detail_above(moved, REAL_MARGIN) >> REAL_TOP;
             i++)
            flaw = footpoint_detail_KIND_along_step(x, p, 0.25, y, &moved);
        if ((flaw | footpoint_detail_above(moved, REAL_MARGIN) |
             footpoint_detail_infinite(y[0] + y[1] + y[2])) >>
                REAL_TOP ||
            footpoint_detail_SHAPE_beyond(y[0], y[1]) <= 0.0)
            continue;
        for (i = 0; i < 3; i++)
            at[i] = y[i];
        return FOOTPOINT_OUTSIDE;
    }
    return FOOTPOINT_ERR_DOMAIN;
}

/* Of the points in the face the nearest one; of none the one less far outside. */
FOOTPOINT_COLD int footpoint_detail_KIND_along_full(const REAL *const *x, const REAL p[3],
                                                    REAL at[3])
{
    REAL q[2][9], found[8][2], best = 0.0;
    int inside = 0, points, i, k;
    if (footpoint_detail_KIND_edge_on(x, p))
        return FOOTPOINT_ERR_DEGENERATE;
    footpoint_detail_KIND_seen(x, p, q);
    points = footpoint_detail_KIND_meets(q, found);
    if (points < 0)
        return FOOTPOINT_ERR_NO_CONVERGENCE;
    for (k = 0; k < points; k++) {
        REAL y[3], moved, over, rank;
        footpoint_detail_SHAPE_start(0, y);
        y[0] += found[k][0];
        y[1] += found[k][1];
        for (i = 0; i < 3; i++)
            (void)footpoint_detail_KIND_along_step(x, p, 0.25, y, &moved);
        over = footpoint_detail_SHAPE_beyond(y[0], y[1]);
        rank = over > 0.0 ? over : fabs(y[2]);
        if (k == 0 || (over > 0.0 ? inside == 0 && rank < best : inside == 0 || rank < best)) {
            best = rank;
            for (i = 0; i < 3; i++)
                at[i] = y[i];
        }
        inside += over <= 0.0;
    }
    if (points == 0)
        return footpoint_detail_KIND_beside(x, p, at);
    return inside > 1 ? FOOTPOINT_NOT_UNIQUE : inside == 1 ? FOOTPOINT_OK : FOOTPOINT_OUTSIDE;
}
