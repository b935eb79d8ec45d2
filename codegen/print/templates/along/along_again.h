/* Projection along a direction if the quick way fails. */

/* Searches in full, in units of length in which the segment and the direction are about 1 long. Returns
 * FOOTPOINT_ERR_DOMAIN if a slave node or a distance overflows there. */
FOOTPOINT_COLD int footpoint_detail_KIND_along_again(const REAL *const *x, const REAL along[3],
                                                     REAL loc[2], REAL *dist)
{
    REAL y[VECTORS][3], p[3], at[3], away;
    const REAL *z[VECTORS];
    int exponent = 0, i, status = footpoint_detail_along_scale(along, p);
    const int nodes = footpoint_detail_scale(x, VECTORS - 1, VECTORS, y, &exponent);
    if (status == FOOTPOINT_OK || nodes == FOOTPOINT_ERR_NOT_FINITE)
        status = nodes;
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    for (i = 0; i < 3; i++)
        if (footpoint_detail_above(y[VECTORS - 1][i], 1e-4 / REAL_MIN) >> REAL_TOP)
            return FOOTPOINT_ERR_DOMAIN;
    status = footpoint_detail_KIND_along_full(z, p, at);
    if (status < FOOTPOINT_OK)
        return status;
    away = exponent ? ldexp(at[2], exponent) : at[2];
    if (footpoint_detail_infinite(away) >> REAL_TOP)
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = at[0];
    loc[1] = at[1];
    *dist = away;
    return status;
}
