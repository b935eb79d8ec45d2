/* The evaluator: values, errors and derivatives of programs, and values and errors of trees, over the samples of a table,
 * block by block. */
#ifndef FOOTPOINT_LINES_RUN_H
#define FOOTPOINT_LINES_RUN_H

#include "../common/columns.h"
#include "../genotype/line_program.h"

/** Workspace for a table whose last two columns are the true xi and eta. */
struct lines_run {
    const struct columns *table;  /* not owned */
    struct arena arena;           /* owned: of the arrays */
    struct lines *code;           /* owned: the program */
    const double **value;         /* by line; blocks or rows of the table */
    double **slope;               /* by line; NULL if not needed */
    struct columns block, slopes; /* owned: blocks of TAPE_BLOCK, aligned */
    size_t *place;                /* by line; its block */
    bool *varies;                 /* by line; depends on a line whose slope is wanted */
    size_t *above, *below;        /* by line; number of samples so far on which a divisor was > 0 or < 0 */
    size_t room;
    bool all;    /* every line keeps its own block */
    double work; /* lines of programs, or genes of trees, times samples evaluated so far */
};
struct lines_run *lines_run_new(const struct line_rules *t, const struct columns *table);
void lines_run_free(struct lines_run *r);

/** Computes absolute errors: error[0..n-1] of xi, error[n..2n-1] of eta; INFINITY if a value is not a number. Returns
 *  their sum. Stops and returns INFINITY once the sum exceeds `bound`, or is far above its share after the first
 *  samples, at the same block on every machine.
 *  @param[in] last  function that the program ends in, or -1 */
double lines_errors(struct lines_run *r, const struct genes *t, int last, double bound, double *error);
/** Returns true if each divisor of the program last passed to lines_errors() keeps its sign on all samples. That call
 *  must have computed all errors. */
bool lines_keep_signs(const struct lines_run *r);

enum { TREE_LANES = 64 /* lanes of a sum of errors, added by halves */ };
/** Computes the values of a tree, in prefix form, into value[0..n-1]; symbol s is column s.
 *  @param[in] constant  the constants to which its genes refer; NULL: decimal numbers (decimal.h) */
void lines_tree_values(struct lines_run *r, const int *gene, size_t length, const struct genome_constant *constant,
                       double *value);
/** Returns the sum over all samples of |value - table[target]|. Stops and returns INFINITY, at the same SUM_BLOCK
 *  samples on every machine, once the partial sum exceeds `bound`. Returns INFINITY if a value is not finite. */
double lines_tree_error(struct lines_run *r, const int *gene, size_t length, const struct genome_constant *constant,
                        size_t target, double bound);
/** Computes the values of a tree over a table, as lines_tree_values(). */
void table_values(const struct columns *table, const struct genome_constant *constant, const int *gene, size_t length,
                  double *value);

/** Loads a program whose slopes are wanted.
 *  @param[in] by  line by which to differentiate, numbered as by lines_load(); -1: the program's numbers, which become
 *                 line[number[i]].number */
void lines_run_load(struct lines_run *r, const struct genes *t, int last, int by);
/** Returns the number of rows of the block that starts at `row`. */
static inline size_t lines_rows(const struct lines_run *r, size_t row)
{
    return r->table->n - row < TAPE_BLOCK ? r->table->n - row : TAPE_BLOCK;
}
/** Computes the values of all lines, in value[], for TAPE_BLOCK samples from `row` on. */
void lines_values(struct lines_run *r, size_t row);
/** Computes slope[i] = d root / d line i on the current samples, for all lines between the lines differentiated by and
 *  a root.
 *  @param[in] half  the root: 0 xi, 1 eta */
void lines_slopes(struct lines_run *r, int half);

#endif
