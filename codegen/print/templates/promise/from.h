/* Searches from the last answer. */

/* Searches without a last answer. */
typedef int footpoint_detail_KIND_name(NODE_PARAMETERS, REAL loc[2], REAL *gap);

/* Returns its highest bit set if (xi,eta) is more than half of the segment away from loc, or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_strayed(const REAL loc[2], REAL xi, REAL eta)
{
    return footpoint_detail_above(xi - loc[0], 1.0) | footpoint_detail_above(eta - loc[1], 1.0);
}

/* Continues from (xi,eta), the unproved end of an expansion about loc: takes two more expansions, then searches without
 * a last answer. */
FOOTPOINT_PART int footpoint_detail_KIND_further(footpoint_detail_KIND_name *name,
                                                 const REAL *const *x, REAL promise, REAL least,
                                                 REAL xi, REAL eta, REAL loc[2], REAL *gap)
{
    REAL g;
    int k;
    for (k = 0; k < 2 && !(footpoint_detail_KIND_strayed(loc, xi, eta) >> REAL_TOP); k++) {
        const REAL_BITS doubt = footpoint_detail_KIND_from(x, promise, least, 2, &xi, &eta, &g);
        if (!((doubt | footpoint_detail_KIND_strayed(loc, xi, eta)) >> REAL_TOP)) {
            loc[0] = xi;
            loc[1] = eta;
            *gap = g;
            return FOOTPOINT_OK;
        }
    }
    return name(VECTOR_ROWS, loc, gap);
}
