/* The functions for callers that project along a direction. */

/* PREFIX_along:  finds the point at which the line through xS in the direction `along`, of any length but 0, meets the
 *           segment: loc = {xi, eta} there and dist, with xS = r(xi, eta) + dist along / |along|; mesh length; along
 *           the segment's normal dist is the gap. A point at which the line meets the surface is proved to lie within
 *           ALONG_PROMISE of loc, times |xi| or |eta| if these are above 1, rounding errors included; dist belongs to
 *           r(loc). FOOTPOINT_OK: the line meets the segment nowhere else. FOOTPOINT_NOT_UNIQUE: it meets the segment
 *           more than once, and the answer is the nearest of these points, to their errors. FOOTPOINT_OUTSIDE: it does
 *           not meet the segment, but the surface beyond the edges, which count as ALONG_PROMISE thick.
 *           FOOTPOINT_UNPROVED: any of these or no point, for example if the line nearly touches the segment.
 *           On error loc and dist are untouched: FOOTPOINT_ERR_DOMAIN if xS is too far away for a distance, or the line
 *           does not meet the segment, and no point beyond the edges is proved; FOOTPOINT_ERR_DEGENERATE if there is no
 *           area or no direction, or, within rounding errors, if the line is parallel to the segment's plane; and
 *           FOOTPOINT_ERR_NOT_FINITE.
 * PREFIX_along_n:  does the same for n pairs, each with its status and its direction, three columns. */
FOOTPOINT_FN int PREFIX_along(NODE_PARAMETERS, const REAL along[3], REAL loc[2], REAL *dist)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL at[3];
    int status;
    const REAL_BITS flaw = footpoint_detail_KIND_along(x, along, at, &status);
    const REAL away = at[2] / sqrt(footpoint_detail_dot(along, along));
    if ((flaw | footpoint_detail_infinite(away)) >> REAL_TOP)
        return footpoint_detail_KIND_along_again(x, along, loc, dist);
    loc[0] = at[0];
    loc[1] = at[1];
    *dist = away;
    return status;
}

FOOTPOINT_LOOP void PREFIX_along_n(size_t n, const REAL *const x[COORDINATES],
                                   const REAL *const along[3], REAL *FOOTPOINT_RESTRICT xi,
                                   REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT dist,
                                   int *FOOTPOINT_RESTRICT status)
{
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL q[3] = {along[0][i], along[1][i], along[2][i]};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[3];
        int outside;
        const REAL_BITS flaw = footpoint_detail_KIND_along(row, q, at, &outside);
        status[i] = outside - (int)(2 * (flaw >> REAL_TOP)); /* < 0: a full search follows */
        xi[i] = at[0];
        eta[i] = at[1];
        dist[i] = at[2];
    }
    for (i = 0; i < n; i++) {
        const REAL q[3] = {along[0][i], along[1][i], along[2][i]};
        dist[i] /= sqrt(footpoint_detail_dot(q, q));
    }
    for (i = 0; i < n; i++)
        if (status[i] < FOOTPOINT_OK || footpoint_detail_infinite(dist[i]) >> REAL_TOP) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL q[3] = {along[0][i], along[1][i], along[2][i]};
            const REAL *const row[VECTORS] = {ROWS};
            REAL loc[2];
            loc[0] = xi[i];
            loc[1] = eta[i];
            status[i] = footpoint_detail_KIND_along_again(row, q, loc, &dist[i]);
            xi[i] = loc[0];
            eta[i] = loc[1];
        }
}
