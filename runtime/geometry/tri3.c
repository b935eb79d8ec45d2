/* Geometry of the three-node segment; see footpoint-tri3-geometry.h. */
#include "footpoint-tri3-geometry.h"

#include "isoparametric.h"

enum { NODES = 3 };

void footpoint_tri3_shape(double xi, double eta, double phi[18])
{
    for (int k = 0; k < 6 * 3; k++)
        phi[k] = 0.0;
    phi[0] = 1.0 - xi - eta;
    phi[1] = xi;
    phi[2] = eta;
    phi[3] = phi[6] = -1.0;
    phi[4] = phi[8] = 1.0;
}

void footpoint_tri3_position(const double *const x[3], double xi, double eta, double r[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_tri3_shape(xi, eta, phi);
    isoparametric_point(x, NODES, phi, r);
}

void footpoint_tri3_derivatives(const double *const x[3], double xi, double eta, double r_xi[3], double r_eta[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_tri3_shape(xi, eta, phi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI * NODES, r_xi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_ETA * NODES, r_eta);
}
