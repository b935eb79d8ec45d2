/* Orders operands by the time at which they are ready, which decides the latency of a single evaluation. */
#ifndef FOOTPOINT_BALANCE_H
#define FOOTPOINT_BALANCE_H

#include "../graph/dag.h"

/** Sorts the operands of the used sums and products in place, earliest first, so that chains written from left to right
 *  never wait. */
void balance_order(struct dag *g);

#endif
