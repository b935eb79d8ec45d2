/* Geometry of a Gregory patch over a four-node segment: the paper's (45)-(50). It is made from the corner nodes and the
 * unit normals there. Neighbours that share an edge's two nodes and normals have the same tangent plane at each point
 * of it, however many segments meet in a node (Chiyokura and Kimura, "Design of solids with free-form surfaces",
 * SIGGRAPH 1983; Puso and Laursen, "A 3D contact smoothing method using Gregory patches", IJNME 54, 2002).
 *
 * Corners, coordinates and units as in footpoint-bezier-geometry.h; normals from a mesh: footpoint-node-normals.h. */
#ifndef FOOTPOINT_GREGORY_GEOMETRY_INCLUDED
#define FOOTPOINT_GREGORY_GEOMETRY_INCLUDED

#include "footpoint-bezier-geometry.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The twenty control points of (45)-(50), relative to corner A. */
struct footpoint_gregory {
    struct footpoint_bezier net; /* P_ij; the innermost four are P_110, P_210, P_120, P_220, which smooth AB and DC */
    double twin[2][2][3];        /* P_111, P_121; P_211, P_221 (twin[i-1][j-1]), which smooth AD and BC; mesh length */
};

/** Computes control points from corners x[4][3] and unit normals n[4][3] there, in the order A, B, C, D. Edges and
 *  status as in footpoint_bezier_points. */
int footpoint_gregory_points(const double x[4][3], const double n[4][3], struct footpoint_gregory *patch);

/** Computes point and derivatives at (xi,eta) in -1..1. At a corner (47)-(50) are 0/0. Point and first derivatives have
 *  limits there. Second derivatives have no limit that is the same from all sides; they are taken along the diagonal,
 *  and the mixed derivative is the mean along the two edges. Outside -1..1, the weights of (47)-(50) stay as on the
 *  nearest edge, so that iterations may overstep: r and, except beyond a corner, its first derivatives are
 *  continuous. */
void footpoint_gregory_jet(const struct footpoint_gregory *patch, double xi, double eta, struct footpoint_jet *jet);

/** Computes the point r(xi,eta); mesh length. */
void footpoint_gregory_position(const struct footpoint_gregory *patch, double xi, double eta, double r[3]);

/** Computes the unit normal at (xi,eta), or the gap (xS - r) . n; status as footpoint_jet_normal. */
int footpoint_gregory_normal(const struct footpoint_gregory *patch, double xi, double eta, double n[3]);
int footpoint_gregory_gap(const struct footpoint_gregory *patch, const double xS[3], double xi, double eta,
                          double *gap);

#ifdef __cplusplus
}
#endif

#endif
