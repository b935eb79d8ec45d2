/* The contract of functions over a segment, printed once for all genomes. */

/* NAME_at:  computes xi and eta, dimensionless, without any check.
 * NAME:     computes loc = {xi, eta} and the gap along the unit normal at the foot point (mesh length, > 0 open), both
 *           untouched on error.  Returns FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE or FOOTPOINT_ERR_DEGENERATE (no normal
 *           there, or a result is not finite).  In float without NAME_PROMISE, FOOTPOINT_UNPROVED replaces FOOTPOINT_OK.
 * NAME_n:   calls NAME_at for n pairs; x[3 k + i] is the column of coordinate i of vector k, NODE_NAMES;
 *           xi and eta must overlap nothing else.
 * NAME_checked_n:  calls NAME for n pairs, each with its status; if that is < 0, xi, eta and gap are meaningless.
 * NAME_over_n:  does the same for n slave nodes over a segment, if corners may have any order.  nodes are its vectors,
 *           x the three columns of the slave nodes. */
