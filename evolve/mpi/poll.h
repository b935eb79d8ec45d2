/* Polls: sums and minima over the ranks, without waiting. */
#ifndef FOOTPOINT_POLL_H
#define FOOTPOINT_POLL_H

#include "team.h"

/** Polls 1, 2, ... Every rank joins each in order, without waiting for the others. */
struct poll {
    size_t sums, minima; /* numbers in a poll */
    size_t lag;          /* most polls in flight; grows with the logarithm of the number of ranks, like the latency of a
                 * reduction */
    size_t cast, counted;
    struct poll_slot {
        double *sum[2];   /* this rank's, and the total */
        double *least[2]; /* this rank's, and the minimum, on rank 0 only */
        MPI_Request request[2];
    } * slot;            /* `lag` slots */
    struct arena memory; /* owned: of the slots */
};
struct poll poll_new(const struct team *t, size_t sums, size_t minima);
/** Joins the next poll and returns at once. At most p->lag polls may be in flight. */
void poll_cast(const struct team *t, struct poll *p, const double *sum, const double *least);
/** Returns the slot of the next poll if all ranks have joined it, otherwise NULL. The slot is valid until the next
 *  poll_cast. */
const struct poll_slot *poll_count(struct poll *p);

#endif
