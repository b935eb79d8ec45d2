/* The numbers for the proof of the closest point, from nodes: in float, because products lose too many digits. */

/* Computes at (u,v): x = r_xi, y = r_eta and w = D, their products, and bounds, all four times or, if squares, sixteen times.
 *
 * Rounding, see footpoint_detail_quad4_visit and footpoint_detail_quad4_newton: with Z = (U + V + C) . (U + V + C + W), products
 * are off by 13 units of Z, mixed by 27; and Q, as |t| <= 2 and, if Q > 0, |mixed| <= (uu + vv) / 2, by 250 units of
 * Z (uu + vv + cc). */
FOOTPOINT_PART void footpoint_detail_quad4_here(const REAL p[9],
                                                const footpoint_detail_quad4_vectors *r, int finely,
                                                REAL u, REAL v, REAL x[3], REAL y[3], REAL w[3],
                                                footpoint_detail_quad4_local *q,
                                                footpoint_detail_quad4_bounds *bounds)
{
    footpoint_detail_quad4_place at;
    REAL all[3], more[3], off;
    int i;
    footpoint_detail_quad4_visit(r->x, u, v, &at);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        x[i] = at.u[i];
        y[i] = at.v[i];
        w[i] = at.w[i];
        all[i] = (at.U[i] + at.V[i]) + at.C[i];
        more[i] = all[i] + at.W[i];
    }
    (void)finely;
    q->masked = r->masked;
    q->u = u;
    q->v = v;
    q->uu = footpoint_detail_dot(x, x);
    q->uv = footpoint_detail_dot(x, y);
    q->vv = footpoint_detail_dot(y, y);
    q->uc = footpoint_detail_dot(x, at.c);
    q->vc = footpoint_detail_dot(y, at.c);
    q->cc = footpoint_detail_dot(at.c, at.c);
    q->dc = footpoint_detail_dot(w, at.c);
    q->f = footpoint_detail_dot(x, w);
    q->g = footpoint_detail_dot(y, w);
    q->dd = footpoint_detail_dot(w, w);
    off = REAL_UNIT * footpoint_detail_dot(all, more);
    bounds->wide = 1.0001 * (p[0] + 2.0 * fabs(p[3]) + p[5]);
    bounds->high = 1.0001 * (p[2] + 2.0 * fabs(p[4]) + p[5]);
    bounds->off_f =
        7.0 * REAL_UNIT * (footpoint_detail_weigh(at.U, w) + footpoint_detail_weigh(at.W, x)) +
        1e-5 * off;
    bounds->off_g =
        7.0 * REAL_UNIT * (footpoint_detail_weigh(at.V, w) + footpoint_detail_weigh(at.W, y)) +
        1e-5 * off;
    bounds->off_det = 250.0 * off * (bounds->wide + bounds->high + q->cc);
    bounds->off_rows = 40.0 * off;
}
