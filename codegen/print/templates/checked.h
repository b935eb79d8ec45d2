/* The search with gap and status, for NAME and its loops; `full` as in again.h. */

FOOTPOINT_PART REAL_BITS NAME_detail_checked(const REAL *const *x, int full, REAL zero, REAL *xi,
                                             REAL *eta, REAL *gap)
{
    REAL_BITS flaw = SEARCH_CALL;
    WITH_SHARED_GAP
    if (full)
        flaw |= footpoint_detail_KIND_gap(x, *xi, *eta, LEAST_SIZE, gap);
    {
        const REAL_BITS doubt = NAME_detail_gap(VECTOR_ROWS, *xi, *eta, gap);
        return flaw | (full ? footpoint_detail_infinite(*gap) : doubt);
    }
    END_SHARED_GAP
    WITH_OWN_GAP
    flaw |= footpoint_detail_KIND_gap(x, *xi, *eta, LEAST_SIZE, gap);
    (void)full;
    return flaw;
    END_OWN_GAP
}

FOOTPOINT_FN int NAME(NODE_PARAMETERS, REAL loc[2], REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL xi, eta, g;
    if (NAME_detail_checked(x, 0, 0.0, &xi, &eta, &g) >> REAL_TOP)
        return footpoint_detail_again(NAME_detail_checked, x, SCALED_NODES, VECTORS, loc, gap);
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return FOOTPOINT_OK;
}
