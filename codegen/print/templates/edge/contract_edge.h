/* The contract of functions of edges. */

/* Contact in the plane: edges of NODES nodes xA, xB, ..., each (x, y); A lies at xi = -1, B at xi = 1, and C, the
 * middle node of an edge of three, at xi = 0. The body lies to the left of A -> B, as Abaqus numbers the faces of plane
 * elements: the normal n = (t_y, -t_x) / |t| of the tangent t points to the side of the slave nodes.
 *
 * NAME_at:  xi, dimensionless; nothing is checked.
 * NAME:     xi and the gap (xS - r) . n at the foot point r (mesh length, > 0 open), both untouched if the status is < 0.
 *           FOOTPOINT_OK only if a minimum of the distance to the whole curve, which goes on beyond the ends, is proved to
 *           lie within PROMISE, a macro, of xi, times |xi| if that is greater than 1, rounding errors included, in any
 *           order of summation.  FOOTPOINT_UNPROVED: xi and gap are where the search ended; under -ffast-math nothing is
 *           proved.  FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE: all nodes are one point, or there is no normal
 *           there, or no number.  A minimum need not be the nearest point of the edge: see NAME_closest.
 * NAME_from:  NAME from the last answer: xi must be set, or NaN.  If steps from there prove nothing, or lead farther than
 *           half of the edge, it calls NAME.  If there are two minima, the answer may be the other one.
 * NAME_closest:  finds the closest point r of the edge, its ends included: xi; dist, the distance |xS - r|, < 0 if xS lies
 *           behind the edge; and region, where r lies: 0 inside, 1 end A, 2 end B.  FOOTPOINT_OK is proved: the closest point
 *           lies within PROMISE of xi, and in `region`, unless it is within REAL_CLOSE of an end.  FOOTPOINT_NOT_UNIQUE
 *           is proved, too: no point is nearer than r by more than REAL_TIE |AB|, and another, elsewhere in the plane, is
 *           not farther by more.  FOOTPOINT_UNPROVED: r is the nearest point found.
 *           Behind means (xS - r) . n < 0 for the normal n at r or, if the tangent at r is a thousand times shorter than
 *           at a thousandth (1/1024; float: 1/32) of the way to the middle, for the normal there.  At an end xS is behind only by more
 *           than a small angle, REAL_TURN, and by more than rounding.
 *           On error all untouched: FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE, if all nodes are one point; and
 *           FOOTPOINT_ERR_DOMAIN, if r is farther from xS than 1e149 edges (float: 1e14), or the distance is no number.
 * NAME_closest_of:  finds the nearest of n edges, the nodes of edge i being x[NODES i] and on; which is its number.  At an end
 *           dist < 0 if xS lies behind the sum of the unit normals of all edges that have that end.  Nodes are the same if
 *           their coordinates are.  FOOTPOINT_UNPROVED also if the answer of any edge is not proved.  Edges without an answer
 *           are passed over; if all are, the status is that of the last one, and FOOTPOINT_ERR_DOMAIN if n = 0.
 * NAME_n, NAME_checked_n, NAME_from_n, NAME_closest_n:  NAME_at, NAME, NAME_from and NAME_closest for n pairs, each with its
 *           status; x[2 k + i] is the column of coordinate i of vector k, NODE_NAMES.  If the status is < 0, the other
 *           outputs may be overwritten.  Outputs overlap nothing else.
 * NAME_over_n:  NAME for n slave nodes over one edge: nodes are its vectors, x the two columns of the slave nodes. */
