/* Geometry of the bilinear segment; see footpoint-quad4-geometry.h. */
#include "footpoint-quad4-geometry.h"

#include "vector.h"

void footpoint_quad4_shape(double xi, double eta, double phi[4])
{
    const double s0 = 0.5 * (1.0 - xi), s1 = 0.5 * (1.0 + xi), t0 = 0.5 * (1.0 - eta), t1 = 0.5 * (1.0 + eta);
    phi[0] = s0 * t0;
    phi[1] = s1 * t0;
    phi[2] = s1 * t1;
    phi[3] = s0 * t1;
}

/* Returns component i of the vector from A to r(xi,eta): s along AB, then t along the line that joins AB to DC
 * there. */
static double from_a(const double xA[3], const double xB[3], const double xC[3], const double xD[3], double s, double t,
                     int i)
{
    const double ad = xD[i] - xA[i], bc = xC[i] - xB[i];
    return s * (xB[i] - xA[i]) + t * (ad + s * (bc - ad));
}

void footpoint_quad4_position(const double xA[3], const double xB[3], const double xC[3], const double xD[3], double xi,
                              double eta, double r[3])
{
    for (int i = 0; i < 3; i++)
        r[i] = xA[i] + from_a(xA, xB, xC, xD, 0.5 * (1.0 + xi), 0.5 * (1.0 + eta), i);
}

void footpoint_quad4_offset(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                            const double xS[3], double xi, double eta, double d[3])
{
    for (int i = 0; i < 3; i++)
        d[i] = (xS[i] - xA[i]) - from_a(xA, xB, xC, xD, 0.5 * (1.0 + xi), 0.5 * (1.0 + eta), i);
}

void footpoint_quad4_derivatives(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                 double xi, double eta, double r_xi[3], double r_eta[3])
{
    for (int i = 0; i < 3; i++) {
        r_xi[i] = 0.25 * ((1.0 - eta) * (xB[i] - xA[i]) + (1.0 + eta) * (xC[i] - xD[i]));
        r_eta[i] = 0.25 * ((1.0 - xi) * (xD[i] - xA[i]) + (1.0 + xi) * (xC[i] - xB[i]));
    }
}

int footpoint_quad4_normal(const double xA[3], const double xB[3], const double xC[3], const double xD[3], double xi,
                           double eta, double n[3])
{
    double r_xi[3], r_eta[3];
    footpoint_quad4_derivatives(xA, xB, xC, xD, xi, eta, r_xi, r_eta);
    return vector_normal(r_xi, r_eta, n);
}

int footpoint_quad4_gap(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                        const double xS[3], double xi, double eta, double *gap)
{
    double n[3], d[3];
    const int status = footpoint_quad4_normal(xA, xB, xC, xD, xi, eta, n);
    if (status != FOOTPOINT_OK)
        return status;
    footpoint_quad4_offset(xA, xB, xC, xD, xS, xi, eta, d);
    const double along = vector_dot(d, n);
    if (!number_finite(along))
        return FOOTPOINT_ERR_DEGENERATE;
    *gap = along;
    return FOOTPOINT_OK;
}
