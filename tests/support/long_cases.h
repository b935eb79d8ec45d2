/* How many cases a test tries.  Full counts of some tests take an hour of a processor, so FOOTPOINT_LONG is a share of them: 1 in
 * tests/README.md's table, less in `make check-long`. */
#ifndef FOOTPOINT_TESTS_LONG_CASES_H
#define FOOTPOINT_TESTS_LONG_CASES_H

#include <stdlib.h>

/** Returns `few` cases, or the share FOOTPOINT_LONG of `many` if it is set, but no fewer than `few`. */
static inline long long_cases(long few, long many)
{
    const char *const share = getenv("FOOTPOINT_LONG");
    const double cases = share ? atof(share) * (double)many : 0;
    return cases > (double)few ? (long)cases : few;
}

#endif
