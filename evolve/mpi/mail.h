/* Messages on their way. */
#ifndef FOOTPOINT_MAIL_H
#define FOOTPOINT_MAIL_H

#include "team.h"

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

/** Blocks 0, 1, ... on their way from the ranks that own them to this one, in that order; a few at a time. */
enum { GATHER_WINDOW = 32 };
struct gather {
    bool active;
    int tag;
    const int *owner; /* not owned: rank of each block */
    size_t n, posted, taken;
    struct inbound in[GATHER_WINDOW];
};
void gather_start(struct gather *g, int tag, const int *owner, size_t n);
/** The next block, if it is there (or, with `wait`, when it is), owned by the caller; NULL: not yet.  The gather ends
 *  with the last block.  bytes[i]: length of block i; where bytes is NULL all have `same`. */
void *gather_next(const struct team *t, struct gather *g, const size_t *bytes, size_t same, bool wait);

#endif
