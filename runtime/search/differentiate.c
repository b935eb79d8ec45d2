/* Differentiates a foot point by the header of four-node segments. */
#include "../../generated/footpoint_quad4_derivatives.h"
#include "../footpoint.h"

int footpoint_differentiate(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                            const double xS[3], const double loc[2], struct footpoint_derivatives *out)
{
    return footpoint_quad4_gradients(xA, xB, xC, xD, xS, loc, out->phi, out->r_xi, out->r_eta, out->normal, &out->gap,
                                     out->d_xi, out->d_eta, out->d_gap);
}
