/* Bezier and Gregory patches in quadruple precision, by their control points: the reference of derivatives.  Points and
 * tangents are sums over Bernstein's polynomials, foot points by Newton's iteration with differences of the slopes. */
#ifndef FOOTPOINT_QUAD_PATCH_H
#define FOOTPOINT_QUAD_PATCH_H

#include "quad_precision.h"

enum { PATCH_COORDINATES = 27 }; /* of corners A, B, C, D, normals there, which are made unit, and the slave node */

struct patch_foot {
    quadruple xi, eta, gap, r[3], r_xi[3], r_eta[3], normal[3];
    quadruple inverse[3]; /* of the Hessian of half the squared distance: its elements 11, 12, 22 */
    double condition;     /* of that Hessian, and of the metric */
};

/** Computes the point and its tangents; Bezier patches have no twins. */
void patch_point(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta, struct patch_foot *at);

/** Finds the foot point near (xi, eta).  Returns false if Newton's iteration does not converge. */
bool patch_foot_near(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta,
                     struct patch_foot *foot);

/** Does the same from (xi, eta) if coordinates differ from those of a known foot point by at most 1e-12: by steps with the Hessian
 *  there, each of which leaves about as small a part of the error. */
bool patch_foot_beside(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta,
                       const struct patch_foot *known, struct patch_foot *foot);

#endif
