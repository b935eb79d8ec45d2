/* The processes of a run, and their agreements before and after it. During the run they only exchange messages that
 * block no rank: mail.h, poll.h. */
#ifndef FOOTPOINT_TEAM_H
#define FOOTPOINT_TEAM_H

#include "../../codegen/base/base.h"

#include <mpi.h>

/** The processes of a run. */
struct team {
    MPI_Comm comm; /* owned: a duplicate */
    int rank, size;
};

/** Duplicates the communicator. Collective. */
struct team team_new(MPI_Comm comm);
/** Frees the communicator. Collective. */
void team_free(struct team *t);

/** Returns true on all ranks if `good` is true on all; otherwise false on all, with *d from the lowest failing rank.
 *  Collective. */
bool team_agree(const struct team *t, bool good, struct diag *d);
/** Returns a NUL-terminated copy of rank 0's text, owned by the caller; NULL stays NULL. Collective. */
char *team_tell(const struct team *t, const char *text, size_t bytes);

/** Returns a copy of rank `from`'s n numbers on all ranks, owned by the caller. *n and number matter on that rank only.
 *  Collective. */
int *team_pass(const struct team *t, int from, const int *number, size_t *n);

/** Collects in rank 0's array each number[i], i < n, from rank i mod size. Other ranks' arrays do not change. No number
 *  may be -0. Collective. */
void team_collect(const struct team *t, double *number, size_t n);

/** Replaces each of n numbers by its sum over the ranks, on all ranks. Collective. */
void team_sum(const struct team *t, size_t *number, size_t n);

/** Returns the largest tag that a message may have. Not collective. */
int team_last_tag(const struct team *t);

#endif
