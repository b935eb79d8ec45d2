/* All stationary points of the distance to a bilinear segment, for the files of this folder alone; see stationary.c. */
#ifndef FOOTPOINT_STATIONARY_H
#define FOOTPOINT_STATIONARY_H

#include "bilinear.h"

enum { STATIONARY_MOST = 32 };

struct stationary_point {
    double z[2];      /* xi, eta, in [-1,1] */
    double reach;     /* the points that it stands for are that near in space, over m: 0 for one, known to rounding */
    double variation; /* of their distances from xS, over m */
    double alone[2];  /* in that interval of z[across] lies no other stationary point; empty if that is not known */
    double box[2][2]; /* bounds on (1 + z)/2 of what it stands for, if it has a reach */
    int across;
    int several; /* 1 if it may be none, one or several */
};

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** All points of [-1,1]^2 where (7), (8) hold, and perhaps one within rounding of its edge.  Two or more that cannot be
 *  told apart are one with a reach.
 *  @param[in]  x      the nodes A, B, C, D, S
 *  @param[out] point  up to STATIONARY_MOST
 *  @return how many */
int footpoint_bilinear_stationary(const double *const x[5], const struct bilinear *f, struct stationary_point point[]);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
