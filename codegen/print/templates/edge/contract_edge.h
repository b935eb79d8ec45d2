/* The contract of functions of edges. */

/* Contact in the plane: edges of NODES nodes xA, xB, ..., each (x, y); A lies at xi = -1, B at xi = 1, and C, the
 * middle node of an edge of three, at xi = 0. The body lies to the left of A -> B, as Abaqus numbers the faces of plane
 * elements: the normal n = (t_y, -t_x) / |t| of the tangent t points to the side of the slave nodes.
 *
 * NAME_at:  computes xi, dimensionless; checks nothing.
 * NAME:     computes xi and the gap (xS - r) . n at the foot point r (mesh length, > 0 open).  FOOTPOINT_OK is proved,
 *           rounding errors included, in any order of summation: a minimum of the distance to the whole curve, which
 *           continues beyond the ends, lies within PROMISE, a macro, of xi, times |xi| if that is greater than 1.
 *           FOOTPOINT_UNPROVED: xi and gap are those at the end of the search; under -ffast-math nothing is proved.
 *           On error xi and gap are untouched: FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE if all nodes are one
 *           point, or there is no normal there, or a result is no number.  A minimum need not be the nearest point of
 *           the edge: see NAME_closest.
 * NAME_from:  does the same from the last answer: xi must be set, or NaN.  If steps from there prove nothing, or lead
 *           farther than half of the edge, it calls NAME.  If there are two minima, the answer may be the other one.
 * NAME_closest:  finds the closest point r of the edge, its ends included: xi; dist, the distance |xS - r|, < 0 if xS lies
 *           behind the edge; and region, the place of r: 0 inside, 1 end A, 2 end B.  FOOTPOINT_OK is proved: the closest
 *           point lies within PROMISE of xi, and in `region`, unless it is within REAL_CLOSE of an end.
 *           FOOTPOINT_NOT_UNIQUE is proved, too: no point is nearer than r by more than REAL_TIE |AB|, and another,
 *           elsewhere in the plane, is not farther by more.  FOOTPOINT_UNPROVED: r is the nearest point found.
 *           Behind means (xS - r) . n < 0 for the normal n at r or, if the tangent at r is a thousand times shorter than
 *           at a thousandth (1/1024; float: 1/32) of the way to the middle, for the normal there.  At an end xS is behind
 *           only by more than a small angle, REAL_TURN, and by more than rounding.
 *           On error all outputs are untouched: FOOTPOINT_ERR_NOT_FINITE; FOOTPOINT_ERR_DEGENERATE if all nodes are one
 *           point; FOOTPOINT_ERR_DOMAIN if r is farther from xS than 1e149 edges (float: 1e14), or the distance is no
 *           number.
 * NAME_closest_of:  finds the nearest of n edges, the nodes of edge i being x[NODES i] and on; which is its number.  At an
 *           end dist < 0 if xS lies behind the sum of the unit normals of all edges that share that end.  Nodes with equal
 *           coordinates are the same node.  FOOTPOINT_UNPROVED also if the answer of any edge is not proved.  Edges
 *           without an answer are skipped; if no edge has an answer, the status is the last edge's, and
 *           FOOTPOINT_ERR_DOMAIN if n = 0.
 * NAME_n, NAME_checked_n, NAME_from_n, NAME_closest_n:  do the same as NAME_at, NAME, NAME_from and NAME_closest for n
 *           pairs, each with its status; x[2 k + i] is the column of coordinate i of vector k, NODE_NAMES.  If the status
 *           is < 0, the other outputs may be overwritten.  Outputs must not overlap anything else.
 * NAME_over_n:  does the same as NAME for n slave nodes over one edge: nodes are its vectors, x the two columns of the
 *           slave nodes. */
