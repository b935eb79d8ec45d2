/* The processes of a run, and what they agree on before and after it.  During it there is nothing but messages that
 * are on their way while everybody goes on: mail.h, poll.h. */
#ifndef FOOTPOINT_TEAM_H
#define FOOTPOINT_TEAM_H

#include "../../codegen/base/base.h"

#include <mpi.h>

/** The processes of a run. */
struct team {
    MPI_Comm comm; /* owned: a duplicate */
    int rank, size;
};

/** Collective. */
struct team team_new(MPI_Comm comm);
/** Collective. */
void team_free(struct team *t);

/** Collective: true on all ranks if `good` on all; otherwise false on all, with the *d of the lowest failing rank. */
bool team_agree(const struct team *t, bool good, struct diag *d);
/** Collective: copy of rank 0's text (NULL stays NULL), owned by the caller; NUL-terminated. */
char *team_tell(const struct team *t, const char *text, size_t bytes);

/** Collective: copy of rank `from`'s n numbers on all ranks, owned by the caller; *n and number count on that rank. */
int *team_pass(const struct team *t, int from, const int *number, size_t *n);

/** Collective: number[i], i < n, as rank i mod size has it, on rank 0; the others' arrays stay.  None is -0. */
void team_collect(const struct team *t, double *number, size_t n);

/** Collective: the sums over the ranks of each of n numbers, on all of them. */
void team_sum(const struct team *t, size_t *number, size_t n);

/** The largest tag that a message may have.  Not collective. */
int team_last_tag(const struct team *t);

#endif
