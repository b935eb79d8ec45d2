/* Judges functions with certain answers by the contracts in runtime/footpoint.h. */
#ifndef FOOTPOINT_JUDGES_H
#define FOOTPOINT_JUDGES_H

#include "verdict.h"

/* Error of the generated expression, in xi and eta, that runtime/certain/check.h proves. */
#define BANNER_WORST 1.024e-07

struct tally {
    long calls, answered, outside, not_unique, unproved, refused; /* by status */
    long wrong, wrong_status;                                     /* answers with too large an error; false statuses */
    double worst;
    const char *why; /* the last error found */
};

/** Each function judges a case, whose truth is known, and counts.  If the library found a nearer point than the truth, the truth is
 * corrected. */
void judge_robust(const struct hard_case *h, struct truth *t, struct tally *a);
void judge_stationary(const struct hard_case *h, const struct truth *t, struct tally *a);
void judge_locate(const struct hard_case *h, const struct truth *t, struct tally *a);

/** Judges the proof of a point near a foot point, at a distance that depends on key. */
void judge_certify(const struct hard_case *h, uint64_t key, struct tally *a);

/** Judges the selection from `count` segments that share their node number `at[k]`; t has the truths of all. */
void judge_select(const struct hard_case *h, const int *at, int count, const struct truth *t, struct tally *a);

/** Judges attach_2d_ with 3, 4, 6 or 8 nodes; t belongs to A, B, C, C for triangles. */
void judge_attach(const struct hard_case *h, int nodes, const struct truth *t, struct tally *a);

/** Judges that coordinates that are not finite are refused, and that nothing is written. */
void judge_not_finite(const struct hard_case *h, struct tally *robust, struct tally *stationary, struct tally *locate);

#endif
