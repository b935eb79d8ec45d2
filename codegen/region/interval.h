/* Intervals of real numbers with ends in double, rounded outward: every operation encloses all possible values. Branch
 * and bound uses them because boxes are wide: the product of two wide balls (Arb's) is wider than that of intervals,
 * and takes about ten times as long. At points, Arb is used (evaluate.h). */
#ifndef FOOTPOINT_INTERVAL_H
#define FOOTPOINT_INTERVAL_H

#include <flint/fmpq.h>
#include <float.h>
#include <math.h>
#include <mpfr.h>
#include <stdbool.h>

/** lo <= hi; infinite ends do not belong to the interval. */
struct interval {
    double lo, hi;
};

/* Returns the lesser number, in a single instruction, unlike fmin and fmax. */
static inline double lesser(double a, double b)
{
    return a < b ? a : b;
}

static inline double greater(double a, double b)
{
    return a > b ? a : b;
}

/** Returns a number below (above) all numbers that round to x, whichever operation rounds to x. */
static inline double below(double x)
{
    const double y = lesser(x, DBL_MAX);
    return y - (fabs(y) * 0x1p-52 + 0x1p-1074);
}

static inline double above(double x)
{
    return -below(-x);
}

/** Returns true if x, the rounded sum of two numbers, is exact. */
static inline bool sum_is_exact(double a, double b, double x)
{
    const double other = x - a;
    return fabs(x) <= DBL_MAX && (a - (x - other)) + (b - other) == 0;
}

/** Returns true if a rounded product is certainly exact; may return false for small products. */
static inline bool product_is_exact(double a, double b, double x)
{
    return fabs(x) <= DBL_MAX && fabs(x) > 0x1p-900 && fma(a, b, -x) == 0;
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

/** Returns the largest |x|. */
static inline double interval_most(struct interval x)
{
    return greater(-x.lo, x.hi);
}

/** Returns the smallest |x|; never -0, division by which would give -infinity. */
static inline double interval_least(struct interval x)
{
    return greater(greater(x.lo, -x.hi), 0);
}

/** Returns a number inside, near the middle if the interval is finite. */
static inline double interval_middle(struct interval x)
{
    if (interval_finite(x))
        return lesser(greater(0.5 * x.lo + 0.5 * x.hi, x.lo), x.hi);
    if (x.lo < 0 && x.hi > 0)
        return 0;
    return x.lo >= 0 ? lesser(2 * x.lo + 1, DBL_MAX) : greater(2 * x.hi - 1, -DBL_MAX);
}

/** Returns the distance of the farther end from a number inside. */
static inline double interval_half(struct interval x, double middle)
{
    return x.lo == x.hi ? 0 : above(greater(x.hi - middle, middle - x.lo));
}

/** Returns the intersection; may be empty: lo > hi. */
static inline struct interval interval_meet(struct interval x, struct interval y)
{
    return (struct interval){greater(x.lo, y.lo), lesser(x.hi, y.hi)};
}

static inline struct interval interval_negative(struct interval x)
{
    return (struct interval){-x.hi, -x.lo};
}

/* Adds; a sum of 0 is exact. */
static inline struct interval interval_add(struct interval x, struct interval y)
{
    const double lo = x.lo + y.lo, hi = x.hi + y.hi;
    return (struct interval){lo == 0 ? lo : below(lo), hi == 0 ? hi : above(hi)};
}

static inline struct interval interval_subtract(struct interval x, struct interval y)
{
    return interval_add(x, interval_negative(y));
}

/* Multiplies ends: 0 times an infinite end is 0, because the end does not belong to the interval. */
static inline double interval_product_of_ends(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

static inline bool interval_is_zero(struct interval x)
{
    return x.lo == 0 && x.hi == 0;
}

static inline struct interval interval_multiply(struct interval x, struct interval y)
{
    const double a = interval_product_of_ends(x.lo, y.lo), b = interval_product_of_ends(x.lo, y.hi);
    const double c = interval_product_of_ends(x.hi, y.lo), d = interval_product_of_ends(x.hi, y.hi);
    const double lo = lesser(lesser(a, b), lesser(c, d)), hi = greater(greater(a, b), greater(c, d));
    /* a 0 is exact, or an underflow whose sign the factors determine */
    const bool same = (x.lo >= 0 && y.lo >= 0) || (x.hi <= 0 && y.hi <= 0);
    const bool opposite = (x.lo >= 0 && y.hi <= 0) || (x.hi <= 0 && y.lo >= 0);
    if (interval_is_zero(x) || interval_is_zero(y))
        return interval_point(0);
    return (struct interval){lo == 0 && same ? 0 : below(lo), hi == 0 && opposite ? 0 : above(hi)};
}

static inline struct interval interval_absolute(struct interval x)
{
    return (struct interval){interval_least(x), interval_most(x)};
}

static inline struct interval interval_square(struct interval x)
{
    const struct interval a = interval_absolute(x);
    return (struct interval){greater(0, below(a.lo * a.lo)), a.hi == 0 ? 0 : above(a.hi * a.hi)};
}

/** Divides; the whole line if y contains 0. */
static inline struct interval interval_divide(struct interval x, struct interval y)
{
    if (interval_has(y, 0))
        return interval_whole();
    const double p = 1 / y.hi, q = 1 / y.lo; /* an infinite end gives 0 */
    return interval_multiply(x, (struct interval){isinf(y.hi) ? 0 : below(p), isinf(y.lo) ? 0 : above(q)});
}

static inline struct interval interval_minimum(struct interval x, struct interval y)
{
    return (struct interval){lesser(x.lo, y.lo), lesser(x.hi, y.hi)};
}

static inline struct interval interval_maximum(struct interval x, struct interval y)
{
    return (struct interval){greater(x.lo, y.lo), greater(x.hi, y.hi)};
}

/** Returns an interval that encloses a rational. */
static inline struct interval interval_around(const fmpq *q)
{
    struct interval x;
    mpfr_t y;
    mpfr_init2(y, 53);
    fmpq_get_mpfr(y, q, MPFR_RNDD);
    x.lo = mpfr_get_d(y, MPFR_RNDD);
    fmpq_get_mpfr(y, q, MPFR_RNDU);
    x.hi = mpfr_get_d(y, MPFR_RNDU);
    mpfr_clear(y);
    return x;
}

#endif
