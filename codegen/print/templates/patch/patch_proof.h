/* The proof of a step on a patch. */

/* Bounds the effect of rounding on (r_xi . D, r_eta . D), and per step; see footpoint_detail_net. Dot products and
 * Cramer's rule count as 3 + 4 of 9 u |r_i| |D|. A step counts the errors of both entries of a row of the Hessian, 1820
 * u far^2, and of its determinant, 3 u (r11 r22 + r12^2) <= 42 u far^2 max(r11, r22). */
FOOTPOINT_PART void footpoint_detail_KIND_off(const footpoint_detail_net *t, REAL u, REAL v, REAL d,
                                              REAL step, REAL off[2])
{
    const REAL unit = 1.12e-16, place = unit * (t->place + 18.0 * d), far = d + t->far;
    const REAL turn = unit * (t->turn * d + 2000.0 * step * (far * far));
    off[0] = place * u + turn;
    off[1] = place * v + turn;
}

/* Bounds the error of Newton's step n from the point (x,y) in the patch, whose surface is r, or of Chebyshev's step from
 * there if `corrected`. The highest bit of the result is not set if a minimum of the distance is proved to lie within
 * *error of the step's end, on the patch or on the surface that its polynomials make beside it, unless *error is no
 * number. `ball` is at least 5/4 of the step; if it does not depend on the step, bounds are computed beside it.
 *
 * By Newton and Kantorovich, in maximum norms: F = (r_xi . D, r_eta . D), D = xS - r, has the Jacobian -H, H = [r11
 * r12; r12 r22]; `step` = |H^-1 F|. Row i of the derivatives of H adds up to at most l_i = R_i A + 2 R A_i + |D| T_i,
 * where R_i = |r_i|, A_i = |r_i1| + |r_i2|, T_i = |r_i11| + 2 |r_i12| + |r_i22|, R and A are sums over i, and each is
 * the largest in `ball`. Let w = max(r22 l_1 + |r12| l_2, |r12| l_1 + r11 l_2) / det, so that |1 - H^-1 H(y)| <= w |y -
 * x|. If h = w step <= 1/4, then there is a root within 1.2 step of x, it is within 0.7 h step of the step's end, and H
 * is positive definite on the whole way there.
 *
 * Corrected: H' = K - r_ijk . D, and Chebyshev's step is n - H^-1 K(n,n) / 2. At the root x + z, F = H z + K(z,z) / 2 +
 * S, where row i of S has at most |D| T_i |z|^2 / 2 and, as K changes, k_i |z|^3 / 6, k_i = 2 T_i R + 3 A_i A + R_i T.
 * As |H^-1 K(z + n, z - n)| <= w 2.2 step 0.7 h step, the error is at most 0.77 h^2 step + |H^-1| (0.72 |D| T_i + 0.288
 * k_i step) step^2, and step <= 0.8 ball.
 *
 * Rounding: F is off by `off`, entries of H by 910 u far^2, far = |D| + net.far: 2 2.5 35 and 19 for r_i . r_j, 280 +
 * 3.5 12 for r_ij . D. Let e = 1820 u far^2 |H^-1|. It adds 0.27 e to h. l_i, off by 5 far 2 1680 u far for |r_ij|
 * twice, adds 3400 u far^2 |H^-1|, as steps are at most 0.1. So 7000 u far^2 |H^-1| is subtracted from the limit of h.
 * This keeps e below 0.07, so H is definite, too. The weak inequality of `det` keeps the rounding errors of w and of
 * the step below the margins of 0.72, 0.249 and 0.999. K(n,n) / 2 is off by 5500 u far^2 step^2, which makes 0.3 e
 * step, and by 0.4 e step because H^-1 and n are. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_root(const footpoint_detail_KIND_terms *of,
                                                    const footpoint_detail_local *r,
                                                    const footpoint_detail_newton *n, REAL ball,
                                                    REAL x, REAL y, int corrected, REAL *error)
{
    const REAL unit = 1.12e-16, mixed = fabs(n->r12);
    const REAL inner = footpoint_detail_KIND_inner(of, x, y);
    const REAL third = of->net.third[0] + inner, fourth = of->net.third[1] + inner;
    const REAL u = footpoint_detail_sum(r->u), v = footpoint_detail_sum(r->v);
    const REAL d = footpoint_detail_sum(r->d), far = d + of->net.far,
               uv = footpoint_detail_sum(r->uv);
    const REAL a1 = footpoint_detail_sum(r->uu) + uv + ball * third;
    const REAL a2 = footpoint_detail_sum(r->vv) + uv + ball * fourth, a = a1 + a2;
    const REAL r1 = u + ball * a1, r2 = v + ball * a2, both = r1 + r2, away = d + ball * both;
    const REAL l1 = r1 * a + 2.0 * both * a1 + away * third;
    const REAL l2 = r2 * a + 2.0 * both * a2 + away * fourth;
    REAL rows[2], step, off, w, e, h, other;
    footpoint_detail_KIND_off(&of->net, u, v, d, 0.0, rows);
    off = footpoint_detail_net_most(n->r22 * rows[0] + mixed * rows[1],
                                    n->r11 * rows[1] + mixed * rows[0]);
    w = footpoint_detail_net_most(n->r22 * l1 + mixed * l2, mixed * l1 + n->r11 * l2);
    e = 7000.0 * unit * (far * far) * (footpoint_detail_net_most(n->r11, n->r22) + mixed);
    step = footpoint_detail_net_most(fabs(n->s), fabs(n->t));
    e *= n->per;
    off = n->per * off + (corrected ? 0.5 : 0.3) * e * step;
    h = w * n->per * (step + 2.0 * off);
    *error = 0.72 * h * step + 1.2 * off;
    if (corrected) {
        const REAL some = 0.72 * away, more = 0.24 * ball, most = step + off, rate = h + e * step;
        const REAL sum = third + fourth;
        const REAL k1 = some * third + more * (2.0 * both * third + 3.0 * a1 * a + r1 * sum);
        const REAL k2 = some * fourth + more * (2.0 * both * fourth + 3.0 * a2 * a + r2 * sum);
        const REAL k =
            footpoint_detail_net_most(n->r22 * k1 + mixed * k2, mixed * k1 + n->r11 * k2);
        *error = (0.77 * rate * rate + n->per * k * most) * most + 1.3 * off;
    }
    other = 0.249 - (h + e);
    return footpoint_detail_bits(other) | footpoint_detail_bits(ball - 1.25 * (step + off)) |
           footpoint_detail_bits(footpoint_detail_KIND_ball(x, y) - ball) |
           footpoint_detail_bits(1.01 - of->net.tilt) | footpoint_detail_bits(n->r11) |
           footpoint_detail_bits(n->det * (1.0 - 1e-6) - 1e-6 * (n->r12 * n->r12)) |
           footpoint_detail_fast();
}

/* Clamps the end (s,t) of a step to the patch, as (*p,*q). The highest bit of the result is not set if an error up to
 * `error` keeps the promise nevertheless. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_keeps(REAL s, REAL t, REAL error, REAL promise,
                                                     REAL *p, REAL *q)
{
    REAL room;
    *p = footpoint_detail_KIND_kept(s);
    *q = footpoint_detail_KIND_kept(t);
    room = footpoint_detail_net_most(fabs(s - *p), fabs(t - *q)) + error;
    room = 0.999 * promise - room;
    return footpoint_detail_bits(room) | footpoint_detail_infinite(room);
}

/* Takes Newton's step from (*p,*q), whose surface is r, clamped to the patch. The highest bit of the result is not set
 * if the answer is proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_step(const footpoint_detail_KIND_terms *of,
                                                    const footpoint_detail_local *r, REAL ball,
                                                    REAL promise, REAL *p, REAL *q)
{
    footpoint_detail_newton n;
    REAL_BITS doubt;
    REAL error;
    footpoint_detail_newton_of(r, &n);
    doubt = footpoint_detail_KIND_root(of, r, &n, ball, *p, *q, 0, &error);
    return doubt | footpoint_detail_KIND_keeps(*p + n.s, *q + n.t, error, promise, p, q);
}

/* Takes up to `most` of Chebyshev's steps from (*xi,*eta), clamped to the patch, without proof, until one is below
 * `small`. All but the first count third derivatives. */
