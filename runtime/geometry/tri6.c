/* Geometry of the six-node segment; see footpoint-tri6-geometry.h. */
#include "footpoint-tri6-geometry.h"

#include "isoparametric.h"

enum { NODES = 6 };

void footpoint_tri6_shape(double xi, double eta, double phi[36])
{
    const double w = 1.0 - xi - eta;
    const double row[6][6] = {{w * (2.0 * w - 1.0), xi * (2.0 * xi - 1.0), eta * (2.0 * eta - 1.0), 4.0 * w * xi,
                               4.0 * xi * eta, 4.0 * eta * w},
                              {1.0 - 4.0 * w, 4.0 * xi - 1.0, 0.0, 4.0 * (w - xi), 4.0 * eta, -4.0 * eta},
                              {1.0 - 4.0 * w, 0.0, 4.0 * eta - 1.0, -4.0 * xi, 4.0 * xi, 4.0 * (w - eta)},
                              {4.0, 4.0, 0.0, -8.0, 0.0, 0.0},
                              {4.0, 0.0, 0.0, -4.0, 4.0, -4.0},
                              {4.0, 0.0, 4.0, 0.0, 0.0, -8.0}};
    for (int j = 0; j < 6; j++)
        for (int k = 0; k < 6; k++)
            phi[6 * j + k] = row[j][k];
}

void footpoint_tri6_position(const double *const x[6], double xi, double eta, double r[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_tri6_shape(xi, eta, phi);
    isoparametric_point(x, NODES, phi, r);
}

void footpoint_tri6_derivatives(const double *const x[6], double xi, double eta, double r_xi[3], double r_eta[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_tri6_shape(xi, eta, phi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI * NODES, r_xi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_ETA * NODES, r_eta);
}

void footpoint_tri6_second_derivatives(const double *const x[6], double xi, double eta, double r_xixi[3],
                                       double r_xieta[3], double r_etaeta[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_tri6_shape(xi, eta, phi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI_XI * NODES, r_xixi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI_ETA * NODES, r_xieta);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_ETA_ETA * NODES, r_etaeta);
}
