/* Geometry of the nine-node segment; see footpoint-quad9-geometry.h. */
#include "footpoint-quad9-geometry.h"

#include "isoparametric.h"

enum { NODES = 9 };

/* Computes the parabolas that are 1 at -1, 0 and 1, and their first and second derivatives. */
static void parabolas(double t, double f[3][3])
{
    const double row[3][3] = {
        {0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0)}, {t - 0.5, -2.0 * t, t + 0.5}, {1.0, -2.0, 1.0}};
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            f[j][k] = row[j][k];
}

void footpoint_quad9_shape(double xi, double eta, double phi[54])
{
    static const int a[9] = {0, 2, 2, 0, 1, 2, 1, 0, 1}, b[9] = {0, 0, 2, 2, 0, 1, 2, 1, 1};
    double f[3][3], g[3][3];
    parabolas(xi, f);
    parabolas(eta, g);
    for (int k = 0; k < 9; k++) {
        phi[k] = f[0][a[k]] * g[0][b[k]];
        phi[9 + k] = f[1][a[k]] * g[0][b[k]];
        phi[18 + k] = f[0][a[k]] * g[1][b[k]];
        phi[27 + k] = f[2][a[k]] * g[0][b[k]];
        phi[36 + k] = f[1][a[k]] * g[1][b[k]];
        phi[45 + k] = f[0][a[k]] * g[2][b[k]];
    }
}

void footpoint_quad9_position(const double *const x[9], double xi, double eta, double r[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_quad9_shape(xi, eta, phi);
    isoparametric_point(x, NODES, phi, r);
}

void footpoint_quad9_derivatives(const double *const x[9], double xi, double eta, double r_xi[3], double r_eta[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_quad9_shape(xi, eta, phi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI * NODES, r_xi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_ETA * NODES, r_eta);
}

void footpoint_quad9_second_derivatives(const double *const x[9], double xi, double eta, double r_xixi[3],
                                        double r_xieta[3], double r_etaeta[3])
{
    double phi[FOOTPOINT_ROWS * NODES];
    footpoint_quad9_shape(xi, eta, phi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI_XI * NODES, r_xixi);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_XI_ETA * NODES, r_xieta);
    isoparametric_sum(x, NODES, phi + FOOTPOINT_ROW_ETA_ETA * NODES, r_etaeta);
}
