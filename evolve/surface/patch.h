/* Patches on four corners and their unit normals. */
#ifndef FOOTPOINT_PATCH_H
#define FOOTPOINT_PATCH_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"

enum patch_kind { PATCH_GREGORY, PATCH_BEZIER };

enum { PATCH_NORMALS = 4 }; /* index of the first normal among a sample's vectors, after the corners */

/** Computes the control points of a patch from x[8], corners and normals. A Bezier patch becomes a Gregory patch whose
 *  twins are its inner points. Returns the status of footpoint_gregory_points(). */
int patch_points(enum patch_kind kind, const double x[][3], struct footpoint_gregory *patch);

#endif
