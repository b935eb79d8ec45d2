/* A projection along a direction and its second derivatives at once: the text of a macro. */

FOOTPOINT_UNUSED
FOOTPOINT_FN int JOINED_BENDS(NODE_PARAMETERS, const REAL along[3], REAL loc[2], REAL *dist,
                              REAL *d_xi, REAL *d_eta, REAL *d_dist, REAL *h_xi, REAL *h_eta,
                              REAL *h_dist)
{
    const int searched = PROJECTION(NODE_NAMES, along, loc, dist);
    const int status =
        searched < 0 ? searched
                     : BENDS(NODE_NAMES, along, loc, 0, d_xi, d_eta, d_dist, h_xi, h_eta, h_dist);
    return status == FOOTPOINT_OK ? searched : status;
}
