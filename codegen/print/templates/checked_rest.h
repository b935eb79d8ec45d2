/* The end of a loop over arrays of checked searches. */

/* What is not good beyond doubt in full. */
FOOTPOINT_PART void footpoint_detail_KIND_checked_rest(footpoint_detail_search *search, size_t n,
                                                       const REAL *const *x, int nodes, REAL *xi,
                                                       REAL *eta, REAL *gap, int *status)
{
    size_t i;
    for (i = 0; i < n; i++)
        if (status[i] != FOOTPOINT_OK) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            REAL loc[2];
            loc[0] = xi[i];
            loc[1] = eta[i];
            status[i] = footpoint_detail_again(search, row, nodes, VECTORS, loc, &gap[i]);
            xi[i] = loc[0];
            eta[i] = loc[1];
        }
}
