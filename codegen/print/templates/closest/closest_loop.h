/* The quick way to closest points, over arrays. */

/* Searches n pairs. dist: squares of distances with their signs. */
FOOTPOINT_PART void
footpoint_detail_KIND_closest_loop(footpoint_detail_nearby *nearby, size_t n, const REAL *const *x,
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                   REAL *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT region,
                                   int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[3];
        status[i] = nearby(row, 1, zero, at, &region[i]);
        xi[i] = at[0];
        eta[i] = at[1];
        dist[i] = at[2];
    }
}
