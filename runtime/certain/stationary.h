/* Finds all stationary points of the distance to a bilinear segment; only for the files of this folder.  See stationary.c. */
#ifndef FOOTPOINT_STATIONARY_H
#define FOOTPOINT_STATIONARY_H

#include "bilinear.h"

enum { STATIONARY_MOST = 32 };

struct stationary_point {
    double z[2];  /* xi, eta, in [-1,1] */
    double reach; /* points that it stands for are so near in space, over m; 0 for a single point, known to rounding */
    double variation; /* of their distances from xS, over m */
    double alone[2];  /* this interval of z[across] contains no other stationary point; empty if unknown */
    double box[2][2]; /* bounds on (1 + z)/2 of the points that it stands for, if it has a reach */
    int across;
    int several; /* 1 if it may stand for no point, one or several */
};

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Finds all points of [-1,1]^2 that satisfy (7), (8), and perhaps points within rounding of its edge.  Points that cannot be
 *  separated are listed as a point with a reach.
 *  @param[in]  x      the nodes A, B, C, D, S
 *  @param[out] point  up to STATIONARY_MOST
 *  @return the number of points */
int footpoint_bilinear_stationary(const double *const x[5], const struct bilinear *f, struct stationary_point point[]);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
