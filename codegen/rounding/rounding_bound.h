/* Proved bounds of rounding errors in double over a region. */
#ifndef FOOTPOINT_ROUNDING_BOUND_H
#define FOOTPOINT_ROUNDING_BOUND_H

#include "../region/region.h"

/** Where a search for a bound ends. */
struct bound_goal {
    double useful;    /* a bound above this is of no use: the search ends where it does not get there */
    double threshold; /* at least that: a bound between the two is of another use, if nothing better is to be had */
    double enough;    /* a bound at or below this is good enough; 0: the closer, the better */
};

/** Returns a bound of |computed - exact| of operation `op` of the region's program all over the region, with or without
 *  contraction to FMA, by branch and bound.  The search takes at most `boxes` boxes and *work operations on
 *  coefficients, which are counted down, and ends early as the goal says.  +infinity: no bound was found. */
double bound_error(struct region *r, int op, struct bound_goal goal, long boxes, double *work);

/** Bounds of the errors of all outputs of a program at single points. */
struct point_bound;
struct point_bound *point_bound_new(const struct region *r, const struct program *p);
/** @param[in] at  by variable */
void point_bound_at(struct point_bound *b, const double *at, double *error);
void point_bound_free(struct point_bound *b);

#endif
