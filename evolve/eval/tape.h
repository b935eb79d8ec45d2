/* A tree as it is computed over blocks of samples, forward for the values of all its branches, backward for the
 * derivatives of the tree by each of them.  Constants are numbers here, not yet decimals. */
#ifndef FOOTPOINT_TAPE_H
#define FOOTPOINT_TAPE_H

#include "../genotype/tree.h"
#include "columns.h"

struct tape {
    const struct columns *table; /* not owned */
    size_t length, room;
    int *gene;        /* owned */
    size_t *operand;  /* owned: index of a gene's second operand; the first follows the gene */
    size_t *constant; /* owned: indices of the constants, ascending */
    size_t constants;
    double *number;                /* owned: by gene; the constants' values */
    bool *varies;                  /* owned: by gene; a constant is in the branch */
    double *block;                 /* owned: values, then slopes */
    const double **value, **slope; /* owned: by gene; blocks or rows of the table */
};
struct tape *tape_new(const struct columns *table);
void tape_free(struct tape *t);

/** Take a tree whose constants are decimals. */
void tape_load(struct tape *t, const struct tree *tree);
/** Its genes with the numbers rounded to decimals. */
void tape_store(const struct tape *t, struct tree *tree);

/** value[i] of all genes for TAPE_BLOCK samples from `row` on; beyond the table's end they are meaningless. */
void tape_values(struct tape *t, size_t row);
/** slope[i] = d value[0] / d value[i] at the samples of the last tape_values: of all genes, or only of those that lead
 *  to a constant.  Where a protected quotient's divisor is 0 and at kinks one of the sides counts. */
void tape_slopes(struct tape *t, bool all);

#endif
