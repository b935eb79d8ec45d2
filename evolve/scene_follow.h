/* The reference point, frame and tiers of a scene that leaves them to its segments. */
#ifndef FOOTPOINT_SCENE_FOLLOW_H
#define FOOTPOINT_SCENE_FOLLOW_H

#include "scene.h"
#include "vary.h"

/** Rectangles and parallelograms: the affine frame, one tier "exact"; plane segments: the plane frame, tiers "coarse"
 * and "exact"; others: the parallelogram frame and the tiers of the scene quad4.  The reference point, unless the scene
 * has one: corner A for the affine frame, the middle of the contact points' box for others. */
void scene_follow(struct scene *s, enum vary_kind kind);

#endif
