/* Statistics of the errors of a search over many samples. */
#ifndef FOOTPOINT_ERROR_STATS_H
#define FOOTPOINT_ERROR_STATS_H

#include <stddef.h>

/** Of absolute errors; dimensionless, as xi and eta are. */
struct error_stats {
    double mean, p99, max; /* of the finite errors; infinite if there is none */
    size_t failures;       /* errors that are infinite or not a number */
};

/** Statistics of n errors >= 0; p99 is the ceil(0.99 m)-th smallest of the m finite ones.  Reorders error[]. */
struct error_stats error_stats_of(double *error, size_t n);

#endif
