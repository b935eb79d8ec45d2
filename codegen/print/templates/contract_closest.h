/* What the functions of closed segments do, said once for all genomes. */

/* NAME_closest:  the closest point r of the segment, its edges and corners included: loc = {xi, eta} there, its distance
 *           |xS - r| (mesh length; < 0 behind, where (xS - r) . (NORMAL) is), and where it lies:
 *           region 0 inside, EDGES.
 *           All untouched on error: as NAME, or FOOTPOINT_ERR_DOMAIN if r is farther from xS than the longest edge is
 *           long.  Points of edges are right to rounding, those inside as right as NAME_at's.
 * NAME_closest_n:  the same for n pairs; what is not FOOTPOINT_OK may be written. */
