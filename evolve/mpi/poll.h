/* Polls: sums and minima over the ranks that nobody waits for. */
#ifndef FOOTPOINT_POLL_H
#define FOOTPOINT_POLL_H

#include "team.h"

/** Polls 1, 2, ..., each of which every rank joins, in order, without waiting for the others. */
struct poll {
    size_t sums, minima; /* numbers of a poll */
    size_t lag; /* so many polls may be uncounted: grows with the logarithm of the ranks, as the way of a result does */
    size_t cast, counted;
    struct poll_slot {
        double *sum[2];   /* owned: own, and of all */
        double *least[2]; /* owned: own, and of all, on rank 0 alone */
        MPI_Request request[2];
    } * slot; /* owned: lag of them */
};
struct poll poll_new(const struct team *t, size_t sums, size_t minima);
/** Join the next poll; returns at once.  At most p->lag polls may be uncounted. */
void poll_cast(const struct team *t, struct poll *p, const double *sum, const double *least);
/** The next poll if all ranks have joined it: its slot, valid until the next poll_cast; NULL: not yet. */
const struct poll_slot *poll_count(struct poll *p);
void poll_free(struct poll *p);

#endif
