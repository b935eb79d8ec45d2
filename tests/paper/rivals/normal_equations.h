/* Sums products of columns for normal equations, and solves these.  A pass over the samples computes the products of all pairs of
 * columns; any choice of these columns is then fitted without the samples. */
#ifndef FOOTPOINT_NORMAL_EQUATIONS_H
#define FOOTPOINT_NORMAL_EQUATIONS_H

#include <stdbool.h>
#include <stddef.h>

/** Products in progress: of each of `rows` columns with each of `columns` others. */
struct products {
    size_t rows, columns;
    double *lane; /* owned: for each pair the sums of its lanes, so that the order of summation is always the same */
};
struct products products_new(size_t rows, size_t columns);
void products_free(struct products *p);
void products_clear(struct products *p);

/** Columns of a block of samples: column j begins at first + j * stride. */
struct panel {
    const double *first;
    size_t stride;
};
/** Adds n samples (a multiple of 8) of a's columns, one for each row, times b's, one for each column.  `lower`: the
 * pairs above the diagonal may be left out. */
void products_add(struct products *p, struct panel a, struct panel b, size_t n, bool lower);
/** Writes the sums so far, row after row; with `lower` the upper triangle mirrors the lower. */
void products_sum(const struct products *p, bool lower, double *sum);

/** Solves the normal equations of the columns chosen[0..k-1] for column `goal`; `gram` holds the products of all `count` columns.
 *  Fills coefficient[k]; returns the remaining sum of squares, or -1 if the columns are dependent.
 *  @param work  room for k * k numbers */
double products_fit(const double *gram, size_t count, const size_t *chosen, size_t k, size_t goal, double *coefficient,
                    double *work);

#endif
