/* The functions for callers that have last answers. */

/* Calls footpoint_detail_KIND_further(); not inlined, so that NAME_from reserves nothing for it. */
FOOTPOINT_COLD int NAME_detail_further(NODE_PARAMETERS, REAL xi, REAL eta, REAL loc[2], REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    return footpoint_detail_KIND_further(NAME, x, PROMISE, LEAST_SIZE, xi, eta, loc, gap);
}

FOOTPOINT_FN int NAME_from(NODE_PARAMETERS, REAL loc[2], REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL xi = loc[0], eta = loc[1], g;
    if (footpoint_detail_KIND_from(x, PROMISE, LEAST_SIZE, 3, &xi, &eta, &g) >> REAL_TOP)
        return NAME_detail_further(NODE_NAMES, xi, eta, loc, gap);
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return FOOTPOINT_OK;
}

FOOTPOINT_LOOP void NAME_from_n(size_t n, const REAL *const x[COORDINATES],
                                REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    footpoint_detail_KIND_from_n(NAME, NAME_from, NULL, n, x, PROMISE, LEAST_SIZE, xi, eta, gap,
                                 status);
}

FOOTPOINT_LOOP void NAME_from_over_n(const REAL *const nodes[SEGMENT_VECTORS], size_t n,
                                     const REAL *const x[3], REAL *FOOTPOINT_RESTRICT xi,
                                     REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT gap,
                                     int *FOOTPOINT_RESTRICT status)
{
    footpoint_detail_KIND_from_n(NAME, NAME_from, nodes, n, x, PROMISE, LEAST_SIZE, xi, eta, gap,
                                 status);
}
