/* The functions of the generated headers, in long double. */
#ifndef FOOTPOINT_TESTS_HEADERS_LONG_H
#define FOOTPOINT_TESTS_HEADERS_LONG_H

#include <stddef.h>

/** NAME_at of the i-th METHOD of methods.inc; x: a pointer for each vector of the segment. */
extern void (*const headers_long[])(const long double *const *x, const long double *xs, long double *xi,
                                    long double *eta);

#endif
