/* Shares multiples of values between terms. */
#ifndef FOOTPOINT_SHARE_MULTIPLES_H
#define FOOTPOINT_SHARE_MULTIPLES_H

#include "schedule.h"

/** Returns a graph with the schedule's values in which c f is computed once for terms c f and c f g of several sums, or
 *  NULL if there are no such terms. *saved: the multiplications saved. */
struct dag *multiples_taken(const struct schedule *s, size_t *saved);

#endif
