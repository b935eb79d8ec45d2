/* Edges of two nodes: all results are exact to rounding. */

/* Projects S.  With e = B - A and d = S - A, (xi + 1) / 2 is d.e / e.e.  Differences are off by one unit of rounding,
 * products by two more.  The sums of products, one term of which cancels, and the quotient are off by at most ten
 * units of the sum of the absolute values. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge2_project(const REAL *const *x, REAL promise,
                                                        REAL e[2], REAL d[2], REAL *xi)
{
    REAL ee, terms, per, room, reach;
    e[0] = x[1][0] - x[0][0];
    e[1] = x[1][1] - x[0][1];
    d[0] = x[2][0] - x[0][0];
    d[1] = x[2][1] - x[0][1];
    ee = footpoint_detail_plane_dot(e, e);
    terms = fabs(d[0] * e[0]) + fabs(d[1] * e[1]);
    per = 2.0 / ee;
    *xi = footpoint_detail_plane_dot(d, e) * per - 1.0;
    reach = fabs(*xi); /* the larger of this and 1, without a comparison */
    room = 0.99 * promise * (0.5 * (1.0 + reach + fabs(1.0 - reach))) -
           10.0 * REAL_UNIT * (terms * per);
    return footpoint_detail_outside(ee) | footpoint_detail_bits(room) |
           footpoint_detail_infinite(room) | footpoint_detail_fast();
}

FOOTPOINT_PART void footpoint_detail_edge2_at(const REAL *const *x, REAL *xi)
{
    REAL e[2], d[2];
    (void)footpoint_detail_edge2_project(x, 1.0, e, d, xi);
}

/* Finds the foot point.  The highest bit of the result is set unless xi is proved and there is a gap. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge2_locate(const REAL *const *x, REAL promise, REAL *xi,
                                                       REAL *gap)
{
    REAL e[2], d[2];
    const REAL_BITS flaw = footpoint_detail_edge2_project(x, promise, e, d, xi);
    *gap = footpoint_detail_plane_cross(d, e) / sqrt(footpoint_detail_plane_dot(e, e));
    return flaw | footpoint_detail_infinite(*gap);
}

/* Repeats the search in full, in a unit of length in which the edge is about 1 long. */
FOOTPOINT_COLD int footpoint_detail_edge2_repair(const REAL *const *x, REAL promise, REAL *xi,
                                                 REAL *gap)
{
    const REAL_BITS flaw = footpoint_detail_edge2_locate(x, promise, xi, gap);
    if (footpoint_detail_infinite(*xi + *gap) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    return flaw >> REAL_TOP ? FOOTPOINT_UNPROVED : FOOTPOINT_OK;
}

/* Ignores the last answer, from which the search gains nothing. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge2_follow(const REAL *const *x, REAL promise, REAL *xi,
                                                       REAL *gap)
{
    return footpoint_detail_edge2_locate(x, promise, xi, gap);
}

/* Finds the closest point: the end beyond which xi lies, or xi. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge2_near(const REAL *const *x, REAL promise, REAL *xi,
                                                     REAL *dist, int *region)
{
    REAL e[2], d[2], to[2], dd, across;
    const REAL_BITS flaw = footpoint_detail_edge2_project(x, promise, e, d, xi);
    const int left = (int)(footpoint_detail_bits(*xi + 1.0) >> REAL_TOP);
    const int right = (int)(footpoint_detail_bits(1.0 - *xi) >> REAL_TOP);
    across = footpoint_detail_plane_cross(d, e) / sqrt(footpoint_detail_plane_dot(e, e));
    to[0] = right ? x[2][0] - x[1][0] : d[0];
    to[1] = right ? x[2][1] - x[1][1] : d[1];
    dd = sqrt(footpoint_detail_plane_dot(to, to));
    *xi = left ? -1.0 : right ? 1.0 : *xi;
    *region = left + 2 * right;
    *dist = *region == 0                                                    ? across
            : footpoint_detail_plane_behind(to, e, fabs(e[0]) + fabs(e[1])) ? -dd
                                                                            : dd;
    return flaw | footpoint_detail_infinite(*dist);
}

FOOTPOINT_COLD int footpoint_detail_edge2_seek(const REAL *const *x, REAL promise, REAL *xi,
                                               REAL *dist, int *region)
{
    const REAL_BITS flaw = footpoint_detail_edge2_near(x, promise, xi, dist, region);
    if (footpoint_detail_infinite(*xi + *dist) >> REAL_TOP)
        return FOOTPOINT_ERR_DOMAIN;
    return flaw >> REAL_TOP ? FOOTPOINT_UNPROVED : FOOTPOINT_OK;
}

/* Computes the tangent at an end, of any length. */
FOOTPOINT_PART void footpoint_detail_edge2_tangent(const REAL *const *x, REAL xi, REAL t[2])
{
    (void)xi;
    t[0] = x[1][0] - x[0][0];
    t[1] = x[1][1] - x[0][1];
}

/* Returns 0: distances without a proved place have no bound. */
FOOTPOINT_FN int footpoint_detail_edge2_at_least(const REAL *const *x, REAL dist)
{
    (void)x;
    (void)dist;
    return 0;
}

/* Computes shape functions, their derivatives and second derivatives. */
FOOTPOINT_PART void footpoint_detail_edge2_shape(REAL xi, REAL *phi, REAL *slope, REAL *bend)
{
    phi[0] = 0.5 - 0.5 * xi;
    phi[1] = 0.5 + 0.5 * xi;
    slope[0] = -0.5;
    slope[1] = 0.5;
    bend[0] = bend[1] = 0.0;
}

/* Computes the line through the slave node in the direction p, and S - r. */
FOOTPOINT_PART void footpoint_detail_edge2_line(const REAL *const *x, const REAL p[2],
                                                struct footpoint_detail_line *l)
{
    const REAL e[2] = {x[1][0] - x[0][0], x[1][1] - x[0][1]};
    const REAL a[2] = {x[2][0] - x[0][0], x[2][1] - x[0][1]};
    const REAL b[2] = {x[2][0] - x[1][0], x[2][1] - x[1][1]}, s[2] = {a[0] + b[0], a[1] + b[1]};
    l->a[0] = -footpoint_detail_plane_cross(p, s);
    l->a[1] = footpoint_detail_plane_cross(p, e);
    l->a[2] = 0.0;
    l->far = 2.0 * (footpoint_detail_plane_across(p, a[0], a[1]) +
                    footpoint_detail_plane_across(p, b[0], b[1]));
    l->wide = footpoint_detail_plane_across(p, e[0], e[1]);
}

FOOTPOINT_PART void footpoint_detail_edge2_way(const REAL *const *x, REAL xi, REAL d[2])
{
    const REAL t = 0.5 * (xi + 1.0);
    d[0] = (x[2][0] - x[0][0]) - t * (x[1][0] - x[0][0]);
    d[1] = (x[2][1] - x[0][1]) - t * (x[1][1] - x[0][1]);
}
