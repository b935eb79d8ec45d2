/* Computes a foot point and its derivatives in quadruple precision, as a reference.  Shape functions follow only from
 * the monomials of a face and the places of its nodes, the foot point from Newton's iteration, derivatives from
 * differences of two foot points. */
#ifndef FOOTPOINT_QUAD_PRECISION_H
#define FOOTPOINT_QUAD_PRECISION_H

#include <stdbool.h>

__extension__ typedef __float128 quadruple;

enum { MOST_NODES = 9, MOST_COORDINATES = 3 * (MOST_NODES + 1) };

quadruple exact_dot(const quadruple a[3], const quadruple b[3]);

/** Makes a vector of length 1. */
void exact_unit(quadruple v[3]);

/** Computes the unit vector along a x b. */
void exact_normal(const quadruple a[3], const quadruple b[3], quadruple n[3]);

/** Returns the quotient of the eigenvalues of a symmetric matrix, the larger by the smaller. */
double exact_condition(quadruple h11, quadruple h12, quadruple h22);

/** Computes the inverse of a symmetric matrix: its elements 11, 12, 22. */
void exact_inverse(quadruple h11, quadruple h12, quadruple h22, quadruple inverse[3]);

struct exact_face {
    int nodes;
    const double (*place)[2];                /* (xi, eta) of the nodes; not owned */
    quadruple shape[MOST_NODES][MOST_NODES]; /* the factor of monomial m for node k */
};

/** A foot point: its place, the gap, the normal, and the shape functions there. */
struct exact_foot {
    quadruple xi, eta, gap, normal[3], phi[MOST_NODES];
    quadruple inverse[3]; /* of the Hessian of half the squared distance: its elements 11, 12, 22 */
    double condition;     /* of that Hessian, and of the metric */
};

/** Returns the face of 3, 4, 6, 8 or 9 nodes. */
struct exact_face exact_face_of(int nodes);

/** Computes the point of the face and its unit normal; the nodes have three coordinates each. */
void exact_point(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta, quadruple r[3],
                 quadruple normal[3]);

/** Finds the foot point near (xi, eta); x are the nodes and then the slave node.  Returns false if Newton's iteration does not
 *  converge. */
bool exact_foot_near(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta,
                     struct exact_foot *foot);

/** Does the same from (xi, eta) if coordinates differ from those of a known foot point by at most 1e-12: by steps with the Hessian
 *  there, each of which leaves about as small a part of the error. */
bool exact_foot_beside(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta,
                       const struct exact_foot *known, struct exact_foot *foot);

#endif
