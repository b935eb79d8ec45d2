/* The functions of the generated headers, called with a pointer to each vector of the segment. */
#include "header_functions.h"

#include "../support/kind_arguments.h"
#include "methods.h"

#define METHOD(scene, kind, name, mul, div, add, sqrt, promise)                                                        \
    static void at_##name(const double *const *x, const double *xs, double *xi, double *eta)                           \
    {                                                                                                                  \
        name##_at(NODES_OF_##kind(x, xs), xi, eta);                                                                    \
    }                                                                                                                  \
    static int locate_##name(const double *const *x, const double *xs, double loc[2], double *gap)                     \
    {                                                                                                                  \
        return name(NODES_OF_##kind(x, xs), loc, gap);                                                                 \
    }
#include "methods.inc"
#undef METHOD

const struct header_function header_functions[HEADER_FUNCTIONS] = {
#define METHOD(scene, kind, name, mul, div, add, sqrt, promise)                                                        \
    {scene, #kind, #name, promise, at_##name, name##_n, locate_##name, name##_checked_n},
#include "methods.inc"
#undef METHOD
};
