/* Numbers of twice the precision, as sums of two doubles, for the few places at which a double is not enough.  Uses Dekker's
 * and Knuth's operations in the forms whose error is at most 2^-101 of the result under any cancellation (Joldes, Muller and
 * Popescu 2017); the C library's fma() is exact on any machine. */
#ifndef FOOTPOINT_TWOFOLD_H
#define FOOTPOINT_TWOFOLD_H

#include "ieee.h"

#include <math.h>

struct twofold {
    double high, low;
};

static inline struct twofold twofold_of(double a)
{
    const struct twofold x = {a, 0.0};
    return x;
}

/* Returns a + b exactly. */
static inline struct twofold twofold_sum(double a, double b)
{
    struct twofold x;
    x.high = a + b;
    const double c = x.high - a;
    x.low = (a - (x.high - c)) + (b - c);
    return x;
}

static inline struct twofold twofold_add(struct twofold a, struct twofold b)
{
    const struct twofold high = twofold_sum(a.high, b.high), low = twofold_sum(a.low, b.low);
    const struct twofold x = twofold_sum(high.high, high.low + low.high);
    return twofold_sum(x.high, x.low + low.low);
}

static inline struct twofold twofold_subtract(struct twofold a, struct twofold b)
{
    const struct twofold minus = {-b.high, -b.low};
    return twofold_add(a, minus);
}

static inline struct twofold twofold_multiply(struct twofold a, struct twofold b)
{
    const double high = a.high * b.high;
    return twofold_sum(high, fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high));
}

/* Multiplies by a power of two, or by another number that leaves both parts exact. */
static inline struct twofold twofold_scale(double by, struct twofold a)
{
    a.high *= by;
    a.low *= by;
    return a;
}

static inline struct twofold twofold_divide(struct twofold a, struct twofold b)
{
    const double first = a.high / b.high;
    const struct twofold rest = twofold_subtract(a, twofold_multiply(twofold_of(first), b));
    return twofold_sum(first, rest.high / b.high);
}

static inline struct twofold twofold_dot(const struct twofold a[3], const struct twofold b[3])
{
    return twofold_add(twofold_add(twofold_multiply(a[0], b[0]), twofold_multiply(a[1], b[1])),
                       twofold_multiply(a[2], b[2]));
}

#endif
