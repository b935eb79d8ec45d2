/* Finds the closest point of a plane triangle; see triangle.c. */
#ifndef FOOTPOINT_TRIANGLE_H
#define FOOTPOINT_TRIANGLE_H

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Finds the closest point of a triangle, in closed form: it is always unique and always found.
 *  @param[in]  x         coordinates of A, B, C and xS
 *  @param[out] loc       {xi, eta}
 *  @param[out] distance  >= 0, right to a few rounding errors of the largest difference of coordinates
 *  @return FOOTPOINT_OK, FOOTPOINT_NO_AREA; with no output written: FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DOMAIN (the
 *          distance overflows) */
int footpoint_triangle_closest(const double x[12], double loc[2], double *distance);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
