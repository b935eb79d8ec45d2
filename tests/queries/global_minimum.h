/* Finds all global minima of the distance of a point from a closed face, with proof: see global_minimum.c. */
#ifndef FOOTPOINT_GLOBAL_MINIMUM_H
#define FOOTPOINT_GLOBAL_MINIMUM_H

#include "distance_polynomial.h"

enum { MINIMA = 16 };

/** A candidate: s, t in [0,1] of the face and the squared distance, in balls.  region: 0 inside, then edges, then corners. */
struct minimum {
    arb_t z[2], square;
    int region;
};

struct minima {
    int n;
    struct minimum at[MINIMA];
};

void minima_init(struct minima *found);
void minima_clear(struct minima *found);

/** Finds all global minima.  Points within 1e-40 count as a single point, and squares that overlap as equal.
 *  x: as in polynomial_of_face.  Returns 0 if there are more than MINIMA candidates or too many boxes: nothing is proved. */
int minima_find(enum query_kind kind, const double *x, struct minima *found);

#endif
