/* Common subexpressions: products and sums that occur in several places are computed once. */
#ifndef FOOTPOINT_CSE_H
#define FOOTPOINT_CSE_H

#include "../graph/dag.h"

/** Rewrites the used nodes of *g in place: pairs of factors and pairs of terms (up to a common ratio) that occur more
 *  than once become nodes. Afterwards node numbers are not a topological order, and values are not unique. Returns the
 *  work, in pairs of operands examined. */
size_t share_pairs(struct dag *g);

/** Replaces a factor of several products by a node, a sum of one term, so that multiples of it may be shared: 2 x y and
 *  2 x z. */
void share_multiples(struct dag *g);

#endif
