/* Kinds of master segments as scenes need them: the geometry behind a segment_kind of codegen/genome/segment_kind.h,
 * and the certain foot point on them. */
#ifndef FOOTPOINT_SURFACE_H
#define FOOTPOINT_SURFACE_H

#include "patch.h"
#include "sample.h"

#include <stdbool.h>

/** One kind.  Segments are the vectors of a sample, in the order of the segment_kind; those of length are in one unit.
 */
struct surface {
    const char *name; /* as the segment_kind's */
    size_t nodes;
    bool triangle;
    enum patch_kind patch; /* of the kinds with normals */
    /** Where r is a sum of nodes: shape functions and derivatives as in runtime/; else NULL. */
    void (*shape)(double xi, double eta, double *phi);
    /** r, r_xi and r_eta at (xi,eta). */
    void (*point)(const struct surface *f, double (*x)[3], double xi, double eta, double r[3][3]);
    /** Foot point of the scene's meaning: the local minimum of the distance nearest to s->xs whose (xi,eta) lies in
     *  lo < xi,eta <= hi (component-wise; on triangles xi + eta <= hi[0], too).  Fills xi, eta, gap of *s.  False if
     *  there is none, or if none can be told with certainty. */
    bool (*foot)(const struct surface *f, struct sample *s, const double lo[2], const double hi[2]);
};

/** Of a kind; never NULL for one that segment_find() knows. */
const struct surface *surface_find(const struct segment_kind *k);

/** Point r(xi,eta) and unit normal there; false where there is none. */
bool surface_normal(const struct surface *f, double (*x)[3], double xi, double eta, double r[3], double n[3]);

/* The functions of the table's rows. */

/** Bilinear: the quintic of foot_bilinear.h. */
bool surface_foot_bilinear(const struct surface *f, struct sample *s, const double lo[2], const double hi[2]);
/** Kinds with shape functions of degree up to 2 in xi and in eta: see foot_quadratic.c. */
bool surface_foot_quadratic(const struct surface *f, struct sample *s, const double lo[2], const double hi[2]);
/** Gregory and Bezier patches: see foot_patch.c. */
void surface_point_patch(const struct surface *f, double (*x)[3], double xi, double eta, double r[3][3]);
bool surface_foot_patch(const struct surface *f, struct sample *s, const double lo[2], const double hi[2]);

#endif
