/* The quadrilateral with mid-side nodes and a middle. */

/* Computes u = r_xi, v = r_eta and d = xS - r at (xi,eta), by products of the parabolas that are 1 at -1, 0, 1. */
FOOTPOINT_FN void footpoint_detail_quad9_surface(const REAL *const *x, REAL xi, REAL eta, REAL u[3],
                                                 REAL v[3], REAL d[3])
{
    static const int column[9] = {0, 2, 2, 0, 1, 2, 1, 0, 1}, row[9] = {0, 0, 2, 2, 0, 1, 2, 1, 1};
    const REAL f[3] = {0.5 * xi * (xi - 1.0), 1.0 - xi * xi, 0.5 * xi * (xi + 1.0)};
    const REAL g[3] = {0.5 * eta * (eta - 1.0), 1.0 - eta * eta, 0.5 * eta * (eta + 1.0)};
    const REAL df[3] = {xi - 0.5, -2.0 * xi, xi + 0.5};
    const REAL dg[3] = {eta - 0.5, -2.0 * eta, eta + 0.5};
    REAL p[9], pu[9], pv[9];
    int k;
    for (k = 1; k < 9; k++) {
        p[k] = f[column[k]] * g[row[k]];
        pu[k] = df[column[k]] * g[row[k]];
        pv[k] = f[column[k]] * dg[row[k]];
    }
    footpoint_detail_weighted(x, 9, p, pu, pv, u, v, d);
}
