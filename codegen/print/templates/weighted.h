/* The surface of kinds whose points are sums of nodes times shape functions. */

/* Computes r_xi, r_eta and xS - r from shape functions p and their derivatives.  Their sums are 1, 0 and 0, so that differences of
 * nodes suffice. */
FOOTPOINT_PART void footpoint_detail_weighted(const REAL *const *x, int nodes, const REAL *p,
                                              const REAL *pu, const REAL *pv, REAL u[3], REAL v[3],
                                              REAL d[3])
{
    int j, k;
    FOOTPOINT_UNROLL
    for (j = 0; j < 3; j++) {
        u[j] = v[j] = 0.0;
        d[j] = x[nodes][j] - x[0][j];
        for (k = 1; k < nodes; k++) {
            u[j] += pu[k] * (x[k][j] - x[0][j]);
            v[j] += pv[k] * (x[k][j] - x[0][j]);
            d[j] -= p[k] * (x[k][j] - x[0][j]);
        }
    }
}
