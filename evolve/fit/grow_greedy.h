/* Polynomials by greedy selection of monomials: the plain fits that anything bred must beat. */
#ifndef FOOTPOINT_GROW_GREEDY_H
#define FOOTPOINT_GROW_GREEDY_H

#include "../eval/objective.h"
#include "pareto.h"

struct greedy_plan {
    const int *symbol; /* genes; not owned */
    size_t symbols;
    size_t degree;     /* 1..MONOMIAL_DEGREE; less where there would be more than GREEDY_MONOMIALS monomials */
    size_t max_terms;  /* monomials of one polynomial */
    size_t max_length; /* genes */
};
enum { GREEDY_MONOMIALS = 600 };

/** Polynomials of 1, 2, ... terms: each takes the monomial that lowers the sum of squares the most, all coefficients
 * are those of least squares, then those of the objective's norm.  Offers them in Horner's form. */
void greedy_polynomials(const struct greedy_plan *plan, struct objective *objective, size_t target,
                        struct pareto *front);

#endif
