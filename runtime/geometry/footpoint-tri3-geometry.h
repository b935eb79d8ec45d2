/* Geometry of the three-node (plane) segment: r = A + xi (B - A) + eta (C - A), with xi, eta >= 0 and xi + eta <= 1, so
 * that 1 - xi - eta, xi and eta are the area coordinates of A, B and C. It is the face of a four-node tetrahedron. No
 * digits are lost far from the origin, see footpoint-quad4-geometry.h. */
#ifndef FOOTPOINT_TRI3_GEOMETRY_INCLUDED
#define FOOTPOINT_TRI3_GEOMETRY_INCLUDED

#ifdef __cplusplus
extern "C" {
#endif

/** Computes shape functions of A, B, C at (xi,eta) and, in the rows after them, their derivatives by xi, eta, xi xi, xi
 *  eta and eta eta: row j starts at phi[3 j]. */
void footpoint_tri3_shape(double xi, double eta, double phi[18]);

/** Computes the point r(xi,eta) of the segment; x: its nodes; mesh length. */
void footpoint_tri3_position(const double *const x[3], double xi, double eta, double r[3]);

/** Computes the first derivatives of r by xi and by eta; mesh length. */
void footpoint_tri3_derivatives(const double *const x[3], double xi, double eta, double r_xi[3], double r_eta[3]);

#ifdef __cplusplus
}
#endif

#endif
