/* The end of a loop over arrays of closest points. */

/* Roots of the squares in dist, and once more what NAME_closest does in another unit of length. */
FOOTPOINT_PART void footpoint_detail_KIND_closest_rest(footpoint_detail_nearest *nearest, size_t n,
                                                       const REAL *const *x, int nodes, REAL *xi,
                                                       REAL *eta, REAL *dist, int *region,
                                                       int *status)
{
    size_t i;
    for (i = 0; i < n; i++)
        dist[i] = footpoint_detail_signed_root(dist[i]);
    for (i = 0; i < n; i++)
        if (status[i] == FOOTPOINT_ERR_DEGENERATE) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            REAL loc[2];
            loc[0] = xi[i];
            loc[1] = eta[i];
            status[i] =
                footpoint_detail_closest(nearest, row, nodes, VECTORS, loc, &dist[i], &region[i]);
            xi[i] = loc[0];
            eta[i] = loc[1];
        }
}
