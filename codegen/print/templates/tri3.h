/* The flat triangle. */

/* Computes u = r_xi, v = r_eta and d = xS - r at (xi,eta). */
FOOTPOINT_FN void footpoint_detail_tri3_surface(const REAL *const *x, REAL xi, REAL eta, REAL u[3],
                                                REAL v[3], REAL d[3])
{
    REAL p[3], pu[3], pv[3];
    p[1] = xi;
    p[2] = eta;
    pu[1] = pv[2] = 1.0;
    pu[2] = pv[1] = 0.0;
    footpoint_detail_weighted(x, 3, p, pu, pv, u, v, d);
}
