/* Computes statistics of the errors of a search over many samples. */
#ifndef FOOTPOINT_ERROR_STATS_H
#define FOOTPOINT_ERROR_STATS_H

#include <stddef.h>

/** Statistics of absolute errors; dimensionless, like xi and eta. */
struct error_stats {
    double mean, p99, max; /* of the finite errors; infinite if all are infinite */
    size_t failures;       /* errors that are infinite or NaN */
};

/** Returns statistics of n errors >= 0; p99 is the ceil(0.99 m)-th smallest of the m finite errors.  Reorders error[]. */
struct error_stats error_stats_of(double *error, size_t n);

#endif
