/* The quick way to the closest point in float: in a unit of length in which the segment is about 1 long, because products of eight
 * lengths must be finite. */

FOOTPOINT_PART int NAME_detail_nearby(const REAL *const *x, int lanes, REAL zero, REAL at[3],
                                      int *region)
{
    const REAL unit = footpoint_detail_leading(footpoint_detail_relative(x, 4)), per = 1.0 / unit;
    const REAL_BITS doubt = footpoint_detail_above(unit, 1e12) | footpoint_detail_above(per, 1e12);
    REAL y[VECTORS][3], xi, eta;
    int i, status;
    FOOTPOINT_UNROLL
    for (i = 0; i < COORDINATES; i++)
        y[i / 3][i % 3] = unit * x[i / 3][i % 3];
    (void)START_detail(VECTOR_ROWS, zero, &xi, &eta);
    status = START_detail_approach(SCALED_ROWS, PROMISE, lanes, xi, eta, at, region);
    at[2] *= per * per;
    return doubt >> REAL_TOP ? FOOTPOINT_UNPROVED : status;
}
