/* The islands of a run, distributed over the ranks, and the data that rank 0 gathers from them. */
#ifndef FOOTPOINT_ISLANDS_H
#define FOOTPOINT_ISLANDS_H

#include "../archive/archive.h"
#include "../island/island.h"
#include "../mpi/mail.h"

/** Tags of messages: blocks for rank 0, and migrants. */
enum tag { TAG_LOG, TAG_REPORT, TAG_MIGRANTS /* + the receiving island; must be last */ };

/** A ring of islands and its search. */
struct ring {
    struct quest *quest; /* not owned */
    size_t max_length;   /* in genes */
    double load;         /* of its islands: approximate cost of an individual */
};
/** Returns its key in random streams. */
static inline size_t ring_key(const struct ring *r)
{
    return 2 * r->quest->tier + (size_t)(r->quest->output == 1);
}

/** All islands of a run. Ring r contains islands r * places .. r * places + places - 1. */
struct islands {
    size_t rings, places;
    struct ring *ring;      /* owned, indexed by ring; those below by island */
    struct island **island; /* NULL on ranks that do not own it */
    int *owner;             /* rank */
    bool *seeded;           /* started from a champion */
};
size_t islands_count(const struct islands *s);
void islands_free(struct islands *s);

/** Distributes the islands over `size` ranks, most expensive first, each to the rank with the least load. Not
 *  collective: all ranks compute the same distribution. */
void islands_share(struct islands *s, int size);

/** Returns false with *d if MPI has too few tags for this many islands. Not collective. */
bool islands_can_be_tagged(const struct islands *s, const struct team *t, struct diag *d);

/** Collects a size of each island, computed by its owner, into size[0..n-1] on all ranks. Collective. */
void islands_sizes(const struct islands *s, const struct team *t, size_t (*of)(const struct island *), size_t *size);

/** Gathers the reports of all islands (island_report) on rank 0, which takes one after another, in their order. Collective. */
void islands_reports(const struct islands *s, const struct team *t,
                     void (*take)(void *to, size_t island, const int *report), void *to);

#endif
