/* Vectors of three coordinates, for the files of this folder alone. */
#ifndef FOOTPOINT_VECTOR_H
#define FOOTPOINT_VECTOR_H

#include "footpoint.h"

#include <math.h>

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

/* c = a - b */
static inline void vector_sub(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[i] - b[i];
}

static inline int vector_finite(const double a[3])
{
    return isfinite(a[0]) && isfinite(a[1]) && isfinite(a[2]);
}

static inline int vector_equal(const double a[3], const double b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* n = a x b / |a x b|; FOOTPOINT_ERR_DEGENERATE if the square of that length is 0, not finite, or too small for all its
 * digits. */
static inline int vector_normal(const double a[3], const double b[3], double n[3])
{
    double c[3];
    vector_cross(a, b, c);
    const double square = vector_dot(c, c), length = sqrt(square);
    if (!isnormal(square))
        return FOOTPOINT_ERR_DEGENERATE;
    for (int i = 0; i < 3; i++)
        n[i] = c[i] / length;
    return FOOTPOINT_OK;
}

#endif
