/* Vectors of three coordinates, only for the files of this folder. */
#ifndef FOOTPOINT_VECTOR_H
#define FOOTPOINT_VECTOR_H

#include "../footpoint.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Returns the bits of |x|: infinity's exceed those of all finite numbers, and NaN's exceed infinity's. Statuses compare
 * integers, because -ffast-math removes isfinite() and comparisons with NaN. */
static inline uint64_t number_bits(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits & UINT64_MAX >> 1;
}

static inline int number_finite(double x)
{
    return number_bits(x) < (uint64_t)0x7ff << 52;
}

/* Returns true if x is finite and not smaller than the least normal number. */
static inline int number_normal(double x)
{
    return number_bits(x) >= (uint64_t)1 << 52 && number_finite(x);
}

static inline double vector_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void vector_cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Computes c = a - b. */
static inline void vector_sub(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[i] - b[i];
}

static inline int vector_finite(const double a[3])
{
    return number_finite(a[0]) && number_finite(a[1]) && number_finite(a[2]);
}

/* Returns the exponent of the power of 2 above a's largest component, by a factor of at most 2; -1100, less than any
 * exponent, if all are 0. */
static inline int vector_exponent(const double a[3])
{
    const double most = fmax(fmax(fabs(a[0]), fabs(a[1])), fabs(a[2]));
    int exponent = 0;
    (void)frexp(most, &exponent);
    return most > 0.0 ? exponent : -1100;
}

/* Squared sine of the angle below which vectors count as parallel, as in generated/: their vector product is then
 * mostly rounding. */
#define VECTOR_PARALLEL 1e-20

/* Computes n = a x b / |a x b|. Returns FOOTPOINT_ERR_DEGENERATE if a and b are parallel to rounding, if one is 0, or
 * if a number is not finite, whatever the unit of length. */
static inline int vector_normal(const double a[3], const double b[3], double n[3])
{
    double c[3], d[3], e[3];
    vector_cross(a, b, c);
    double square = vector_dot(c, c), most = vector_dot(a, a) * vector_dot(b, b);
    if (!number_normal(square) || !number_normal(most)) {
        const int da = vector_exponent(a), db = vector_exponent(b);
        for (int i = 0; i < 3; i++) {
            d[i] = ldexp(a[i], -da);
            e[i] = ldexp(b[i], -db);
        }
        vector_cross(d, e, c);
        square = vector_dot(c, c);
        most = vector_dot(d, d) * vector_dot(e, e);
    }
    if (!number_normal(square) || !number_normal(most) || !(square > VECTOR_PARALLEL * most))
        return FOOTPOINT_ERR_DEGENERATE;
    const double length = sqrt(square);
    for (int i = 0; i < 3; i++)
        n[i] = c[i] / length;
    return FOOTPOINT_OK;
}

#endif
