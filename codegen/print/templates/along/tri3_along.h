/* Where a line meets the plane of the flat triangle. */

/* at = {xi, eta, distance times |p|}; status FOOTPOINT_OK or FOOTPOINT_OUTSIDE.  The highest bit of what it returns is set unless the
 * line is far from parallel to the plane. */
FOOTPOINT_PART REAL_BITS footpoint_detail_tri3_along(const REAL *const *x, const REAL p[3],
                                                     REAL at[3], int *status)
{
    REAL c1[3], c2[3], d[3], m1[3], m2[3], n[3], across, size, pp;
    int i;
    for (i = 0; i < 3; i++) {
        c1[i] = x[1][i] - x[0][i];
        c2[i] = x[2][i] - x[0][i];
        d[i] = x[3][i] - x[0][i];
    }
    footpoint_detail_cross(c1, p, m1);
    footpoint_detail_cross(c2, p, m2);
    footpoint_detail_cross(c1, c2, n);
    across = footpoint_detail_dot(c1, m2);
    pp = footpoint_detail_dot(p, p);
    at[0] = footpoint_detail_dot(d, m2) / across;
    at[1] = -footpoint_detail_dot(d, m1) / across;
    at[2] = footpoint_detail_dot(d, n) / across * pp;
    size = footpoint_detail_dot(c1, c1) + footpoint_detail_dot(c2, c2);
    *status = FOOTPOINT_OUTSIDE * (int)((footpoint_detail_above(at[0] - 0.5, 0.5) |
                                         footpoint_detail_above(at[1] - 0.5, 0.5) |
                                         footpoint_detail_above(at[0] + at[1] - 0.5, 0.5)) >>
                                        REAL_TOP);
    return footpoint_detail_outside(across) | footpoint_detail_outside(pp) |
           footpoint_detail_infinite(at[0] + at[1] + at[2]) |
           footpoint_detail_bits(across * across - 100.0 * REAL_FLAT * (size * size * pp));
}

FOOTPOINT_COLD int footpoint_detail_tri3_along_full(const REAL *const *x, const REAL p[3],
                                                    REAL at[3])
{
    int status;
    const REAL_BITS flaw = footpoint_detail_tri3_along(x, p, at, &status);
    at[2] /= sqrt(footpoint_detail_dot(p, p));
    return flaw >> REAL_TOP ? FOOTPOINT_ERR_DEGENERATE : status;
}
