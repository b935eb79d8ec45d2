/* Moves from a search's xi and eta to the closest point of the closed segment, with its proof, by values of the search. */

FOOTPOINT_PART int NAME_detail_approach(NODE_PARAMETERS, REAL promise, int lanes, REAL xi, REAL eta,
                                        REAL at[3], int *region)
{
    VECTOR_STATEMENTS
    const REAL products[9] = {PRODUCT_LIST};
    const REAL *const x[VECTORS] = {NODE_NAMES};
    const footpoint_detail_quad4_vectors vectors = {
        x, a, b, c, d, OVER, SIZE, UNITS * REAL_UNIT, TWIST, lanes && footpoint_detail_masks()};
    return footpoint_detail_quad4_close(products, &vectors, promise, RATIO * PER, lanes, xi, eta,
                                        at, region);
}
