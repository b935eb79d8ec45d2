/* The processes of a run, and their agreements before and after it. During the run they only exchange messages that
 * block no rank: mail.h, poll.h. */
#ifndef FOOTPOINT_TEAM_H
#define FOOTPOINT_TEAM_H

#include "../../codegen/base/base.h"

#include <mpi.h>

/** Ends the job on a network failure, because ranks cannot agree on anything then. */
void mpi_check(int code, const char *call);
#define CHECK(call) mpi_check((call), #call)

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

/** Replaces each of n numbers by its sum over the ranks, on all ranks. Collective. */
void team_sum(const struct team *t, size_t *number, size_t n);

/** Returns the largest tag that a message may have. Not collective. */
int team_last_tag(const struct team *t);

#endif
