/* The contract of searches that begin with the last answer. */

/* NAME_from:  does the same as NAME, from the last answer: loc must be set to {xi, eta} of the last step or of a neighbour's
 *           foot point. It is fastest if the foot point has moved by less than 0.1. If steps from loc prove nothing, or
 *           lead farther than half of the segment, or if a number in loc is NaN or infinite, it calls NAME; callers
 *           without a last answer set NaN. Statuses, outputs and proofs are those of NAME, though rounding differs. On
 *           a folded segment with several close minima, the answer is the minimum to which steps from loc lead; it need
 *           not be NAME's, nor the nearest.
 * NAME_from_n:  does the same for n pairs, with last answers in xi and eta, which the new answers replace unless the
 *           status is < 0.
 * NAME_from_over_n:  does the same for n slave nodes over one segment, like NAME_over_n. */
