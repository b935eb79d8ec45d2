/* Answers if the quick way proves nothing, and the search over arrays, for edges of any kind. */

/* Copies nodes and slave node in a unit of length in which the edge is about 1 long.  Returns FOOTPOINT_ERR_DOMAIN if
 * xS is too far away for products. */
FOOTPOINT_FN int footpoint_detail_KIND_unit(const REAL *const *x, REAL (*y)[2], const REAL **z,
                                            int *exponent)
{
    const int status = footpoint_detail_plane_scale(x, NODES, y, exponent);
    int i;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    if (status != FOOTPOINT_OK)
        return status;
    return (footpoint_detail_above(y[NODES][0], 1e-4 / sqrt(REAL_MIN)) |
            footpoint_detail_above(y[NODES][1], 1e-4 / sqrt(REAL_MIN))) >>
                   REAL_TOP
               ? FOOTPOINT_ERR_DOMAIN
               : FOOTPOINT_OK;
}

/* Searches again from `at`, where the quick way ended, then in full. */
FOOTPOINT_COLD int footpoint_detail_KIND_answer(const REAL *const *x, REAL promise, REAL at,
                                                REAL *xi, REAL *gap)
{
    REAL y[VECTORS][2], g;
    const REAL *z[VECTORS];
    int exponent = 0, status = FOOTPOINT_OK;
    if (footpoint_detail_KIND_follow(x, promise, &at, &g) >> REAL_TOP) {
        status = footpoint_detail_KIND_unit(x, y, z, &exponent);
        if (status != FOOTPOINT_OK)
            return status == FOOTPOINT_ERR_NOT_FINITE ? status : FOOTPOINT_ERR_DEGENERATE;
        status = footpoint_detail_KIND_repair(z, promise, &at, &g);
        g = ldexp(g, exponent);
        if (status < FOOTPOINT_OK || footpoint_detail_infinite(g) >> REAL_TOP)
            return FOOTPOINT_ERR_DEGENERATE;
    }
    *xi = at;
    *gap = g;
    return status;
}

FOOTPOINT_COLD int footpoint_detail_KIND_nearest(const REAL *const *x, REAL promise, REAL *xi,
                                                 REAL *dist, int *region)
{
    REAL y[VECTORS][2], at, d;
    const REAL *z[VECTORS];
    int exponent = 0, where, status = footpoint_detail_KIND_unit(x, y, z, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    status = footpoint_detail_KIND_seek(z, promise, &at, &d, &where);
    d = ldexp(d, exponent);
    if (status < FOOTPOINT_OK || footpoint_detail_infinite(d) >> REAL_TOP)
        return FOOTPOINT_ERR_DOMAIN;
    *xi = at;
    *dist = d;
    *region = where;
    return status;
}

/* Finds the closest point of one edge. */
FOOTPOINT_PART int footpoint_detail_KIND_closest(const REAL *const *x, REAL promise, REAL *xi,
                                                 REAL *dist, int *region)
{
    REAL at, d;
    int where;
    if (footpoint_detail_KIND_near(x, promise, &at, &d, &where) >> REAL_TOP)
        return footpoint_detail_KIND_nearest(x, promise, xi, dist, region);
    *xi = at;
    *dist = d;
    *region = where;
    return FOOTPOINT_OK;
}

/* Adds the unit tangent of an edge whose end is r to sum. */
FOOTPOINT_FN void footpoint_detail_KIND_add_tangents(const REAL *const *segment, const REAL *r,
                                                     REAL *sum)
{
    REAL y[VECTORS][2], t[2], length;
    const REAL *row[VECTORS], *z[VECTORS];
    int j, k, exponent = 0;
    for (j = 0; j < NODES; j++)
        row[j] = segment[j];
    row[NODES] = r;
    for (k = 0; k < 2; k++) {
        if (segment[k][0] != r[0] || segment[k][1] != r[1] ||
            footpoint_detail_KIND_unit(row, y, z, &exponent) != FOOTPOINT_OK)
            continue;
        footpoint_detail_KIND_tangent(z, k ? 1.0 : -1.0, t);
        length = sqrt(footpoint_detail_plane_dot(t, t));
        if (length > 0.0) {
            sum[0] += t[0] / length;
            sum[1] += t[1] / length;
        }
    }
}

/* Returns 1 if xS lies behind the edges, of n, that meet at the end r: behind the sum of their unit normals. */
FOOTPOINT_FN int footpoint_detail_KIND_corner(size_t n, const REAL *const *x, const REAL *xS,
                                              const REAL *r)
{
    REAL d[2], sum[2] = {0.0, 0.0};
    size_t i;
    for (i = 0; i < n; i++)
        footpoint_detail_KIND_add_tangents(x + NODES * i, r, sum);
    d[0] = xS[0] - r[0];
    d[1] = xS[1] - r[1];
    return footpoint_detail_plane_behind(d, sum, 4.0);
}

/* Returns 1 if no point of the edge is nearer than dist by more than 1e-10 of the largest difference of coordinates. */
FOOTPOINT_COLD int footpoint_detail_KIND_is_nearest(const REAL *const *x, REAL dist)
{
    REAL y[VECTORS][2];
    const REAL *z[VECTORS];
    int exponent = 0;
    if (footpoint_detail_KIND_unit(x, y, z, &exponent) != FOOTPOINT_OK)
        return 0;
    return footpoint_detail_KIND_at_least(z, ldexp(dist, -exponent));
}

/* Finds the nearest of n edges. */
FOOTPOINT_FN int footpoint_detail_KIND_closest_of(size_t n, const REAL *const *x, const REAL *xS,
                                                  REAL promise, REAL *xi, REAL *dist, int *region,
                                                  size_t *which)
{
    int found = FOOTPOINT_ERR_DOMAIN, any = 0, unproved = 0, where = 0;
    REAL best = 0.0, at = 0.0;
    size_t i, k, nearest = 0;
    for (i = 0; i < n; i++) {
        const REAL *row[VECTORS];
        REAL local, d;
        int region_here, status;
        for (k = 0; k < NODES; k++)
            row[k] = x[NODES * i + k];
        row[NODES] = xS;
        status = footpoint_detail_KIND_closest(row, promise, &local, &d, &region_here);
        unproved = unproved || status == FOOTPOINT_UNPROVED;
        if (status < FOOTPOINT_OK) {
            found = any ? found : status;
            continue;
        }
        if (any && !(fabs(d) < fabs(best)))
            continue;
        any = 1;
        found = status;
        nearest = i;
        at = local;
        best = d;
        where = region_here;
    }
    if (!any)
        return found;
    if (where)
        best = footpoint_detail_KIND_corner(n, x, xS, x[NODES * nearest + (where == 2)])
                   ? -fabs(best)
                   : fabs(best);
    *xi = at;
    *dist = best;
    *region = where;
    *which = nearest;
    return unproved ? FOOTPOINT_UNPROVED : found;
}
