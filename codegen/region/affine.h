/* Affine forms of enclosed values (forms.h). */
#ifndef FOOTPOINT_AFFINE_H
#define FOOTPOINT_AFFINE_H

#include "forms.h"

/** Computes the form of operation i from its operands' forms; narrows w->range[i]. */
void affine_set(struct forms *w, size_t i);

/** Takes over the form of `other` times `ratio`, to which operation i is equal, if it is closer. */
void affine_adopt(struct forms *w, size_t i, size_t other, struct interval ratio);

/** Takes over the form of `other` shifted by `difference`, which encloses operation i minus other, if it is closer. */
void affine_shift(struct forms *w, size_t i, size_t other, struct interval difference);

/** Computes derivatives of a result by the operations on which it depends, backwards: call affine_result, then for each
 *  operation affine_charge for its operands, and affine_slope. Values are those of the last evaluation, up to
 *  errors. */
void affine_result(struct forms *w, int result);

/** Adds to the derivative by operand k the contribution through operation i; `part` is narrowed by it.
 *  @param[in] error  of the values, indexed by operation */
struct interval affine_charge(struct forms *w, int i, int k, const double *error, struct interval part);

/** Returns the result's derivative by operation i. */
struct interval affine_slope(const struct forms *w, int i);

/** Clears the derivative by operation i. */
void affine_discharge(struct forms *w, int i);

/** Shrinks a box, just evaluated, to the part where operation `op` may be >= bound (sign 1) or <= bound (-1). Returns
 *  true if it cut something off. */
bool affine_narrow(const struct forms *w, int op, int sign, double bound, struct interval *box);

#endif
