/* Alternative forms of the same values, before factors are extracted. */
#ifndef FOOTPOINT_EXPAND_H
#define FOOTPOINT_EXPAND_H

#include "../genome/segment_kind.h"
#include "../graph/dag.h"
#include "choices.h"

/** Returns a new graph in which the sums that the policy dissolves (CHOICE_DISSOLVE) are multiplied out where they are
 *  used, as long as no sum gets too long. */
struct dag *shape_dissolve(const struct dag *g, const struct policy *policy, struct record *record);

/** Returns a new graph in which quotients are brought to a common denominator, kept as a product, where the policy asks
 *  for it (CHOICE_COMBINE). Quotients inside quotients are resolved; singularities that vanish are counted in
 *  `removed`. */
struct dag *shape_combine(const struct dag *g, const struct policy *policy, struct record *record);

/** Returns a new graph in which independent inverses 1/a, 1/b become b r, a r with one r = 1/(a b). */
struct dag *shape_join(const struct dag *g);

/** Returns a new graph in which the vectors of a segment, sums of its nodes and the slave node of weight 0, use the
 *  fewest additions of differences. Returns NULL if there are no such vectors or too many nodes. If not all ways can be
 *  tried, another seed may give another result. */
struct dag *shape_differences(const struct dag *g, const struct segment_kind *k, uint64_t seed);

/** Returns true if coordinates occur only as differences of two, which are exact, or nearly, wherever the segment lies:
 *  not in other sums, and not in products. */
bool shape_is_relative(const struct dag *g, const struct segment_kind *k);

/** Returns true for a segment with so many nodes that the cheapest forms add coordinates, which loses digits far from
 *  the origin. Differences then come first, whatever they cost. */
bool shape_differs_first(const struct segment_kind *k);

/** Returns a new graph in which each sum of terms that are not sums is factored over the rationals, and each quotient
 *  is cancelled by the greatest common divisor. Returns NULL if nothing factors or everything is too large. */
struct dag *shape_factor(const struct dag *g);

#endif
