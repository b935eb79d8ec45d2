/* A Gregory patch for the reference search, relative to the slave node, in units of its size, with u = (1 + xi)/2 and v
 * = (1 + eta)/2, evaluated in long double; and all its stationary points in a box, with certainty. */
#ifndef FOOTPOINT_FOOT_PATCH_LOCAL_H
#define FOOTPOINT_FOOT_PATCH_LOCAL_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../common/vec3.h"
#include "foot_bilinear.h"

struct patch_local {
    double p[4][4][3], e[2][2][3]; /* net, relative to the slave node; twin minus inner point */
    double third[4][3];            /* bounds of |p_uuu|, |p_uuv|, |p_uvv|, |p_vvv| of the net */
    double size;                   /* mesh length */
};

/** Vector from the slave node, and its derivatives by u and v. */
struct patch_jet {
    long double r[3], u[3], v[3], uu[3], uv[3], vv[3];
};

/** Localises a patch. Returns false if it has no size or is not finite. */
bool patch_localise(const struct footpoint_gregory *patch, const double xs[3], struct patch_local *l);

/** Evaluates (45)-(50) as they stand, and their derivatives. */
void patch_evaluate(const struct patch_local *l, long double u, long double v, struct patch_jet *jet);

/** Iterates Newton's method from (u,v) until steps are at the level of rounding; returns false if they do not get
 *  there. *minimum: the Hessian of the distance is positive definite at the result. */
bool patch_polish(const struct patch_local *l, long double *u, long double *v, bool *minimum);

/** Returns the point at (u,v) with its distance, in the callers' coordinates. */
struct stationary patch_point_at(const struct patch_local *l, long double u, long double v, bool minimum);

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
