/* Closest points over arrays of faces and slave nodes. */

/* Takes roots of the squares in dist and, after the loop, repeats failed searches in another unit of length. */
FOOTPOINT_PART void
footpoint_detail_KIND_closest_n(footpoint_detail_nearest *nearest, size_t n, const REAL *const *x,
                                int scalable, REAL *FOOTPOINT_RESTRICT xi,
                                REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT dist,
                                int *FOOTPOINT_RESTRICT region, int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[3];
        status[i] = nearest(row, zero, at, &region[i]);
        xi[i] = at[0];
        eta[i] = at[1];
        dist[i] = at[2];
    }
    for (i = 0; i < n; i++)
        dist[i] = footpoint_detail_signed_root(dist[i]);
    for (i = 0; i < n; i++)
        if (status[i] != FOOTPOINT_OK) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            REAL at[3];
            int where = region[i];
            at[0] = xi[i];
            at[1] = eta[i];
            at[2] = dist[i];
            status[i] = status[i] == FOOTPOINT_ERR_DOMAIN
                            ? footpoint_detail_KIND_closest_beyond(row, at, &where)
                            : footpoint_detail_KIND_closest(nearest, row, scalable, at, &where);
            if (status[i] == FOOTPOINT_OK) {
                xi[i] = at[0];
                eta[i] = at[1];
                dist[i] = at[2];
                region[i] = where;
            }
        }
}
