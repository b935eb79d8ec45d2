/* Loops over arrays, which FOOTPOINT_LOOP inlines with the searches that they call: without that they do not vectorise. */

/* The search of NAME_at. */
typedef REAL_BITS footpoint_detail_KIND_search(NODE_PARAMETERS, REAL zero, REAL *xi, REAL *eta);

FOOTPOINT_PART void footpoint_detail_KIND_n(footpoint_detail_KIND_search *search, size_t n,
                                            const REAL *const *x, REAL *FOOTPOINT_RESTRICT xi,
                                            REAL *FOOTPOINT_RESTRICT eta)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        (void)search(ROWS, zero, &xi[i], &eta[i]);
    }
}

/* Searches with statuses. p: the vectors, the first `nodes` of which another unit of length changes. Answers that are
 * not good beyond doubt are searched in full after the loop. */
FOOTPOINT_PART void footpoint_detail_KIND_full(footpoint_detail_search *search,
                                               const REAL *const *row, int nodes, REAL promise,
                                               REAL *xi, REAL *eta, REAL *gap, int *status)
{
    REAL loc[2];
    loc[0] = *xi;
    loc[1] = *eta;
    *status = footpoint_detail_KIND_answer(search, row, nodes, promise, loc, gap);
    *xi = loc[0];
    *eta = loc[1];
}
