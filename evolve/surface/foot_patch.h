/* The certain closest point on a Gregory patch (or on a Bezier patch, whose twins are its inner points). */
#ifndef FOOTPOINT_FOOT_PATCH_H
#define FOOTPOINT_FOOT_PATCH_H

#include "foot_patch_local.h"
#include "sample.h"

/** Computes the control points of a patch from x[8], corners and normals. A Bezier patch becomes a Gregory patch whose
 *  twins are its inner points. Returns the status of footpoint_gregory_points(). */
int patch_points(enum patch_kind kind, const double x[][3], struct footpoint_gregory *patch);

/** Finds all stationary points of the distance from xs to the patch in the box lo <= xi,eta <= hi, within -1..1,
 *  nearest first. Returns their number, or PATCH_UNCERTAIN if they cannot be separated: near a centre of curvature, or
 *  at a corner of a patch where second derivatives jump. */
int foot_patch_stationary(const struct footpoint_gregory *patch, const double xs[3], const double lo[2],
                          const double hi[2], struct stationary found[PATCH_STATIONARY_MAX]);

/** Finds the closest point of the whole patch, including edges and corners. `minimum`: it is an interior stationary
 *  point. Returns false if no point is certain. */
bool foot_patch_closest(const struct footpoint_gregory *patch, const double xs[3], struct stationary *closest);

/** Returns true if the closest point of the box lo <= xi,eta <= hi is proved to be the minimum to which Newton's iteration
 *  converges from `near`: much quicker. */
bool foot_patch_closest_near(const struct footpoint_gregory *patch, const double xs[3], const double lo[2],
                             const double hi[2], const double near[2], struct stationary *closest);

#endif
