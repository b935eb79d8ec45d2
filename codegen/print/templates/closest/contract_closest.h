/* The contract of functions of closed segments. */

/* NAME_closest:  finds the closest point r of the segment, its edges and corners included: loc = {xi, eta} there; dist, the
 *           distance |xS - r|, mesh length, < 0 if xS lies behind the segment; and region, the part that contains r: 0 inside, EDGES.
 *           Behind means (xS - r) . n < 0 for the segment's normal n at r.  If r_xi x r_eta at r is a thousand times shorter
 *           than at a thousandth (1/1024; float: 1/32) of the way to the middle, as at a collapsed edge or at an angle of
 *           about 180 degrees, n is the normal at the latter point.  At an edge or a corner xS is
 *           behind only by more than a small angle, 1e-12 (float: 1e-6), and by more than rounding: a node beside a flat
 *           segment, in its plane, has dist > 0.  A negative sign is not yet contact: xS penetrates if dist < 0 and region
 *           is 0, or if NAME_closest_of with all segments there has dist < 0.
 *           Points of edges are right to the rounding of their distances; inside it is NAME_at's point, unless a point of
 *           an edge is nearer.  On error all outputs are untouched: statuses of the search, and FOOTPOINT_ERR_DOMAIN if r is
 *           farther from xS than the longest edge, a range in which no search was measured.
 * NAME_closest_n:  does the same for n pairs, each with its status; on error the other results may be overwritten.
 * NAME_closest_of:  finds the nearest of n segments, the nodes of segment i being x[SEGMENT_VECTORS i] and on, such as a
 *           search for neighbours returns; which is its number.  dist < 0 behind the surface of the segments: at
 *           an edge or a corner (xS - r) . n < 0 for the sum n of the unit normals of all segments that share it, each
 *           times its angle there (Baerentzen and Aanaes 2005).  This is the side of a closed surface if all segments
 *           at that edge or corner are among the n; otherwise it is the side of the given segments.  Nodes with
 *           equal coordinates are the same node.  If errors of NAME_at could hide which of two segments is nearer,
 *           loc is more accurate than NAME_closest's.  Segments without an answer are skipped; if no segment has an answer,
 *           the status is the last segment's, and FOOTPOINT_ERR_DOMAIN if n = 0. */
