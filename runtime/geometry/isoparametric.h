/* What the segments whose shape functions are tables share: sums of nodes times weights, formed from differences of
 * nodes as in footpoint-quad4-geometry.h.  Weights of shape functions add up to 1, those of their derivatives to 0.
 * Internal. */
#ifndef FOOTPOINT_ISOPARAMETRIC_H
#define FOOTPOINT_ISOPARAMETRIC_H

/** Rows of a table of shape functions: they themselves and their derivatives. */
enum {
    FOOTPOINT_ROW_VALUE,
    FOOTPOINT_ROW_XI,
    FOOTPOINT_ROW_ETA,
    FOOTPOINT_ROW_XI_XI,
    FOOTPOINT_ROW_XI_ETA,
    FOOTPOINT_ROW_ETA_ETA,
    FOOTPOINT_ROWS
};

/* sum = sum over k of weight[k] (x[k] - x[0]) */
static inline void isoparametric_sum(const double *const *x, int n, const double *weight, double sum[3])
{
    sum[0] = sum[1] = sum[2] = 0.0;
    for (int k = 1; k < n; k++)
        for (int i = 0; i < 3; i++)
            sum[i] += weight[k] * (x[k][i] - x[0][i]);
}

/* The point itself. */
static inline void isoparametric_point(const double *const *x, int n, const double *weight, double r[3])
{
    isoparametric_sum(x, n, weight, r);
    for (int i = 0; i < 3; i++)
        r[i] += x[0][i];
}

#endif
