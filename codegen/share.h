/* Sharing of parts: products and sums that occur in several places are computed once. */
#ifndef FOOTPOINT_SHARE_H
#define FOOTPOINT_SHARE_H

#include "dag.h"

/** Rewrites the used nodes of *g in place: pairs of factors and pairs of terms (up to a common ratio) that occur more
 *  than once become nodes of their own.  Afterwards node numbers are no topological order and values are not unique. */
void share_pairs(struct dag *g);

#endif
