/* Derivatives of projection along a direction, first and second. */

/* Holds the parts of derivatives. Differentiating r(xi) + t q = xS by coordinates i and e gives {xi, t}_i = - v .
 * (phi_i - t q_i) and {xi, t}_ie = - v . [...]. The rows v satisfy v . r_xi = {1, 0} and v . q = {0, 1}. The bracket is
 * the sum of r_xixi xi_i xi_e, (f_i . u_e) w_i, (f_e . u_i) w_e and t q_ie. */
struct footpoint_detail_KIND_turns {
    REAL u[2][COORDINATES + 2]; /* first derivatives of xi and t, the distance */
    REAL w[2][COORDINATES + 2]; /* v times those of r(xi) and q at fixed xi and t, and */
    REAL f[2][COORDINATES + 2]; /* their slopes: phi_xi; 1 */
    REAL c[2];                  /* v . r_xixi */
    REAL q[2], t, unit, over;   /* t is in units of `unit`, over: 1 over the direction's length */
};

/* Computes the parts by the direction, whose two coordinates come last. */
FOOTPOINT_PART void footpoint_detail_KIND_turn_direction(struct footpoint_detail_KIND_turns *s,
                                                         const REAL *const *v)
{
    int e, i, j;
    for (j = 0; j < 2; j++)
        for (i = 0; i < 2; i++) {
            const REAL turn = s->over * (v[j][i] - (j ? s->q[i] : 0.0));
            e = COORDINATES + i;
            s->u[j][e] = -s->t * turn;
            s->w[j][e] = (j ? s->unit : 1.0) * turn;
            s->f[j][e] = (REAL)j;
        }
}

/* Computes the parts from t, q, unit and over, for an edge about 1 long. The highest bit of the result is set if the
 * line is so nearly parallel to the edge that rounding may cost derivatives more than about 1e-9. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_turn(const REAL *const *x, REAL xi,
                                                    struct footpoint_detail_KIND_turns *s)
{
    REAL phi[VECTORS], slope[VECTORS], bend[NODES], a[2], b[2], edges = 0.0, v[2][2], det;
    const REAL *const rows[2] = {v[0], v[1]};
    int e, j, k;
    footpoint_detail_KIND_shape(xi, phi, slope, bend);
    phi[NODES] = -1.0;
    slope[NODES] = 0.0;
    for (j = 0; j < 2; j++) {
        a[j] = b[j] = 0.0;
        for (k = 1; k < NODES; k++) {
            const REAL edge = x[k][j] - x[0][j];
            a[j] += slope[k] * edge;
            b[j] += bend[k] * edge;
            edges += edge * edge;
        }
    }
    det = footpoint_detail_plane_cross(a, s->q);
    v[0][0] = s->q[1] / det;
    v[0][1] = -s->q[0] / det;
    v[1][0] = -a[1] / det;
    v[1][1] = a[0] / det;
    for (j = 0; j < 2; j++) {
        s->c[j] = (j ? s->unit : 1.0) * footpoint_detail_plane_dot(v[j], b);
        for (e = 0; e < COORDINATES; e++) {
            s->w[j][e] = (j ? 1.0 : 1.0 / s->unit) * v[j][e % 2];
            s->u[j][e] = -phi[e / 2] * (v[j][e % 2] / s->unit);
            s->f[j][e] = j ? 0.0 : slope[e / 2];
        }
    }
    footpoint_detail_KIND_turn_direction(s, rows);
    return footpoint_detail_bits(det * det - 6.4e-10 * (1.0 + xi * xi) * edges) |
           footpoint_detail_infinite(det);
}

/* Bounds second derivatives number j from above. */
FOOTPOINT_PART REAL footpoint_detail_KIND_bend_most(const struct footpoint_detail_KIND_turns *s,
                                                    int j)
{
    REAL u = 0.0, w = s->unit * s->over, f = 1.0;
    int i;
    for (i = 0; i < COORDINATES + 2; i++) {
        w += fabs(s->w[j][i]);
        u += fabs(s->u[0][i]) + fabs(s->u[1][i]);
        f += fabs(s->f[0][i]);
    }
    return 2.0 * (u * fabs(s->c[j]) + w * f) * u + 2.0 * fabs(s->t * s->over) * w;
}

