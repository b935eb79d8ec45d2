/* Everything that processes say to each other: agreement on errors before and after a run; during it nothing but
 * messages that are on their way while islands go on: parcels of migrants, polls of what the ranks have done and wish,
 * blocks for rank 0.  The only header of MPI. */
#ifndef FOOTPOINT_TEAM_H
#define FOOTPOINT_TEAM_H

#include "../island/island.h"

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
/** Collective: the largest of all ranks' numbers. */
int team_most(const struct team *t, int number);
/** Collective: copy of rank 0's text (NULL stays NULL), owned by the caller; NUL-terminated. */
char *team_tell(const struct team *t, const char *text, size_t bytes);

/** Collective: copy of rank `from`'s n numbers on all ranks, owned by the caller; *n and number count on that rank. */
int *team_pass(const struct team *t, int from, const int *number, size_t *n);

/** Collective: number[i], i < n, as rank i mod size has it, on rank 0; the others' arrays stay.  None is -0. */
void team_collect(const struct team *t, double *number, size_t n);

/** All islands of a run.  Ring r holds the islands r * places .. r * places + places - 1. */
struct sea {
    size_t rings, places;
    struct island **island; /* rings * places; NULL where another rank owns it */
    int *owner;             /* rank of each */
    size_t *max_length;     /* of each ring: genes */
};
size_t sea_islands(const struct sea *s);

/** Share the islands out, the longest genomes first, always to the rank with the least to do.  Not collective: all
 * ranks find the same. */
void team_share(const struct team *t, struct sea *s);

/** False with *d where MPI has not tags enough for this many islands.  Not collective. */
bool team_can_tag(const struct team *t, size_t islands, struct diag *d);

/* ---- messages on their way: mail.c ---- */

enum tag { TAG_STATE, TAG_LOG, TAG_SIZE, TAG_REPORT, TAG_MIGRANTS /* + the receiving island: the last */ };

/** Messages that this rank has sent and that may not have left yet. */
struct mail {
    MPI_Request *request; /* owned */
    void **parcel;        /* owned: what they carry */
    size_t n, request_room, parcel_room;
};
/** Send `bytes` at `parcel`, an array that is taken over.  Messages between two ranks of one tag keep their order. */
void mail_send(const struct team *t, struct mail *m, void *parcel, size_t bytes, int to, int tag);
/** Let go of what has left. */
void mail_sweep(struct mail *m);
/** Wait until all has left, and free everything. */
void mail_free(struct mail *m);

/** A message that is expected, of known length and source. */
struct inbound {
    MPI_Request request;
    void *parcel; /* owned; NULL: none is expected */
};
void inbound_expect(const struct team *t, struct inbound *in, size_t bytes, int from, int tag);
/** True once it is there, or if none is expected. */
bool inbound_here(struct inbound *in);
/** The next message from a rank, of any length, owned by the caller; waits. */
void *team_receive(const struct team *t, int from, int tag, size_t *bytes);

/** Blocks from all islands on their way to rank 0, a block from each, in the order of the islands; a few at a time. */
enum { GATHER_WINDOW = 32 };
struct gather {
    bool active;
    int tag;
    size_t posted, taken;
    struct inbound in[GATHER_WINDOW];
};
void gather_start(struct gather *g, int tag);
/** The next block, if it is there (or, with `wait`, when it is), owned by the caller; NULL: not yet.  The gather ends
 *  with the last block.  bytes[i]: length of island i's block; where bytes is NULL all have `same`. */
void *gather_next(const struct team *t, const struct sea *s, struct gather *g, const size_t *bytes, size_t same,
                  bool wait);

/** A tree that an island reports. */
struct find {
    size_t island;
    struct tree tree; /* genes in the list's memory */
};
struct finds {
    struct find *find; /* owned: by island, in the order of its report */
    size_t finds, room;
    int **memory; /* owned: an island's report each */
    size_t islands;
};
/** Collective: what all islands report (island_report), on rank 0; empty on the others. */
struct finds team_gather(const struct team *t, const struct sea *s);
void finds_free(struct finds *f);

/** Collective: the lengths of all islands' states (island_state_size), on rank 0, owned by the caller; else NULL. */
size_t *team_state_sizes(const struct team *t, const struct sea *s);

/* ---- polls: poll.c ---- */

/** Sums over the ranks. */
enum { POLL_WORK, POLL_SAVE, POLL_STOP, POLL_SUMS = POLL_STOP + 5 };

/** Polls 1, 2, ..., each of which every rank joins, in order, without waiting for the others. */
struct poll {
    size_t best; /* minima beside the sums */
    size_t lag; /* so many polls may be uncounted: grows with the logarithm of the ranks, as the way of a result does */
    size_t cast, counted;
    struct poll_slot {
        double sum[2][POLL_SUMS]; /* own, and of all */
        double *best[2];          /* owned; minima on rank 0 alone */
        MPI_Request request[2];
    } * slot; /* owned: lag of them */
};
struct poll poll_new(const struct team *t, size_t best);
/** Join the next poll; returns at once.  At most p->lag polls may be uncounted. */
void poll_cast(const struct team *t, struct poll *p, const double sum[POLL_SUMS], const double *best);
/** The next poll if all ranks have joined it: its slot, valid until the next poll_cast; NULL: not yet. */
const struct poll_slot *poll_count(struct poll *p);
void poll_free(struct poll *p);

#endif
