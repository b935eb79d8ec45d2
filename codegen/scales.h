/* The scales of a schedule. */
#ifndef FOOTPOINT_SCALES_H
#define FOOTPOINT_SCALES_H

#include "schedule.h"

/** Changes the scales, all ONE so far, so that few multiplications by constants are left; returns the work, in pairs of
 *  terms compared.  groups: operands that share a coefficient in a sum are changed together, too. */
double scales_improve(struct schedule *s, bool groups);

#endif
