/* The gap of the kinds that have footpoint_detail_KIND_surface(). */

/* See footpoint_detail_normal_gap(); size is the sum of the squares of the distances of the nodes from A. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_gap(const REAL *const *x, REAL xi, REAL eta,
                                                   REAL least, REAL *gap)
{
    REAL u[3], v[3], d[3], size = 0.0, uu, vv;
    int i, j;
    footpoint_detail_KIND_surface(x, xi, eta, u, v, d);
    FOOTPOINT_UNROLL
    for (j = 0; j < 3; j++) {
        FOOTPOINT_UNROLL
        for (i = 1; i < NODES; i++)
            size += (x[i][j] - x[0][j]) * (x[i][j] - x[0][j]);
    }
    uu = u[0] * u[0] + u[1] * u[1] + u[2] * u[2] + size;
    vv = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + size;
    return footpoint_detail_normal_gap(u, v, d, uu, vv, size, least, xi + eta, gap);
}
