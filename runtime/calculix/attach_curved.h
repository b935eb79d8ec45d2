/* A quadratic face as a polynomial in its local coordinates, for attach_curved.c and attach_search.c alone. */
#ifndef FOOTPOINT_ATTACH_CURVED_H
#define FOOTPOINT_ATTACH_CURVED_H

#include "attach.h"

enum { CURVED_TERMS = 8 };

/* r - xS = k0 + k1 u + k2 v + k3 u^2 + k4 u v + k5 v^2 + k6 u^2 v + k7 u v^2, and the sum of squares of k3 to k7. */
struct curved {
    double k[CURVED_TERMS][3], bend2;
};

/* r - xS at (u,v) = loc. */
static inline void curved_away(const struct curved *f, const double loc[2], double r[3])
{
    const double u = loc[0], v = loc[1];
    for (int i = 0; i < 3; i++)
        r[i] = f->k[0][i] + u * (f->k[1][i] + u * (f->k[3][i] + v * f->k[6][i]) + v * (f->k[4][i] + v * f->k[7][i])) +
               v * (f->k[2][i] + v * f->k[5][i]);
}

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Looks for a point of the face that is nearer than the local minimum loc.
 *  @param[in]  corners  3 or 4
 *  @param[out] start    if there is one: such a point
 *  @return 1 if there is one, 0 if none is nearer by more than 1e-10 of the face's size, or none was found before the
 *          search gave up: on a face that folds onto itself at the slave node there may be many places to look at */
int footpoint_attach_nearer(const struct curved *f, int corners, const double loc[2], double start[2]);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
