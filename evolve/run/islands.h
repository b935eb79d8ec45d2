/* The islands of a run, shared out over the ranks, and what rank 0 gathers from them. */
#ifndef FOOTPOINT_ISLANDS_H
#define FOOTPOINT_ISLANDS_H

#include "../archive/archive.h"
#include "../island/island.h"
#include "../mpi/mail.h"

/** Tags of messages: blocks for rank 0, and migrants. */
enum tag { TAG_LOG, TAG_REPORT, TAG_MIGRANTS /* + the receiving island: the last */ };

/** What a ring of islands searches for. */
struct ring {
    struct quest *quest; /* not owned */
    size_t max_length;   /* genes */
    double load;         /* of its islands: what an individual costs, about */
};
/** Its key in random streams. */
static inline size_t ring_key(const struct ring *r)
{
    return 2 * r->quest->tier + (size_t)(r->quest->output == 1);
}

/** All islands of a run.  Ring r holds the islands r * places .. r * places + places - 1. */
struct islands {
    size_t rings, places;
    struct ring *ring;      /* owned, as are these, by island: */
    struct island **island; /* NULL where another rank owns it */
    int *owner;             /* rank */
    bool *seeded;           /* started from a champion */
};
size_t islands_count(const struct islands *s);
void islands_free(struct islands *s);

/** Share the islands out over so many ranks, the dearest first, always to the rank with the least to do.  Not
 *  collective: all ranks find the same. */
void islands_share(struct islands *s, int size);

/** False with *d where MPI has not tags enough for this many islands.  Not collective. */
bool islands_can_be_tagged(const struct islands *s, const struct team *t, struct diag *d);

/** Collective: a size of each island, as the rank that has it says, to size[0..n-1] on all ranks. */
void islands_sizes(const struct islands *s, const struct team *t, size_t (*of)(const struct island *), size_t *size);

/** A tree that an island reports. */
struct reported {
    size_t island;
    struct genes genes; /* genes in the list's memory */
    double error;       /* that the islands of its ring minimise */
};
struct reports {
    struct reported *found; /* owned: by island, in the order of its report */
    size_t n, room;
    int **memory; /* owned: an island's report each */
    size_t islands;
};
/** Collective: what all islands report (island_report), on rank 0; empty on the others. */
struct reports islands_reports(const struct islands *s, const struct team *t);
void reports_free(struct reports *f);

#endif
