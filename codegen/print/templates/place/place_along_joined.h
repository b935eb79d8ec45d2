/* A projection along a direction and its derivatives at once: the text of a macro. */

FOOTPOINT_UNUSED
FOOTPOINT_FN int JOINED_SLOPES(NODE_PARAMETERS, const REAL along[3], REAL loc[2], REAL dist[1],
                               REAL d_xi[SLOPE_COUNT], REAL d_eta[SLOPE_COUNT],
                               REAL d_dist[SLOPE_COUNT])
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL *const row[4] = {0, d_xi, d_eta, d_dist};
    const int searched = PROJECTION(NODE_NAMES, along, loc, dist);
    int status = searched;
    if (searched >= 0 && SLOPES_detail(x, along, loc, dist, row) >> REAL_TOP)
        status = SLOPES_detail_again(NODE_NAMES, along, loc, 0, d_xi, d_eta, d_dist);
    return status < 0 ? status : searched;
}
