/* The quick way to a closest point, from a search. */

FOOTPOINT_PART int NAME_detail_nearby(const REAL *const *x, int lanes, REAL zero, REAL at[3],
                                      int *region)
{
    REAL xi, eta;
    (void)START_detail(VECTOR_ROWS, zero, &xi, &eta);
    return START_detail_approach(VECTOR_ROWS, PROMISE, lanes, xi, eta, at, region);
}
