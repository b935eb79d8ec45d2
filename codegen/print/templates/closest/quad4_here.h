/* The numbers for the proof of the closest point, from scalar products that a search has. */

/* Computes at (u,v): x = r_xi, y = r_eta and w = D, their products, and bounds; finely: slopes as accurate as possible.
 *
 * Rounding, in units u = REAL_UNIT and with S = a . a + b . b + c . c, |xi| and |eta| <= 1: vectors are off by k u of
 * their bounds, k <= 0.5 rounding / u - 6.5, products by `rounding`.  These bounds are at most 1.42 sqrt(S) for
 * a and b, 2.53 sqrt(S) for c and |D| + 3.5 sqrt(S) for d.  So slopes are off by (k + 3) u sqrt(S) (5.4 |D| + 12.6
 * sqrt(S)) or less; products at (u,v) by 26 S `rounding`, D . c by 29.3 S + 1.3 D . D of it, `mixed` by 55 S + 1.3 D
 * . D; and Q, as |t| <= 2 and, if Q > 0, |mixed| <= 2 S, by 40 S times that. */
FOOTPOINT_PART void footpoint_detail_quad4_here(const REAL p[9],
                                                const footpoint_detail_quad4_vectors *r, int finely,
                                                REAL u, REAL v, REAL x[3], REAL y[3], REAL w[3],
                                                footpoint_detail_quad4_local *q,
                                                footpoint_detail_quad4_bounds *bounds)
{
    const REAL size = r->size, off = r->rounding * size;
    REAL y12, reach;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        x[i] = r->a[i] + v * r->c[i];
        y[i] = r->b[i] + u * r->c[i];
        w[i] = r->over * r->d[i] - u * r->a[i] - v * y[i];
    }
    q->masked = r->masked;
    q->u = u;
    q->v = v;
    q->cc = p[5];
    q->uc = p[3] + v * p[5];
    q->vc = p[4] + u * p[5];
    y12 = u * p[3] + v * q->vc;
    q->uu = p[0] + v * (p[3] + q->uc);
    q->vv = p[2] + u * (p[4] + q->vc);
    q->uv = p[1] + y12;
    q->dc = p[8] - y12;
    q->f = footpoint_detail_dot(x, w);
    q->g = footpoint_detail_dot(y, w);
    q->dd = footpoint_detail_dot(w, w);
    bounds->wide = p[0] + 2.0 * fabs(p[3]) + p[5] + 30.0 * off;
    bounds->high = p[2] + 2.0 * fabs(p[4]) + p[5] + 30.0 * off;
    reach = 6.0 * size + q->dd;
    bounds->off_f = bounds->off_g = (1.35 * r->rounding - 9.0 * REAL_UNIT) * reach;
    if (finely)
        footpoint_detail_quad4_off(p, r, r->rounding, fabs(u), fabs(v), &bounds->off_f,
                                   &bounds->off_g);
    bounds->off_det = 375.0 * (off * reach);
    bounds->off_rows = r->rounding * (81.0 * size + 1.3 * q->dd);
}
