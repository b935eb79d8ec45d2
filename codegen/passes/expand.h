/* Other forms of the same values, before factors are taken out. */
#ifndef FOOTPOINT_EXPAND_H
#define FOOTPOINT_EXPAND_H

#include "../genome/segment_kind.h"
#include "../graph/dag.h"
#include "choices.h"

/** A new graph in which the sums that the policy dissolves (CHOICE_DISSOLVE) are multiplied out where they are used, as
 *  long as no sum gets too long. */
struct dag *shape_dissolve(const struct dag *g, const struct policy *policy, struct record *record);

/** A new graph in which quotients are brought to a common denominator, kept as a product, where the policy says so
 *  (CHOICE_COMBINE).  Quotients inside quotients are resolved: singularities go, counted in `removed`. */
struct dag *shape_combine(const struct dag *g, const struct policy *policy, struct record *record);

/** Independent inverses 1/a, 1/b become b r, a r with one r = 1/(a b). */
struct dag *shape_join(const struct dag *g);

/** A new graph in which the vectors of a segment, sums of its nodes and the slave node of weight 0, are made by the
 *  fewest additions of differences; NULL if there are none, or too many nodes.  Where not all ways can be tried, another
 *  seed may give another one. */
struct dag *shape_differences(const struct dag *g, const struct segment_kind *k, uint64_t seed);

/** True if coordinates occur as differences of two alone, which are exact, or nearly, wherever the segment lies: not in
 *  sums of another kind, and not in products. */
bool shape_is_relative(const struct dag *g, const struct segment_kind *k);

/** True for a segment of so many nodes that the cheapest forms add coordinates, which loses digits far from the origin:
 *  there differences come first, whatever they cost. */
bool shape_differs_first(const struct segment_kind *k);

/** A new graph in which each sum of terms that are not sums is factored over the rationals, and each quotient
 *  cancelled by the greatest common divisor; NULL if nothing factors or all is too large to try. */
struct dag *shape_factor(const struct dag *g);

#endif
