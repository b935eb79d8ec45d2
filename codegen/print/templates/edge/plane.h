/* Parts that searches in the plane share: products, units of length, signs. */

#ifndef FOOTPOINT_OUTSIDE
#define FOOTPOINT_OUTSIDE 1
#endif
#ifndef FOOTPOINT_NOT_UNIQUE
#define FOOTPOINT_NOT_UNIQUE 2
#endif
#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3)
#endif

FOOTPOINT_PART REAL footpoint_detail_plane_dot(const REAL a[2], const REAL b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

FOOTPOINT_PART REAL footpoint_detail_plane_cross(const REAL a[2], const REAL b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* Copies nodes and slave node, the last one, in a unit of length, 2^exponent, in which the largest difference of
 * coordinates of A and another node is 1 to 2. */
FOOTPOINT_FN int footpoint_detail_plane_scale(const REAL *const *x, int nodes, REAL (*y)[2],
                                              int *exponent)
{
    REAL most = 0.0, first, second;
    REAL_BITS infinite = 0;
    int i, j;
    for (i = 0; i <= nodes; i++)
        infinite |= footpoint_detail_infinite(x[i][0]) | footpoint_detail_infinite(x[i][1]);
    if (infinite >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    for (i = 1; i < nodes; i++)
        for (j = 0; j < 2; j++)
            most = footpoint_detail_greater(most, fabs(0.5 * x[i][j] - 0.5 * x[0][j]));
    if (footpoint_detail_below(most, REAL_MIN) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    (void)frexp(most, exponent);
    first = ldexp(1.0, -(*exponent / 2)); /* by steps: the whole power may overflow */
    second = ldexp(1.0, *exponent / 2 - *exponent);
    for (i = 0; i <= nodes; i++)
        for (j = 0; j < 2; j++)
            y[i][j] = first * x[i][j] * second;
    return FOOTPOINT_OK;
}

/* Returns 1 if d, from a point of an edge to the slave node, points behind the edge of tangent t by more than a small
 * angle and by more than rounding; size bounds the coordinates of whose sums t consists. */
FOOTPOINT_PART int footpoint_detail_plane_behind(const REAL d[2], const REAL t[2], REAL size)
{
    const REAL across = footpoint_detail_plane_cross(d, t);
    const REAL angle =
        sqrt(footpoint_detail_plane_dot(d, d)) * sqrt(footpoint_detail_plane_dot(t, t));
    const REAL rounding = 16.0 * REAL_UNIT * size * (fabs(d[0]) + fabs(d[1]));
    return (int)(footpoint_detail_bits(across + REAL_TURN * angle + rounding) >> REAL_TOP);
}
