/* Finds closest points of faces of six, eight and nine nodes, with certainty.  A face is of degree 2 in each of two coordinates a and b
 * in [0,1], and the squared distance of degree 4.  Over a box a polynomial lies between the least and the largest of its
 * Bernstein coefficients.  Boxes are halved until they are points. */
#ifndef FOOTPOINT_CURVED_FACE_H
#define FOOTPOINT_CURVED_FACE_H

#include <stdbool.h>

/** r less xs: coefficient [i][j] belongs to B_i(a) B_j(b) of degree 2. */
struct curved_face {
    long double net[3][3][3];
    bool triangle; /* xi = a (1 - b), eta = b; else xi = 2 a - 1, eta = 2 b - 1 */
};

/** Computes the face of 6, 8 or 9 nodes x and the point xs. */
void curved_face_of(struct curved_face *f, int nodes, double (*x)[3], const double xs[3]);

/** Returns the distance of the closest point, at loc = {xi, eta}. */
double curved_face_closest(const struct curved_face *f, double loc[2]);

/** Computes r - xs at any (xi,eta). */
void curved_face_point(const struct curved_face *f, double xi, double eta, double r[3]);

#endif
