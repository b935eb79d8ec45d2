/* Products of symbols up to a degree, and trees of their sums. */
#ifndef FOOTPOINT_MONOMIALS_H
#define FOOTPOINT_MONOMIALS_H

#include "../../../evolve/common/columns.h"
#include "../../../evolve/genotype/genotype.h"

enum { MONOMIAL_DEGREE = 4 };

struct monomial {
    int symbol[MONOMIAL_DEGREE]; /* genes, ascending in the order of the given symbols */
    size_t degree;
};

/** Returns all monomials of at most that degree (0..MONOMIAL_DEGREE) in n symbols, 1 first, and their number *count.  Free with
 *  free(). */
struct monomial *monomials_new(const int *symbol, size_t n, size_t degree, size_t *count);

/** Returns the number of genes that monomials_tree may need for n terms. */
size_t monomials_room(size_t n);
/** Writes the sum of n different monomials, each times its coefficient, in Horner's form: the most frequent symbol is factored out
 *  first. */
void monomials_tree(const struct monomial *term, const double *coefficient, size_t n, struct genes *t);

#endif
