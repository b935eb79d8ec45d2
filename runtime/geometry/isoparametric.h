/* Shared by segments whose shape functions are tables: sums of nodes times weights, computed from differences of nodes
 * as in footpoint-quad4-geometry.h. Weights of shape functions add up to 1, weights of their derivatives to 0.
 * Internal. */
#ifndef FOOTPOINT_ISOPARAMETRIC_H
#define FOOTPOINT_ISOPARAMETRIC_H

/** Rows of a table of shape functions: the functions and their derivatives. */
enum {
    FOOTPOINT_ROW_VALUE,
    FOOTPOINT_ROW_XI,
    FOOTPOINT_ROW_ETA,
    FOOTPOINT_ROW_XI_XI,
    FOOTPOINT_ROW_XI_ETA,
    FOOTPOINT_ROW_ETA_ETA,
    FOOTPOINT_ROWS
};

/* Computes the sum over k of weight[k] (x[k] - x[0]). */
static inline void isoparametric_sum(const double *const *x, int n, const double *weight, double sum[3])
{
    sum[0] = sum[1] = sum[2] = 0.0;
    for (int k = 1; k < n; k++)
        for (int i = 0; i < 3; i++)
            sum[i] += weight[k] * (x[k][i] - x[0][i]);
}

/* Computes the point itself. */
static inline void isoparametric_point(const double *const *x, int n, const double *weight, double r[3])
{
    isoparametric_sum(x, n, weight, r);
    for (int i = 0; i < 3; i++)
        r[i] += x[0][i];
}

#endif
