/* The contract of functions of closed segments that prove their answers. */

/* NAME_closest:  finds the closest point r of the segment, its edges and corners included: loc = {xi, eta} there; dist, the
 *           distance |xS - r|, mesh length, < 0 if xS lies behind the segment; and region, where r lies: 0 inside, EDGES.
 *           FOOTPOINT_OK is proved, rounding errors included, which no order of summation changes: the point of the closed
 *           segment that is closest to xS lies within NAME_PROMISE of loc, in xi and in eta, and in `region`, unless it is
 *           within REAL_CLOSE of the border of that.  So dist exceeds the least distance by NAME_PROMISE times the largest
 *           |r_xi| + |r_eta| at most.  FOOTPOINT_NOT_UNIQUE is proved, too: no point is nearer than r by more than REAL_TIE of the
 *           longest edge, and another, elsewhere in space, is not farther by more.  FOOTPOINT_UNPROVED: r is the nearest
 *           point that descents have found; so are all answers under -ffast-math.  Where two nodes are one point, xi or eta
 *           may be any number of the edge between them.
 *           Behind means (xS - r) . n < 0 for the segment's normal n at r or, where r_xi x r_eta is a thousand times shorter
 *           at r than at a thousandth (1/1024; float: 1/32) of the way to the middle, because an edge is collapsed, or
 *           almost, or an angle about 180 degrees, for the normal there.  At an edge or a corner xS is
 *           behind only by more than a small angle, 1e-12 (float: 1e-6), and by more than rounding: a node beside a flat segment, in its
 *           plane, has dist > 0.  A sign is no contact: xS penetrates if dist < 0 and region is 0, or if NAME_closest_of
 *           has dist < 0 for all segments there.
 *           On error all untouched: FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE, if the segment has no area; and
 *           FOOTPOINT_ERR_DOMAIN, if r is farther from xS than the longest edge is long.
 * NAME_closest_from:  the same with the last answer, or NaN, in loc.  Down to promises of 1e-5 it begins there and falls back
 *           to NAME_closest if it proves nothing; finer ones begin anew, which is as fast.  region 1 to 8 is where xS leaves
 *           the segment: the edge or corner whose neighbour to search next.
 * NAME_closest_n:  the same for n pairs, each with its status; where that is an error, the rest may be overwritten.
 * NAME_closest_of:  finds the nearest of n segments, the nodes of segment i being x[SEGMENT_VECTORS i] and on, such as a
 *           search for neighbours hands over; which is its number.  dist < 0 behind the surface that the segments make: at
 *           an edge or a corner (xS - r) . n < 0 for the sum n of the unit normals of all segments that have it, each
 *           times its angle there (Baerentzen and Aanaes 2005).  That is the side of a closed surface if all segments
 *           at that edge or corner are among the n; if some are missing, it is the side of those that are given.  Nodes
 *           are the same if their coordinates are.  FOOTPOINT_UNPROVED also if a segment whose answer is not proved may be
 *           nearer.  Where errors of loc could hide which of two segments is nearer, both are found to rounding.  Segments
 *           without an answer are passed over; if all are, the status is that of the last one, and FOOTPOINT_ERR_DOMAIN if
 *           n = 0. */
