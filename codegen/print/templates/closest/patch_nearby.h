/* The quick way to a closest point of a patch. */

FOOTPOINT_PART int NAME_detail_nearby(const REAL *const *x, int lanes, REAL zero, REAL at[3],
                                      int *region)
{
    (void)lanes;
    (void)ONCE_detail(VECTOR_ROWS, zero, &at[0], &at[1]);
    return footpoint_detail_KIND_close(x, PROMISE, ONCE_STEPS, at, region);
}
