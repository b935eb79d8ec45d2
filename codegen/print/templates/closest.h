/* Points of edges, and statuses of closest points. */

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

#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3)
#endif

/* Of the nearest point found, dd being the square of its distance: FOOTPOINT_ERR_DEGENERATE if something is not finite in
 * `all`, size, the sum of the squares of edges, is not between least and 1 / least, or there is no area, whose vector is
 * n; else FOOTPOINT_ERR_DOMAIN beyond the longest edge; else FOOTPOINT_ERR_DEGENERATE where the search has a flaw. */
FOOTPOINT_PART int footpoint_detail_closest_status(REAL_BITS flaw, REAL all, const REAL n[3],
                                                   REAL size, REAL least, REAL dd, REAL longest)
{
    const REAL nn = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const REAL_BITS away = footpoint_detail_below(longest, dd);
    const REAL_BITS nodes =
        footpoint_detail_below(size, least) | footpoint_detail_below(1.0 / least, size) |
        footpoint_detail_bits(nn - REAL_FLAT * (size * size)) | footpoint_detail_infinite(all);
    return FOOTPOINT_ERR_DEGENERATE * (int)((nodes | (flaw & ~away)) >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((away & ~nodes) >> REAL_TOP);
}

/* The root of the square of a distance, with its sign. */
FOOTPOINT_PART REAL footpoint_detail_signed_root(REAL dd)
{
    const REAL root = sqrt(fabs(dd));
    return dd < 0.0 ? -root : root;
}

/* A search of closest points: x as NAME has its vectors; at = {xi, eta, square of the distance with its sign}. */
typedef int footpoint_detail_nearest(const REAL *const *x, REAL at[3], int *region);

/* NAME_closest: where the status is FOOTPOINT_ERR_DEGENERATE once more, in a unit of length in which the segment is about 1
 * long; with nodes = 0 not. */
FOOTPOINT_PART int footpoint_detail_closest(footpoint_detail_nearest *nearest, const REAL *const *x,
                                            int nodes, int vectors, REAL loc[2], REAL *dist,
                                            int *region)
{
    REAL y[5][3], at[3], d;
    const REAL *const z[5] = {y[0], y[1], y[2], y[3], y[4]};
    int exponent = 0, where, status = nearest(x, at, &where);
    if (status == FOOTPOINT_ERR_DEGENERATE) {
        status = footpoint_detail_scale(x, nodes, vectors, y, &exponent);
        if (status == FOOTPOINT_OK)
            status = nearest(z, at, &where);
    }
    if (status != FOOTPOINT_OK)
        return status;
    d = footpoint_detail_signed_root(at[2]);
    loc[0] = at[0];
    loc[1] = at[1];
    *dist = exponent ? ldexp(d, exponent) : d;
    *region = where;
    return FOOTPOINT_OK;
}
