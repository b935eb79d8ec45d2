/* Projection along a direction. */

/* Returns the distance at xi, times |p|. */
FOOTPOINT_PART REAL footpoint_detail_KIND_away(const REAL *const *x, const REAL p[2], REAL xi)
{
    REAL d[2];
    footpoint_detail_KIND_way(x, xi, d);
    return footpoint_detail_plane_dot(d, p);
}

/* Searches in units of length in which edge and direction are about 1 long. */
FOOTPOINT_FN int footpoint_detail_KIND_along(const REAL *const *x, const REAL p[2], REAL *xi,
                                             REAL *dist)
{
    struct footpoint_detail_line l;
    REAL root[2];
    int status;
    footpoint_detail_KIND_line(x, p, &l);
    if (!(fabs(l.a[1]) + fabs(l.a[2]) > 1e-9 * l.wide))
        return FOOTPOINT_ERR_DEGENERATE;
    status = footpoint_detail_plane_meet(&l, root, xi);
    if (status == FOOTPOINT_NOT_UNIQUE && fabs(footpoint_detail_KIND_away(x, p, root[1])) <
                                              fabs(footpoint_detail_KIND_away(x, p, root[0])))
        *xi = root[1];
    *dist = footpoint_detail_KIND_away(x, p, *xi) / sqrt(footpoint_detail_plane_dot(p, p));
    return status;
}

FOOTPOINT_FN int PREFIX_along(NODE_PARAMETERS, const REAL along[2], REAL *xi, REAL *dist)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL y[VECTORS][2], p[2], at, away;
    const REAL *z[VECTORS];
    int exponent = 0, turn, status = footpoint_detail_KIND_unit(x, y, z, &exponent);
    const int turned = footpoint_detail_plane_direction(along, p, &turn);
    if (status == FOOTPOINT_ERR_NOT_FINITE || turned == FOOTPOINT_ERR_NOT_FINITE)
        return FOOTPOINT_ERR_NOT_FINITE;
    if (status != FOOTPOINT_OK || turned != FOOTPOINT_OK)
        return status != FOOTPOINT_OK ? status : turned;
    status = footpoint_detail_KIND_along(z, p, &at, &away);
    if (status < FOOTPOINT_OK)
        return status;
    away = ldexp(away, exponent);
    if (footpoint_detail_infinite(away + at) >> REAL_TOP)
        return FOOTPOINT_ERR_DOMAIN;
    *xi = at;
    *dist = away;
    return status;
}

FOOTPOINT_FN void PREFIX_along_n(size_t n, const REAL *const x[COORDINATES],
                                 const REAL *const along[2], REAL *FOOTPOINT_RESTRICT xi,
                                 REAL *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT status)
{
    size_t i;
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][2] = {COLUMNS};
        const REAL q[2] = {along[0][i], along[1][i]};
        status[i] = PREFIX_along(ROWS, q, &xi[i], &dist[i]);
    }
}
