/* The surface of the bilinear segment. */

/* Computes u = r_xi, v = r_eta and d = xS - r at (xi,eta), without differences of edges, which on collapsed edges leave rounding. */
FOOTPOINT_PART void footpoint_detail_quad4_surface(const REAL *const *x, REAL xi, REAL eta,
                                                   REAL u[3], REAL v[3], REAL d[3])
{
    const REAL right = 0.25 * (1.0 + xi), left = 0.25 * (1.0 - xi);
    const REAL above = 0.25 * (1.0 + eta), below = 0.25 * (1.0 - eta);
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL ab = x[1][i] - x[0][i];
        u[i] = below * ab + above * (x[2][i] - x[3][i]);
        v[i] = left * (x[3][i] - x[0][i]) + right * (x[2][i] - x[1][i]);
        d[i] = (x[4][i] - x[0][i]) - 2.0 * right * ab - 4.0 * above * v[i];
    }
}
