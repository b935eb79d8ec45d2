/* Geometry of the kinds of master segments, as scenes need it: one surface for each segment_kind of
 * codegen/genome/segment_kind.h, with the certain foot point on it. */
#ifndef FOOTPOINT_SURFACE_H
#define FOOTPOINT_SURFACE_H

#include "sample.h"

#include <stdbool.h>

/** A kind. A segment is the vectors of a sample, in the order of the segment_kind; positions share one unit of
 *  length. */
struct surface {
    const char *name; /* the segment_kind's name */
    size_t nodes;
    bool triangle;
    enum patch_kind patch; /* for kinds with normals */
    /** Shape functions and derivatives as in runtime/, if r is a weighted sum of nodes; otherwise NULL. */
    void (*shape)(double xi, double eta, double *phi);
    /** Computes r, r_xi and r_eta at (xi,eta). */
    void (*point)(const struct surface *f, double (*x)[3], double xi, double eta, double r[3][3]);
    /** Finds the foot point as scenes define it: the local minimum of the distance nearest to s->xs with lo < xi,eta <=
     *  hi (component-wise; on triangles also xi + eta <= hi[0]). Fills xi, eta, gap of *s. Returns false if there is
     *  none, or if it is not certain.
     *  @param[in] near  a point near the foot point, which makes the search quick and changes no result but by rounding;
     *                   or NULL */
    bool (*foot)(const struct surface *f, struct sample *s, const double lo[2], const double hi[2],
                 const double near[2]);
};

/** Returns the surface of a kind; never NULL if segment_find() knows the kind. */
const struct surface *surface_find(const struct segment_kind *k);

/** Computes point r(xi,eta) and unit normal; returns false if there is no normal. */
bool surface_normal(const struct surface *f, double (*x)[3], double xi, double eta, double r[3], double n[3]);

/* Functions of the table's rows. */

/** Bilinear: the quintic of foot_bilinear.h. */
bool surface_foot_bilinear(const struct surface *f, struct sample *s, const double lo[2], const double hi[2],
                           const double near[2]);
/** Kinds with shape functions of degree up to 2 in xi and in eta: see foot_quadratic.c. */
bool surface_foot_quadratic(const struct surface *f, struct sample *s, const double lo[2], const double hi[2],
                            const double near[2]);
/** Gregory and Bezier patches: see foot_patch.c. */
void surface_point_patch(const struct surface *f, double (*x)[3], double xi, double eta, double r[3][3]);
bool surface_foot_patch(const struct surface *f, struct sample *s, const double lo[2], const double hi[2],
                        const double near[2]);

#endif
