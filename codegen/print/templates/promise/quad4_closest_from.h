/* The closest point from the last answer. */

/* For fine promises one approach from the last answer ends too far off, and more cost as much as a new start. */
FOOTPOINT_FN int NAME_closest_from(NODE_PARAMETERS, REAL loc[2], REAL *dist, int *region)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL at[3];
    int where, status;
    if (PROMISE < 1e-6 || footpoint_detail_infinite(loc[0] + loc[1]) >> REAL_TOP)
        return NAME_closest(NODE_NAMES, loc, dist, region);
    status = START_detail_approach(VECTOR_ROWS, PROMISE, 0, loc[0], loc[1], at, &where);
    if (status == FOOTPOINT_UNPROVED)
        return NAME_closest(NODE_NAMES, loc, dist, region);
    at[2] = footpoint_detail_signed_root(at[2]);
    return footpoint_detail_quad4_proved_answer(status, at, where, loc, dist, region);
}
