/* The search of one pair by any tier; for the files of the library alone. */
#ifndef FOOTPOINT_LOCATE_H
#define FOOTPOINT_LOCATE_H

#include "../footpoint_batch.h"

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Nodes x[0] to x[4] by themselves.
 *  @param[in] sure  as for batches
 *  @return what the function of the tier gives; FOOTPOINT_ERR_DOMAIN if that is not sure, where it has to be */
int footpoint_locate_one(enum footpoint_tier tier, int sure, const double *const *x, double loc[2], double *gap);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
