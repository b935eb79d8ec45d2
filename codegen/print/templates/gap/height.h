/* Computes the gap if a search has the tangents: on bilinear segments and flat triangles. */

/* Computes the gap (9) from tangents u and v, of any length, and w with w . n = (xS - r(xi,eta)) . n, over `per`; size is the sum of
 * the squares of c1, c2, c3 (r = c0 + xi c1 + eta c2 + xi eta c3) in the unit of u, times at most 4 times the square of edges.
 * If the highest bit of the result is not set, footpoint_detail_KIND_gap() sets it neither: (xi,eta) is near enough that
 * the square of u is less than 66 sizes, the size is well within limits, and so is the square of n, which is far from 0. */
FOOTPOINT_PART REAL_BITS footpoint_detail_height(const REAL u[3], const REAL v[3], const REAL w[3],
                                                 REAL size, REAL per, REAL unit, REAL xi, REAL eta,
                                                 REAL least, REAL *gap)
{
    const REAL length = unit * size;
    REAL n[3], nn;
    footpoint_detail_cross(u, v, n);
    nn = footpoint_detail_dot(n, n);
    *gap = per * footpoint_detail_dot(w, n) / sqrt(nn);
    return footpoint_detail_above(xi * xi + eta * eta, 64.0) | footpoint_detail_infinite(*gap) |
           (footpoint_detail_bits(length) - footpoint_detail_bits(least)) |
           footpoint_detail_above(length, 0.25 / least) |
           footpoint_detail_bits(nn - 5000.0 * REAL_FLAT * (size * size));
}
