/* Errors between the samples: from the worst samples uphill to the worst errors near them. */
#ifndef FOOTPOINT_CLIMB_H
#define FOOTPOINT_CLIMB_H

#include "../eval/errors.h"
#include "../samples/sampler.h"

enum { CLIMB_STEPS = 60 };

/** Climbs from the samples of most error of an expression, TALLY_WORST of them, within the limits of their scene: CLIMB_STEPS
 *  changes each of the random numbers that they are drawn from, ever smaller ones, of which those stay that make the error
 *  larger.  Each change is a sample as any other, with a foot point of its own.  Deterministic in scene, run and `which`.
 *  @param[in] which  the expression of m, whose tally is of the sampler's samples; it is sorted
 *  @return the largest error met, no less than that of any sample */
double climb(struct sampler *p, struct measurement *m, size_t which);

/** Whether there is something to climb on: samples that are drawn, for errors that are not another distribution's. */
bool climb_can(const struct sampler *p);

#endif
