/* The squared distance of a point from a face, as a polynomial of two parameters, in balls of arb: intervals that contain
 * every rounding.  The face has s, t in [0,1]; a triangle has s + t <= 1. */
#ifndef FOOTPOINT_DISTANCE_POLYNOMIAL_H
#define FOOTPOINT_DISTANCE_POLYNOMIAL_H

#include <arb.h>

enum query_kind { QUERY_TRI3, QUERY_QUAD4, QUERY_TRI6, QUERY_QUAD8, QUERY_QUAD9, QUERY_KINDS };
enum { QUERY_NODES = 9, DEGREE = 4, POWERS = DEGREE + 1, PRECISION = 384 };

extern const char *const query_kind_name[QUERY_KINDS];
extern const int query_kind_nodes[QUERY_KINDS];
extern const int query_kind_corners[QUERY_KINDS];

/** A polynomial of one parameter or two: sum m[POWERS i + j] s^i t^j, with only j = 0 if `parameters` is 1.  b: the Bernstein
 *  coefficients. */
struct polynomial {
    int parameters;
    arb_t m[POWERS * POWERS], b[POWERS * POWERS];
};

void polynomial_init(struct polynomial *f);
void polynomial_clear(struct polynomial *f);

/** Computes weights, in quarters, of the nodes in the point s = i/2, t = j/2 of the face; 0 for missing nodes. */
void polynomial_weights(enum query_kind kind, int i, int j, int weight[QUERY_NODES]);

/** Computes f over the face.  x: nodes x 3 and the slave node: corners counter-clockwise, middles of edges, centre. */
void polynomial_of_face(struct polynomial *f, enum query_kind kind, const double *x);

/** Computes f over the edge from corner `edge` to the next corner, with one parameter. */
void polynomial_of_edge(struct polynomial *f, enum query_kind kind, const double *x, int edge);

/** Encloses f and its derivatives over the ball z: value, d/ds, d/dt, d2/ds2, d2/dsdt, d2/dt2. */
enum { VALUE, D_S, D_T, D_SS, D_ST, D_TT, JET };
void polynomial_jet(const struct polynomial *f, arb_t z[2], arb_t jet[JET]);

#endif
