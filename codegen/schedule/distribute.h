/* Rewrites products as sums of other products. */
#ifndef FOOTPOINT_DISTRIBUTE_H
#define FOOTPOINT_DISTRIBUTE_H

#include "../graph/cost.h"
#include "../graph/dag.h"

/** Rewrites used products of *g in place. If several are a value e times v, v + 1, v - 1 and the like, e v is computed
 *  once and the others become e v + e, e v - e, if that is cheaper. Like share_pairs, it leaves node numbers that are
 *  not a topological order. */
void distribute_products(struct dag *g, const struct cost_model *m);

#endif
