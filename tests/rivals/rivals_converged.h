/* Newton's iteration until it converges, in four variants; see rivals.h. */
#ifndef FOOTPOINT_RIVALS_CONVERGED_H
#define FOOTPOINT_RIVALS_CONVERGED_H

#include "rivals.h"

/** Gauss-Newton steps before converged Newton. Iterations stop at a step below their tolerance; the error is then about
 *  its square. "loose" stops at 1e-5. */
enum { RIVAL_NEWTON_GAUSS = 3 };
#define RIVAL_NEWTON_TOLERANCE 1e-10
#define RIVAL_NEWTON_LOOSE 1e-5

/** Fair Newton starts from the taper and so needs no Gauss-Newton steps. After a step of 1e-7 the error is about its
 *  square, the rounding of the answer. The start counts as the first step. */
enum { RIVAL_FAIR_STEPS_MAX = 1 + 20 };
#define RIVAL_FAIR_TOLERANCE 1e-7

/* Returns 1 if a step moves neither xi nor eta by more than the tolerance. */
RIVAL_FN int rival_stands(struct rival_point p, struct rival_point next, double tolerance)
{
    const FOOTPOINT_REAL limit = tolerance, du = next.u - p.u, dv = next.v - p.v;
    return (fabs(du) <= limit) & (fabs(dv) <= limit);
}

/** Runs Newton's iteration from the centre after three Gauss-Newton steps. Returns the number of steps, or 0 if `most`
 *  do not suffice (xi, eta are then the last point). */
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

/** Runs only Newton's steps, from *xi, *eta, the last step's answer. Returns as rival_newton. */
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

/* Returns the foot point on the parallelogram of e1 and e2, corrected for the taper to first order. */
RIVAL_FN struct rival_point rival_taper(const struct rival_products *g)
{
    const FOOTPOINT_REAL one = 1.0, inverse = one / (g->g11 * g->g22 - g->g12 * g->g12);
    struct rival_point p;
    p.u = (g->g22 * g->g1 - g->g12 * g->g2) * inverse;
    p.v = (g->g11 * g->g2 - g->g12 * g->g1) * inverse;
    const FOOTPOINT_REAL w = p.u * p.v * inverse;
    p.u = p.u - (g->g22 * g->g13 - g->g12 * g->g23) * w;
    p.v = p.v - (g->g11 * g->g23 - g->g12 * g->g13) * w;
    return p;
}

/* Takes Newton's steps from the taper. Returns the number of steps, including the start, or 0 if `most` do not
 * suffice. */
RIVAL_FN int rival_fair_steps(const struct rival_products *g, int most, double tolerance, struct rival_point *p)
{
    const FOOTPOINT_REAL one = 1.0;
    int n = 1, stands = 0;
    *p = rival_taper(g);
    for (; n < most && !stands; n++) {
        const struct rival_point next = rival_step(g, 1, *p, one);
        stands = rival_stands(*p, next, tolerance);
        *p = next;
    }
    return stands ? n : 0;
}

/** Runs Newton's iteration as a good programmer writes it today: Newton's steps from the taper. Returns the number of
 *  steps, including the start, or 0 if `most` do not suffice (xi, eta are then the last point). */
RIVAL_FN int rival_newton_fair(RIVAL_NODES, int most, double tolerance, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    struct rival_basis b;
    struct rival_point p;
    rival_basis_centre(xA, xB, xC, xD, xS, &b);
    const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
    const int n = rival_fair_steps(&g, most, tolerance, &p);
    *xi = p.u;
    *eta = p.v;
    return n;
}

#endif
