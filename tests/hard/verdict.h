/* Measures errors of answers, for the judges of double and of float. */
#ifndef FOOTPOINT_VERDICT_H
#define FOOTPOINT_VERDICT_H

#include "truth.h"

double verdict_root(wide x);

/** Returns the rounding errors of distances. */
double verdict_tie(const struct truth *t);

/** Returns the error of a foot point, inside the segment or not: its distance in xi and eta from the stationary point.  INFINITY if
 *  that is not the closest point of the segment although an inner point is, or if there is no stationary point.  `worst`: the
 *  permitted error. */
double verdict_free(const struct truth *t, const double loc[2], double worst);

/** Returns the error of a minimum of the distance to the whole surface: its distance in xi and eta from a minimum, relative to
 *  max(1, |xi|, |eta|); INFINITY without a minimum. */
double verdict_minimum(const struct truth *t, const double loc[2]);

#endif
