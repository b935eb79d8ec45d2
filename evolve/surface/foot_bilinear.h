/* The certain closest point on a bilinear segment: all stationary points from the quintic in eta. */
#ifndef FOOTPOINT_FOOT_BILINEAR_H
#define FOOTPOINT_FOOT_BILINEAR_H

#include "sample.h"

#include <stdbool.h>

/** A stationary point of the distance from xs to the bilinear surface. */
struct stationary {
    double xi, eta, distance;
    bool minimum; /* local minimum of the distance: the Hessian is positive definite */
};

/** Inserts a point by ascending distance among n, unless there are `most`; drops a point found twice. Returns their new
 *  number. */
int stationary_insert(struct stationary *found, int n, int most, const struct stationary *s);

/** Returns true if lo < xi,eta <= hi, with values within rounding of a bound treated as on it. */
bool stationary_inside(const struct stationary *s, const double lo[2], const double hi[2]);

/** Computes c1, c2 and c3 from differences of corners, which lose nothing far from the origin. */
void bilinear_vectors(const double x[4][3], double c[3][3]);

/** Finds all real stationary points of the unbounded bilinear surface, nearest first. x[4][3], xs[3] as in struct
 *  sample. Returns their number (0..5), or -1 if the segment is degenerate or not finite. */
int foot_bilinear_stationary(const double x[4][3], const double xs[3], struct stationary found[5]);

/** Finds the foot point as scenes define it: the local minimum nearest to xs with lo < xi,eta <= hi (component-wise).
 *  Fills xi, eta, gap of *s. Returns false if it does not exist. */
bool foot_bilinear(struct sample *s, const double lo[2], const double hi[2]);

#endif
