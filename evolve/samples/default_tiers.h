/* The reference point, frame and tiers of a scene that leaves them to its segments. */
#ifndef FOOTPOINT_DEFAULT_TIERS_H
#define FOOTPOINT_DEFAULT_TIERS_H

#include "../input/scene.h"
#include "variation.h"

/** Segments quad4 that are rectangles or parallelograms: the affine frame, one tier "exact"; plane ones: the plane
 *  frame, tiers "fast", "coarse" and "exact"; all other segments: frame and tiers of the scene of their kind.  The
 *  reference point, unless the scene has one: corner A for the affine frame, otherwise as scene_choose_reference says.
 *  False with *d: the scene of the kind cannot be read. */
bool scene_default_tiers(const char *root, struct scene *s, enum variation_kind kind, struct diag *d);

#endif
