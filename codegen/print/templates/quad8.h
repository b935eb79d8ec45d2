/* The quadrilateral with mid-side nodes. */

/* Computes u = r_xi, v = r_eta and d = xS - r at (xi,eta): corners (a,b), mid-side nodes at a = 0 and at b = 0. */
FOOTPOINT_FN void footpoint_detail_quad8_surface(const REAL *const *x, REAL xi, REAL eta, REAL u[3],
                                                 REAL v[3], REAL d[3])
{
    REAL p[8], pu[8], pv[8];
    int k;
    for (k = 1; k < 4; k++) {
        const REAL a = k < 3 ? 1.0 : -1.0, b = k > 1 ? 1.0 : -1.0;
        p[k] = 0.25 * (1.0 + a * xi) * (1.0 + b * eta) * (a * xi + b * eta - 1.0);
        pu[k] = 0.25 * a * (1.0 + b * eta) * (2.0 * a * xi + b * eta);
        pv[k] = 0.25 * b * (1.0 + a * xi) * (a * xi + 2.0 * b * eta);
    }
    for (k = 4; k < 8; k += 2) {
        const REAL b = k > 4 ? 1.0 : -1.0, a = -b;
        p[k] = 0.5 * (1.0 - xi * xi) * (1.0 + b * eta);
        pu[k] = -xi * (1.0 + b * eta);
        pv[k] = 0.5 * b * (1.0 - xi * xi);
        p[k + 1] = 0.5 * (1.0 - eta * eta) * (1.0 + a * xi);
        pu[k + 1] = 0.5 * a * (1.0 - eta * eta);
        pv[k + 1] = -eta * (1.0 + a * xi);
    }
    footpoint_detail_weighted(x, 8, p, pu, pv, u, v, d);
}
