/* Searches on patches from the last answers, for callers. */

FOOTPOINT_FN int NAME_from(NODE_PARAMETERS, REAL loc[2], REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL xi, eta, g;
    if (footpoint_detail_KIND_from(x, PROMISE, LEAST_SIZE, loc, &xi, &eta, &g) >> REAL_TOP)
        return footpoint_detail_KIND_further(NAME_detail_checked, x, PROMISE, loc, gap);
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return FOOTPOINT_OK;
}

FOOTPOINT_LOOP void NAME_from_n(size_t n, const REAL *const x[COORDINATES],
                                REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    RUN(NULL, 3, NAME_detail_checked, NULL, n, x, PROMISE, xi, eta, gap, status);
}

FOOTPOINT_LOOP void NAME_from_over_n(const REAL *const nodes[SEGMENT_VECTORS], size_t n,
                                     const REAL *const x[3], REAL *FOOTPOINT_RESTRICT xi,
                                     REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT gap,
                                     int *FOOTPOINT_RESTRICT status)
{
    RUN(NULL, 3, NAME_detail_checked, nodes, n, x, PROMISE, xi, eta, gap, status);
}
