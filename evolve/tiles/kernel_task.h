/* The task of the tile kernel. */
#ifndef FOOTPOINT_KERNEL_TASK_H
#define FOOTPOINT_KERNEL_TASK_H

#include "../common/columns.h"

/** A genome over a table: symbol s is column s. Constants belong to the program or, if `constant` is NULL, are decimal
 *  numbers coded in their genes (decimal.h). */
struct kernel_task {
    const int *gene;
    size_t length;
    const struct genome_constant *constant; /* not owned; may be NULL */
    const struct columns *table;            /* not owned */
};

#endif
