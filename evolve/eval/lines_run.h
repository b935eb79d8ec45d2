/* Values, errors and derivatives of programs over the samples of a table, block by block. */
#ifndef FOOTPOINT_LINES_RUN_H
#define FOOTPOINT_LINES_RUN_H

#include "../common/columns.h"
#include "../genotype/line_program.h"

/** Workspace for one table, whose last two columns are the true xi and eta. */
struct lines_run {
    const struct columns *table; /* not owned */
    struct lines *code;          /* owned: the program */
    const double **value;        /* owned: by line; blocks or rows of the table */
    double **slope;              /* owned: by line; NULL where none is wanted */
    double *block, *slopes;      /* owned */
    size_t *place;               /* owned: by line; its block */
    bool *varies;                /* owned: by line; what its slope is wanted for is among what it depends on */
    size_t *above, *below;       /* owned: by line; samples on which a divisor was so far more or less than 0 */
    size_t room, block_room, slope_room;
    bool all;    /* every line keeps its block */
    double work; /* lines times samples evaluated for errors so far */
};
struct lines_run *lines_run_new(const struct line_rules *t, const struct columns *table);
void lines_run_free(struct lines_run *r);

/** Absolute errors, INFINITY where a value is not a number: error[0..n-1] of xi, error[n..2n-1] of eta; returns their sum.
 *  INFINITY, and no further errors, once the sum exceeds `bound`, or on the first samples is far above what that leaves
 *  them, at the same block on every machine.
 *  @param[in] last  function that the program ends in; -1: none */
double lines_errors(struct lines_run *r, const struct genes *t, int last, double bound, double *error);
/** Whether the divisors of the program of lines_errors(), whose errors were all taken, are of one sign on all samples,
 *  each. */
bool lines_keep_signs(const struct lines_run *r);

/** Values of an expression in prefix form over a table of its symbols, into value[0..n-1]: symbol s is column s. */
void table_values(const struct columns *table, const struct genome_constant *constant, const int *gene, size_t length,
                  double *value);

/** Takes a program for its slopes.
 *  @param[in] by  the line that they are taken by, as lines_load() numbers lines; -1: its numbers, which become
 *                 line[number[i]].number */
void lines_run_load(struct lines_run *r, const struct genes *t, int last, int by);
/** Values of all lines, in value[], for TAPE_BLOCK samples from `row` on. */
void lines_values(struct lines_run *r, size_t row);
/** slope[i] = d root / d line i at these samples, of all lines between what slopes are taken by and a root.
 *  @param[in] half  which root: 0 xi, 1 eta */
void lines_slopes(struct lines_run *r, int half);

#endif
