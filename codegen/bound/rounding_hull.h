/* Bounds of rounding errors backwards on a hull, where derivatives are limited (hull.h). */
#ifndef FOOTPOINT_ROUNDING_HULL_H
#define FOOTPOINT_ROUNDING_HULL_H

#include "rounding_parts.h"

/** How far errors move the result's derivative by operation i, on a way backwards from joint `result`, and within which limits
 *  that leaves it. */
void rounding_limit_by_hull(struct rounding *e, int result, int i);

/** What operation i, or an input's error, adds to the error of the result beyond units times its weight. */
double rounding_rest(struct rounding *e, int i);

/** After a way backwards from a joint, of that rest or, where it is infinite, without a bound. */
void rounding_end_on_hull(struct rounding *e, int joint, double rest);

/** Errors do not change what operation i chooses. */
bool rounding_is_decided(const struct rounding *e, int i);

#endif
