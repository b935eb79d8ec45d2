/* The error that evolution minimises: in the scene's norm, over the training samples. */
#ifndef FOOTPOINT_OBJECTIVE_H
#define FOOTPOINT_OBJECTIVE_H

#include "../genotype/genotype.h"
#include "../input/scene.h"
#include "../surface/sample.h"
#include "../tiles/kernel.h"
#include "lines_run.h"

/** Measures programs and trees on a table; one for each process. */
struct objective {
    const struct columns *table;       /* not owned */
    const struct genome_file *program; /* not owned: what the genes mean */
    enum scene_norm norm;
    bool decimal; /* constants of trees are coded in their genes (decimal.h), not the program's; false at first */
    struct kernel *kernel;    /* owned */
    double *scratch;          /* owned: two values for each sample */
    double *picked;           /* owned: of one part of the samples */
    struct line_rules *rules; /* owned: of the program; NULL where there is none */
    struct lines_run *lines;  /* owned: for programs of both outputs */
};
struct objective *objective_new(const struct genome_file *program, const struct columns *table, enum scene_norm norm);
void objective_free(struct objective *o);

/** An error, in the scene's norm, that is no more than rounding: none less is any better. */
double objective_rounding(enum scene_norm norm);

/** Largest errors that a program may have without being charged for them. */
struct tails {
    double p99, max;        /* 0: any */
    double band[GAP_BANDS]; /* means, of samples with bands of |gap|; 0: any */
};

/** Error of a tree against a column of the table: mean, 99 % or maximum of |value - column|.  INFINITY where a value is
 *  not finite, or where the mean is sure to exceed `bound`. */
double objective_tree_error(struct objective *o, const struct genes *t, size_t column, double bound);

/* Programs are measured against the true xi and eta, the last two columns; `last` is the function that they end in, -1:
 * none. */

/** The same of a program, all errors of xi and eta; INFINITY where the mean seems to exceed `bound` by the first
 *  samples, too. */
double objective_error(struct objective *o, const struct genes *t, int last, double bound);

/** The same of a program, multiplied by how far its 99 % and largest errors, and its mean in the worst band, exceed what they
 *  may be; INFINITY where that exceeds `bound`, or a divisor changes its sign among the samples. */
double objective_error_in_tails(struct objective *o, const struct genes *t, int last, const struct tails *tails,
                                double bound);
/** 99 % and largest error of a program, or what rounding makes of them, if that is more. */
struct tails objective_tails(struct objective *o, const struct genes *t, int last);
/** The same and the mean, of xi and of eta, in each part of the samples: one largest error is chance,
 *  and of two programs the better one has it in all parts.  Parts are quarters or, of samples with bands of |gap|, the
 *  halves of each band. */
enum { OUTPUT_PARTS = 2 * GAP_BANDS };
struct outputs {
    double mean[2][OUTPUT_PARTS], p99[2][OUTPUT_PARTS], max[2][OUTPUT_PARTS];
};
struct outputs objective_outputs(struct objective *o, const struct genes *t, int last);
/** True if none of a program's is larger; in a band it is if it is in both halves, whose difference is chance. */
bool objective_no_worse(struct objective *o, const struct genes *t, int last, const struct outputs *than);

/** Genes times samples evaluated so far; of programs, lines times samples. */
double objective_work(const struct objective *o);

#endif
