/* Proved bounds of rounding errors in double over a region. */
#ifndef FOOTPOINT_ROUNDING_BOUND_H
#define FOOTPOINT_ROUNDING_BOUND_H

#include "hull.h"

/** Above |computed - exact| of operation `op` of the region's program all over the region, with or without contraction
 *  to FMA, by branch and bound in at most `boxes` boxes, and no more than *work allows, in operations on coefficients,
 *  which are counted down.  +infinity: none was found. */
double bound_error(struct region *r, int op, long boxes, double *work);

/** The same of all operations that outputs are made of, on the hull of the program's values.
 *  @param[out] error  by operation of the hull's program; +infinity: none was found */
void bound_errors_on_hull(const struct hull *h, double *error);

/** The same on parts of it. */
struct part_bound;
struct part_bound *part_bound_new(const struct hull *h);
/** @param[out] error  by operation of the hull's program; +infinity: none was found. */
void part_bound_at(struct part_bound *b, const struct hull_part *part, double *error);
void part_bound_free(struct part_bound *b);

/** The same of all outputs of a program at single points. */
struct point_bound;
struct point_bound *point_bound_new(const struct region *r, const struct program *p);
/** @param[in] at  by variable */
void point_bound_at(struct point_bound *b, const double *at, double *error);
void point_bound_free(struct point_bound *b);

#endif
