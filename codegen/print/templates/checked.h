/* The search with gap and status, for NAME and its loops; `way` as in again.h. */

FOOTPOINT_PART REAL_BITS NAME_detail_checked(const REAL *const *x, int way, REAL zero, REAL *xi,
                                             REAL *eta, REAL *gap)
{
    REAL_BITS flaw;
    WITH_CURVED
    if (way != 1)
        return footpoint_detail_KIND_curved(x, PROMISE, STEPS, !way, LEAST_SIZE, xi, eta, gap);
    END_CURVED
    flaw = SEARCH_CALL;
    WITH_PATCH
    if (way != 1)
        return footpoint_detail_KIND_patch(x, PROMISE, STEPS, PROMISE < 1e-6, LEAST_SIZE, xi, eta,
                                           gap);
    return flaw | footpoint_detail_KIND_gap(x, *xi, *eta, LEAST_SIZE, gap);
    END_PATCH
    WITH_EXACT_PROMISE
    if (way != 1)
        flaw |= EXACT_prove(x, PROMISE, xi, eta);
    END_EXACT_PROMISE
    WITH_PROMISE
    if (way == 1)
        return flaw | footpoint_detail_KIND_gap(x, *xi, *eta, LEAST_SIZE, gap);
    return START_detail_prove(VECTOR_ROWS, PROMISE, way ? 0 : STEPS, xi, eta, gap);
    END_PROMISE
    WITH_CURVED
    return flaw | footpoint_detail_KIND_gap(x, *xi, *eta, LEAST_SIZE, gap);
    END_CURVED
    WITH_SHARED_GAP
    if (way == 1)
        flaw |= footpoint_detail_KIND_gap(x, *xi, *eta, LEAST_SIZE, gap);
    {
        const REAL_BITS doubt = NAME_detail_gap(VECTOR_ROWS, *xi, *eta, gap);
        return flaw | (way == 1 ? footpoint_detail_infinite(*gap) : doubt);
    }
    END_SHARED_GAP
    WITH_OWN_GAP
    flaw |= footpoint_detail_KIND_gap(x, *xi, *eta, LEAST_SIZE, gap);
    (void)way;
    return flaw;
    END_OWN_GAP
}

FOOTPOINT_FN int NAME(NODE_PARAMETERS, REAL loc[2], REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL xi, eta, g;
    if (NAME_detail_checked(x, 2, 0.0, &xi, &eta, &g) >> REAL_TOP)
        return footpoint_detail_KIND_answer(NAME_detail_checked, x, SCALED_NODES, PROMISE, loc,
                                            gap);
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return footpoint_detail_claim(FOOTPOINT_OK, PROMISE);
}
