/* The Gregory patch of runtime/geometry/gregory.c. */

/* Computes u = r_xi, v = r_eta and d = xS - r at (xi,eta), as a sum over the corners c, of the handles a[c][0] along xi and
 * a[c][1] along eta and the inner points q, of which each of the two edges has its own.  w weights these; f and g are the
 * Bernstein polynomials of a corner and of its handle, h their sum, and fd, gd, hd their derivatives towards larger xi, eta. */
FOOTPOINT_FN void footpoint_detail_gregory_surface(const REAL *const *x, REAL xi, REAL eta,
                                                   REAL u[3], REAL v[3], REAL d[3])
{
    REAL a[4][2][3], t[4][2][3], k[4][2], l[4][2], q[4][2][3];
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
            FOOTPOINT_UNROLL
            for (j = 0; j < 3; j++)
                t[c][m][j] =
                    n[(j + 1) % 3] * a[c][m][(j + 2) % 3] - n[(j + 2) % 3] * a[c][m][(j + 1) % 3];
        }
    }
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++) {
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const REAL *const b = a[c][m], *const o = a[c][1 - m];
            const REAL size = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
            k[c][m] = (t[c][m][0] * o[0] + t[c][m][1] * o[1] + t[c][m][2] * o[2]) / size;
            l[c][m] = (b[0] * o[0] + b[1] * o[1] + b[2] * o[2]) / size;
        }
    }
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++) {
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const int e = m ? 3 - c : c ^ 1;
            FOOTPOINT_UNROLL
            for (j = 0; j < 3; j++) {
                const REAL middle = (x[e][j] - x[c][j]) + (a[e][m][j] - a[c][m][j]);
                q[c][m][j] = a[c][m][j] + ((k[c][m] - k[e][m]) * t[c][m][j] - k[c][m] * t[e][m][j] +
                                           2.0 * l[c][m] * middle - l[e][m] * a[c][m][j]) /
                                              3.0;
            }
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
        REAL f[2], g[2], h[2], fd[2], gd[2], hd[2], s[2], sum, w, wd[2];
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const REAL p = 0.5 + z[m] * (m ? eta : xi), r = 1.0 - p;
            s[m] = r;
            f[m] = p * p * p;
            g[m] = 3.0 * p * p * r;
            h[m] = f[m] + g[m];
            fd[m] = 3.0 * z[m] * p * p;
            gd[m] = 3.0 * z[m] * p * (2.0 * r - p);
            hd[m] = 6.0 * z[m] * p * r;
        }
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++)
            s[m] = s[m] > 0.0 ? s[m] : 0.0;
        w = s[0] + s[1];
        sum = w > 0.0 ? w : 1.0;
        wd[0] = s[0] > 0.0 ? z[0] * s[1] / (sum * sum) : 0.0;
        wd[1] = s[1] > 0.0 ? -z[1] * s[0] / (sum * sum) : 0.0;
        w = w > 0.0 ? s[1] / sum : 0.5;
        FOOTPOINT_UNROLL
        for (j = 0; j < 3; j++) {
            const REAL y = x[c][j] - x[0][j], o = q[c][1][j] - q[c][0][j], i = q[c][0][j] + w * o;
            d[j] -= y * h[0] * h[1] + a[c][0][j] * g[0] * f[1] + a[c][1][j] * f[0] * g[1] +
                    i * g[0] * g[1];
            u[j] += y * hd[0] * h[1] + a[c][0][j] * gd[0] * f[1] + a[c][1][j] * fd[0] * g[1] +
                    (i * gd[0] + o * wd[0] * g[0]) * g[1];
            v[j] += y * h[0] * hd[1] + a[c][0][j] * g[0] * fd[1] + a[c][1][j] * f[0] * gd[1] +
                    (i * gd[1] + o * wd[1] * g[1]) * g[0];
        }
    }
}
