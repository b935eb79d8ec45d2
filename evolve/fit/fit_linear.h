/* The coefficients of the terms that a tree is the sum of, by linear least squares. */
#ifndef FOOTPOINT_FIT_LINEAR_H
#define FOOTPOINT_FIT_LINEAR_H

#include "fit_constants.h"

/** Split the tree at its root into up to ROOT_TERMS terms, joined by + - neg, and copy it with the coefficients and the
 *  intercept that minimise the sum of squares over the fitter's table.  A term that is a constant times something gets
 *  another constant; constants and terms that depend on those before them vanish.  False, with `out` undefined, where
 *  that takes more than `max_length` genes or values are not finite.  The result may be worse in another norm. */
enum { ROOT_TERMS = 12 };
bool fit_root_terms(struct fitter *f, const struct tree *in, size_t target, size_t max_length, struct tree *out);

#endif
