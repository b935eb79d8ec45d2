/* Closest points of curved edges, of three nodes each. */

/* Clamps x to -1 and 1. */
FOOTPOINT_PART REAL footpoint_detail_clamped(REAL x)
{
    const REAL most = x < 1.0 ? x : 1.0;
    return most > -1.0 ? most : -1.0;
}

/* Computes the edge r = m + t (q + t w), |t| <= 1, from node a over m to b; p = m - s. */
FOOTPOINT_PART void footpoint_detail_curve(const REAL *a, const REAL *m, const REAL *b,
                                           const REAL *s, REAL p[3], REAL q[3], REAL w[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        p[i] = m[i] - s[i];
        q[i] = 0.5 * (b[i] - a[i]);
        w[i] = 0.5 * ((a[i] - m[i]) + (b[i] - m[i]));
    }
}

/* Begins the search of the place of edge k of n that is nearest to s.  The squared distance is a polynomial of degree 4 in t, half its
 * slope c[0] + t (c[1] + t (c[2] + t c[3])); c[4] is the square of q.  at: the nearest place of the chord and, at index k + n, its
 * farther end, because there may be two minima.  Returns the square of the chord. */
FOOTPOINT_PART REAL footpoint_detail_curve_begin(const REAL *a, const REAL *m, const REAL *b,
                                                 const REAL *s, int k, int n, REAL c[5][8],
                                                 REAL at[8])
{
    REAL p[3], q[3], w[3], pq = 0.0, pw = 0.0, qq = 0.0, qw = 0.0, ww = 0.0;
    int i;
    footpoint_detail_curve(a, m, b, s, p, q, w);
    for (i = 0; i < 3; i++) {
        pq += p[i] * q[i];
        pw += p[i] * w[i];
        qq += q[i] * q[i];
        qw += q[i] * w[i];
        ww += w[i] * w[i];
    }
    c[0][k] = c[0][k + n] = pq;
    c[1][k] = c[1][k + n] = qq + 2.0 * pw;
    c[2][k] = c[2][k + n] = 3.0 * qw;
    c[3][k] = c[3][k + n] = 2.0 * ww;
    c[4][k] = c[4][k + n] = qq + REAL_MIN;
    at[k] = footpoint_detail_clamped(-(pq + qw) / c[4][k]);
    at[k + n] = at[k] > 0.0 ? -1.0 : 1.0;
    return 4.0 * qq;
}

/* Moves all edges' places by Newton's steps to slopes of 0, by Gauss-Newton steps if the distance is not convex: five, and
 * more while a squared distance falls by more than rounding. */
FOOTPOINT_PART void footpoint_detail_curve_steps(int n, REAL c[5][8], REAL at[8])
{
    REAL less[8];
    int i, k, left = 1;
    for (i = 0; i < 50 && left; i++) {
        for (k = 0; k < 2 * n; k++) {
            const REAL t = at[k];
            const REAL slope = c[0][k] + t * (c[1][k] + t * (c[2][k] + t * c[3][k]));
            const REAL bend = c[1][k] + t * (2.0 * c[2][k] + 3.0 * t * c[3][k]);
            const REAL gauss = 0.1 * (c[4][k] + 2.0 * t * (2.0 / 3.0 * c[2][k] + t * c[3][k]));
            const REAL most = bend > gauss ? bend : gauss;
            at[k] = footpoint_detail_clamped(t - slope / (most > REAL_MIN ? most : REAL_MIN));
            less[k] = slope * (t - at[k]);
        }
        left = i < 4;
        for (k = 0; !left && k < 2 * n; k++)
            left = less[k] > REAL_MARGIN * c[4][k];
    }
}

/* Finds the nearer of the two places of edge k, *t; returns the squared distance there. */
FOOTPOINT_PART REAL footpoint_detail_curve_end(const REAL *a, const REAL *m, const REAL *b,
                                               const REAL *s, int k, int n, const REAL at[8],
                                               REAL *t)
{
    const REAL u = at[k], v = at[k + n];
    REAL p[3], q[3], w[3], first = 0.0, second = 0.0, size = 0.0;
    int i;
    footpoint_detail_curve(a, m, b, s, p, q, w);
    for (i = 0; i < 3; i++) {
        const REAL d = p[i] + u * (q[i] + u * w[i]), e = p[i] + v * (q[i] + v * w[i]);
        first += d * d;
        second += e * e;
        size += q[i] * q[i];
    }
    *t = second < first - 4.0 * REAL_MARGIN * (first + size) ? v : u;
    return second < first - 4.0 * REAL_MARGIN * (first + size) ? second : first;
}
