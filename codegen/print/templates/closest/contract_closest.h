/* What the functions of closed segments do, said once for all genomes. */

/* NAME_closest:  the closest point r of the segment, its edges and corners included: loc = {xi, eta} there, its distance
 *           |xS - r| (mesh length; < 0 behind, where (xS - r) . (NORMAL) is), and region, where it lies:
 *           0 inside, EDGES.
 *           Points of edges are right to the rounding of their distances; inside it is NAME_at's point, unless one of
 *           an edge is nearer.  On error all untouched: as the search, and FOOTPOINT_ERR_DOMAIN if r is farther from xS
 *           than the longest edge is long, slave nodes for which no search was measured.
 * NAME_closest_n:  the same for n pairs, each with its status; where that is an error, the rest may be overwritten.
 * NAME_closest_of:  the nearest of n segments, the nodes of segment i being x[SEGMENT_VECTORS i] and on, such as a
 *           search for neighbours hands over; which is its number, of several as near as each other to rounding that
 *           of the one which xS lies straightest over.  Segments without an answer are passed over; if all are, the
 *           status is that of the last one, and FOOTPOINT_ERR_DOMAIN if n = 0. */
