/* The evaluator: values and errors of a prefix genome over many samples, block by block. */
#ifndef FOOTPOINT_KERNEL_H
#define FOOTPOINT_KERNEL_H

#include "../codegen/genome.h"

enum {
    KERNEL_BLOCK = 256, /* samples at a time: a genome's operands stay in the first-level cache */
    KERNEL_LANES = 16   /* a sum runs in this many lanes, sample i in lane i mod 16, whatever the vector width is */
};

/** A table of samples: one column of n doubles per symbol, padded to whole blocks and aligned to cache lines. */
struct columns {
    size_t n, count;
    size_t room;    /* rows that a column really has: n rounded up to whole blocks; the padding is 0 */
    double *data;   /* not owned: aligned in `memory` */
    double *memory; /* owned */
};
struct columns columns_new(size_t n, size_t count);
void columns_free(struct columns *c);
/** First row of a column. */
double *columns_at(const struct columns *c, size_t column);

/** Vector registers that the blocks are computed with.  Every width gives the same bits. */
enum kernel_width { KERNEL_PLAIN, KERNEL_256, KERNEL_512, KERNEL_WIDTHS };
bool kernel_supports(enum kernel_width width);
/** 128, 256, 512; KERNEL_PLAIN is what the compiler was told to build for. */
int kernel_bits(enum kernel_width width);

/** Workspace of one thread: the translated genome and a stack of blocks. */
struct kernel;
struct kernel *kernel_new(enum kernel_width width);
/** The same with the widest supported registers. */
struct kernel *kernel_new_widest(void);
void kernel_free(struct kernel *k);

/** A genome in a table: symbol s of a gene is column s, constants are the program's. */
struct kernel_task {
    const int *gene;
    size_t length;
    const struct genome_constant *constant; /* not owned; NULL: decimal numbers (decimal.h) */
    const struct columns *table;            /* not owned */
};

/** Sum over all samples of |value - table[target]|.  Gives up with INFINITY, at the same block on every machine, once
 *  the partial sum exceeds `bound`; also INFINITY where a value is not finite. */
double kernel_error_sum(struct kernel *k, const struct kernel_task *t, size_t target, double bound);

/** The values themselves, into value[0..n-1]. */
void kernel_values(struct kernel *k, const struct kernel_task *t, double *value);

/** Genes times samples evaluated so far. */
double kernel_work(const struct kernel *k);

#endif
