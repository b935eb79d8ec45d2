/* Geometry of the eight-node (serendipity) segment, the face of a twenty-node hexahedron: -1 <= xi, eta <= 1; corners A
 * (-1,-1), B (1,-1), C (1,1), D (-1,1), then the mid-side nodes E of AB, F of BC, G of CD, H of DA. No digits are lost
 * far from the origin, see footpoint-quad4-geometry.h. */
#ifndef FOOTPOINT_QUAD8_GEOMETRY_INCLUDED
#define FOOTPOINT_QUAD8_GEOMETRY_INCLUDED

#ifdef __cplusplus
extern "C" {
#endif

/** Computes shape functions of A, B, C, D, E, F, G, H at (xi,eta) and, in the rows after them, their derivatives by xi,
 *  eta, xi xi, xi eta and eta eta: row j starts at phi[8 j]. */
void footpoint_quad8_shape(double xi, double eta, double phi[48]);

/** Computes the point r(xi,eta) of the segment; x: its nodes; mesh length. */
void footpoint_quad8_position(const double *const x[8], double xi, double eta, double r[3]);

/** Computes the first derivatives of r by xi and by eta; mesh length. */
void footpoint_quad8_derivatives(const double *const x[8], double xi, double eta, double r_xi[3], double r_eta[3]);

/** Computes the second derivatives of r; mesh length. */
void footpoint_quad8_second_derivatives(const double *const x[8], double xi, double eta, double r_xixi[3],
                                        double r_xieta[3], double r_etaeta[3]);

#ifdef __cplusplus
}
#endif

#endif