FOOTPOINT_APART void footpoint_detail_KIND_bare_steps(const REAL *const *x, int most, REAL small,
                                                      REAL *xi, REAL *eta)
{
    footpoint_detail_KIND_terms of;
    REAL p, q;
    footpoint_detail_KIND_expand(x, &of);
    p = *xi;
    q = *eta;
    footpoint_detail_KIND_bare(&of, xi, eta);
    while (--most && fabs(*xi - p) + fabs(*eta - q) > small) {
        footpoint_detail_local r;
        footpoint_detail_newton n;
        REAL h[2];
        p = *xi;
        q = *eta;
        footpoint_detail_KIND_local(&of, p, q, &r);
        footpoint_detail_newton_of(&r, &n);
        footpoint_detail_KIND_chebyshev(&r, &n, h);
        footpoint_detail_KIND_bend(&of, p, q, &r, &n, h);
        *xi = footpoint_detail_KIND_kept(p + h[0]);
        *eta = footpoint_detail_KIND_kept(q + h[1]);
    }
}

/* Computes xi, eta and the gap (9) from the end of a search, by `bare` steps and a proved step, or the next two inside
 * the patch if their steps are short. If the last step is short (`near`), the gap and its normal follow from the values
 * before it, to its second order. */
FOOTPOINT_APART REAL_BITS footpoint_detail_KIND_patch(const REAL *const *x, REAL promise, int bare,
                                                      int near, REAL least, REAL *xi, REAL *eta,
                                                      REAL *gap)
{
    footpoint_detail_KIND_terms of;
    footpoint_detail_local r;
    footpoint_detail_newton n;
    REAL_BITS doubt = 0, goes_on = (REAL_BITS)1 << REAL_TOP;
    REAL p = 0.0, q = 0.0, size;
    int k = 0;
    footpoint_detail_KIND_expand(x, &of);
    do {
        p = *xi;
        q = *eta;
        footpoint_detail_KIND_local(&of, p, q, &r);
        if (k < bare) {
            footpoint_detail_newton_of(&r, &n);
            footpoint_detail_KIND_correct(&r, &n, xi, eta);
        } else {
            doubt = footpoint_detail_KIND_step(&of, &r, 0.25 * footpoint_detail_KIND_ball(p, q),
                                               promise, xi, eta);
            if (!(doubt >> REAL_TOP))
                break;
            goes_on = footpoint_detail_below(*xi - p, 0.25) &
                      footpoint_detail_below(*eta - q, 0.25) & footpoint_detail_below(*xi, 1.0) &
                      footpoint_detail_below(*eta, 1.0);
        }
    } while (++k < bare + 3 && goes_on >> REAL_TOP);
    if (near)
        footpoint_detail_net_follow(*xi - p, *eta - q, &r);
    else
        footpoint_detail_KIND_local(&of, *xi, *eta, &r);
    size = of.net.base * of.net.base;
    return doubt | footpoint_detail_normal_gap(r.u, r.v, r.d, size, size, 0.0625 * size, least,
                                               *xi + *eta, gap);
}
