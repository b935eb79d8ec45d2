/* Affine forms of the values that enclosures are of (forms.h). */
#ifndef FOOTPOINT_AFFINE_H
#define FOOTPOINT_AFFINE_H

#include "forms.h"

/** The form of operation i from those of its operands; narrows w->range[i]. */
void affine_set(struct forms *w, size_t i);

/** After an evaluation over `box`: shrink the box to where operation `op` may be >= bound (sign 1) or <= bound (-1).
 *  True if that cut something off. */
bool affine_narrow(const struct forms *w, int op, int sign, double bound, struct interval *box);

#endif
