/* The bilinear segment. */

/* Computes the gap; see footpoint_detail_normal_gap().  size is the sum of the squares of the edges. */
FOOTPOINT_PART REAL_BITS footpoint_detail_gap(const REAL xA[3], const REAL xB[3], const REAL xC[3],
                                              const REAL xD[3], const REAL xS[3], REAL xi, REAL eta,
                                              REAL least, REAL *gap)
{
    const REAL reach = 1.0 + xi * xi + eta * eta;
    REAL u[3], v[3], d[3], uu = 0.0, vv = 0.0, along = 0.0, across = 0.0;
    int i;
    for (i = 0; i < 3; i++) {
        const REAL ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], bc = xC[i] - xB[i];
        const REAL s = 0.5 * (1.0 + xi), t = 0.5 * (1.0 + eta);
        u[i] = ab + t * (dc - ab);
        v[i] = ad + s * (bc - ad);
        d[i] = (xS[i] - xA[i]) - s * ab - t * v[i];
        uu += u[i] * u[i];
        vv += v[i] * v[i];
        along += ab * ab + dc * dc;
        across += ad * ad + bc * bc;
    }
    return footpoint_detail_normal_gap(u, v, d, uu + reach * along, vv + reach * across,
                                       along + across, least, xi + eta, gap);
}

FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_gap(const REAL *const *x, REAL xi, REAL eta,
                                                    REAL least, REAL *gap)
{
    return footpoint_detail_gap(x[0], x[1], x[2], x[3], x[4], xi, eta, least, gap);
}

/* Computes the gap of r = c0 + xi c1 + eta c2 + xi eta c3: a, b, c are c1, c2, c3, all times a number whose square is 4 / unit,
 * d = (xS - c0) / per, and ratio is 1 / per over that number. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_over(const REAL a[3], const REAL b[3],
                                                     const REAL c[3], const REAL d[3], REAL size,
                                                     REAL ratio, REAL per, REAL unit, REAL xi,
                                                     REAL eta, REAL least, REAL *gap)
{
    const REAL twist = ratio * (xi * eta);
    const REAL u[3] = {a[0] + eta * c[0], a[1] + eta * c[1], a[2] + eta * c[2]};
    const REAL v[3] = {b[0] + xi * c[0], b[1] + xi * c[1], b[2] + xi * c[2]};
    const REAL w[3] = {d[0] + twist * c[0], d[1] + twist * c[1], d[2] + twist * c[2]};
    return footpoint_detail_height(u, v, w, size, per, unit, xi, eta, least, gap);
}
