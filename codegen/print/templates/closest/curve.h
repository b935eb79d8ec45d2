/* Closest points of curved edges, of three nodes each. */

/* x between -1 and 1. */
FOOTPOINT_PART REAL footpoint_detail_clamped(REAL x)
{
    const REAL most = x < 1.0 ? x : 1.0;
    return most > -1.0 ? most : -1.0;
}

/* The edge r = m + t (q + t w), |t| <= 1, from node a over m to b; p = m - s. */
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

/* Where edge k of n is nearest to s.  The square of the distance is a polynomial of degree 4 in t, half its slope c[0] + t
 * (c[1] + t (c[2] + t c[3])); c[4] is the square of q.  at: where the chord is nearest, and, n places on, the end that is
 * farther away, as there may be two such places.  Returns the square of the chord. */
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

/* Newton's steps of all edges to where their slopes are 0, Gauss and Newton's where the distance is not convex: five, and
 * more until none makes the square of a distance less but by rounding. */
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

/* The nearer of the two places of edge k: *t; returns the square of the distance there. */
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
