/* For CalculiX: replaces the routine of the same name, which finds the closest point of a face by a pattern search.
 * Only the argument list comes from CalculiX. Link its program with this object, or with
 *
 *     -u attach_2d_ -lfootpoint_ccx -lfootpoint
 *
 * before the archive of its own objects; nothing else changes.
 *
 * CalculiX requires the closest point of the closed face: local coordinates never leave it. On an edge or a corner, the
 * tangent that CalculiX computes is as valid as before. */
#include "attach.h"

/* gfortran's name for attach_2d(pneigh,pnode,nterms,ratio,dist,xil,etl); integer is 4 bytes, real*8.
 *
 * pneigh(3,9)  [in]      coordinates of the nodes of the face pnode(3)     [in,out]  the slave node; the closest point
 * of the face nterms       [in]      3, 4, 6 or 8 nodes ratio(9)     [out]     the first nterms: shape functions at
 * that point dist         [out]     distance between the two points, >= 0 xil, etl     [out]     local coordinates,
 * attach.h
 *
 * Faces must be from 1e-30 to 1e30 long. If a coordinate is not finite, or nterms has another value, the distance is
 * not finite. */
void attach_2d_(const double pneigh[9][3], double pnode[3], const int *nterms, double ratio[9], double *dist,
                double *xil, double *etl);

static inline void shape_functions(int nodes, const double loc[2], double phi[])
{
    const double u = loc[0], v = loc[1], w = 1.0 - u - v;
    const double up = 1.0 + u, um = 1.0 - u, vp = 1.0 + v, vm = 1.0 - v;
    switch (nodes) {
    case 3:
        phi[0] = w;
        phi[1] = u;
        phi[2] = v;
        break;
    case 4:
        phi[0] = 0.25 * um * vm;
        phi[1] = 0.25 * up * vm;
        phi[2] = 0.25 * up * vp;
        phi[3] = 0.25 * um * vp;
        break;
    case 6:
        phi[0] = w * (2.0 * w - 1.0);
        phi[1] = u * (2.0 * u - 1.0);
        phi[2] = v * (2.0 * v - 1.0);
        phi[3] = 4.0 * u * w;
        phi[4] = 4.0 * u * v;
        phi[5] = 4.0 * v * w;
        break;
    default:
        phi[0] = -0.25 * um * vm * (1.0 + u + v);
        phi[1] = -0.25 * up * vm * (1.0 - u + v);
        phi[2] = -0.25 * up * vp * (1.0 - u - v);
        phi[3] = -0.25 * um * vp * (1.0 + u - v);
        phi[4] = 0.5 * up * um * vm;
        phi[5] = 0.5 * up * vp * vm;
        phi[6] = 0.5 * up * um * vp;
        phi[7] = 0.5 * um * vp * vm;
    }
}

/* Computes, from local coordinates, shape functions, the point (in place of the slave node), and their distance. Each
 * call has a constant number of nodes. */
static inline double project(int nodes, const double x[][3], const double loc[2], double xs[3], double ratio[])
{
    double phi[8], point[3] = {0.0, 0.0, 0.0}, away[3];
    shape_functions(nodes, loc, phi);
    for (int n = 0; n < nodes; n++) {
        ratio[n] = phi[n];
        for (int i = 0; i < 3; i++)
            point[i] += phi[n] * x[n][i];
    }
    for (int i = 0; i < 3; i++) {
        away[i] = xs[i] - point[i];
        xs[i] = point[i];
    }
    return sqrt(vector_dot(away, away));
}

void attach_2d_(const double pneigh[9][3], double pnode[3], const int *nterms, double ratio[9], double *dist,
                double *xil, double *etl)
{
    double loc[2] = {NAN, NAN}, distance = NAN;
    switch (*nterms) {
    case 3:
        footpoint_attach_tri3(pneigh, pnode, loc);
        distance = project(3, pneigh, loc, pnode, ratio);
        break;
    case 4:
        footpoint_attach_quad4(pneigh, pnode, loc);
        distance = project(4, pneigh, loc, pnode, ratio);
        break;
    case 6:
        footpoint_attach_tri6(pneigh, pnode, loc);
        distance = project(6, pneigh, loc, pnode, ratio);
        break;
    case 8:
        footpoint_attach_quad8(pneigh, pnode, loc);
        distance = project(8, pneigh, loc, pnode, ratio);
        break;
    default:
        break;
    }
    *dist = distance;
    *xil = loc[0];
    *etl = loc[1];
}
