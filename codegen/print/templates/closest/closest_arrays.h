/* Closest points over arrays of faces and slave nodes, and of one slave node over many faces. */

/* Roots of the squares in dist, and once more what NAME_closest does in another unit of length, behind the loop. */
FOOTPOINT_PART void
footpoint_detail_KIND_closest_n(footpoint_detail_nearest *nearest, size_t n, const REAL *const *x,
                                int nodes, REAL *FOOTPOINT_RESTRICT xi,
                                REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT dist,
                                int *FOOTPOINT_RESTRICT region, int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[4];
        status[i] = nearest(row, zero, at, &region[i]);
        xi[i] = at[0];
        eta[i] = at[1];
        dist[i] = at[2];
    }
    for (i = 0; i < n; i++)
        dist[i] = footpoint_detail_signed_root(dist[i]);
    for (i = 0; i < n; i++)
        if (status[i] == FOOTPOINT_ERR_DEGENERATE) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            REAL at[4];
            int where;
            status[i] = footpoint_detail_closest(nearest, row, nodes, VECTORS, at, &where);
            if (status[i] == FOOTPOINT_OK) {
                xi[i] = at[0];
                eta[i] = at[1];
                dist[i] = at[2];
                region[i] = where;
            }
        }
}

/* Of faces as near as each other, to rounding, that which xS lies straightest over: where they share an edge or a
 * corner, its side is the right one. */
FOOTPOINT_PART int footpoint_detail_KIND_closest_of(footpoint_detail_nearest *nearest, size_t n,
                                                    const REAL *const *x, const REAL *xS, int nodes,
                                                    REAL loc[2], REAL *dist, int *region,
                                                    size_t *which)
{
    REAL least = 0.0, straightest = 0.0;
    int found = FOOTPOINT_ERR_DOMAIN, k;
    size_t i;
    for (i = 0; i < n; i++) {
        const REAL *row[VECTORS];
        REAL at[4], away, more;
        int where, status;
        for (k = 0; k < SEGMENT_VECTORS; k++)
            row[k] = x[SEGMENT_VECTORS * i + (size_t)k];
        row[SEGMENT_VECTORS] = xS;
        status = footpoint_detail_closest(nearest, row, nodes, VECTORS, at, &where);
        if (status != FOOTPOINT_OK) {
            found = found == FOOTPOINT_OK ? found : status;
            continue;
        }
        away = fabs(at[2]);
        more = 4.0 * REAL_MARGIN * (away + least);
        if (found == FOOTPOINT_OK &&
            !(away < least - more || (away <= least + more && at[3] > straightest)))
            continue;
        found = FOOTPOINT_OK;
        least = away;
        straightest = at[3];
        loc[0] = at[0];
        loc[1] = at[1];
        *dist = at[2];
        *region = where;
        *which = i;
    }
    return found;
}
