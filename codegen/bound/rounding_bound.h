/* Proved bounds of rounding errors in double over a region. */
#ifndef FOOTPOINT_ROUNDING_BOUND_H
#define FOOTPOINT_ROUNDING_BOUND_H

#include "region.h"

/** Above |computed - exact| of operation `op` of the region's program all over the region, with or without contraction
 *  to FMA, by branch and bound in at most `boxes` boxes, and no more than *work allows, in operations on coefficients,
 *  which are counted down.  +infinity: none was found. */
double bound_error(struct region *r, int op, long boxes, double *work);

/** The same at one point: values of all inputs. */
double bound_error_at(const struct region *r, int op, const double *input);

#endif
