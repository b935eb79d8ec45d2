/* All monomials of some symbols over a table of samples, and polynomials of any choice of them.  Coefficients follow by least
 * squares (equation (22) of the paper) from the products of the monomials, without a pass over the samples; errors of
 * many polynomials take one pass. */
#ifndef FOOTPOINT_POLYNOMIALS_H
#define FOOTPOINT_POLYNOMIALS_H

#include "../../../evolve/input/scene.h"
#include "monomials.h"

struct polynomials {
    struct monomial *term; /* owned */
    size_t count;
    size_t samples;
    double *gram; /* owned: products of all monomials and, last, the target: (count + 1)^2 */
    double
        *value; /* owned: blocks of samples, each with a column for every monomial and a last column for the target */
    size_t blocks;
};
enum { POLYNOMIALS_ROWS = 64 }; /* samples of a block, filled up with zeros */
static inline double *polynomials_column(const struct polynomials *p, size_t block, size_t column)
{
    return p->value + (block * (p->count + 1) + column) * POLYNOMIALS_ROWS;
}
struct polynomials *polynomials_new(const int *symbol, size_t symbols, size_t degree, const struct columns *table,
                                    size_t target);
void polynomials_free(struct polynomials *p);

/** A choice: chosen[i] != 0 if monomial i is a term. */
typedef int gene_bit;
/** Returns the number of terms of a choice, with their indices, ascending, in at[] unless that is NULL. */
size_t polynomials_terms(const struct polynomials *p, const gene_bit *chosen, size_t *at);

/** Computes least-squares coefficients of a choice, for the terms in their order.  Returns the remaining sum of squares, or -1
 *  if the terms are dependent on these samples, or if there are no terms. */
double polynomials_fit(const struct polynomials *p, const gene_bit *chosen, double *coefficient);

/** Computes the same coefficients for another norm, the mean or the largest |error|, by weighted least squares, repeated. */
void polynomials_fit_norm(const struct polynomials *p, const gene_bit *chosen, enum scene_norm norm,
                          double *coefficient);

/** Computes the mean |error| of n choices, count bits each, stored in sequence, with least-squares coefficients; INFINITY if the
 *  terms are dependent. */
void polynomials_errors(const struct polynomials *p, const gene_bit *chosen, size_t n, double *error);

/** Returns the condition number of a choice's normal equations, columns scaled to unit length; INFINITY if they are singular to
 *  working precision. */
double polynomials_condition(const struct polynomials *p, const gene_bit *chosen);

/** Exchanges terms by forward and backward steps until no exchange lowers the sum of squares: adds the term that lowers it
 * most while there are fewer than `limit`, then drops the least valuable term and adds the best. Returns true
 * if the choice has changed. */
bool polynomials_exchange(const struct polynomials *p, gene_bit *chosen, size_t limit);

#endif
