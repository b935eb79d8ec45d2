/* Errors between the samples: from the worst samples uphill to the worst errors near them. */
#ifndef FOOTPOINT_CLIMB_H
#define FOOTPOINT_CLIMB_H

#include "../eval/errors.h"
#include "../samples/sampler.h"

/** Climbs from the samples of most error of a function, TALLY_WORST of them, within the limits of their scene: 60 changes
 *  each, 30 on curved faces, of the random numbers that they are drawn from, ever smaller ones, of which those stay that make
 *  the larger error of xi and eta larger.  Each change is a sample as any other, with a foot point of its own.  Deterministic
 *  in scene, run and `first`.
 *  @param[in] m           has taken the samples of p; the tallies are sorted
 *  @param[in] first, outs the function's outputs in m
 *  @param[out] worst      worst[outs]: the largest error met of each, no less than that of any sample */
void climb(struct sampler *p, struct measurement *m, size_t first, size_t outs, double *worst);

/** Whether there is something to climb on: samples that are drawn, for errors that are not another distribution's. */
bool climb_can(const struct sampler *p);

#endif
