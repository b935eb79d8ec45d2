/* When values are ready: what decides the time of one evaluation on its own. */
#ifndef FOOTPOINT_BALANCE_H
#define FOOTPOINT_BALANCE_H

#include "../graph/dag.h"

/** Sorts the operands of the used sums and products in place: first those that are ready first, so that chains written
 *  from left to right wait for nothing. */
void balance_order(struct dag *g);

#endif
