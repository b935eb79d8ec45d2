/* Evaluates a program at several points side by side, in loops that compilers vectorise: in double as the C text
 * prescribes, and in pairs of doubles, x + y with |y| <= 2^-53 |x|, with errors of about 2^-100 of intermediate
 * values. */
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

/** The places of the values of a program's first operations. A place is reused after a value's last use, so that places
 *  stay in the cache. */
struct lanes_plan {
    const struct program *program; /* not owned */
    size_t ops, slots, steps;
    int *slot;               /* owned: by operation */
    struct lanes_step *step; /* owned: the operations except constants, with the places of their inputs */
};

/** Plans the first `ops` operations. kept: indexed by operation; values needed at the end. */
struct lanes_plan lanes_plan_new(const struct program *p, size_t ops, const bool *kept);
void lanes_plan_free(struct lanes_plan *plan);

/** Returns places with the constants filled in, as doubles or, if `low` is not NULL, as the upper halves of pairs whose
 *  lower halves go to *low. The caller frees both. */
struct lanes *lanes_new(const struct lanes_plan *plan, struct lanes **low);

/** Computes the operations at all points in double, except constants, which must be set already.
 *  @param[in] input     indexed by input
 *  @param[in] contract  NULL, or a stream of random numbers that decides for each sum of products whether it is one
 *                       fma()
 *  @param[in,out] value indexed by place */
void lanes_double(const struct lanes_plan *plan, const struct lanes *input, uint64_t *contract, struct lanes *value);

/** Computes the operations at all points in pairs. A pair becomes NaN if its value is not a number or exceeds the range
 *  of the method. */
void lanes_pairs(const struct lanes_plan *plan, const struct lanes *input, struct lanes *high, struct lanes *low);

#endif
