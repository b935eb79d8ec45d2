/* Computes the gap from a search's own values: r = c0 + xi c1 + eta c2 + xi eta c3. */

FOOTPOINT_PART REAL_BITS NAME_detail_gap(NODE_PARAMETERS, REAL xi, REAL eta, REAL *gap)
{
    VECTOR_STATEMENTS
    const REAL size = SIZE;
    const REAL ratio = RATIO, per = PER, unit = UNIT;
    return footpoint_detail_quad4_over(a, b, c, d, size, ratio, per, unit, xi, eta, LEAST_SIZE,
                                       gap);
}
