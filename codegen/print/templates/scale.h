/* Parts that the checked searches of all kinds share. */

/* Returns 1 if all coordinates of n vectors are finite. */
FOOTPOINT_FN int footpoint_detail_finite(const REAL *const *x, int n)
{
    REAL_BITS infinite = 0;
    int i, j;
    for (i = 0; i < n; i++)
        for (j = 0; j < 3; j++)
            infinite |= footpoint_detail_infinite(x[i][j]);
    return !(infinite >> REAL_TOP);
}

/* Scales nodes and slave node, the last of the vectors, to a unit of length, 2^exponent, in which the segment is about 1
 * long; normals, which come before the slave node, are copied.  Returns an error if they are not finite, or of no length. */
FOOTPOINT_FN int footpoint_detail_scale(const REAL *const *x, int nodes, int vectors, REAL (*y)[3],
                                        int *exponent)
{
    REAL most = 0.0, first, second;
    int i, j;
    if (!footpoint_detail_finite(x, vectors))
        return FOOTPOINT_ERR_NOT_FINITE;
    for (i = 1; i < nodes; i++)
        for (j = 0; j < 3; j++) {
            const REAL half = fabs(0.5 * x[i][j] - 0.5 * x[0][j]);
            most = half > most ? half : most;
        }
    if ((footpoint_detail_below(most, REAL_MIN) | footpoint_detail_infinite(most)) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    (void)frexp(most, exponent);
    first = ldexp(1.0, -(*exponent / 2)); /* by steps: the whole power may overflow */
    second = ldexp(1.0, *exponent / 2 - *exponent);
    for (i = 0; i < vectors; i++)
        for (j = 0; j < 3; j++)
            y[i][j] = i < nodes || i == vectors - 1 ? first * x[i][j] * second : x[i][j];
    return FOOTPOINT_OK;
}

/* Computes the gap (9): d . n = (xS - r(xi,eta)) . n with the unit normal n = u x v / |...|, u = r_xi, v = r_eta there; mesh length,
 * > 0 open.  The highest bit of the result is set if u and v are parallel, so that there is no area and no normal, if size, a
 * sum of squares of edges, is not between least and 1 / least, or if a number is not finite.
 * uu * vv: at least the product of the squares of the terms of u and v; these cancel far outside, so that rounding makes a
 * normal of nodes on a line. */
FOOTPOINT_PART REAL_BITS footpoint_detail_normal_gap(const REAL u[3], const REAL v[3],
                                                     const REAL d[3], REAL uu, REAL vv, REAL size,
                                                     REAL least, REAL loc, REAL *gap)
{
    const REAL nx = u[1] * v[2] - u[2] * v[1];
    const REAL ny = u[2] * v[0] - u[0] * v[2];
    const REAL nz = u[0] * v[1] - u[1] * v[0];
    const REAL nn = nx * nx + ny * ny + nz * nz;
    *gap = (d[0] * nx + d[1] * ny + d[2] * nz) / sqrt(nn);
    return footpoint_detail_below(size, least) | footpoint_detail_below(1.0 / least, size) |
           footpoint_detail_outside(nn) | footpoint_detail_bits(nn - REAL_FLAT * (uu * vv)) |
           footpoint_detail_infinite(loc + *gap);
}
