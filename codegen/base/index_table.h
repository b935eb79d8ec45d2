/* A hash table of the elements of an array, by index. The owner of the array compares elements:
 *
 *     size_t probe = 0;
 *     for (int i; (i = index_next(&table, hash, &probe)) >= 0;)
 *         if (equal(&array[i], &wanted))
 *             return i;
 *     index_add(&table, hash, n);
 *
 * Open addressing, at most half full. Clearing the table only starts a new round. */
#ifndef FOOTPOINT_INDEX_TABLE_H
#define FOOTPOINT_INDEX_TABLE_H

#include "base.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct index_slot {
    uint64_t hash;
    unsigned round; /* round in which the slot was filled; empty if it is not the table's */
    int index;
};

/** Empty if it is all zeros. */
struct index_table {
    struct index_slot *slot; /* owned */
    size_t slots, used;      /* slots: 0 or a power of 2 */
    unsigned round;
};

/** Returns the next element with this hash, or -1. *probe must be 0 at first. */
static inline int index_next(const struct index_table *t, uint64_t hash, size_t *probe)
{
    while (t->slots > 0) {
        const struct index_slot *s = &t->slot[(size_t)(hash + (*probe)++) & (t->slots - 1)];
        if (s->round != t->round)
            return -1;
        if (s->hash == hash)
            return s->index;
    }
    return -1;
}

static inline void index_free(struct index_table *t)
{
    free(t->slot);
    *t = (struct index_table){0};
}

static inline void index_clear(struct index_table *t)
{
    t->used = 0;
    if (++t->round > 0)
        return;
    t->round = 1;
    if (t->slots > 0)
        memset(t->slot, 0, t->slots * sizeof *t->slot);
}

static inline void index_put(struct index_table *t, struct index_slot s)
{
    size_t at = (size_t)s.hash & (t->slots - 1);
    while (t->slot[at].round == t->round)
        at = (at + 1) & (t->slots - 1);
    t->slot[at] = s;
}

static inline void index_grow(struct index_table *t)
{
    const struct index_table old = *t;
    t->slots = old.slots ? 2 * old.slots : 64;
    t->slot = new_array(t->slots, sizeof *t->slot);
    t->round += t->round == 0;
    for (size_t i = 0; i < old.slots; i++)
        if (old.slot[i].round == old.round)
            index_put(t, old.slot[i]);
    free(old.slot);
}

/** Adds an element.
 *  @param[in] hash  well-mixed bits, especially the lowest */
static inline void index_add(struct index_table *t, uint64_t hash, int index)
{
    if (2 * (t->used + 1) > t->slots)
        index_grow(t);
    index_put(t, (struct index_slot){hash, t->round, index});
    t->used++;
}

#endif
