/* The loop over slave nodes of a segment. */

/* Searches slave nodes x over a segment, copied to c, which no result can change, so that its own values are computed once. */
FOOTPOINT_PART void
footpoint_detail_KIND_over_n(footpoint_detail_search *search, const REAL *const *segment, size_t n,
                             const REAL *const *x, int nodes, REAL promise,
                             REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                             REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    REAL c[SEGMENT_VECTORS][3];
    size_t i;
    int j, k;
    for (k = 0; k < SEGMENT_VECTORS; k++)
        for (j = 0; j < 3; j++)
            c[k][j] = segment[k][j];
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL s[3] = {x[0][i], x[1][i], x[2][i]};
        const REAL *const row[VECTORS] = {SEGMENT_ROWS, s};
        REAL u, v, g;
        status[i] = FOOTPOINT_ERR_DEGENERATE * (int)(search(row, 0, zero, &u, &v, &g) >> REAL_TOP);
        xi[i] = u;
        eta[i] = v;
        gap[i] = g;
    }
    for (i = 0; i < n; i++)
        if (status[i] != FOOTPOINT_OK) {
            const REAL s[3] = {x[0][i], x[1][i], x[2][i]};
            const REAL *const row[VECTORS] = {SEGMENT_ROWS, s};
            footpoint_detail_KIND_full(search, row, nodes, promise, &xi[i], &eta[i], &gap[i],
                                       &status[i]);
        } else
            status[i] = footpoint_detail_claim(FOOTPOINT_OK, promise);
}
