/* Closest points of straight edges. */

/* The edge from corner a to b: e = b - a, p = s - a, *ee the square of its length, and *t where its point nearest to s
 * lies, from 0 to 1; returns the square of their distance. */
FOOTPOINT_PART REAL footpoint_detail_edge(const REAL a[3], const REAL b[3], const REAL s[3],
                                          REAL e[3], REAL p[3], REAL *ee, REAL *t)
{
    REAL ahead = 0.0, ss = 0.0, dd = 0.0;
    int i;
    for (i = 0; i < 3; i++) {
        e[i] = b[i] - a[i];
        p[i] = s[i] - a[i];
        ss += e[i] * e[i];
        ahead += p[i] * e[i];
    }
    ahead = 0.5 * (ahead + fabs(ahead));
    *ee = ss;
    *t = (ahead < ss ? ahead : ss) / (ss + REAL_MIN);
    for (i = 0; i < 3; i++) {
        const REAL d = p[i] - *t * e[i];
        dd += d * d;
    }
    return dd;
}
