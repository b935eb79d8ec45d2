/* The text of the headers, compiled with long double for double: the reference for their rounding errors. */
#include "headers_long.h"

#include "../support/kind_arguments.h"

#include <math.h>

#define double long double
#define atan2 atan2l
#define sqrt sqrtl
#define copysign copysignl
#define fabs fabsl
#define frexp frexpl
#define ldexp ldexpl
#include "methods.h"

#define METHOD(scene, kind, name, mul, div, add, sqrt, promise)                                                        \
    static void at_##name(const double *const *x, const double *xs, double *xi, double *eta)                           \
    {                                                                                                                  \
        name##_at(NODES_OF_##kind(x, xs), xi, eta);                                                                    \
    }
#include "methods.inc"
#undef METHOD

void (*const headers_long[])(const double *const *x, const double *xs, double *xi, double *eta) = {
#define METHOD(scene, kind, name, mul, div, add, sqrt, promise) at_##name,
#include "methods.inc"
#undef METHOD
};
