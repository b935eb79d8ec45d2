/* The gap of a search that has the tangents: of bilinear segments and flat triangles. */

FOOTPOINT_PART REAL footpoint_detail_square(const REAL a[3])
{
    return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

/* Gap (9) of tangents u and v, of any length, and w with w . n = (xS - r(xi,eta)) . n, over `per`; size is the sum of
 * the squares of c1, c2, c3 (r = c0 + xi c1 + eta c2 + xi eta c3) in the unit of u, times 4 that of edges at most.
 * The highest bit of what it returns is not set if
 * footpoint_detail_KIND_gap() sets none: (xi,eta) is near enough for the square of u to be less than 66 sizes, the size
 * is well within limits, and so is the square of n then, which is far from 0. */
FOOTPOINT_PART REAL_BITS footpoint_detail_height(const REAL u[3], const REAL v[3], const REAL w[3],
                                                 REAL size, REAL per, REAL unit, REAL xi, REAL eta,
                                                 REAL least, REAL *gap)
{
    const REAL nx = u[1] * v[2] - u[2] * v[1];
    const REAL ny = u[2] * v[0] - u[0] * v[2];
    const REAL nz = u[0] * v[1] - u[1] * v[0];
    const REAL nn = nx * nx + ny * ny + nz * nz;
    const REAL length = unit * size;
    *gap = per * (w[0] * nx + w[1] * ny + w[2] * nz) / sqrt(nn);
    return footpoint_detail_above(xi * xi + eta * eta, 64.0) | footpoint_detail_infinite(*gap) |
           (footpoint_detail_bits(length) - footpoint_detail_bits(least)) |
           footpoint_detail_above(length, 0.25 / least) |
           footpoint_detail_bits(nn - 5000.0 * REAL_FLAT * (size * size));
}
