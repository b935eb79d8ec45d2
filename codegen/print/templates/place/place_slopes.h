/* Derivatives of projection along a direction, from shape functions and tangents. */

/* Computes rows v with v . (d xS - sum phi_k d xk - t dq) = d xi, d eta and dt for r(xi,eta) + t q = xS, by Cramer's
 * rule with the tangents a and b. a and b are sums of edges, whose squares add up to at most `size`. By estimate, not
 * proof, they are right to 40 rounding errors (of 2^-53) of the root of `size`, and their products to that times the
 * root of size (a . a + b . b). The highest bit of the result is set if (a x b) . q is less than 1.2e-5 times that
 * root, or a number is not finite; above, v is right to 1e-9. all: at least the square of each row. */
FOOTPOINT_PART REAL_BITS footpoint_detail_solve_along(const REAL a[3], const REAL b[3],
                                                      const REAL q[3], REAL size, REAL v[3][3],
                                                      REAL *all)
{
    const REAL both = footpoint_detail_dot(a, a) + footpoint_detail_dot(b, b);
    REAL det, over;
    int i, k;
    footpoint_detail_cross(b, q, v[0]);
    footpoint_detail_cross(q, a, v[1]);
    footpoint_detail_cross(a, b, v[2]);
    det = footpoint_detail_dot(v[2], q);
    over = 1.0 / det;
    *all = (over * over) * (both + both * both);
    for (k = 0; k < 3; k++)
        for (i = 0; i < 3; i++)
            v[k][i] *= over;
    return footpoint_detail_not_above(det * det - 1.6e-10 * (size * both));
}

/* Returns the distance along q. */
FOOTPOINT_PART REAL footpoint_detail_ahead(const REAL *const *y, int nodes, const REAL *phi,
                                           const REAL q[3])
{
    REAL d[3] = {0.0, 0.0, 0.0};
    int i, k;
    FOOTPOINT_UNROLL
    for (k = 0; k < nodes; k++)
        for (i = 0; i < 3; i++)
            d[i] += phi[k] * (y[nodes][i] - y[k][i]);
    return footpoint_detail_dot(d, q);
}

/* Writes derivatives of xi, eta and distance, unless the row is NULL: by nodes and slave node, from v; by the direction,
 * because q . v is 0, 0 and 1, `turn` times v, or for the distance v - q. */
FOOTPOINT_PART void footpoint_detail_write_slopes(int nodes, const REAL *phi, REAL v[3][3],
                                                  const REAL q[3], REAL turn, REAL *const *row)
{
    int i, j, k;
    for (j = 0; j < 3; j++) {
        if (!row[j])
            continue;
        FOOTPOINT_UNROLL
        for (k = 0; k < nodes; k++) {
            REAL *const to = row[j] + 3 * k;
            const REAL less = -phi[k], first = less * v[j][0], second = less * v[j][1];
            to[0] = first; /* adjacent: one instruction stores both */
            to[1] = second;
            to[2] = less * v[j][2];
        }
        for (i = 0; i < 3; i++)
            row[j][3 * nodes + i] = v[j][i];
        for (i = 0; i < 3; i++)
            row[j][3 * nodes + 3 + i] = turn * (j < 2 ? v[j][i] : v[j][i] - q[i]);
    }
}

/* Computes the distance and, by nodes, slave node and direction, the derivatives of xi, eta and distance: row[0] to
 * row[3], unless NULL.  Returns a status.  y: nodes and slave node, in units of `unit`; q: unit vector; over: 1 over
 * the length of the direction; phi: shape functions. */
FOOTPOINT_PART int footpoint_detail_slopes(const REAL *const *y, int nodes, REAL unit,
                                           const REAL *phi, const REAL a[3], const REAL b[3],
                                           REAL size, const REAL q[3], REAL over, REAL *const *row)
{
    REAL v[3][3], t, turn, all, shapes = 1.0;
    int i, k;
    if (footpoint_detail_solve_along(a, b, q, size, v, &all) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    all = 0.0;
    for (k = 0; k < nodes; k++)
        shapes += fabs(phi[k]);
    for (i = 0; i < 3; i++) {
        v[0][i] /= unit;
        v[1][i] /= unit;
        all += fabs(v[0][i]) + fabs(v[1][i]) + fabs(v[2][i]) + 1.0;
    }
    t = footpoint_detail_ahead(y, nodes, phi, q) * unit;
    turn = -t * over;
    if ((footpoint_detail_infinite(all * shapes) | footpoint_detail_infinite(t) |
         footpoint_detail_infinite(all * turn)) >>
        REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    if (row[0])
        row[0][0] = t;
    footpoint_detail_write_slopes(nodes, phi, v, q, turn, row + 1);
    return FOOTPOINT_OK;
}

/* Computes the unit vector q along a direction and 1 over the direction's length.  Returns a status. */
FOOTPOINT_COLD int footpoint_detail_direction(const REAL along[3], REAL q[3], REAL *over)
{
    REAL most = 0.0, length;
    int i, exponent;
    for (i = 0; i < 3; i++) {
        if (footpoint_detail_infinite(along[i]) >> REAL_TOP)
            return FOOTPOINT_ERR_NOT_FINITE;
        most = fabs(along[i]) > most ? fabs(along[i]) : most;
    }
    if (footpoint_detail_below(most, REAL_MIN) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    (void)frexp(most, &exponent);
    for (i = 0; i < 3; i++)
        q[i] = ldexp(along[i], -exponent);
    length = 1.0 / sqrt(footpoint_detail_dot(q, q));
    for (i = 0; i < 3; i++)
        q[i] *= length;
    *over = ldexp(length, -exponent);
    return FOOTPOINT_OK;
}
