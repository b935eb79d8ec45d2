/* Values, errors and derivatives of twin trees over the samples of a table, block by block. */
#ifndef FOOTPOINT_TWIN_TAPE_H
#define FOOTPOINT_TWIN_TAPE_H

#include "../genotype/twin.h"
#include "kernel.h"

/** Workspace for one table, whose last two columns are the true xi and eta. */
struct twin_run {
    const struct columns *table; /* not owned */
    struct twin_code *code;      /* owned: the tree */
    const double **value;        /* owned: by line; blocks or rows of the table */
    double **slope;              /* owned: by line; NULL where no number follows */
    double *block, *slopes;      /* owned */
    size_t *place;               /* owned: by line; its block */
    bool *varies;                /* owned: by line; a number of the tree is among what it depends on */
    size_t room, block_room, slope_room;
    bool all;    /* every line keeps its block */
    double work; /* lines times samples evaluated for errors so far */
};
struct twin_run *twin_run_new(const struct twins *t, const struct columns *table);
void twin_run_free(struct twin_run *r);

/** Sum over all samples of |xi - true xi| + |eta - true eta|.  INFINITY once it exceeds `bound`, at the same block on
 *  every machine, and where a value is not finite. */
double twin_error_sum(struct twin_run *r, const struct tree *t, double bound);
/** error[0..n-1] of xi, error[n..2n-1] of eta: absolute ones, INFINITY where a value is not a number. */
void twin_errors(struct twin_run *r, const struct tree *t, double *error);

/** Take a tree to be fitted: its numbers become line[number[i]].number. */
void twin_load(struct twin_run *r, const struct tree *t);
/** Values of all lines, in value[], for TAPE_BLOCK samples from `row` on. */
void twin_values(struct twin_run *r, size_t row);
/** slope[i] = d root / d line i at these samples, of all lines that lead to a number and from there to a root.
 *  @param[in] half  which root: 0 xi, 1 eta */
void twin_slopes(struct twin_run *r, int half);

#endif
