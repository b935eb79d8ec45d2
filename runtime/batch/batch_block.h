/* Blocks of pairs as columns, and the functions that work on them, once for each instruction set; for batch*.c alone.
 */
#ifndef FOOTPOINT_BATCH_BLOCK_H
#define FOOTPOINT_BATCH_BLOCK_H

#include "../footpoint_batch.h"

/* Pairs of a block: few enough for the processor to look ahead into the next one, and a multiple of LANES, which no
 * instruction set exceeds.  Nodes are fetched into the cache that many pairs before they are gathered. */
enum { BLOCK = 32, LANES = 8, AHEAD = 64, CACHE_LINE = 64 };

struct block {
    _Alignas(64) double x[15][BLOCK]; /* coordinate i of node k (A, B, C, D, S) in column 3 k + i */
    double xi[BLOCK], eta[BLOCK], gap[BLOCK];
    int64_t status[BLOCK];
};

/* Kinds of arrays: indices of 64 bits, coordinates in float, x, y and z of a node side by side. */
enum { KIND_WIDE = 1, KIND_FLOAT = 2, KIND_TRIPLES = 4, KINDS = 8 };

/* Counts are multiples of LANES. */
struct lanes {
    /* Columns x of the BLOCK pairs from number `first`, and a look ahead; 0, and no columns, if an index is out of
     * range or, among triples, that of the last node, behind which there may be nothing to read. */
    int (*gather[KINDS])(struct block *b, const struct footpoint_pairs *p, size_t first);
    /* xi, eta and gap from x, and the status: FOOTPOINT_OK, or FOOTPOINT_ERR_DEGENERATE where footpoint_locate_one has the
     * answer; 1 if all are FOOTPOINT_OK.  `prepared` takes the corners of the first pair for all. */
    int (*search[FOOTPOINT_TIERS])(struct block *b, size_t count);
    int (*prepared[FOOTPOINT_TIERS])(struct block *b, size_t count);
    /* Statuses of answers that are not sure. */
    void (*verify)(struct block *b, size_t count);
};

/* Not for callers of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/* The set that suits this machine best. */
const struct lanes *footpoint_batch_lanes(void);

/* Number `set`, from 0 (what the compiler was told) to LANE_SETS - 1; NULL if this machine has it not. */
enum { LANE_SETS = 3 };
const struct lanes *footpoint_batch_lanes_of(int set);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
