/* The functions for callers that find closest points. */

FOOTPOINT_PART int NAME_detail_closest(const REAL *const *x, REAL zero, REAL at[3], int *region)
{
    REAL xi, eta;
    REAL_BITS flaw = NAME_detail(VECTOR_ROWS, zero, &xi, &eta);
    return footpoint_detail_KIND_nearest(x, flaw, LEAST_SIZE, xi, eta, at, region);
}

FOOTPOINT_FN int NAME_closest(NODE_PARAMETERS, REAL loc[2], REAL *dist, int *region)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL at[3];
    int where;
    const int status = footpoint_detail_KIND_closest(NAME_detail_closest, x, SCALABLE, at, &where);
    return footpoint_detail_claim(
        footpoint_detail_closest_answer(status, at, where, loc, dist, region), PROMISE);
}

FOOTPOINT_LOOP void NAME_closest_n(size_t n, const REAL *const x[COORDINATES],
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                   REAL *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT region,
                                   int *FOOTPOINT_RESTRICT status)
{
    size_t i;
    footpoint_detail_KIND_closest_n(NAME_detail_closest, n, x, SCALABLE, xi, eta, dist, region,
                                    status);
    for (i = 0; PROMISE < 0.0 && i < n; i++)
        status[i] = footpoint_detail_claim(status[i], PROMISE);
}

FOOTPOINT_FN int NAME_closest_of(size_t n, const REAL *const *x, const REAL xS[3], REAL loc[2],
                                 REAL *dist, int *region, size_t *which)
{
    return footpoint_detail_claim(footpoint_detail_KIND_closest_of(NAME_detail_closest, n, x, xS,
                                                                   SCALABLE, loc, dist, region,
                                                                   which),
                                  PROMISE);
}
