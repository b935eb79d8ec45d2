/* Second derivatives along a direction, for callers. */

/* Computes their parts, in a unit of length in which the face is about 1 long; returns a status. */
FOOTPOINT_PART int BENDS_detail_turns(const REAL *const *x, const REAL along[3], const REAL loc[2],
                                      struct footpoint_detail_turns *s)
{
    REAL phi[NODES] = {0.0}, f[2][NODES] = {{0.0}}, r[5][3] = {{0.0}}, z[VECTORS][3];
    REAL *const found[ROW_COUNT] = {phi, f[0], f[1], r[0], r[1], r[2], r[3], r[4]};
    REAL *const first[4] = {&s->t, s->u[0], s->u[1], s->u[2]};
    const REAL *const shape[5] = {f[0], f[1], r[2], r[3], r[4]}, *y[VECTORS];
    int exponent = 0, status = footpoint_detail_scale(x, NODES, VECTORS, z, &exponent), k;
    if (status == FOOTPOINT_OK)
        status = footpoint_detail_direction(along, s->q, &s->over);
    if (status != FOOTPOINT_OK)
        return status;
    if ((footpoint_detail_infinite(loc[0]) | footpoint_detail_infinite(loc[1])) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    for (k = 0; k < VECTORS; k++)
        y[k] = z[k];
    if (NAME_detail(y, loc[0], loc[1], found, 1, 0, 1) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    status = footpoint_detail_slopes(y, NODES, 1.0, phi, r[0], r[1], SLOPES_detail_size(y, loc),
                                     s->q, 1.0, first);
    s->unit = ldexp(1.0, exponent);
    if (status == FOOTPOINT_OK)
        footpoint_detail_turn(s, shape, NODES);
    return status;
}

/* footpoint_KIND_hessian_along:  computes, at loc = {xi, eta} as a projection found it, dist, d_xi, d_eta and d_dist as
 *           footpoint_KIND_gradients_along does, and second derivatives of xi, eta and dist by the same coordinates r
 *           and c, r >= c, packed: element r (r + 1) / 2 + c.  Rows may be NULL.  Statuses are the same.
 * UPPER_HESSIAN_ALONG_OF(footpoint_KIND_along), at file scope, joins it with the projection: footpoint_KIND_along_hessian. */
FOOTPOINT_FN int BENDS(NODE_PARAMETERS, const REAL along[3], const REAL loc[2], REAL *dist,
                       REAL *d_xi, REAL *d_eta, REAL *d_dist, REAL *h_xi, REAL *h_eta, REAL *h_dist)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL *const row[7] = {dist, d_xi, d_eta, d_dist, h_xi, h_eta, h_dist};
    struct footpoint_detail_turns s;
    const int status = BENDS_detail_turns(x, along, loc, &s);
    return status == FOOTPOINT_OK ? footpoint_detail_write_turns(&s, SLOPE_COUNT, row) : status;
}
