/* What projection along a direction promises. */

/* PREFIX_along:  where the line through xS in the direction `along`, of any length but 0, meets the edge: xi, and dist with
 *           xS = r(xi) + dist along / |along|.  FOOTPOINT_OK is proved: the line meets the curve within ALONG_PROMISE of xi,
 *           and the edge nowhere else; FOOTPOINT_NOT_UNIQUE, it meets the edge twice, the point that is nearer to xS is the
 *           answer; FOOTPOINT_OUTSIDE, it meets the edge nowhere, but the curve beyond its ends within the promise of xi, times
 *           |xi|.  FOOTPOINT_UNPROVED: any of these, as where it nearly touches the edge.  xi and dist are untouched where it
 *           returns FOOTPOINT_ERR_DOMAIN: it does not meet the curve, or there is no number; FOOTPOINT_ERR_DEGENERATE: no
 *           length, no direction, or that of a straight edge; and FOOTPOINT_ERR_NOT_FINITE.
 * PREFIX_along_n:  the same for n pairs, each with its status and its direction, two columns. */
