/* The intersection of a line with a curved face, in full. */

/* Takes one step of (xi,eta) = at to the point at which xS - r is a multiple of p; at[2] becomes their distance, to
 * second order in the step, whose square is *moved. The highest bit of the result is set if p lies in the plane of the
 * tangents. */
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

/* Returns 1 if rounding errors may hide that p lies in the plane of the tangents at 16 places. Then it does everywhere,
 * as the volume that the three span has degree 3 in xi and in eta. Tangents are sums of differences of nodes, times at
 * most 8, to 16 units, and products to 7 more. */
FOOTPOINT_FN int footpoint_detail_KIND_edge_on(const REAL *const *x, const REAL p[3])
{
    const REAL low = NODES > 6 ? -1.0 : 0.0, third = (1.0 - low) / 3.0;
    const REAL unit = footpoint_detail_unit() * footpoint_detail_manhattan(p);
    REAL u[3], v[3], d[3], n[3], edges = 0.0;
    int i, k;
    for (i = 1; i < NODES; i++)
        for (k = 0; k < 3; k++)
            edges += fabs(x[i][k] - x[0][k]);
    for (i = 0; i < 16; i++) {
        footpoint_detail_KIND_surface(x, low + third * (REAL)(i & 3), low + third * (REAL)(i >> 2),
                                      u, v, d);
        footpoint_detail_cross(u, v, n);
        if (fabs(footpoint_detail_dot(n, p)) >
            200.0 * unit * edges * (footpoint_detail_manhattan(u) + footpoint_detail_manhattan(v)))
            return 0;
    }
    return 1;
}

/* Computes the face as two polynomials, along two directions at right angles to p and to each other, with lengths of p
 * or its square. Returns 1 if one of them is nowhere 0 on the face. */
FOOTPOINT_FN int footpoint_detail_KIND_seen(const REAL *const *x, const REAL p[3],
                                            footpoint_detail_KIND_view *s)
{
    const REAL length = footpoint_detail_manhattan(p);
    REAL c[3][9], e[2][3];
    const int least = fabs(p[0]) < fabs(p[1]) ? (fabs(p[2]) < fabs(p[0]) ? 2 : 0)
                                              : (fabs(p[2]) < fabs(p[1]) ? 2 : 1);
    int i, k, beside = 0;
    for (i = 0; i < 3; i++) {
        footpoint_detail_KIND_powers(x, i, c[i]);
        e[0][i] = i == least ? 1.0 : 0.0;
    }
    footpoint_detail_cross(p, e[0], e[1]);
    footpoint_detail_cross(e[1], p, e[0]);
    s->off = length * (1.0 + length) * footpoint_detail_KIND_rounding(c);
    s->n = 0;
    for (k = 0; k < 2; k++) {
        REAL most = s->off;
        for (i = 0; i < 9; i++)
            s->q[k][i] =
                i < NODES ? e[k][0] * c[0][i] + e[k][1] * c[1][i] + e[k][2] * c[2][i] : 0.0;
        for (i = 1; i < 9; i++)
            most += 1.001 * fabs(s->q[k][i]);
        beside |= fabs(s->q[k][0]) > most;
    }
    return beside;
}

/* Takes up to 50 short steps from `at` to the point at which the line meets the surface. The highest bit of the result
 * is set if they do not converge. */
FOOTPOINT_FN REAL_BITS footpoint_detail_KIND_walk(const REAL *const *x, const REAL p[3], REAL at[3])
{
    REAL moved = 1.0;
    REAL_BITS flaw = 0;
    int i;
    for (i = 0; i < 50 && (footpoint_detail_above(moved, REAL_MARGIN) & ~flaw) >> REAL_TOP; i++)
        flaw = footpoint_detail_KIND_along_step(x, p, 0.25, at, &moved);
    return flaw | footpoint_detail_above(moved, REAL_MARGIN) |
           footpoint_detail_infinite(at[0] + at[1] + at[2]);
}

/* Sets at[2] to the distance at (xi,eta) = at. */
FOOTPOINT_FN void footpoint_detail_KIND_ahead(const REAL *const *x, const REAL p[3], REAL at[3])
{
    REAL u[3], v[3], d[3];
    footpoint_detail_KIND_surface(x, at[0], at[1], u, v, d);
    at[2] = footpoint_detail_dot(p, d) / sqrt(footpoint_detail_dot(p, p));
}

/* Returns 1 if a point of the surface is proved to lie within the promise, times |at| if that is above 1, of `at`,
 * which moves to the proved place: as in parts of the face, in smaller parts if a larger part fails. Rounding errors
 * grow as the highest powers of u and v. */
