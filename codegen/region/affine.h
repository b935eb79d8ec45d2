/* Affine forms of the values that enclosures are of (forms.h). */
#ifndef FOOTPOINT_AFFINE_H
#define FOOTPOINT_AFFINE_H

#include "forms.h"

/** The form of operation i from those of its operands; narrows w->range[i]. */
void affine_set(struct forms *w, size_t i);

/** Operation i is `ratio` times another: takes that one's form if it says more. */
void affine_adopt(struct forms *w, size_t i, size_t other, struct interval ratio);

/** Operation i less another is in `difference`: takes the other one's form, shifted, if it says more. */
void affine_shift(struct forms *w, size_t i, size_t other, struct interval difference);

/** Derivatives of a result by the operations that it depends on, backwards: affine_result, then of each operation
 *  affine_charge for its operands, and affine_slope.  Values are those of the last evaluation, up to errors. */
void affine_result(struct forms *w, int result);

/** What the result owes to operand k of operation i, `part` narrowed, is added to the operand's derivative.
 *  @param[in] error  by operation, of the values */
struct interval affine_charge(struct forms *w, int i, int k, const double *error, struct interval part);

/** The result's derivative by operation i. */
struct interval affine_slope(const struct forms *w, int i);

/** Forgets it. */
void affine_discharge(struct forms *w, int i);

/** After an evaluation over `box`: shrink the box to where operation `op` may be >= bound (sign 1) or <= bound (-1).
 *  True if that cut something off. */
bool affine_narrow(const struct forms *w, int op, int sign, double bound, struct interval *box);

#endif
