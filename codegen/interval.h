/* Intervals of real numbers with ends in double, rounded outward: every operation encloses all values that it can take.
 * They serve branch and bound, where boxes are wide: the product of two wide balls (Arb's) is wider than that of the
 * intervals, and takes some ten times as long.  At points, Arb is used (point.h). */
#ifndef FOOTPOINT_INTERVAL_H
#define FOOTPOINT_INTERVAL_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

/** lo <= hi; ends at infinity do not belong to it. */
struct interval {
    double lo, hi;
};

/* Of two numbers; unlike fmin and fmax, an instruction. */
static inline double lesser(double a, double b)
{
    return a < b ? a : b;
}

static inline double greater(double a, double b)
{
    return a > b ? a : b;
}

/** A number below (above) all that round to x, whatever operation x is the rounded result of. */
static inline double below(double x)
{
    const double y = lesser(x, DBL_MAX);
    return y - (fabs(y) * 0x1p-52 + 0x1p-1074);
}

static inline double above(double x)
{
    return -below(-x);
}

static inline struct interval interval_whole(void)
{
    return (struct interval){-INFINITY, INFINITY};
}

static inline struct interval interval_point(double x)
{
    return (struct interval){x, x};
}

static inline bool interval_finite(struct interval x)
{
    return x.lo >= -DBL_MAX && x.hi <= DBL_MAX;
}

static inline bool interval_has(struct interval x, double v)
{
    return x.lo <= v && v <= x.hi;
}

/** Largest |x|. */
static inline double interval_most(struct interval x)
{
    return greater(-x.lo, x.hi);
}

/** Smallest |x|. */
static inline double interval_least(struct interval x)
{
    return greater(0, greater(x.lo, -x.hi));
}

/** A number inside, near the middle where the interval is finite. */
static inline double interval_middle(struct interval x)
{
    if (interval_finite(x))
        return lesser(greater(0.5 * x.lo + 0.5 * x.hi, x.lo), x.hi);
    if (x.lo < 0 && x.hi > 0)
        return 0;
    return x.lo >= 0 ? lesser(2 * x.lo + 1, DBL_MAX) : greater(2 * x.hi - 1, -DBL_MAX);
}

/** May be empty: lo > hi. */
static inline struct interval interval_meet(struct interval x, struct interval y)
{
    return (struct interval){greater(x.lo, y.lo), lesser(x.hi, y.hi)};
}

static inline struct interval interval_negative(struct interval x)
{
    return (struct interval){-x.hi, -x.lo};
}

/* A sum of 0 is exact. */
static inline struct interval interval_add(struct interval x, struct interval y)
{
    const double lo = x.lo + y.lo, hi = x.hi + y.hi;
    return (struct interval){lo == 0 ? lo : below(lo), hi == 0 ? hi : above(hi)};
}

static inline struct interval interval_subtract(struct interval x, struct interval y)
{
    return interval_add(x, interval_negative(y));
}

/* One end of a product: a factor of 0 makes it 0, even where the other one is an end at infinity. */
static inline struct interval interval_product_of_ends(double a, double b)
{
    if (a == 0 || b == 0)
        return interval_point(0);
    return (struct interval){below(a * b), above(a * b)};
}

static inline struct interval interval_multiply(struct interval x, struct interval y)
{
    const struct interval a = interval_product_of_ends(x.lo, y.lo), b = interval_product_of_ends(x.lo, y.hi);
    const struct interval c = interval_product_of_ends(x.hi, y.lo), d = interval_product_of_ends(x.hi, y.hi);
    return (struct interval){lesser(lesser(a.lo, b.lo), lesser(c.lo, d.lo)),
                             greater(greater(a.hi, b.hi), greater(c.hi, d.hi))};
}

static inline struct interval interval_absolute(struct interval x)
{
    return (struct interval){interval_least(x), interval_most(x)};
}

static inline struct interval interval_square(struct interval x)
{
    const struct interval a = interval_absolute(x);
    return (struct interval){greater(0, interval_product_of_ends(a.lo, a.lo).lo),
                             interval_product_of_ends(a.hi, a.hi).hi};
}

/** The whole line where y has 0. */
static inline struct interval interval_divide(struct interval x, struct interval y)
{
    if (interval_has(y, 0))
        return interval_whole();
    const double p = 1 / y.hi, q = 1 / y.lo; /* an end at infinity gives 0 */
    return interval_multiply(x, (struct interval){isinf(y.hi) ? 0 : below(p), isinf(y.lo) ? 0 : above(q)});
}

/** The whole line where x has negative numbers: there is no root. */
static inline struct interval interval_root(struct interval x)
{
    if (x.lo < 0)
        return interval_whole();
    return (struct interval){greater(0, below(sqrt(x.lo))), above(sqrt(x.hi))};
}

static inline struct interval interval_minimum(struct interval x, struct interval y)
{
    return (struct interval){lesser(x.lo, y.lo), lesser(x.hi, y.hi)};
}

static inline struct interval interval_maximum(struct interval x, struct interval y)
{
    return (struct interval){greater(x.lo, y.lo), greater(x.hi, y.hi)};
}

#endif
