/* The certain closest point on a Gregory patch (or a Bezier patch: one whose twins are its inner points). */
#ifndef FOOTPOINT_FOOT_PATCH_H
#define FOOTPOINT_FOOT_PATCH_H

#include "foot_patch_boxes.h"
#include "patch.h"
#include "sample.h"

/** All stationary points of the distance from xs to the patch in the box lo <= xi,eta <= hi, within -1..1, nearest
 *  first.  Returns how many, or PATCH_UNCERTAIN where they cannot be told apart: near a centre of curvature, or in the
 *  corner of a patch whose second derivatives jump there. */
int foot_patch_stationary(const struct footpoint_gregory *patch, const double xs[3], const double lo[2],
                          const double hi[2], struct stationary found[PATCH_STATIONARY_MAX]);

/** The closest point of the whole patch, its edges and corners among them; `minimum` tells that it is a stationary
 * point within.  False: it cannot be told with certainty. */
bool foot_patch_closest(const struct footpoint_gregory *patch, const double xs[3], struct stationary *closest);

/** Foot point of the scene's meaning: the local minimum nearest to xs with lo < xi,eta <= hi.  Fills xi, eta and gap of
 *  *s from its corners, normals and slave node.  False if there is none, or none that is certain. */
bool foot_patch(enum patch_kind kind, struct sample *s, const double lo[2], const double hi[2]);

#endif
