/* Sharing of parts: products and sums that occur in several places are computed once. */
#ifndef FOOTPOINT_CSE_H
#define FOOTPOINT_CSE_H

#include "../graph/dag.h"

/** Rewrites the used nodes of *g in place: pairs of factors and pairs of terms (up to a common ratio) that occur more
 *  than once become nodes of their own.  Afterwards node numbers are no topological order and values are not unique.
 *  Returns the work, in pairs of operands looked at. */
size_t share_pairs(struct dag *g);

/** Gives what is a factor of several products a node of its own there, a sum of one term, so that a multiple of it may
 *  be shared: 2 x y and 2 x z. */
void share_multiples(struct dag *g);

#endif
