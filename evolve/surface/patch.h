/* Patches on four corners and the unit normals there. */
#ifndef FOOTPOINT_PATCH_H
#define FOOTPOINT_PATCH_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"

enum patch_kind { PATCH_GREGORY, PATCH_BEZIER };

enum { PATCH_NORMALS = 4 }; /* where they begin among the vectors of a sample, behind the corners */

/** The control points of a patch of x[8], corners and normals, a Bezier patch's as those of a Gregory patch whose twins
 *  are its inner points; status as footpoint_gregory_points(). */
int patch_points(enum patch_kind kind, const double x[][3], struct footpoint_gregory *patch);

#endif
