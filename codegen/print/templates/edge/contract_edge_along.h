/* The contract of projection along a direction on edges. */

/* PREFIX_along:  finds the point at which the line through xS in the direction `along`, of any length but 0, meets the
 *           edge: xi, and dist with xS = r(xi) + dist along / |along|. FOOTPOINT_OK is proved: the line meets the curve
 *           within ALONG_PROMISE of xi, and the edge nowhere else. FOOTPOINT_NOT_UNIQUE is proved: it meets the edge
 *           twice, and the answer is the point nearer to xS. FOOTPOINT_OUTSIDE is proved: it does not meet the edge,
 *           but the curve beyond its ends within the promise of xi, times |xi|. FOOTPOINT_UNPROVED: any of these, for
 *           example if the line nearly touches the edge.
 *           On error xi and dist are untouched: FOOTPOINT_ERR_DOMAIN if the line does not meet the curve, or a result
 *           is not finite; FOOTPOINT_ERR_DEGENERATE if edge or direction have no length, or the line is parallel to a
 *           straight edge; and FOOTPOINT_ERR_NOT_FINITE.
 * PREFIX_along_n:  does the same for n pairs, each with its status and its direction, two columns. */
