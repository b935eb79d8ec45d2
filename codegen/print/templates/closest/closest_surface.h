/* The side of the surface of several faces. */

/* Collects the vectors of face i and its slave node. */
FOOTPOINT_PART void footpoint_detail_KIND_row(const REAL *const *x, const REAL *xS, size_t i,
                                              const REAL *row[VECTORS])
{
    int k;
    for (k = 0; k < SEGMENT_VECTORS; k++)
        row[k] = x[SEGMENT_VECTORS * i + (size_t)k];
    row[SEGMENT_VECTORS] = xS;
}

/* Returns 1 if xS lies behind the surface that n faces make at loc, in `region` > 0 of face `which`. */
FOOTPOINT_COLD int footpoint_detail_KIND_behind_all(size_t n, const REAL *const *x, const REAL *xS,
                                                    size_t which, const REAL loc[2], int region)
{
    const REAL *row[VECTORS], *end[2];
    REAL fan[3] = {0.0, 0.0, 0.0}, t;
    size_t i;
    footpoint_detail_KIND_row(x, xS, which, row);
    t = footpoint_detail_KIND_feature(row, loc, region, end);
    for (i = 0; i < n; i++) {
        footpoint_detail_KIND_row(x, xS, i, row);
        footpoint_detail_KIND_add_face(row, end, t, fan);
    }
    footpoint_detail_KIND_row(x, xS, which, row);
    return footpoint_detail_KIND_behind(row, loc, 1, fan);
}
