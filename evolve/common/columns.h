/* Tables of samples. */
#ifndef FOOTPOINT_COLUMNS_H
#define FOOTPOINT_COLUMNS_H

#include "../../codegen/genome/genome.h"

enum {
    SUM_BLOCK = 512, /* samples between two checks of a tree's error bound */
    TAPE_BLOCK = 128 /* samples that are evaluated together; divides SUM_BLOCK */
};

/** A table of samples: a column of n doubles per symbol, padded to whole blocks and aligned to cache lines. */
struct columns {
    size_t n, count;
    size_t room;         /* rows from a column to the next: n rounded up to whole blocks, plus a pad; padding is 0 */
    double *data;        /* not owned: aligned in `memory` */
    double *memory;      /* owned */
    bool single;         /* values computed from the columns are rounded to float after each operation */
    unsigned char *band; /* owned: band of |gap| of each row, for mesh samples; otherwise NULL */
};
struct columns columns_new(size_t n, size_t count);
void columns_free(struct columns *c);
/** Returns the first row of a column. */
double *columns_at(const struct columns *c, size_t column);

/** Returns a table of every `stride`-th sample. */
struct columns columns_thin(const struct columns *all, size_t stride);

#endif
