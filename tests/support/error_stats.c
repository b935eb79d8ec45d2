/* Computes mean, 99 % and maximum of errors; see error_stats.h. */
#include "error_stats.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

struct error_stats error_stats_of(double *error, size_t n)
{
    struct error_stats s = {0};
    size_t finite = 0;
    for (size_t i = 0; i < n; i++)
        if (isfinite(error[i])) {
            s.mean += error[i];
            s.max = error[i] > s.max ? error[i] : s.max;
            error[finite++] = error[i];
        }
    s.failures = n - finite;
    if (finite == 0) {
        s.mean = s.p99 = s.max = INFINITY;
        return s;
    }
    s.mean /= (double)finite;
    s.p99 = gsl_stats_select(error, 1, finite, (99 * finite + 99) / 100 - 1);
    return s;
}
