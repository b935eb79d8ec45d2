/* A Gregory patch for the reference search: relative to the slave node, in units of its size, with u = (1 + xi)/2 and v
 * = (1 + eta)/2; evaluated in long double. */
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

#endif
