/* The fits of constants that islands call (fitting.h): least squares of root terms for children, Levenberg and
 * Marquardt's method for members of the front; on some of the samples, measured on all. */
#ifndef FOOTPOINT_FITS_H
#define FOOTPOINT_FITS_H

#include "../eval/objective.h"
#include "fitting.h"

/** The objective is not owned. */
struct fits *fits_new(struct objective *objective);
void fits_free(struct fits *f);
struct fitting fits_hooks(struct fits *f);

#endif
