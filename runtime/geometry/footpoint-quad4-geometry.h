/* Geometry of the bilinear segment r(xi,eta) = sum phi_i x_i, as (7)-(11) need it. See footpoint.h for the order of
 * corners and for units. Everything is computed from differences of nodes, so that a segment far from the origin loses
 * no more digits than its coordinates have lost already. */
#ifndef FOOTPOINT_QUAD4_GEOMETRY_INCLUDED
#define FOOTPOINT_QUAD4_GEOMETRY_INCLUDED

#include "../footpoint.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Computes shape functions phi of A, B, C, D at (xi,eta): (1 +- xi)(1 +- eta)/4; their sum is 1. */
void footpoint_quad4_shape(double xi, double eta, double phi[4]);

/** Computes the point r(xi,eta) of the segment; mesh length. */
void footpoint_quad4_position(const double xA[3], const double xB[3], const double xC[3], const double xD[3], double xi,
                              double eta, double r[3]);

/** Computes the first derivatives of r by xi and by eta; mesh length. (The mixed derivative is c3 = (A - B + C - D)/4;
 *  the others vanish.) */
void footpoint_quad4_derivatives(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                 double xi, double eta, double r_xi[3], double r_eta[3]);

/** Computes the unit normal n = r_xi x r_eta / |r_xi x r_eta|. Returns FOOTPOINT_ERR_DEGENERATE if the two are
 *  parallel, vanish or are not finite. */
int footpoint_quad4_normal(const double xA[3], const double xB[3], const double xC[3], const double xD[3], double xi,
                           double eta, double n[3]);

/** Computes the vector xS - r(xi,eta); mesh length. */
void footpoint_quad4_offset(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                            const double xS[3], double xi, double eta, double d[3]);

/** Computes the signed gap (xS - r(xi,eta)) . n along the unit normal there; mesh length, > 0 open. Status as
 *  footpoint_quad4_normal; also FOOTPOINT_ERR_DEGENERATE if the gap is not finite. */
int footpoint_quad4_gap(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                        const double xS[3], double xi, double eta, double *gap);

#ifdef __cplusplus
}
#endif

#endif
