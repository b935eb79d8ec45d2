/* Messages in transit. */
#ifndef FOOTPOINT_MAIL_H
#define FOOTPOINT_MAIL_H

#include "team.h"

/** Messages that this rank has sent and that may not have left yet. */
struct mail {
    MPI_Request *request; /* owned */
    void **parcel;        /* owned: contents */
    size_t n, request_room, parcel_room;
};
/** Sends `bytes` bytes of `parcel`, an array that the mail takes over. Messages between two ranks with the same tag
 *  keep their order. */
void mail_send(const struct team *t, struct mail *m, void *parcel, size_t bytes, int to, int tag);
/** Frees messages that have left. */
void mail_sweep(struct mail *m);
/** Waits until all messages have left, then frees everything. */
void mail_free(struct mail *m);

/** An expected message of known length and source. */
struct inbound {
    MPI_Request request;
    void *parcel; /* owned; NULL: no message is expected */
};
void inbound_expect(const struct team *t, struct inbound *in, size_t bytes, int from, int tag);
/** Returns true if the message has arrived or no message is expected. */
bool inbound_here(struct inbound *in);

/** Blocks 0, 1, ... in transit, in this order, from the ranks that own them to this rank; a few at a time. */
enum { GATHER_WINDOW = 32 };
struct gather {
    bool active;
    int tag;
    const int *owner; /* not owned: rank of each block */
    size_t n, posted, taken;
    struct inbound in[GATHER_WINDOW];
};
void gather_start(struct gather *g, int tag, const int *owner, size_t n);
/** Returns the next block, owned by the caller, or NULL if it has not arrived; with `wait`, waits for it. The gather
 *  ends after the last block. bytes[i] is the length of block i; if `bytes` is NULL, every block has length `same`. */
void *gather_next(const struct team *t, struct gather *g, const size_t *bytes, size_t same, bool wait);

#endif
