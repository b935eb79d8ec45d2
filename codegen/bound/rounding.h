/* Rounding errors of a program, bounded over a box. */
#ifndef FOOTPOINT_ROUNDING_H
#define FOOTPOINT_ROUNDING_H

#include "rounding_parts.h"

/** For the error of operation `op`, which the forms are of; on the hull, unless that is NULL. */
struct rounding *rounding_new(struct forms *w, int op, const struct hull *hull);
void rounding_free(struct rounding *e);

/** Above |computed - exact| over the box that the forms were evaluated on last, whichever products are contracted to
 *  FMA. */
double rounding_error(struct rounding *e);

#endif
