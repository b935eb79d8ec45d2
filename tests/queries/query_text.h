/* Reads queries, and computes points of their faces in quadruple precision, for judges and answers.  Shares nothing with the
 * program that writes the queries. */
#ifndef FOOTPOINT_QUERY_TEXT_H
#define FOOTPOINT_QUERY_TEXT_H

#include <stdio.h>

enum { QUERY_TEXT_NODES = 9, QUERY_TEXT_KINDS = 5, QUERY_TEXT_MINIMA = 16 };
typedef __float128 quad;

struct query_text {
    char kind[8], family[16];
    int index; /* of the kind: tri3, quad4, tri6, quad8, quad9 */
    int nodes, corners, minima, region;
    double x[3 * (QUERY_TEXT_NODES + 1)]; /* nodes, then the slave node */
    quad distance, loc[QUERY_TEXT_MINIMA][2];
    double length; /* largest difference of a coordinate of the slave node and of a node */
};

/** Reads the next query.  Returns 1, 0 at the end of the file, -1 if it is malformed. */
int query_read(FILE *file, struct query_text *q);

/** Computes r(xi, eta) - xS, and its first and second derivatives: r, r_xi, r_eta, r_xixi, r_xieta, r_etaeta. */
void query_jet(const struct query_text *q, const quad loc[2], quad r[6][3]);

/** Returns the distance of r(xi, eta) from the slave node. */
quad query_distance(const struct query_text *q, const double loc[2]);

/** Returns the larger component of the next step of Newton's method for the foot point at loc, infinite if there is no step. */
double query_newton_step(const struct query_text *q, const double loc[2]);

#endif
