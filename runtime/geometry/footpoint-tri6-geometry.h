/* Geometry of the six-node segment, the face of a ten-node tetrahedron: xi, eta >= 0, xi + eta <= 1; corners A (0,0), B
 * (1,0), C (0,1), then the mid-side nodes D of AB, E of BC, F of CA. No digits are lost far from the origin, see
 * footpoint-quad4-geometry.h. */
#ifndef FOOTPOINT_TRI6_GEOMETRY_INCLUDED
#define FOOTPOINT_TRI6_GEOMETRY_INCLUDED

#ifdef __cplusplus
extern "C" {
#endif

/** Computes shape functions of A, B, C, D, E, F at (xi,eta) and, in the rows after them, their derivatives by xi, eta,
 *  xi xi, xi eta and eta eta: row j starts at phi[6 j]. */
void footpoint_tri6_shape(double xi, double eta, double phi[36]);

/** Computes the point r(xi,eta) of the segment; x: its nodes; mesh length. */
void footpoint_tri6_position(const double *const x[6], double xi, double eta, double r[3]);

/** Computes the first derivatives of r by xi and by eta; mesh length. */
void footpoint_tri6_derivatives(const double *const x[6], double xi, double eta, double r_xi[3], double r_eta[3]);

/** Computes the second derivatives of r; mesh length. */
void footpoint_tri6_second_derivatives(const double *const x[6], double xi, double eta, double r_xixi[3],
                                       double r_xieta[3], double r_etaeta[3]);

#ifdef __cplusplus
}
#endif

#endif
