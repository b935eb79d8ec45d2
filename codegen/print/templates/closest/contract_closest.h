/* The contract of functions of closed segments. */

/* NAME_closest:  finds the closest point r of the segment, its edges and corners included: loc = {xi, eta} there; dist, the
 *           distance |xS - r|, mesh length, < 0 if xS lies behind the segment; and region, where r lies: 0 inside, EDGES.
 *           Behind means (xS - r) . n < 0 for the segment's normal n at r or, where r_xi x r_eta is a thousand times shorter
 *           at r than at a thousandth (1/1024; float: 1/32) of the way to the middle, because an edge is collapsed, or
 *           almost, or an angle about 180 degrees, for the normal there.  At an edge or a corner xS is
 *           behind only by more than a small angle, 1e-12 (float: 1e-6), and by more than rounding: a node beside a flat
 *           segment, in its plane, has dist > 0.  A sign is no contact: xS penetrates if dist < 0 and region is 0, or if
 *           NAME_closest_of has dist < 0 for all segments there.
 *           Points of edges are right to the rounding of their distances; inside it is NAME_at's point, unless one of
 *           an edge is nearer.  On error all untouched: as the search, and FOOTPOINT_ERR_DOMAIN if r is farther from xS
 *           than the longest edge is long, slave nodes for which no search was measured.
 * NAME_closest_n:  the same for n pairs, each with its status; where that is an error, the rest may be overwritten.
 * NAME_closest_of:  finds the nearest of n segments, the nodes of segment i being x[SEGMENT_VECTORS i] and on, such as a
 *           search for neighbours hands over; which is its number.  dist < 0 behind the surface that the segments make: at
 *           an edge or a corner (xS - r) . n < 0 for the sum n of the unit normals of all segments that have it, each
 *           times its angle there (Baerentzen and Aanaes 2005).  That is the side of a closed surface if all segments
 *           at that edge or corner are among the n; if some are missing, it is the side of those that are given.  Nodes
 *           are the same if their coordinates are.  Where errors of NAME_at could hide which of two segments is nearer,
 *           loc is more accurate than that of NAME_closest.  Segments without an answer are passed over; if all are, the
 *           status is that of the last one, and FOOTPOINT_ERR_DOMAIN if n = 0. */