FOOTPOINT_COLD int footpoint_detail_KIND_beyond(const footpoint_detail_KIND_view *s, REAL at[3])
{
    footpoint_detail_KIND_view far = *s;
    REAL from[3], to[2], wide, half, most;
    int i;
    footpoint_detail_SHAPE_start(0, from);
    wide = footpoint_detail_larger(fabs(at[0] - from[0]), fabs(at[1] - from[1]));
    wide = footpoint_detail_larger(1.0, 1.1 * wide);
    most = footpoint_detail_larger(fabs(at[0]), fabs(at[1]));
    most = 0.99 * ALONG_PROMISE * footpoint_detail_larger(1.0, most);
    far.off *= NODES > 6 ? wide * wide * (wide * wide) : wide * wide;
    for (half = 0.05 * wide, i = 0; i < 4; half /= 16.0, i++)
        if (footpoint_detail_KIND_line_about(&far, at[0] - from[0], at[1] - from[1], half,
                                             most / half, to) == 1) {
            at[0] = from[0] + to[0];
            at[1] = from[1] + to[1];
            return footpoint_detail_SHAPE_beyond(at[0], at[1]) > 0.0;
        }
    return 0;
}

/* Finds a point at which the line meets the surface beyond the edges: the first of the steps from five places that lead
 * to a proved point. */
FOOTPOINT_FN int footpoint_detail_KIND_beside(const REAL *const *x, const REAL p[3],
                                              const footpoint_detail_KIND_view *s, REAL at[3])
{
    int k;
    for (k = 0; k < 5; k++) {
        footpoint_detail_SHAPE_start(k, at);
        if (footpoint_detail_KIND_walk(x, p, at) >> REAL_TOP ||
            footpoint_detail_SHAPE_beyond(at[0], at[1]) <= 0.0 ||
            !footpoint_detail_KIND_beyond(s, at))
            continue;
        footpoint_detail_KIND_ahead(x, p, at);
        return FOOTPOINT_OUTSIDE;
    }
    return FOOTPOINT_ERR_DOMAIN;
}

/* Computes (xi,eta) and the distance of a found point. Beyond the edges, or without a proof, it takes steps from there
 * and uses their end if they converge. */
FOOTPOINT_FN void footpoint_detail_KIND_place(const REAL *const *x, const REAL p[3],
                                              const REAL found[3], REAL at[3])
{
    const REAL half = 0.5 * ALONG_PROMISE;
    REAL y[3];
    footpoint_detail_SHAPE_start(0, at);
    at[0] += found[0];
    at[1] += found[1];
    y[0] = at[0];
    y[1] = at[1];
    y[2] = 0.0;
    if ((found[2] > 0.0 || footpoint_detail_SHAPE_beyond(at[0], at[1]) > 4.0 * half) &&
        !(footpoint_detail_KIND_walk(x, p, y) >> REAL_TOP) &&
        (found[2] > 0.0 || (fabs(y[0] - at[0]) <= half && fabs(y[1] - at[1]) <= half))) {
        at[0] = y[0];
        at[1] = y[1];
    }
    footpoint_detail_KIND_ahead(x, p, at);
}

/* Returns the nearest point in the face, or otherwise the point least far outside. Points near an edge may be on either
 * side; if there are several, they are no answer. */
FOOTPOINT_COLD int footpoint_detail_KIND_along_full(const REAL *const *x, const REAL p[3],
                                                    REAL at[3])
{
    footpoint_detail_KIND_view s;
    REAL best = 0.0, doubt = 0.0;
    int inside = 0, maybe = 0, surely = 0, i, k;
    if (footpoint_detail_KIND_edge_on(x, p))
        return FOOTPOINT_ERR_DEGENERATE;
    if (!footpoint_detail_KIND_seen(x, p, &s))
        footpoint_detail_KIND_meets(&s);
    for (k = 0; k < s.n; k++) {
        REAL y[3], over, rank;
        footpoint_detail_KIND_place(x, p, s.found[k], y);
        over = footpoint_detail_SHAPE_beyond(y[0], y[1]);
        rank = over > 0.0 ? over : fabs(y[2]);
        if (k == 0 || (over > 0.0 ? inside == 0 && rank < best : inside == 0 || rank < best)) {
            best = rank;
            for (i = 0; i < 3; i++)
                at[i] = y[i];
        }
        doubt += s.found[k][2];
        inside += over <= 0.0;
        maybe += over <= 2.0 * ALONG_PROMISE;
        surely += over < -2.0 * ALONG_PROMISE;
    }
    if (s.n == 0)
        return footpoint_detail_KIND_beside(x, p, &s, at);
    if (doubt > 0.0 || (maybe > 1 && surely < 2))
        return FOOTPOINT_UNPROVED;
    return maybe > 1 ? FOOTPOINT_NOT_UNIQUE : inside ? footpoint_detail_met() : FOOTPOINT_OUTSIDE;
}
