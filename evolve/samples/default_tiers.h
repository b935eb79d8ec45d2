/* The reference point, frame and tiers of a scene that leaves them to its segments. */
#ifndef FOOTPOINT_DEFAULT_TIERS_H
#define FOOTPOINT_DEFAULT_TIERS_H

#include "../input/scene.h"
#include "variation.h"

/** Segments quad4 that are rectangles or parallelograms: the affine frame, one tier "exact"; plane ones: the plane
 *  frame, tiers "fast", "coarse" and "exact"; all other segments: frame and tiers of the scene of their kind.  The
 *  reference point, unless the scene has one: corner A for the affine frame, otherwise as scene_choose_reference says.
 *  False with *d: the scene of the kind cannot be read. */
bool scene_follow(const char *root, struct scene *s, enum vary_kind kind, struct diag *d);

/** The scene that is called as s->segment, evolve/scenes/<kind>.scene.  NULL with *d: there is none, it has no tiers of
 *  its own, or it is `s` itself. */
struct scene *scene_of_kind(const char *root, const struct scene *s, struct diag *d);

/** Corner A, or the middle of the contact points' box; of triangles their centre. */
void scene_choose_reference(struct scene *s, bool from_corner);

#endif
