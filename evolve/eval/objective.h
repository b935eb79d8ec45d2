/* The error that evolution minimises: in the scene's norm, over the training samples. */
#ifndef FOOTPOINT_OBJECTIVE_H
#define FOOTPOINT_OBJECTIVE_H

#include "../genotype/tree.h"
#include "../input/scene.h"
#include "kernel.h"
#include "twin_tape.h"

/** Measures trees against columns of a table; one for each process. */
struct objective {
    const struct columns *table;       /* not owned */
    const struct genome_file *program; /* not owned: what the genes mean */
    enum scene_norm norm;
    bool decimal; /* constants of trees are coded in their genes (decimal.h), not the program's; false at first */
    struct kernel *kernel;       /* owned */
    double *scratch;             /* owned: two values for each sample */
    struct twins *twins;         /* owned: of the program; NULL where there is none */
    struct twin_run *twin;       /* owned: for trees of both outputs */
    struct columns_float single; /* owned: the table in float; empty unless the norm is the mean */
};
struct objective *objective_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm);
void objective_free(struct objective *o);

/** True of the target of twin trees: not a column, but the true xi and eta, the last two of the table. */
bool objective_takes_both(const struct objective *o, size_t target);

/** Error of a tree against table column `target`, or of a twin tree against both: mean, 99 % or maximum of
 *  |value - target|.  INFINITY where a value is not finite, or where the mean is sure to exceed `bound`. */
double objective_error(struct objective *o, const struct tree *t, size_t target, double bound);

/** The same for ranking: the mean is computed in float, with about six digits in half the time; not of twin trees. */
double objective_rank(struct objective *o, const struct tree *t, size_t target, double bound);

/** Genes times samples evaluated so far; of twin trees, lines times samples. */
double objective_work(const struct objective *o);

#endif
