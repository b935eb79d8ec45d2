/* The error that evolution minimises: in the scene's norm, over the training samples. */
#ifndef FOOTPOINT_OBJECTIVE_H
#define FOOTPOINT_OBJECTIVE_H

#include "../genotype/genotype.h"
#include "../input/scene.h"
#include "../surface/sample.h"
#include "lines_run.h"

/** Measures programs and trees on a table. Each process needs its own. */
struct objective {
    const struct columns *table;       /* not owned */
    const struct genome_file *program; /* not owned: defines the genes */
    enum scene_norm norm;
    bool decimal;    /* constants of trees are coded in their genes (decimal.h), not in the program; false at first */
    double *scratch; /* owned: two values per sample */
    double *picked;  /* owned: errors on a part of the samples */
    struct line_rules *rules; /* owned: of the program; may be NULL */
    struct lines_run *lines;  /* owned; lines->work counts what was evaluated */
};
struct objective *objective_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm);
void objective_free(struct objective *o);

/** Returns the error, in the scene's norm, that counts as rounding: smaller errors are no better. */
double objective_rounding(enum scene_norm norm);

/** Largest errors that a program may have without a charge. */
struct tails {
    double p99, max;        /* 0: no limit */
    double band[GAP_BANDS]; /* means in bands of |gap|; 0: no limit */
};

/** Returns the error of a tree against a column of the table: mean, 99 % or maximum of |value - column|. Returns
 *  INFINITY if a value is not finite, or if the mean is certain to exceed `bound`. */
double objective_tree_error(struct objective *o, const struct genes *t, size_t column, double bound);

/* Programs are measured against the true xi and eta, the last two columns; `last` is the function that they end in, or
 * -1. */

/** Returns the error of a program over all errors of xi and eta. Returns INFINITY also if the first samples suggest
 *  that the mean exceeds `bound`. */
double objective_error(struct objective *o, const struct genes *t, int last, double bound);

/** Returns the error of a program, multiplied by the factors by which its 99 % and largest error and its mean in the
 *  worst band exceed their limits. Returns INFINITY if that exceeds `bound`, or if a divisor changes its sign among the
 *  samples. */
double objective_error_in_tails(struct objective *o, const struct genes *t, int last, const struct tails *tails,
                                double bound);
/** Returns the 99 % and largest error of a program, but at least those of rounding. */
struct tails objective_tails(struct objective *o, const struct genes *t, int last);
/** Errors of xi and of eta (mean, 99 %, largest) in each part of the samples. A single largest error is chance; the
 *  better of two programs is better in all parts. Parts are quarters or, for samples with bands of |gap|, the halves of
 *  each band. */
enum { OUTPUT_PARTS = 2 * GAP_BANDS };
struct outputs {
    double mean[2][OUTPUT_PARTS], p99[2][OUTPUT_PARTS], max[2][OUTPUT_PARTS];
};
struct outputs objective_outputs(struct objective *o, const struct genes *t, int last);
/** Returns true if no figure of the program is larger. In a band, a figure is larger only if it is larger in both
 *  halves; a difference between halves is chance. */
bool objective_no_worse(struct objective *o, const struct genes *t, int last, const struct outputs *than);

#endif
