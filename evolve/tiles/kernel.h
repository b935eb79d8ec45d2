/* The evaluator: values and errors of a prefix genome over many samples, tile by tile. */
#ifndef FOOTPOINT_KERNEL_H
#define FOOTPOINT_KERNEL_H

#include "kernel_task.h"

enum { KERNEL_LANES = 64 /* lanes of a block's sum; see kernel.c */ };

/** Vector registers that hold the tiles. Every width gives the same bits. */
enum kernel_width { KERNEL_PLAIN, KERNEL_256, KERNEL_512, KERNEL_WIDTHS };
bool kernel_supports(enum kernel_width width);
/** Returns 128, 256 or 512. KERNEL_PLAIN is the width of the compiler's target. */
int kernel_bits(enum kernel_width width);

/** Workspace of a thread: the translated genome and a stack of tiles. */
struct kernel;
struct kernel *kernel_new(enum kernel_width width);
/** Returns a workspace with the widest supported registers. */
struct kernel *kernel_new_widest(void);
void kernel_free(struct kernel *k);

/** Returns the sum over all samples of |value - table[target]|. Stops and returns INFINITY, at the same block on every
 *  machine, once the partial sum exceeds `bound`. Returns INFINITY if a value is not finite. */
double kernel_error_sum(struct kernel *k, const struct kernel_task *t, size_t target, double bound);

/** Writes the values to value[0..n-1]. */
void kernel_values(struct kernel *k, const struct kernel_task *t, double *value);

/** Returns genes times samples evaluated so far. */
double kernel_work(const struct kernel *k);

#endif
