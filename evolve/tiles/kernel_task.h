/* What the tile kernel computes. */
#ifndef FOOTPOINT_KERNEL_TASK_H
#define FOOTPOINT_KERNEL_TASK_H

#include "../common/columns.h"

/** A genome in a table: symbol s of a gene is column s; constants are the program's, or, where `constant` is NULL,
 *  decimal numbers coded in their genes (decimal.h). */
struct kernel_task {
    const int *gene;
    size_t length;
    const struct genome_constant *constant; /* not owned; may be NULL */
    const struct columns *table;            /* not owned */
};

#endif
