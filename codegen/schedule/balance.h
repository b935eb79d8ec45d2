/* Chains of dependent operations: what decides the time of one evaluation on its own. */
#ifndef FOOTPOINT_BALANCE_H
#define FOOTPOINT_BALANCE_H

#include "../graph/cost.h"
#include "../graph/dag.h"

/** Rewrites the used sums and products of *g in place as trees that are ready as early as possible.  Returns the length
 *  of the longest chain from an input to an output.  Afterwards node numbers are no topological order. */
double balance_trees(struct dag *g, const struct cost_model *latency);

/** Sorts the operands of the used sums and products in place: first those that are ready first, so that chains written
 *  from left to right wait for nothing. */
void balance_order(struct dag *g, const struct cost_model *latency);

#endif
