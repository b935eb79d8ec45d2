// Tribol: replaces InvIso of src/tribol/integ/FE.hpp, the inverse isoparametric map, and adds derivatives. Tribol's
// nodes of a quadrilateral are (1,1), (-1,1), (-1,-1), (1,-1): ours, starting with the third. Include it where Tribol's
// RealT (double) and SLIC_ERROR_IF are defined.
#ifndef FOOTPOINT_REPLACE_TRIBOL
#define FOOTPOINT_REPLACE_TRIBOL

#include "footpoint.h"
#include "footpoint_quad4.h"
#include "footpoint_tri3.h"

namespace tribol
{

/** Computes parent coordinates of a point on or near a face.
 *  @param[in]  x           the point; mesh length
 *  @param[in]  xA, yA, zA  nodes' coordinates, stacked
 *  @param[in]  numNodes    3 or 4
 *  @param[out] xi          {xi, eta}; clamped if rounding exceeds an edge; untouched if SLIC_ERROR_IF returns */
inline void InvIso(const RealT x[3], const RealT *xA, const RealT *yA, const RealT *zA, const int numNodes, RealT xi[2])
{
    RealT node[4][3], gap = 0.;
    for (int i = 0; i < numNodes && i < 4; i++) {
        const int from = numNodes == 4 ? (i + 2) % 4 : i;
        node[i][0] = xA[from];
        node[i][1] = yA[from];
        node[i][2] = zA[from];
    }
    const int status = numNodes == 4   ? footpoint_quad4_full(node[0], node[1], node[2], node[3], x, xi, &gap)
                       : numNodes == 3 ? footpoint_tri3_exact(node[0], node[1], node[2], x, xi, &gap)
                                       : FOOTPOINT_ERR_ARGUMENT;
    SLIC_ERROR_IF(status != FOOTPOINT_OK, "InvIso: no foot point.");
    for (int k = 0; k < 2 && numNodes == 4; k++)
        if (xi[k] * xi[k] > 1. && xi[k] * xi[k] < 1. + 2.e-10)
            xi[k] = xi[k] > 0. ? 1. : -1.;
}

/** Computes the same for a quadrilateral, with shape functions and derivatives.
 *  @param[out] phi    of Tribol's nodes
 *  @param[out] dxi    derivatives of xi, eta and gap by the coordinates of Tribol's nodes, then of x; 3 x 5 x 3
 *  @return false if there is no foot point that depends smoothly on the nodes */
inline bool InvIsoDerivatives(const RealT x[3], const RealT *xA, const RealT *yA, const RealT *zA, RealT xi[2],
                              RealT phi[4], RealT dxi[3][5][3])
{
    RealT node[4][3];
    footpoint_derivatives at;
    for (int i = 0; i < 4; i++) {
        node[i][0] = xA[(i + 2) % 4];
        node[i][1] = yA[(i + 2) % 4];
        node[i][2] = zA[(i + 2) % 4];
    }
    InvIso(x, xA, yA, zA, 4, xi);
    if (footpoint_differentiate(node[0], node[1], node[2], node[3], x, xi, &at) != FOOTPOINT_OK)
        return false;
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            const int to = i < 4 ? (i + 2) % 4 : 4;
            dxi[0][to][k] = at.d_xi[3 * i + k];
            dxi[1][to][k] = at.d_eta[3 * i + k];
            dxi[2][to][k] = at.d_gap[3 * i + k];
        }
    for (int i = 0; i < 4; i++)
        phi[(i + 2) % 4] = at.phi[i];
    return true;
}

} // namespace tribol

#endif
