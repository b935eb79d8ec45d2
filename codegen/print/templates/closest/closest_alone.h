/* The quick way to closest points, over arrays: no blocks. */

FOOTPOINT_PART size_t footpoint_detail_KIND_closest_blocks(
    footpoint_detail_nearby *nearby, size_t n, const REAL *const *x, REAL *FOOTPOINT_RESTRICT xi,
    REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT region,
    int *FOOTPOINT_RESTRICT status)
{
    (void)nearby, (void)n, (void)x, (void)xi, (void)eta, (void)dist, (void)region, (void)status;
    return 0;
}
