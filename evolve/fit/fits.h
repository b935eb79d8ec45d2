/* Fits of constants for islands (fitting.h): least squares of root terms for children, Levenberg-Marquardt for members
 * of the front. Fits use a part of the samples; results are measured on all. */
#ifndef FOOTPOINT_FITS_H
#define FOOTPOINT_FITS_H

#include "../eval/objective.h"
#include "fitting.h"

/** Returns fits on an objective, which is not owned. */
struct fits *fits_new(struct objective *objective);
void fits_free(struct fits *f);
struct fitting fits_hooks(struct fits *f);

#endif
