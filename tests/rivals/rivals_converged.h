/* Newton's iteration until it stands, three ways; see rivals.h. */
#ifndef FOOTPOINT_RIVALS_CONVERGED_H
#define FOOTPOINT_RIVALS_CONVERGED_H

#include "rivals.h"

/** Of converged Newton: Gauss-Newton steps before it, and the step at which it stops.  A step of 1e-5
 *  is followed by an error of about its square: that is "loose". */
enum { RIVAL_NEWTON_GAUSS = 3 };
#define RIVAL_NEWTON_TOLERANCE 1e-10
#define RIVAL_NEWTON_LOOSE 1e-5

/* 1 if a step moves neither xi nor eta by more than the tolerance. */
RIVAL_FN int rival_stands(struct rival_point p, struct rival_point next, double tolerance)
{
    const FOOTPOINT_REAL limit = tolerance, du = next.u - p.u, dv = next.v - p.v;
    return (fabs(du) <= limit) & (fabs(dv) <= limit);
}

/** Newton's iteration from the centre, three Gauss-Newton steps first.  Returns the steps taken, or 0 if `most` of them
 *  were not enough (xi, eta are then where it stands). */
RIVAL_FN int rival_newton(RIVAL_NODES, int most, double tolerance, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL one = 1.0;
    struct rival_basis b;
    rival_basis_centre(xA, xB, xC, xD, xS, &b);
    const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
    struct rival_point p = rival_first(&g, 0, one);
    int n = 1, stands = 0;
    for (; n < most && !stands; n++) {
        const struct rival_point next = rival_step(&g, n >= RIVAL_NEWTON_GAUSS, p, one);
        stands = rival_stands(p, next, tolerance);
        p = next;
    }
    *xi = p.u;
    *eta = p.v;
    return stands ? n : 0;
}

/** The same from *xi, *eta, the answer of the step before: Newton's steps alone. */
RIVAL_FN int rival_newton_from(RIVAL_NODES, int most, double tolerance, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL one = 1.0;
    struct rival_basis b;
    rival_basis_centre(xA, xB, xC, xD, xS, &b);
    const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
    struct rival_point p = {*xi, *eta};
    int n = 0, stands = 0;
    for (; n < most && !stands; n++) {
        const struct rival_point next = rival_step(&g, 1, p, one);
        stands = rival_stands(p, next, tolerance);
        p = next;
    }
    *xi = p.u;
    *eta = p.v;
    return stands ? n : 0;
}

#endif
