/* The contract of derivatives along a direction. */

/* PREFIX_gradients_along:  at xi as PREFIX_along found it: dist, and d_xi and d_dist, the derivatives of xi and dist by the
 *           COORDINATES coordinates of NODE_NAMES and, last, the two of `along`.
 * PREFIX_hessian_along:  likewise second derivatives h_xi and h_dist, packed: by coordinates r and c, r >= c, at [r (r + 1) / 2 + c].
 *           Outputs may be NULL.  On error all untouched: FOOTPOINT_ERR_NOT_FINITE, an input or a result;
 *           FOOTPOINT_ERR_DEGENERATE: no length, no direction, or the line is so nearly parallel to the edge that rounding may
 *           cost derivatives more than about 1e-9; FOOTPOINT_ERR_DOMAIN: xS is too far away. */
