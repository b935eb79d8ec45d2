/* Multiples of values that several terms have in common. */
#ifndef FOOTPOINT_SHARE_MULTIPLES_H
#define FOOTPOINT_SHARE_MULTIPLES_H

#include "schedule.h"

/** A graph whose values are those of the schedule, in which c f is computed once for terms c f and c f g of several
 *  sums; NULL if there is nothing of the kind.  *saved: the multiplications that this saves. */
struct dag *multiples_taken(const struct schedule *s, size_t *saved);

#endif
