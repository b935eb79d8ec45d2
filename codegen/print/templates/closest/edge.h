/* Closest points of straight edges. */

/* Finds the point of the edge from corner a to b that is nearest to s, at *t from 0 to 1: e = b - a, p = s - a, *ee the square of its
 * length.  Returns the squared distance. */
FOOTPOINT_PART REAL footpoint_detail_edge(const REAL a[3], const REAL b[3], const REAL s[3],
                                          REAL e[3], REAL p[3], REAL *ee, REAL *t)
{
    REAL d[3], ahead;
    footpoint_detail_from(a, b, e);
    footpoint_detail_from(a, s, p);
    *ee = footpoint_detail_dot(e, e);
    ahead = footpoint_detail_dot(p, e);
    ahead = ahead > 0.0 ? ahead : 0.0;
    *t = (ahead < *ee ? ahead : *ee) / (*ee + REAL_MIN);
    d[0] = p[0] - *t * e[0];
    d[1] = p[1] - *t * e[1];
    d[2] = p[2] - *t * e[2];
    return footpoint_detail_dot(d, d);
}
