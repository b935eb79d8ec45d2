/* A foot point and what changes with it in quadruple precision: the reference of derivatives.  Shape functions follow from
 * the monomials of a face and the places of its nodes alone, the foot point from Newton's iteration, derivatives from
 * differences of two foot points. */
#ifndef FOOTPOINT_QUAD_PRECISION_H
#define FOOTPOINT_QUAD_PRECISION_H

#include <stdbool.h>

__extension__ typedef __float128 quadruple;

enum { MOST_NODES = 9, MOST_COORDINATES = 3 * (MOST_NODES + 1) };

quadruple exact_dot(const quadruple a[3], const quadruple b[3]);

/** Makes a vector of length 1. */
void exact_unit(quadruple v[3]);

/** The unit vector along a x b. */
void exact_normal(const quadruple a[3], const quadruple b[3], quadruple n[3]);

/** Quotient of the eigenvalues of a symmetric matrix, the larger by the smaller. */
double exact_condition(quadruple h11, quadruple h12, quadruple h22);

/** The inverse of a symmetric matrix: its elements 11, 12, 22. */
void exact_inverse(quadruple h11, quadruple h12, quadruple h22, quadruple inverse[3]);

struct exact_face {
    int nodes;
    const double (*place)[2];                /* (xi, eta) of the nodes; not owned */
    quadruple shape[MOST_NODES][MOST_NODES]; /* of node k, the factor of monomial m */
};

/** What a foot point has: its place, the gap, the normal, and the shape functions there. */
struct exact_foot {
    quadruple xi, eta, gap, normal[3], phi[MOST_NODES];
    quadruple inverse[3]; /* of the Hessian of half the square of the distance: its elements 11, 12, 22 */
    double condition;     /* of that Hessian, and of the metric */
};

/** The face of so many nodes: 3, 4, 6, 8 or 9. */
struct exact_face exact_face_of(int nodes);

/** The point of the face and its unit normal; the nodes have three coordinates each. */
void exact_point(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta, quadruple r[3],
                 quadruple normal[3]);

/** The foot point near (xi, eta); x are the nodes and the slave node behind them.  False: Newton's iteration ends nowhere. */
bool exact_foot_near(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta,
                     struct exact_foot *foot);

/** The same from (xi, eta), where coordinates differ from those of a known foot point by 1e-12 or less: by steps with the
 *  Hessian there, each of which leaves about so much of the error. */
bool exact_foot_beside(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta,
                       const struct exact_foot *known, struct exact_foot *foot);

#endif
