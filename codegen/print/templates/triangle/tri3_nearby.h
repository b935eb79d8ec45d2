/* The quick way to a closest point of a triangle, which needs no search. */

FOOTPOINT_PART int NAME_detail_nearby(const REAL *const *x, int lanes, REAL zero, REAL at[3],
                                      int *region)
{
    (void)lanes;
    (void)zero;
    return footpoint_detail_tri3_nearby(x, PROMISE, LEAST_SIZE, at, region);
}
