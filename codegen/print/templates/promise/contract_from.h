/* The contract of searches that begin with the last answer. */

/* NAME_from:  NAME from the last answer: loc must be set, to {xi, eta} of the step before or of a neighbour's foot point.
 *           Fastest if the foot point has moved by less than 0.1.  Where steps from loc prove nothing, or lead farther
 *           than half of the segment, and where a number in loc is NaN or infinite, it calls NAME: callers without a last
 *           answer set NaN.  Statuses, outputs and proofs are those of NAME, though rounding differs.  On a folded segment,
 *           where several minima lie close together, the answer is the minimum that steps from loc lead to; it need not be
 *           the one that NAME finds, nor the nearest.
 * NAME_from_n:  the same for n pairs, with last answers in xi and eta, which the new ones overwrite unless the status is < 0.
 * NAME_from_over_n:  the same for n slave nodes over one segment, as NAME_over_n. */
