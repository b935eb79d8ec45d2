/* The Bezier patch of runtime/geometry/bezier.c. */

/* Computes u = r_xi, v = r_eta and d = xS - r at (xi,eta), as a sum over the corners c, of the handles a[c][0] along xi and
 * a[c][1] along eta, whose sum leads to the inner point. */
FOOTPOINT_FN void footpoint_detail_bezier_surface(const REAL *const *x, REAL xi, REAL eta,
                                                  REAL u[3], REAL v[3], REAL d[3])
{
    REAL a[4][2][3];
    int c, m, j;
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++) {
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const REAL *const y = x[m ? 3 - c : c ^ 1], *const n = x[4 + c];
            const REAL along =
                (y[0] - x[c][0]) * n[0] + (y[1] - x[c][1]) * n[1] + (y[2] - x[c][2]) * n[2];
            FOOTPOINT_UNROLL
            for (j = 0; j < 3; j++)
                a[c][m][j] = (y[j] - x[c][j] - along * n[j]) / 3.0;
        }
    }
    FOOTPOINT_UNROLL
    for (j = 0; j < 3; j++) {
        u[j] = v[j] = 0.0;
        d[j] = x[8][j] - x[0][j];
    }
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++) {
        const REAL z[2] = {c == 1 || c == 2 ? 0.5 : -0.5, c > 1 ? 0.5 : -0.5};
        REAL g[2], h[2], gd[2], hd[2];
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const REAL p = 0.5 + z[m] * (m ? eta : xi), r = 1.0 - p;
            g[m] = 3.0 * p * p * r;
            h[m] = p * p * p + g[m];
            gd[m] = 3.0 * z[m] * p * (2.0 * r - p);
            hd[m] = 6.0 * z[m] * p * r;
        }
        FOOTPOINT_UNROLL
        for (j = 0; j < 3; j++) {
            const REAL y = x[c][j] - x[0][j];
            d[j] -= y * h[0] * h[1] + a[c][0][j] * g[0] * h[1] + a[c][1][j] * h[0] * g[1];
            u[j] += y * hd[0] * h[1] + a[c][0][j] * gd[0] * h[1] + a[c][1][j] * hd[0] * g[1];
            v[j] += y * h[0] * hd[1] + a[c][0][j] * g[0] * hd[1] + a[c][1][j] * h[0] * gd[1];
        }
    }
}
