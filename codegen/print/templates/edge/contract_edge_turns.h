/* The contract of derivatives along a direction. */

/* PREFIX_gradients_along:  computes, at xi as PREFIX_along found it, dist and the derivatives d_xi and d_dist of xi and
 *           dist by the COORDINATES coordinates of NODE_NAMES and, last, the two of `along`.
 * PREFIX_hessian_along:  also computes second derivatives h_xi and h_dist, packed: by coordinates r and c, r >= c, at
 *           [r (r + 1) / 2 + c].
 *           Outputs may be NULL.  On error all outputs are untouched: FOOTPOINT_ERR_NOT_FINITE if an input or a result is
 *           not finite; FOOTPOINT_ERR_DEGENERATE if edge or direction have no length, or the line is so nearly parallel to
 *           the edge that rounding may cost derivatives more than about 1e-9; FOOTPOINT_ERR_DOMAIN if xS is too far away. */
