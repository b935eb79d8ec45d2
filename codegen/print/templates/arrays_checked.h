/* The loop over pairs of segments and slave nodes, with statuses. */

FOOTPOINT_PART void footpoint_detail_KIND_checked_n(footpoint_detail_search *search, size_t n,
                                                    const REAL *const *x, int nodes, REAL promise,
                                                    REAL *FOOTPOINT_RESTRICT xi,
                                                    REAL *FOOTPOINT_RESTRICT eta,
                                                    REAL *FOOTPOINT_RESTRICT gap,
                                                    int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL u, v, g;
        status[i] = FOOTPOINT_ERR_DEGENERATE * (int)(search(row, 0, zero, &u, &v, &g) >> REAL_TOP);
        xi[i] = u;
        eta[i] = v;
        gap[i] = g;
    }
    for (i = 0; i < n; i++)
        if (status[i] != FOOTPOINT_OK) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            footpoint_detail_KIND_full(search, row, nodes, promise, &xi[i], &eta[i], &gap[i],
                                       &status[i]);
        } else
            status[i] = footpoint_detail_claim(FOOTPOINT_OK, promise);
}
