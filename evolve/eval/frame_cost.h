/* The cost of the frame's values that an expression needs, each counted once. */
#ifndef FOOTPOINT_FRAME_COST_H
#define FOOTPOINT_FRAME_COST_H

#include "operation_count.h"

struct frame_cost;
/** Returns prices of the lets of a program; inputs are free. */
struct frame_cost *frame_cost_new(const struct genome_file *program, const struct prices *prices);
void frame_cost_free(struct frame_cost *f);

/** Returns the price of all lets that a tree needs, directly or through others. */
double frame_cost_of(struct frame_cost *f, const struct genes *t);

#endif
