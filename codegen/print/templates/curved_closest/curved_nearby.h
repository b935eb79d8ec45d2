/* The quick way to a closest point of a curved face. */

FOOTPOINT_PART int NAME_detail_nearby(const REAL *const *x, int lanes, REAL zero, REAL at[3],
                                      int *region)
{
    (void)lanes, (void)zero;
    return footpoint_detail_KIND_close(x, PROMISE, STEPS, at, region);
}
