/* Finds closest points of closed patches, with certainty: parts of the patch are halved until their control points, and how
 * far inner points of Gregory patches move there, show that no point of a part is nearer than a known one. Remaining
 * parts, of 1/128 of the patch, lead to minima by Newton's steps in quadruple precision. */
#ifndef FOOTPOINT_TESTS_PATCH_NEAREST_H
#define FOOTPOINT_TESTS_PATCH_NEAREST_H

#include "patch_judge.h"

/** Moves z = {xi, eta} downhill on the closed patch until steps vanish. Returns half the square of the distance there. */
patch_wide patch_settle(const struct patch_case *f, const struct patch_net *t, patch_wide z[2]);

/** Finds the closest point z. Returns half the square of its distance. */
patch_wide patch_nearest(const struct patch_case *f, const struct patch_net *t, patch_wide z[2]);

#endif