/* Computes second derivatives number j, packed. If both coordinates are of the direction, t times v times the second
 * derivatives of q is added. */
FOOTPOINT_PART void footpoint_detail_KIND_bend(const struct footpoint_detail_KIND_turns *s, int j,
                                               REAL *row)
{
    const REAL *const w = s->w[j], *const q = s->q, straight = j ? s->unit * s->over : 0.0;
    int e, i;
    for (i = 0; i < COORDINATES + 2; row += ++i) {
        const REAL x = s->u[0][i], t = s->u[1][i];
        const REAL a = s->c[j] * x + w[i] * s->f[0][i], b = w[i] * s->f[1][i];
        for (e = 0; e <= i; e++)
            row[e] = -(a * s->u[0][e] + b * s->u[1][e] + w[e] * (x * s->f[0][e] + t * s->f[1][e]));
        for (e = COORDINATES; e <= i; e++)
            row[e] += s->t * s->over *
                      (q[i % 2] * w[e] + q[e % 2] * w[i] +
                       straight * ((e == i ? 1.0 : 0.0) - q[i % 2] * q[e % 2]));
    }
}

/* Writes the distance, first and second derivatives: rows 0, 1 to 2 and 3 to 4, unless NULL. Returns a status. */
FOOTPOINT_PART int footpoint_detail_KIND_bends(const struct footpoint_detail_KIND_turns *s,
                                               REAL *const *row)
{
    REAL most = fabs(s->t * s->unit);
    int i, j;
    for (j = 0; j < 2; j++) {
        for (i = 0; row[1 + j] && i < COORDINATES + 2; i++)
            most += fabs((j ? s->unit : 1.0) * s->u[j][i]);
        most += row[3 + j] ? footpoint_detail_KIND_bend_most(s, j) : 0.0;
    }
    if (footpoint_detail_infinite(most) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    if (row[0])
        row[0][0] = s->t * s->unit;
    for (j = 0; j < 2; j++) {
        for (i = 0; row[1 + j] && i < COORDINATES + 2; i++)
            row[1 + j][i] = (j ? s->unit : 1.0) * s->u[j][i];
        if (row[3 + j])
            footpoint_detail_KIND_bend(s, j, row[3 + j]);
    }
    return FOOTPOINT_OK;
}

FOOTPOINT_FN int PREFIX_hessian_along(NODE_PARAMETERS, const REAL along[2], REAL xi, REAL *dist,
                                      REAL *d_xi, REAL *d_dist, REAL *h_xi, REAL *h_dist)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL *const row[5] = {dist, d_xi, d_dist, h_xi, h_dist}, y[VECTORS][2], length;
    const REAL *z[VECTORS];
    struct footpoint_detail_KIND_turns s;
    int exponent = 0, turn = 0, status = footpoint_detail_KIND_unit(x, y, z, &exponent);
    if (status == FOOTPOINT_OK)
        status = footpoint_detail_plane_direction(along, s.q, &turn);
    if (status != FOOTPOINT_OK)
        return status;
    if (footpoint_detail_infinite(xi) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    length = 1.0 / sqrt(footpoint_detail_plane_dot(s.q, s.q));
    s.q[0] *= length;
    s.q[1] *= length;
    s.over = ldexp(length, -turn);
    s.unit = ldexp(1.0, exponent);
    s.t = footpoint_detail_KIND_away(z, s.q, xi);
    if (footpoint_detail_KIND_turn(z, xi, &s) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    return footpoint_detail_KIND_bends(&s, row);
}

FOOTPOINT_FN int PREFIX_gradients_along(NODE_PARAMETERS, const REAL along[2], REAL xi, REAL *dist,
                                        REAL *d_xi, REAL *d_dist)
{
    return PREFIX_hessian_along(NODE_NAMES, along, xi, dist, d_xi, d_dist, 0, 0);
}
