/* Tables of samples. */
#ifndef FOOTPOINT_COLUMNS_H
#define FOOTPOINT_COLUMNS_H

#include "../../codegen/genome/genome.h"

enum {
    KERNEL_BLOCK = 512, /* samples between two looks at the bound */
    TAPE_BLOCK = 128    /* samples at a time where derivatives are wanted; divides KERNEL_BLOCK */
};

/** A table of samples: one column of n doubles per symbol, padded to whole blocks and aligned to cache lines. */
struct columns {
    size_t n, count;
    size_t room;    /* distance of two columns in rows: n rounded up to whole blocks, and a bit; the padding is 0 */
    double *data;   /* not owned: aligned in `memory` */
    double *memory; /* owned */
    unsigned char *band; /* owned: of mesh samples the band of |gap|, by row; or NULL */
};
struct columns columns_new(size_t n, size_t count);
void columns_free(struct columns *c);
/** First row of a column. */
double *columns_at(const struct columns *c, size_t column);

/** A table of every `stride`-th sample of another. */
struct columns columns_thin(const struct columns *all, size_t stride);

#endif
