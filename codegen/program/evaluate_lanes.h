/* A program at several points side by side, in loops that compilers vectorise: in double as the C text says, and in pairs of
 * doubles, x + y with |y| <= 2^-53 |x|, whose errors are about 2^-100 of the values on the way. */
#ifndef FOOTPOINT_EVALUATE_LANES_H
#define FOOTPOINT_EVALUATE_LANES_H

#include "program.h"

#include <stdint.h>

enum { LANES = 16 };

/** A value at each of the points. */
struct lanes {
    double at[LANES];
};

struct lanes_step;

/** Where the values of a program's first operations are kept.  A place is used again after a value's last use, so that
 *  they stay in the cache. */
struct lanes_plan {
    const struct program *program; /* not owned */
    size_t ops, slots, steps;
    int *slot;               /* owned: by operation */
    struct lanes_step *step; /* owned: the operations but constants, with the places of what they take */
};

/** `kept`, indexed by operation: its value is asked for at the end. */
struct lanes_plan lanes_plan_new(const struct program *p, size_t ops, const bool *kept);
void lanes_plan_free(struct lanes_plan *plan);

/** Returns places with the constants filled in, as doubles, or, where `low` is not NULL, as the upper halves of pairs, the
 *  lower ones of which go to *low.  Caller frees. */
struct lanes *lanes_new(const struct lanes_plan *plan, struct lanes **low);

/** Computes the operations at all points in double, beside constants, which are there already.
 *  @param[in] input     indexed by input
 *  @param[in] contract  NULL, or a stream of random numbers that decides for each sum of products whether it is one fma()
 *  @param[in,out] value indexed by place */
void lanes_double(const struct lanes_plan *plan, const struct lanes *input, uint64_t *contract, struct lanes *value);

/** Computes the operations at all points in pairs.  Where a value is no number, or too large for the way it is computed, a
 *  pair is no number. */
void lanes_pairs(const struct lanes_plan *plan, const struct lanes *input, struct lanes *high, struct lanes *low);

#endif
