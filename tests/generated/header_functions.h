/* The functions of the generated headers, as a table. */
#ifndef FOOTPOINT_TESTS_HEADER_FUNCTIONS_H
#define FOOTPOINT_TESTS_HEADER_FUNCTIONS_H

#include <stddef.h>

enum {
    HEADER_FUNCTIONS = 0
#define METHOD(scene, kind, name, mul, div, add, sqrt, promise) +1
#include "methods.inc"
#undef METHOD
};

/** The i-th METHOD of methods.inc: NAME_at, NAME_n, NAME and NAME_checked_n; x: a pointer for each vector of the segment. */
extern const struct header_function {
    const char *scene, *kind, *name;
    double promise; /* NAME_PROMISE, or 0 if there is no promise */
    void (*at)(const double *const *x, const double *xs, double *xi, double *eta);
    void (*n)(size_t n, const double *const *x, double *xi, double *eta);
    int (*locate)(const double *const *x, const double *xs, double loc[2], double *gap);
    void (*checked_n)(size_t n, const double *const *x, double *xi, double *eta, double *gap, int *status);
} header_functions[HEADER_FUNCTIONS];

#endif
