/* Derivatives of a foot point by the implicit function theorem.  With phi, a = r_xi, b = r_eta, d = xS - r, n the
 * normal and H the Hessian of bilinear.h, the equations a . d = b . d = 0 and a coordinate x of node k give H
 * d(xi,eta)/dx = (phi_k,xi d - phi_k a, phi_k,eta d - phi_k b)  for a corner,   (a, b)  for xS, and, as d is along n
 * there, dgap/dx = -phi_k n for a corner, n for xS.  (What xi and eta do to the gap drops out.) */
#include "../geometry/footpoint-quad4-geometry.h"
#include "../geometry/vector.h"

#include <float.h>

static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

int footpoint_differentiate(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                            const double xS[3], const double loc[2], struct footpoint_derivatives *out)
{
    struct footpoint_derivatives o;
    double d[3], c3[3], phi[5], phi_xi[5] = {0}, phi_eta[5] = {0};
    if (!vector_finite(xA) || !vector_finite(xB) || !vector_finite(xC) || !vector_finite(xD) || !vector_finite(xS) ||
        !number_finite(loc[0]) || !number_finite(loc[1]))
        return FOOTPOINT_ERR_NOT_FINITE;
    footpoint_quad4_shape(loc[0], loc[1], o.phi);
    footpoint_quad4_derivatives(xA, xB, xC, xD, loc[0], loc[1], o.r_xi, o.r_eta);
    footpoint_quad4_offset(xA, xB, xC, xD, xS, loc[0], loc[1], d);
    const int status = vector_normal(o.r_xi, o.r_eta, o.normal);
    if (status != FOOTPOINT_OK)
        return status;
    for (int i = 0; i < 3; i++)
        c3[i] = 0.25 * ((xC[i] - xD[i]) - (xB[i] - xA[i]));
    const double h11 = vector_dot(o.r_xi, o.r_xi), h22 = vector_dot(o.r_eta, o.r_eta);
    const double h12 = vector_dot(o.r_xi, o.r_eta) - vector_dot(c3, d), determinant = h11 * h22 - h12 * h12;
    if (!(fabs(determinant) > 8.0 * DBL_EPSILON * (h11 * h22 + h12 * h12)) || !number_finite(determinant))
        return FOOTPOINT_ERR_DEGENERATE;
    for (int k = 0; k < 4; k++) {
        phi[k] = o.phi[k];
        phi_xi[k] = 0.25 * corner[k][0] * (1.0 + corner[k][1] * loc[1]);
        phi_eta[k] = 0.25 * corner[k][1] * (1.0 + corner[k][0] * loc[0]);
    }
    phi[4] = -1.0;
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++) {
            const double g1 = phi_xi[k] * d[i] - phi[k] * o.r_xi[i], g2 = phi_eta[k] * d[i] - phi[k] * o.r_eta[i];
            o.d_xi[3 * k + i] = (h22 * g1 - h12 * g2) / determinant;
            o.d_eta[3 * k + i] = (h11 * g2 - h12 * g1) / determinant;
            o.d_gap[3 * k + i] = -phi[k] * o.normal[i];
        }
    o.gap = vector_dot(d, o.normal);
    *out = o;
    return FOOTPOINT_OK;
}
