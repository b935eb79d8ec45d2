/* The contract of functions of closed segments that prove their answers. */

/* NAME_closest:  finds the closest point r of the segment, its edges and corners included: loc = {xi, eta} there; dist, the
 *           distance |xS - r|, mesh length, < 0 if xS lies behind the segment; and region, the part that contains r: 0 inside, EDGES.
 *           FOOTPOINT_OK is proved, rounding errors included, which no order of summation changes: the point of the closed
 *           segment that is closest to xS lies within NAME_PROMISE of loc, in xi and in eta, and in `region`, unless it is
 *           within REAL_CLOSE of the region's border.  So dist exceeds the least distance by at most NAME_PROMISE times the
 *           largest |r_xi| + |r_eta|.  FOOTPOINT_NOT_UNIQUE is proved, too: no point is nearer than r by more than REAL_TIE of the
 *           longest edge, and another point, elsewhere in space, is not farther by more.  FOOTPOINT_UNPROVED: r is the nearest
 *           point that descents have found; under -ffast-math this is the status of all answers.  If two nodes coincide, xi or
 *           eta may be any number of the edge between them.
 *           Behind means (xS - r) . n < 0 for the segment's normal n at r.  If r_xi x r_eta at r is a thousand times shorter
 *           than at a thousandth (1/1024; float: 1/32) of the way to the middle, as at a collapsed edge or at an angle of
 *           about 180 degrees, n is the normal at the latter point.  At an edge or a corner xS is
 *           behind only by more than a small angle, 1e-12 (float: 1e-6), and by more than rounding: a node beside a flat
 *           segment, in its plane, has dist > 0.  A negative sign is not yet contact: xS penetrates if dist < 0 and region
 *           is 0, or if NAME_closest_of with all segments there has dist < 0.
 *           On error all outputs are untouched: FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE if the segment has no area;
 *           FOOTPOINT_ERR_DOMAIN if r is farther from xS than the longest edge; FOOTPOINT_UNPROVED is possible there, too.
 * NAME_closest_from:  does the same from the last answer, or NaN, in loc.  Down to promises of 1e-5 it begins there and calls
 *           NAME_closest if it proves nothing; finer promises begin anew, which is as fast.  region 1 to 8 is the edge or corner
 *           at which xS leaves the segment: search the neighbour there next.
 * NAME_closest_n:  does the same for n pairs, each with its status; on error the other results may be overwritten.
 * NAME_closest_of:  finds the nearest of n segments, the nodes of segment i being x[SEGMENT_VECTORS i] and on, such as a
 *           search for neighbours returns; which is its number.  dist < 0 behind the surface of the segments: at
 *           an edge or a corner (xS - r) . n < 0 for the sum n of the unit normals of all segments that share it, each
 *           times its angle there (Baerentzen and Aanaes 2005).  This is the side of a closed surface if all segments
 *           at that edge or corner are among the n; otherwise it is the side of the given segments.  Nodes with
 *           equal coordinates are the same node.  FOOTPOINT_UNPROVED also if a segment without a proved answer may be
 *           nearer.  If errors of loc could hide which of two segments is nearer, both are found to rounding.  Segments
 *           without an answer are skipped; if no segment has an answer, the status is the last segment's, and
 *           FOOTPOINT_ERR_DOMAIN if n = 0. */
