/* A sample on a smoothed surface: one patch, one slave node and its certain foot point. */
#ifndef FOOTPOINT_PATCH_H
#define FOOTPOINT_PATCH_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"

#include <stddef.h>

enum patch_kind { PATCH_GREGORY, PATCH_BEZIER };

struct patch_sample {
    double x[4][3]; /* corners A, B, C, D at (xi,eta) = (-1,-1), (1,-1), (1,1), (-1,1); any length unit */
    double n[4][3]; /* unit normals at the corners */
    double xs[3];   /* slave node; same unit as x */
    double xi, eta; /* foot point on the patch, dimensionless */
    double gap;     /* (xs - r(xi,eta)) . n, n the patch's unit normal there; same unit as x */
    enum patch_kind kind;
};

struct patch_set {
    struct patch_sample *s; /* owned */
    size_t n, room;
};

/** The control points of a sample's patch, a Bezier patch's as those of a Gregory patch whose twins are its inner
 * points; status as footpoint_gregory_points(). */
int patch_sample_points(const struct patch_sample *s, struct footpoint_gregory *patch);

/** The paper's sixteen inputs (section 7.2.1), in the frame in which A is the origin, B = (1,0,0) and D lies in the x-y
 *  plane: patch_input_name[] says which.  Normals are told by the ratios of their components, x/z and y/z. */
enum { PATCH_INPUTS = 16 };
extern const char *const patch_input_name[PATCH_INPUTS];
void patch_inputs(const struct patch_sample *s, double input[PATCH_INPUTS]);

void patch_set_add(struct patch_set *set, const struct patch_sample *s);
void patch_set_free(struct patch_set *set);

#endif
