/* Geometry of the eight-node segment; see footpoint-quad8-geometry.h. */
#include "footpoint-quad8-geometry.h"

#include "isoparametric.h"

enum { NODES = 8 };

void footpoint_quad8_shape(double xi, double eta, double phi[48])
{
    static const double a[8] = {-1.0, 1.0, 1.0, -1.0, 0.0, 1.0, 0.0, -1.0};
    static const double b[8] = {-1.0, -1.0, 1.0, 1.0, -1.0, 0.0, 1.0, 0.0};
    for (int k = 0; k < 8; k++) {
        const double s = 1.0 + a[k] * xi, t = 1.0 + b[k] * eta;
        if (k < 4) {
            phi[k] = 0.25 * s * t * (s + t - 3.0);
            phi[8 + k] = 0.25 * a[k] * t * (2.0 * s + t - 3.0);
            phi[16 + k] = 0.25 * b[k] * s * (s + 2.0 * t - 3.0);
            phi[24 + k] = 0.5 * t;
            phi[32 + k] = 0.25 * a[k] * b[k] * (2.0 * s + 2.0 * t - 3.0);
            phi[40 + k] = 0.5 * s;
        } else if (k % 2 == 0) {
            phi[k] = 0.5 * (1.0 - xi * xi) * t;
            phi[8 + k] = -xi * t;
            phi[16 + k] = 0.5 * b[k] * (1.0 - xi * xi);
            phi[24 + k] = -t;
            phi[32 + k] = -b[k] * xi;
            phi[40 + k] = 0.0;
        } else {
            phi[k] = 0.5 * (1.0 - eta * eta) * s;
            phi[8 + k] = 0.5 * a[k] * (1.0 - eta * eta);
            phi[16 + k] = -eta * s;
            phi[24 + k] = 0.0;
            phi[32 + k] = -a[k] * eta;
            phi[40 + k] = -s;
        }
    }
}

void footpoint_quad8_position(const double *const x[8], double xi, double eta, double r[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_quad8_shape(xi, eta, phi);
    isoparametric_point(x, NODES, phi, r);
}

void footpoint_quad8_derivatives(const double *const x[8], double xi, double eta, double r_xi[3], double r_eta[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_quad8_shape(xi, eta, phi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI * NODES, r_xi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_ETA * NODES, r_eta);
}

void footpoint_quad8_second_derivatives(const double *const x[8], double xi, double eta, double r_xixi[3],
                                        double r_xieta[3], double r_etaeta[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_quad8_shape(xi, eta, phi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI_XI * NODES, r_xixi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI_ETA * NODES, r_xieta);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_ETA_ETA * NODES, r_etaeta);
}
