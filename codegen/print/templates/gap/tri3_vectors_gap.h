/* Computes the gap from a search's own values on a flat triangle: c3 = 0. */

FOOTPOINT_PART REAL_BITS NAME_detail_gap(NODE_PARAMETERS, REAL xi, REAL eta, REAL *gap)
{
    VECTOR_STATEMENTS
    const REAL size = SIZE;
    const REAL per = PER, unit = UNIT;
    return footpoint_detail_tri3_over(a, b, d, size, per, unit, xi, eta, LEAST_SIZE, gap);
}
