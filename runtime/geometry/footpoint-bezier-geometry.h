/* Geometry of a bicubic Bezier patch over a four-node segment (Farin, "Curves and surfaces for CAGD", 2002), made from
 * the four corner nodes and the unit normals there. Neighbours share an edge curve, but with a kink along it;
 * footpoint-gregory-geometry.h joins them smoothly.
 *
 * Corners A, B, C, D at (xi,eta) = (-1,-1), (1,-1), (1,1), (-1,1); u = (1 + xi)/2 and v = (1 + eta)/2 are the paper's
 * coordinates. Units as in footpoint.h. Control points are relative to A, so that a patch far from the origin loses no
 * more digits than its nodes have lost already. */
#ifndef FOOTPOINT_BEZIER_GEOMETRY_INCLUDED
#define FOOTPOINT_BEZIER_GEOMETRY_INCLUDED

#include "../footpoint.h"

#ifdef __cplusplus
extern "C" {
#endif

struct footpoint_bezier {
    double origin[3];  /* corner A; mesh length */
    double p[4][4][3]; /* P_ij - A, i along xi, j along eta: A = P_00, B = P_30, C = P_33, D = P_03; mesh length */
};

/** A point of a patch and its derivatives by xi and eta; mesh length. */
struct footpoint_jet {
    double r[3];                               /* r(xi,eta) - A */
    double r_xi[3], r_eta[3];                  /* first derivatives */
    double r_xixi[3], r_xieta[3], r_etaeta[3]; /* second derivatives */
};

/** Computes control points from corners x[4][3] and unit normals n[4][3] there, in the order A, B, C, D. The inner
 *  points of an edge lie in the tangent planes of its ends, a third of the projected edge away. The four innermost
 *  points complete parallelograms with their corner's three points (no twist). Returns FOOTPOINT_ERR_NOT_FINITE, or
 *  FOOTPOINT_ERR_DEGENERATE if an edge has no length or is parallel to the normal at an end of it, a normal is 0, or
 *  squares of lengths exceed double. *patch is then untouched. */
int footpoint_bezier_points(const double x[4][3], const double n[4][3], struct footpoint_bezier *patch);

/** Computes point and derivatives at any (xi,eta). */
void footpoint_bezier_jet(const struct footpoint_bezier *patch, double xi, double eta, struct footpoint_jet *jet);

/** Computes the unit normal of a jet, r_xi x r_eta / |r_xi x r_eta|, and the signed gap (xS - r) . n of a slave node, >
 *  0 open; mesh length. Returns FOOTPOINT_ERR_DEGENERATE if there is no normal. gap may be NULL, and then also xS. */
int footpoint_jet_normal(const double origin[3], const struct footpoint_jet *jet, const double xS[3], double n[3],
                         double *gap);

#ifdef __cplusplus
}
#endif

#endif
