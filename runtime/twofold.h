/* Numbers of twice the precision, as sums of two doubles: for the few places where one double is not enough.  Dekker's
 * and Knuth's operations; errors are a few 2^-104 of the operands.  fma() is that of the C library, exact on any
 * machine. */
#ifndef FOOTPOINT_TWOFOLD_H
#define FOOTPOINT_TWOFOLD_H

#include <math.h>

struct twofold {
    double high, low;
};

/* a + b, exactly. */
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

#endif
