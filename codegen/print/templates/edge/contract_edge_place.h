/* The contract of functions at a place of an edge. */

/* PREFIX_place:  computes at xi, which need not be a foot point: phi[NODES], shape functions; r_xi[2], tangent;
 *           normal[2], of length 1; gap, (xS - r) . normal.
 * PREFIX_gradients:  computes at a foot point xi: d_xi[COORDINATES] and d_gap[COORDINATES], derivatives of xi and of
 *           the gap by the coordinates of NODE_NAMES.
 * PREFIX_hessian:  also computes d_normal[2][COORDINATES], derivatives of each component of the normal by all
 *           coordinates, and hessian, second derivatives of the gap by coordinates r and c, r >= c, at [r (r + 1) / 2 +
 *           c].
 *           Outputs may be NULL. On error all outputs are untouched: FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE
 *           if there is no normal, if tangents are not between 1e-77 and 1e77 long or, for derivatives, if the foot
 *           point is the centre of curvature. */
