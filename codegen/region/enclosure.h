/* Evaluates enclosures operation by operation. Each is narrowed by known ranges and by the requires. */
#ifndef FOOTPOINT_ENCLOSURE_H
#define FOOTPOINT_ENCLOSURE_H

#include "forms.h"

/** Encloses the values of a function of one number, OP_UNARY + k, over an interval: the whole line unless the function
 *  rises. */
struct interval function_range(enum op_kind kind, struct interval x);

/** Evaluates over a box, indexed by variable. Returns false if the box has no point of the region. */
bool forms_evaluate(struct forms *w, const struct interval *box);

/** Returns true if all requires are > 0 at a point, a box without width, for which intervals suffice. */
bool forms_hold_at(struct forms *w, const struct interval *point);

/** Evaluates after cutting off what the requires exclude. */
bool forms_evaluate_narrowed(struct forms *w, struct interval *box);

/** Encloses all computed values of the first `ops` operations over a box of inputs, with or without contraction to FMA, from
 *  their operands only; the whole line if a region block computes the inputs. The result is owned by the caller. */
struct interval *computed_ranges(const struct known *x, const struct interval *box, size_t ops);

/** Returns true if all values are finite over the box, hence continuous. */
bool forms_finite(const struct forms *w);

bool box_is_empty(const struct interval *box, size_t variables);

#endif
