/* The functions for callers that find proved closest points. */

FOOTPOINT_FN int NAME_closest(NODE_PARAMETERS, REAL loc[2], REAL *dist, int *region)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL at[3];
    int where;
    const int status =
        footpoint_detail_KIND_proved_closest(NAME_detail_nearby, x, SCALABLE, PROMISE, at, &where);
    return footpoint_detail_KIND_proved_answer(status, at, where, loc, dist, region);
}

FOOTPOINT_LOOP void NAME_closest_n(size_t n, const REAL *const x[COORDINATES],
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                   REAL *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT region,
                                   int *FOOTPOINT_RESTRICT status)
{
    footpoint_detail_KIND_proved_closest_n(NAME_detail_nearby, n, x, SCALABLE, PROMISE, xi, eta,
                                           dist, region, status);
}

FOOTPOINT_FN int NAME_closest_of(size_t n, const REAL *const *x, const REAL xS[3], REAL loc[2],
                                 REAL *dist, int *region, size_t *which)
{
    return footpoint_detail_KIND_proved_closest_of(NAME_detail_nearby, n, x, xS, SCALABLE, PROMISE,
                                                   loc, dist, region, which);
}
