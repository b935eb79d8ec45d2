/* The error that evolution minimises: in the scene's norm, over the training samples. */
#ifndef FOOTPOINT_JUDGE_H
#define FOOTPOINT_JUDGE_H

#include "kernel.h"
#include "scene.h"
#include "tree.h"

/** Measures trees against columns of a table; one for each process. */
struct judge {
    const struct columns *table;       /* not owned */
    const struct genome_file *program; /* not owned: what the genes mean */
    enum scene_norm norm;
    bool decimal; /* constants of trees are coded in their genes (decimal.h), not the program's; false at first */
    struct kernel *kernel; /* owned */
    double *scratch;       /* owned: one value for each sample */
};
struct judge *judge_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm);
void judge_free(struct judge *j);

/** Error of a tree against table column `target`: mean, 99 % or maximum of |value - target|.  INFINITY where a value is
 *  not finite, or where the mean is sure to exceed `bound`. */
double judge_error(struct judge *j, const struct tree *t, size_t target, double bound);

#endif
