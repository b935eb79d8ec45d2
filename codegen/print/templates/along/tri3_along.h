/* The intersection of a line with the plane of the flat triangle. */

/* Returns c1 x c2 . p; *size: the sum of the absolute values of its terms, of which rounding errors are at most 7
 * units. */
FOOTPOINT_FN REAL footpoint_detail_tri3_across(const REAL *const *x, const REAL p[3], REAL *size)
{
    REAL across = 0.0;
    int i;
    *size = 0.0;
    for (i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const REAL a = x[1][j] - x[0][j], b = x[1][k] - x[0][k];
        const REAL c = x[2][j] - x[0][j], d = x[2][k] - x[0][k];
        across += p[i] * (a * d - b * c);
        *size += fabs(p[i]) * (fabs(a * d) + fabs(b * c));
    }
    return across;
}

/* Finds at = {xi, eta, distance times |p|}, with status FOOTPOINT_OK or FOOTPOINT_OUTSIDE. The highest bit of the
 * result is set unless that is proved to the promise: differences of nodes are off by a unit, scalar products with
 * vectors at right angles to p by 6 more, and xi and eta by 2 of their own. */
FOOTPOINT_PART REAL_BITS footpoint_detail_tri3_along(const REAL *const *x, const REAL p[3],
                                                     REAL at[3], int *status)
{
    REAL c1[3], c2[3], d[3], m1[3], m2[3], across, pp, off, wide;
    int i;
    for (i = 0; i < 3; i++) {
        c1[i] = x[1][i] - x[0][i];
        c2[i] = x[2][i] - x[0][i];
        d[i] = x[3][i] - x[0][i];
    }
    footpoint_detail_cross(c1, p, m1);
    footpoint_detail_cross(c2, p, m2);
    across = footpoint_detail_dot(c1, m2);
    pp = footpoint_detail_dot(p, p);
    at[0] = footpoint_detail_dot(d, m2) / across;
    at[1] = -footpoint_detail_dot(d, m1) / across;
    at[2] = 0.0;
    for (i = 0; i < 3; i++)
        at[2] += p[i] * (d[i] - at[0] * c1[i] - at[1] * c2[i]);
    wide = 1.0 + footpoint_detail_excess(at[0]) + footpoint_detail_excess(at[1]);
    off = 10.0 * footpoint_detail_unit() * footpoint_detail_manhattan(p) *
          footpoint_detail_larger(footpoint_detail_manhattan(c1), footpoint_detail_manhattan(c2)) *
          (footpoint_detail_manhattan(d) +
           wide * (footpoint_detail_manhattan(c1) + footpoint_detail_manhattan(c2)));
    *status = (footpoint_detail_above(at[0] - 0.5, 0.5) | footpoint_detail_above(at[1] - 0.5, 0.5) |
               footpoint_detail_above(at[0] + at[1] - 0.5, 0.5)) >>
                      REAL_TOP
                  ? FOOTPOINT_OUTSIDE
                  : footpoint_detail_met();
    return footpoint_detail_outside(across) | footpoint_detail_outside(pp) |
           footpoint_detail_infinite(at[0] + at[1] + at[2]) |
           footpoint_detail_bits(0.99 * ALONG_PROMISE * fabs(across) - off);
}

/* Searches in full. Returns FOOTPOINT_ERR_DEGENERATE if rounding errors may hide that the line is parallel to the
 * plane. */
FOOTPOINT_COLD int footpoint_detail_tri3_along_full(const REAL *const *x, const REAL p[3],
                                                    REAL at[3])
{
    int status;
    REAL size;
    const REAL across = footpoint_detail_tri3_across(x, p, &size);
    const REAL_BITS doubt = footpoint_detail_tri3_along(x, p, at, &status);
    if (!(fabs(across) > 8.0 * footpoint_detail_unit() * size))
        return FOOTPOINT_ERR_DEGENERATE;
    at[2] /= sqrt(footpoint_detail_dot(p, p));
    if (footpoint_detail_infinite(at[0] + at[1] + at[2]) >> REAL_TOP)
        return FOOTPOINT_ERR_DOMAIN;
    return doubt >> REAL_TOP ? FOOTPOINT_UNPROVED : status;
}
