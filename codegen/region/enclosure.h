/* Evaluates enclosures: operation by operation, each narrowed by what is known of it and by what the requires tell. */
#ifndef FOOTPOINT_ENCLOSURE_H
#define FOOTPOINT_ENCLOSURE_H

#include "forms.h"

/** Values of a function of one number, OP_UNARY + k, over an interval: the whole line unless the function rises. */
struct interval function_range(enum op_kind kind, struct interval x);

/** Evaluate over a box (by variable).  False: it has no point of the region. */
bool forms_evaluate(struct forms *w, const struct interval *box);

/** True if all requires are > 0 at a point, a box without width, of which intervals tell all: no affine forms. */
bool forms_hold_at(struct forms *w, const struct interval *point);

/** The same after cutting off what the requires exclude. */
bool forms_evaluate_narrowed(struct forms *w, struct interval *box);

/** Encloses all values that operation `op` is computed as over a box of inputs, with or without contraction to FMA, from
 *  those of its operands alone.  The whole line where a region block computes the inputs. */
struct interval computed_range(const struct known *x, const struct interval *box, int op);

/** True if all values are finite over the box, hence continuous there. */
bool forms_finite(const struct forms *w);

bool box_is_empty(const struct interval *box, size_t variables);

#endif
