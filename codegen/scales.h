/* The scales of a schedule. */
#ifndef FOOTPOINT_SCALES_H
#define FOOTPOINT_SCALES_H

#include "schedule.h"

/** Changes the scales, all ONE so far, so that few multiplications by constants are left; returns the work, in pairs of
 *  terms compared. */
double scales_improve(struct schedule *s);

#endif
