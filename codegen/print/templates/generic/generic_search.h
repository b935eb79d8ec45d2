/* The search in any type of numbers. */

FOOTPOINT_FN int GENERIC(NODE_PARAMETERS, REAL loc[2], REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL xi, eta;
    GENERIC_at(NODE_NAMES, &xi, &eta);
    footpoint_detail_KIND_plain_step(x, &xi, &eta);
    *gap = footpoint_detail_KIND_plain_gap(x, xi, eta);
    loc[0] = xi;
    loc[1] = eta;
    return FOOTPOINT_UNPROVED;
}
