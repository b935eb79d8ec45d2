/* The reference point, frame and tiers of scenes that do not name them. */
#ifndef FOOTPOINT_DEFAULT_TIERS_H
#define FOOTPOINT_DEFAULT_TIERS_H

#include "../input/scene.h"
#include "variation.h"

/** Sets frame and tiers by kind. Rectangles and parallelograms (quad4) get the affine frame and the tier "exact". Plane
 *  quad4 get the plane frame and the tiers "fast", "coarse" and "exact". Other segments get frame and tiers from the
 *  scene of their kind. A reference point that the scene lacks is corner A in the affine frame, otherwise that of
 *  scene_choose_reference. Returns false with *d filled if the scene of the kind cannot be read. */
bool scene_default_tiers(const char *root, struct scene *s, enum variation_kind kind, struct diag *d);

#endif
