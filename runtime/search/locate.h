/* Searches a pair by any tier; only for files of the library. */
#ifndef FOOTPOINT_LOCATE_H
#define FOOTPOINT_LOCATE_H

#include "../footpoint_batch.h"

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Searches the pair of the segment x[0] to x[3] and the slave node x[4].
 *  @param[in] sure  as in batches
 *  @return the status of the tier's function; FOOTPOINT_ERR_DOMAIN if `sure` and the answer is not proved */
int footpoint_locate_one(enum footpoint_tier tier, int sure, const double *const *x, double loc[2], double *gap);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
