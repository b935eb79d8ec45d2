/* Judges of the functions whose answers are certain, by what runtime/footpoint.h says of them. */
#ifndef FOOTPOINT_JUDGES_H
#define FOOTPOINT_JUDGES_H

#include "verdict.h"

/* Of the generated expression, in xi and eta: what runtime/certain/check.h vouches for. */
#define BANNER_WORST 1.024e-07

struct tally {
    long calls, answered, outside, not_unique, unproved, refused; /* by status */
    long wrong, wrong_status;                                     /* answers too far off; statuses that are not true */
    double worst;
    const char *why; /* the last thing that was wrong */
};

/** Each puts the function to one case, whose truth is known, and keeps count.  Where the library found a nearer point
 * than the truth, that is mended. */
void judge_robust(const struct hard_case *h, struct truth *t, struct tally *a);
void judge_stationary(const struct hard_case *h, const struct truth *t, struct tally *a);
void judge_locate(const struct hard_case *h, const struct truth *t, struct tally *a);

/** Asks for the proof of a point near a foot point, how near, key tells. */
void judge_certify(const struct hard_case *h, uint64_t key, struct tally *a);

/** From `count` segments that share the node number `at[k]` of theirs; truths of all. */
void judge_select(const struct hard_case *h, const int *at, int count, const struct truth *t, struct tally *a);

/** attach_2d_ with 3, 4, 6 or 8 nodes; t: of A, B, C, C for triangles. */
void judge_attach(const struct hard_case *h, int nodes, const struct truth *t, struct tally *a);

/** Node values that are not numbers are refused, and nothing is written. */
void judge_not_finite(const struct hard_case *h, struct tally *robust, struct tally *stationary, struct tally *locate);

#endif
