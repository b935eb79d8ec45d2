/* For comparison: the foot point by Newton's iteration from the last answer, on faces and edges of any kind. */
#ifndef LAST_NEWTON_H
#define LAST_NEWTON_H

#include "../../runtime/geometry/footpoint-quad8-geometry.h"
#include "../../runtime/geometry/footpoint-quad9-geometry.h"
#include "../../runtime/geometry/footpoint-tri3-geometry.h"
#include "../../runtime/geometry/footpoint-tri6-geometry.h"
#include "friction.h"

/* Computes N shape functions, then N of each derivative: by xi, eta, xi xi, xi eta, eta eta. */
static void shapes_of_quad4(double xi, double eta, double phi[24])
{
    for (int k = 0; k < 4; k++) {
        const double s = k == 1 || k == 2 ? 0.5 : -0.5, t = k > 1 ? 0.5 : -0.5, p = 0.5 + s * xi, q = 0.5 + t * eta;
        const double all[6] = {p * q, s * q, t * p, 0.0, s * t, 0.0};
        for (int i = 0; i < 6; i++)
            phi[4 * i + k] = all[i];
    }
}

static void shapes_of_edge2(double xi, double eta, double phi[12])
{
    const double all[4] = {0.5 - 0.5 * xi, 0.5 + 0.5 * xi, -0.5, 0.5};
    (void)eta;
    memset(phi, 0, 12 * sizeof *phi);
    memcpy(phi, all, sizeof all);
}

static void shapes_of_edge3(double xi, double eta, double phi[18])
{
    const double first[6] = {
        0.5 * xi * (xi - 1.0), 0.5 * xi * (xi + 1.0), 1.0 - xi * xi, xi - 0.5, xi + 0.5, -2.0 * xi};
    const double second[3] = {1.0, 1.0, -2.0};
    (void)eta;
    memset(phi, 0, 18 * sizeof *phi);
    memcpy(phi, first, sizeof first);
    memcpy(phi + 9, second, sizeof second);
}

static void (*const shapes_of[FOOTPOINT_EDGE3 + 1])(double, double, double *) = {
    footpoint_tri3_shape, footpoint_tri6_shape, shapes_of_quad4, footpoint_quad8_shape, footpoint_quad9_shape, NULL,
    shapes_of_edge2,      shapes_of_edge3};

/* Computes a step from loc: the `move` of (xi,eta), and the gap before it. */
static void newton_step(enum footpoint_face kind, const double *y, const double loc[2], double move[2], double *gap)
{
    const int nodes = footpoint_face_nodes(kind);
    double phi[6 * MOST_FACE], n[3];
    vec r[6] = {{0}};
    shapes_of[kind](loc[0], loc[1], phi);
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3 * nodes; k++)
            r[i][k % 3] += phi[nodes * i + k / 3] * y[k];
    r[2][2] += kind > FOOTPOINT_FACES; /* edges have r_eta = (0, 0, 1) */
    for (int k = 0; k < 3; k++)
        r[0][k] = y[3 * nodes + k] - r[0][k];
    const double aa = along(r[1], r[1]) - along(r[0], r[3]), ab = along(r[1], r[2]) - along(r[0], r[4]);
    const double bb = along(r[2], r[2]) - along(r[0], r[5]), f = along(r[0], r[1]), g = along(r[0], r[2]);
    const double per = 1.0 / (aa * bb - ab * ab);
    move[0] = (bb * f - ab * g) * per;
    move[1] = (aa * g - ab * f) * per;
    for (int k = 0; k < 3; k++)
        n[k] = r[1][(k + 1) % 3] * r[2][(k + 2) % 3] - r[1][(k + 2) % 3] * r[2][(k + 1) % 3];
    *gap = along(r[0], n) / sqrt(along(n, n));
}

/* Iterates until a step is below 1e-10. The gap belongs to the point before the last step, which changes it by the
 * square of the step. */
static int last_newton(enum footpoint_face kind, const double *y, double loc[2], double *gap)
{
    double move[2] = {1.0, 1.0};
    for (int n = 0; n < 20 && !(fabs(move[0]) <= 1e-10 && fabs(move[1]) <= 1e-10); n++) {
        newton_step(kind, y, loc, move, gap);
        loc[0] += move[0];
        loc[1] += move[1];
    }
    return fabs(move[0]) <= 1e-10 && fabs(move[1]) <= 1e-10 ? FOOTPOINT_OK : FOOTPOINT_ERR_NO_CONVERGENCE;
}

#endif
