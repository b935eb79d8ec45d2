/* The gap of the flat triangle from values of a search. */

/* Computes the gap of r = xA + xi c1 + eta c2: a and b are c1 and c2, both times a number whose square is 1 / unit; d
 * is xS - xA over per. */
FOOTPOINT_PART REAL_BITS footpoint_detail_tri3_over(const REAL a[3], const REAL b[3],
                                                    const REAL d[3], REAL size, REAL per, REAL unit,
                                                    REAL xi, REAL eta, REAL least, REAL *gap)
{
    return footpoint_detail_height(a, b, d, size, per, unit, xi, eta, least, gap);
}
