/* The triangle with mid-side nodes. */

/* Computes u = r_xi, v = r_eta and d = xS - r at (xi,eta). */
FOOTPOINT_FN void footpoint_detail_tri6_surface(const REAL *const *x, REAL xi, REAL eta, REAL u[3],
                                                REAL v[3], REAL d[3])
{
    const REAL w = 1.0 - xi - eta;
    REAL p[6], pu[6], pv[6];
    p[1] = xi * (2.0 * xi - 1.0);
    p[2] = eta * (2.0 * eta - 1.0);
    p[3] = 4.0 * w * xi;
    p[4] = 4.0 * xi * eta;
    p[5] = 4.0 * eta * w;
    pu[1] = 4.0 * xi - 1.0;
    pu[2] = pv[1] = 0.0;
    pv[2] = 4.0 * eta - 1.0;
    pu[3] = 4.0 * (w - xi);
    pv[3] = -4.0 * xi;
    pu[4] = 4.0 * eta;
    pv[4] = 4.0 * xi;
    pu[5] = -4.0 * eta;
    pv[5] = 4.0 * (w - eta);
    footpoint_detail_weighted(x, 6, p, pu, pv, u, v, d);
}
