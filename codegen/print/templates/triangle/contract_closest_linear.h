/* The contract of functions of closed plane triangles. */

/* NAME_closest:  finds the closest point r of the segment, its edges and corners included: loc = {xi, eta} there; dist, the
 *           distance |xS - r|, mesh length, < 0 if xS lies behind the segment; and region, where r lies: 0 inside, EDGES.
 *           FOOTPOINT_OK is proved, rounding errors included, which no order of summation changes: the point of the closed
 *           segment that is closest to xS lies within NAME_PROMISE of loc, in xi and in eta, and in `region`, unless it is
 *           within NAME_PROMISE of the border of that.  Elsewhere FOOTPOINT_UNPROVED, as rounding forbids the promise, and
 *           under -ffast-math.
 *           Behind means (xS - r) . n < 0 for the segment's normal n.  At an edge or a corner xS is behind only by more
 *           than a small angle, 1e-12, and by more than rounding: a node beside a segment, in its plane, has dist > 0.  A
 *           sign is no contact: xS penetrates if dist < 0 and region is 0, or if NAME_closest_of has dist < 0 for all
 *           segments there.
 *           On error all untouched: FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE, if the segment has no area; and
 *           FOOTPOINT_ERR_DOMAIN, if r is farther from xS than the longest edge is long.
 * NAME_closest_n:  the same for n pairs, each with its status; where that is an error, the rest may be overwritten.
 * NAME_closest_of:  finds the nearest of n segments, the nodes of segment i being x[SEGMENT_VECTORS i] and on, such as a
 *           search for neighbours hands over; which is its number.  dist < 0 behind the surface that the segments make: at
 *           an edge or a corner (xS - r) . n < 0 for the sum n of the unit normals of all segments that have it, each
 *           times its angle there (Baerentzen and Aanaes 2005).  That is the side of a closed surface if all segments
 *           at that edge or corner are among the n; if some are missing, it is the side of those that are given.  Nodes
 *           are the same if their coordinates are.  FOOTPOINT_UNPROVED also if a segment whose answer is not proved may be
 *           nearer.  Of distances that are equal to rounding either may be taken.  Segments without an answer are passed
 *           over; if all are, the status is that of the last one, and FOOTPOINT_ERR_DOMAIN if n = 0. */
