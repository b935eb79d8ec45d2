/* Blocks of pairs as columns, and the functions that process them, once for each instruction set. For batch*.c only. */
#ifndef FOOTPOINT_BATCH_BLOCK_H
#define FOOTPOINT_BATCH_BLOCK_H

#include "../footpoint_batch.h"

/* Pairs of a block: few enough for the processor to look ahead into the next block, and a multiple of LANES, which no
 * instruction set exceeds. Nodes are prefetched AHEAD pairs before they are gathered. */
enum { BLOCK = 32, LANES = 8, AHEAD = 64, CACHE_LINE = 64 };

struct block {
    _Alignas(64) double x[15][BLOCK]; /* coordinate i of node k (A, B, C, D, S) in column 3 k + i */
    double xi[BLOCK], eta[BLOCK], gap[BLOCK];
    int64_t status[BLOCK];
};

/* Kinds of arrays: 64-bit indices, coordinates in float, x, y and z of a node adjacent. */
enum { KIND_WIDE = 1, KIND_FLOAT = 2, KIND_TRIPLES = 4, KINDS = 8 };

/* Counts must be multiples of LANES. */
struct lanes {
    /* Gathers columns x of BLOCK pairs, starting at pair `first`, and prefetches. Returns 0, without columns, if an
     * index is out of range or, in triples, names the last node, after which memory may end. */
    int (*gather[KINDS])(struct block *b, const struct footpoint_pairs *p, size_t first);
    /* Computes xi, eta and gap from x, and the status: FOOTPOINT_OK, or FOOTPOINT_ERR_DEGENERATE if
     * footpoint_locate_one must answer. Returns 1 if all are FOOTPOINT_OK. `prepared` uses the corners of the first
     * pair for all. */
    int (*search[FOOTPOINT_TIERS])(struct block *b, size_t count);
    int (*prepared[FOOTPOINT_TIERS])(struct block *b, size_t count);
    /* Sets the statuses of answers that are not sure. */
    void (*verify)(struct block *b, size_t count);
};

/* Hidden from callers of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/* Returns the set that suits this machine best. */
const struct lanes *footpoint_batch_lanes(void);

/* Returns set number `set`, from 0 (the compiler's target) to LANE_SETS - 1, or NULL if this machine does not support
 * it. */
enum { LANE_SETS = 3 };
const struct lanes *footpoint_batch_lanes_of(int set);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
