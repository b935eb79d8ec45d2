/* Computes the gap for kinds that have footpoint_detail_KIND_surface(). */

/* Computes the gap; see footpoint_detail_normal_gap().  size is the sum of the squares of the distances of the nodes from A.  u and v
 * are sums of these times derivatives of shape functions. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_gap(const REAL *const *x, REAL xi, REAL eta,
                                                   REAL least, REAL *gap)
{
    const REAL reach = 1.0 + xi * xi + eta * eta, growth = REACH_TO_GROWTH;
    REAL u[3], v[3], d[3], size = 0.0, tangents = 0.0;
    int i, j;
    footpoint_detail_KIND_surface(x, xi, eta, u, v, d);
    FOOTPOINT_UNROLL
    for (j = 0; j < 3; j++) {
        FOOTPOINT_UNROLL
        for (i = 1; i < NODES; i++)
            size += (x[i][j] - x[0][j]) * (x[i][j] - x[0][j]);
        tangents += u[j] * u[j] + v[j] * v[j];
    }
    return footpoint_detail_normal_gap(u, v, d, growth * size, tangents + size, size, least,
                                       xi + eta, gap);
}
