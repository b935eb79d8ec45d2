/* The evaluator: values and errors of a prefix genome over many samples, tile by tile. */
#ifndef FOOTPOINT_KERNEL_H
#define FOOTPOINT_KERNEL_H

#include "../../codegen/genome/genome.h"

enum {
    KERNEL_BLOCK = 512, /* samples between two looks at the bound */
    KERNEL_LANES = 64   /* the sum of a block runs in this many lanes: see kernel.c */
};

/** A table of samples: one column of n doubles per symbol, padded to whole blocks and aligned to cache lines. */
struct columns {
    size_t n, count;
    size_t room;    /* distance of two columns in rows: n rounded up to whole blocks, and a bit; the padding is 0 */
    double *data;   /* not owned: aligned in `memory` */
    double *memory; /* owned */
};
struct columns columns_new(size_t n, size_t count);
void columns_free(struct columns *c);
/** First row of a column. */
double *columns_at(const struct columns *c, size_t column);

/** The same table in float. */
struct columns_float {
    size_t n, count, room;
    float *data;   /* not owned: aligned in `memory` */
    float *memory; /* owned */
};
struct columns_float columns_float_new(const struct columns *c);
void columns_float_free(struct columns_float *c);
float *columns_float_at(const struct columns_float *c, size_t column);

/** Vector registers that the tiles are kept in.  Every width gives the same bits. */
enum kernel_width { KERNEL_PLAIN, KERNEL_256, KERNEL_512, KERNEL_WIDTHS };
bool kernel_supports(enum kernel_width width);
/** 128, 256, 512; KERNEL_PLAIN is what the compiler was told to build for. */
int kernel_bits(enum kernel_width width);

/** Workspace of one thread: the translated genome and a stack of tiles. */
struct kernel;
struct kernel *kernel_new(enum kernel_width width);
/** The same with the widest supported registers. */
struct kernel *kernel_new_widest(void);
void kernel_free(struct kernel *k);

/** A genome in a table: symbol s of a gene is column s; constants are the program's, or, where `constant` is NULL,
 *  decimal numbers coded in their genes (decimal.h). */
struct kernel_task {
    const int *gene;
    size_t length;
    const struct genome_constant *constant; /* not owned; may be NULL */
    const struct columns *table;            /* not owned */
};

/** Sum over all samples of |value - table[target]|.  Gives up with INFINITY, at the same block on every machine, once
 *  the partial sum exceeds `bound`; also INFINITY where a value is not finite. */
double kernel_error_sum(struct kernel *k, const struct kernel_task *t, size_t target, double bound);

/** The same computed in float, over `table` in place of the task's; the sums of the blocks are added in double. */
double kernel_error_sum_float(struct kernel *k, const struct kernel_task *t, const struct columns_float *table,
                              size_t target, double bound);

/** The values themselves, into value[0..n-1]. */
void kernel_values(struct kernel *k, const struct kernel_task *t, double *value);

/** Genes times samples evaluated so far. */
double kernel_work(const struct kernel *k);

#endif
