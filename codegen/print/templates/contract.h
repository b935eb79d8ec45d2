/* What the functions over a segment do, said once for all genomes. */

/* NAME_at:  xi and eta, dimensionless; nothing is checked.
 * NAME:     loc = {xi, eta} and the gap along the unit normal at the foot point (mesh length, > 0 open), both
 *           untouched on error.  Returns FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE or FOOTPOINT_ERR_DEGENERATE: no normal
 *           there, or no number.  In float FOOTPOINT_UNPROVED stands for FOOTPOINT_OK if there is no NAME_PROMISE.
 * NAME_n:   NAME_at for n pairs; x[3 k + i] is the column of coordinate i of vector k, NODE_NAMES;
 *           xi and eta overlap nothing else.
 * NAME_checked_n:  NAME for n pairs, each with its status; where that is < 0, xi, eta and gap say nothing.
 * NAME_over_n:  the same for n slave nodes over one segment, where corners may have any order: what belongs to the
 *           segment alone is computed once; nodes are its vectors, x the three columns of the slave nodes. */
