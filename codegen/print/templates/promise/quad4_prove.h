/* Takes steps from a search's xi and eta, with their proof and the gap, by values of the search. */

FOOTPOINT_PART REAL_BITS NAME_detail_prove(NODE_PARAMETERS, REAL promise, int fixed, REAL *xi,
                                           REAL *eta, REAL *gap)
{
    VECTOR_STATEMENTS
    const REAL size = SIZE;
    const REAL products[9] = {PRODUCT_LIST};
    const REAL ratio = RATIO, per = PER, unit = UNIT, rounding = UNITS * REAL_UNIT;
    const REAL *const x[VECTORS] = {NODE_NAMES};
    const footpoint_detail_quad4_vectors vectors = {x, a, b, c, d, OVER, size, rounding, TWIST, 0};
    const REAL_BITS doubt =
        footpoint_detail_quad4_steps(products, &vectors, promise, fixed, xi, eta);
    return doubt | footpoint_detail_quad4_over(a, b, c, d, size, ratio, per, unit, *xi, *eta,
                                               LEAST_SIZE, gap);
}
