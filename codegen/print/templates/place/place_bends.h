/* Second derivatives of projection along a direction, from first ones and second derivatives of the face. */

/* Limits the coordinates of nodes, slave node and direction. */
#define FOOTPOINT_DETAIL_MOST_TURNS 33

/* Holds the parts of second derivatives. By coordinates i and e, r(xi,eta) + t q = xS has the second derivatives {xi,
 * eta, t}_ie = - v . [...]. The rows v of footpoint_detail_solve_along are the derivatives by the slave node. The
 * bracket is the sum of r_xixi xi_i xi_e and its like, of (f_i . u_e) w_i and (f_e . u_i) w_e, and of t q_ie. */
struct footpoint_detail_turns {
    REAL u[3][FOOTPOINT_DETAIL_MOST_TURNS]; /* first derivatives of xi, eta and t */
    REAL w
        [3]
        [FOOTPOINT_DETAIL_MOST_TURNS]; /* v times those of r(xi,eta) and q at fixed xi, eta and t, and */
    REAL f[3][FOOTPOINT_DETAIL_MOST_TURNS]; /* their slopes: phi_xi, phi_eta; 1 */
    REAL c[3][3];                           /* v . {r_xixi, r_xieta, r_etaeta} */
    REAL q[3], t, unit, over; /* t is in units of `unit`, over: 1 over the direction's length */
};

/* Computes the rest from u, t, q, unit and over. At first the face is about 1 and the direction 1 long; at the end, all
 * but t are in the caller's units. shape: rows phi_xi, phi_eta, r_xixi, r_xieta, r_etaeta. */
FOOTPOINT_PART void footpoint_detail_turn(struct footpoint_detail_turns *s,
                                          const REAL *const *shape, int nodes)
{
    const int slave = 3 * nodes, n = slave + 6;
    REAL v[3][3];
    int i, j;
    for (j = 0; j < 3; j++)
        for (i = 0; i < 3; i++)
            v[j][i] = (j < 2 ? 1.0 : s->unit) * s->u[j][slave + i];
    for (j = 0; j < 3; j++)
        for (i = 0; i < 3; i++)
            s->c[j][i] = footpoint_detail_dot(v[j], shape[2 + i]);
    for (j = 0; j < 3; j++)
        for (i = 0; i < n; i++) {
            const REAL size = i < slave + 3 ? 1.0 / s->unit : s->over;
            const int turns = i >= slave + 3;
            s->u[j][i] *= size;
            s->w[j][i] = size * (v[j][i % 3] - (j == 2 && turns ? s->unit * s->q[i % 3] : 0.0));
            s->f[j][i] = j == 2 ? (REAL)turns : i < slave ? shape[j][i / 3] : 0.0;
        }
}

/* Bounds second derivatives number j, of xi, eta or the distance, from above. */
FOOTPOINT_PART REAL footpoint_detail_turned_most(const struct footpoint_detail_turns *s, int n,
                                                 int j)
{
    REAL u = 0.0, w = s->unit * s->over, f = 1.0;
    int i, k;
    for (i = 0; i < n; i++) {
        w += fabs(s->w[j][i]);
        for (k = 0; k < 3; k++) {
            u += fabs(s->u[k][i]);
            f += fabs(s->f[k][i]);
        }
    }
    return 2.0 * (u * (fabs(s->c[j][0]) + fabs(s->c[j][1]) + fabs(s->c[j][2])) + w * f) * u +
           2.0 * fabs(s->t * s->over) * w;
}

/* Computes second derivatives number j, packed. If both coordinates are of the direction, t times v times the second
 * derivatives of q is added. */
FOOTPOINT_PART void footpoint_detail_turned(const struct footpoint_detail_turns *s, int n, int j,
                                            REAL *FOOTPOINT_RESTRICT row)
{
    const REAL *const c = s->c[j], *const w = s->w[j], *const q = s->q;
    const REAL straight = j < 2 ? 0.0 : s->unit * s->over;
    int e, i;
    for (i = 0; i < n; row += ++i) {
        const REAL x = s->u[0][i], y = s->u[1][i], z = s->u[2][i];
        const REAL a = c[0] * x + c[1] * y + w[i] * s->f[0][i];
        const REAL b = c[1] * x + c[2] * y + w[i] * s->f[1][i], d = w[i] * s->f[2][i];
        for (e = 0; e <= i; e++)
            row[e] = -(a * s->u[0][e] + b * s->u[1][e] + d * s->u[2][e] +
                       w[e] * (x * s->f[0][e] + y * s->f[1][e] + z * s->f[2][e]));
        for (e = n - 3; e <= i; e++)
            row[e] += s->t * s->over *
                      (q[i % 3] * w[e] + q[e % 3] * w[i] +
                       straight * ((e == i ? 1.0 : 0.0) - q[i % 3] * q[e % 3]));
    }
}

/* Writes the distance, first and second derivatives: rows 0, 1 to 3 and 4 to 6, unless NULL. Returns a status. */
FOOTPOINT_PART int footpoint_detail_write_turns(const struct footpoint_detail_turns *s, int n,
                                                REAL *const *row)
{
    REAL most = s->t * s->unit;
    int i, j;
    for (j = 0; j < 3; j++) {
        const REAL size = j < 2 ? 1.0 : s->unit;
        for (i = 0; row[1 + j] && i < n; i++)
            most = fabs(most) + fabs(size * s->u[j][i]);
        if (row[4 + j])
            most = fabs(most) + footpoint_detail_turned_most(s, n, j);
    }
    if (footpoint_detail_infinite(most) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    if (row[0])
        row[0][0] = s->t * s->unit;
    for (j = 0; j < 3; j++) {
        for (i = 0; row[1 + j] && i < n; i++)
            row[1 + j][i] = (j < 2 ? 1.0 : s->unit) * s->u[j][i];
        if (row[4 + j])
            footpoint_detail_turned(s, n, j, row[4 + j]);
    }
    return FOOTPOINT_OK;
}
