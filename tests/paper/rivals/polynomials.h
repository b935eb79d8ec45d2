/* All monomials of some symbols over a table of samples, and polynomials of any choice of them: coefficients by least
 * squares (equation (22) of the paper) from the products of the monomials, without a pass over the samples; errors by
 * one pass for many polynomials. */
#ifndef FOOTPOINT_POLYNOMIALS_H
#define FOOTPOINT_POLYNOMIALS_H

#include "../../../evolve/input/scene.h"
#include "monomials.h"

struct polynomials {
    struct monomial *term; /* owned */
    size_t count;
    size_t samples;
    double *gram;  /* owned: products of all monomials and, last, the target: (count + 1)^2 */
    double *value; /* owned: blocks of samples; in each a column for every monomial and one for the target */
    size_t blocks;
};
enum { POLYNOMIALS_ROWS = 64 }; /* samples of a block; beyond the last there are zeros */
static inline double *polynomials_column(const struct polynomials *p, size_t block, size_t column)
{
    return p->value + (block * (p->count + 1) + column) * POLYNOMIALS_ROWS;
}
struct polynomials *polynomials_new(const int *symbol, size_t symbols, size_t degree, const struct columns *table,
                                    size_t target);
void polynomials_free(struct polynomials *p);

/** A choice: chosen[i] != 0 where monomial i is a term. */
typedef int gene_bit;
/** Terms of a choice; their indices, ascending, into at[] unless that is NULL. */
size_t polynomials_terms(const struct polynomials *p, const gene_bit *chosen, size_t *at);

/** Least-squares coefficients of a choice, for the terms in their order; returns the sum of squares that is left, or -1
 *  where the terms are dependent on these samples (or are none). */
double polynomials_fit(const struct polynomials *p, const gene_bit *chosen, double *coefficient);

/** The same coefficients for another norm, the mean or the largest |error|, in place of those of least squares: by
 *  weighted least squares, repeated. */
void polynomials_fit_norm(const struct polynomials *p, const gene_bit *chosen, enum scene_norm norm,
                          double *coefficient);

/** Mean |error| of n choices, count bits each, one after the other, with least-squares coefficients; INFINITY where the
 *  terms are dependent. */
void polynomials_errors(const struct polynomials *p, const gene_bit *chosen, size_t n, double *error);

/** Condition number of a choice's normal equations, columns scaled to unit length; INFINITY where they are singular to
 *  working precision. */
double polynomials_condition(const struct polynomials *p, const gene_bit *chosen);

/** Exchange terms by forward and backward steps until no exchange lowers the sum of squares: add the term that takes
 * the most from it while there are fewer than `limit`, then drop the one that is worth the least and add the best. True
 * if the choice has changed. */
bool polynomials_exchange(const struct polynomials *p, gene_bit *chosen, size_t limit);

#endif
