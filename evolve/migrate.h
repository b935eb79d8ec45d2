/* Everything that processes say to each other: agreement on errors, migration around the rings, gathering of what was
 * found.  The only header of MPI. */
#ifndef FOOTPOINT_MIGRATE_H
#define FOOTPOINT_MIGRATE_H

#include "island.h"

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

/** Collective: replace value[0..n-1] on all ranks by the minimum over the ranks (n at most INT_MAX). */
void team_minimum(const struct team *t, double *value, size_t n);
/** Collective: sum over the ranks; for show alone, as its last bits depend on their number. */
double team_sum(const struct team *t, double value);

/** All islands of a run.  Ring r holds the islands r * places .. r * places + places - 1. */
struct sea {
    size_t rings, places;
    struct island **island; /* rings * places; NULL where another rank owns it */
    int *owner;             /* rank of each */
    size_t *max_length;     /* of each ring: genes */
};

/** Share the islands out, the longest genomes first, always to the rank with the least to do.  Not collective: all
 * ranks find the same. */
void team_share(const struct team *t, struct sea *s);

/** Collective: in every ring of two places or more, `migrants` copies of each island's best move to the next place. All
 *  leave before the first arrives, so that neither ranks nor order matter. */
void team_migrate(const struct team *t, struct sea *s, size_t migrants);

/** Collective: the front of every island, on rank 0: its island_report, all owned by the caller; NULL on other ranks.
 */
int **team_gather(const struct team *t, struct sea *s);

#endif
