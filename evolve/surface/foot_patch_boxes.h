/* All stationary points of a Gregory patch in a box of (u,v), with certainty. */
#ifndef FOOTPOINT_FOOT_PATCH_BOXES_H
#define FOOTPOINT_FOOT_PATCH_BOXES_H

#include "foot_patch_local.h"

struct patch_box {
    double u[2], v[2]; /* within 0..1 */
};

enum { PATCH_STATIONARY_MAX = 16, PATCH_UNCERTAIN = -1 };

/** Finds the stationary points in a box, nearest first; returns their number, or PATCH_UNCERTAIN. */
int patch_boxes_search(const struct patch_local *l, const struct patch_box *whole,
                       struct stationary found[PATCH_STATIONARY_MAX]);

/** Returns true if it is proved that no point of a box, bounds included, is nearer than the minimum at (u,v) within it: half
 *  the squared distance is convex on a part of the box around the minimum, and larger in the rest. */
bool patch_boxes_none_nearer(const struct patch_local *l, const struct patch_box *whole, double u, double v);

#endif
