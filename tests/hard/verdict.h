/* How far an answer is from the truth, for the judges of double and of float. */
#ifndef FOOTPOINT_VERDICT_H
#define FOOTPOINT_VERDICT_H

#include "truth.h"

double verdict_root(wide x);

/** Rounding errors of distances. */
double verdict_tie(const struct truth *t);

/** Of a foot point, inside the segment or not: distance in xi and eta from the stationary point that is meant; INFINITY
 *  where that is not the closest point of the segment though one inside is, or where there is none.  `worst`: the error
 *  that answers may have. */
double verdict_free(const struct truth *t, const double loc[2], double worst);

/** Of a minimum of the distance to the whole surface: distance in xi and eta, relative to max(1, |xi|, |eta|), from it;
 *  INFINITY where there is none. */
double verdict_minimum(const struct truth *t, const double loc[2]);

#endif
