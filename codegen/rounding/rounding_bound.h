/* Proved bounds of rounding errors in double over a region. */
#ifndef FOOTPOINT_ROUNDING_BOUND_H
#define FOOTPOINT_ROUNDING_BOUND_H

#include "../region/region.h"

/** When a search for a bound ends. */
struct bound_goal {
    double useful;    /* a larger bound is useless: the search ends if it cannot get below */
    double threshold; /* at least `useful`: a bound between the two has another use if the search finds nothing
                       * better */
    double enough;    /* a bound at or below it is good enough; 0: the smaller, the better */
};

/** Returns a bound of |computed - exact| of operation `op` of the region's program over the whole region, with or
 *  without contraction to FMA, by branch and bound. The search takes at most `boxes` boxes and *work operations on
 *  coefficients, which it counts down, and ends early by the goal. Returns +infinity if it finds no bound. */
double bound_error(struct region *r, int op, struct bound_goal goal, long boxes, double *work);

/** Bounds the errors of all outputs of a program at single points. */
struct point_bound;
struct point_bound *point_bound_new(const struct region *r, const struct program *p);
/** @param[in] at  by variable */
void point_bound_at(struct point_bound *b, const double *at, double *error);
void point_bound_free(struct point_bound *b);

#endif
