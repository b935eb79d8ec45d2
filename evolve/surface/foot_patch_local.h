/* A Gregory patch as its reference search sees it: about the slave node, in units of its size, by u = (1 + xi)/2 and
 * v = (1 + eta)/2; evaluated in long double. */
#ifndef FOOTPOINT_FOOT_PATCH_LOCAL_H
#define FOOTPOINT_FOOT_PATCH_LOCAL_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../common/vec3.h"
#include "foot_bilinear.h"

struct patch_local {
    double p[4][4][3], e[2][2][3]; /* net, relative to the slave node; twin less inner point */
    double third[4][3];            /* bounds of |p_uuu|, |p_uuv|, |p_uvv|, |p_vvv| of the net */
    double size;                   /* mesh length */
};

/** Vector from the slave node and its derivatives by u and v. */
struct patch_jet {
    long double r[3], u[3], v[3], uu[3], uv[3], vv[3];
};

/** False if the patch has no size, or anything is not finite. */
bool patch_localise(const struct footpoint_gregory *patch, const double xs[3], struct patch_local *l);

/** (45)-(50) as they stand, and their derivatives. */
void patch_evaluate(const struct patch_local *l, long double u, long double v, struct patch_jet *jet);

/** Newton's iteration from (u,v), until steps are rounding alone; false if that does not come about.  *minimum: the
 *  Hessian of the distance is positive definite there. */
bool patch_polish(const struct patch_local *l, long double *u, long double *v, bool *minimum);

/** The point at (u,v) with its distance, as the reference's callers see it. */
struct stationary patch_point_at(const struct patch_local *l, long double u, long double v, bool minimum);

#endif
