/* Patches from a near start. */

/* Returns its highest bit set if (xi,eta) is more than half of the patch away from loc, or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_strayed(const REAL loc[2], REAL xi, REAL eta)
{
    return footpoint_detail_above(xi - loc[0], 1.0) | footpoint_detail_above(eta - loc[1], 1.0);
}

/* Moves from loc to the foot point (*xi,*eta) and computes the gap there. It takes Chebyshev's steps until Newton's or
 * Chebyshev's is so short that it mostly can be proved. The highest bit of the result is not set if a minimum of the
 * distance is proved to lie within `promise` of the answer, which is at most half of the patch away from loc. Any loc is
 * allowed, also NaN. Nothing is proved if a step leaves the patch. */
FOOTPOINT_APART REAL_BITS footpoint_detail_KIND_from(const REAL *const *x, REAL promise, REAL least,
                                                     const REAL loc[2], REAL *xi, REAL *eta,
                                                     REAL *gap)
{
    footpoint_detail_KIND_terms of;
    footpoint_detail_local r;
    footpoint_detail_newton n;
    REAL_BITS doubt = (REAL_BITS)1 << REAL_TOP;
    REAL p, q, size, error, step = 1.0, h[2] = {0.0, 0.0};
    int k;
    *gap = 0.0;
    if (footpoint_detail_infinite(loc[0] + loc[1]) >> REAL_TOP)
        return doubt; /* comparisons with NaN raise exceptions */
    p = footpoint_detail_KIND_kept(loc[0]);
    q = footpoint_detail_KIND_kept(loc[1]);
    footpoint_detail_KIND_expand(x, &of);
    for (k = 0; k < 5 && doubt >> REAL_TOP; k++) {
        const REAL x0 = p, y0 = q;
        footpoint_detail_KIND_local(&of, p, q, &r);
        footpoint_detail_newton_of(&r, &n);
        step = footpoint_detail_net_most(fabs(n.s), fabs(n.t));
        if ((footpoint_detail_above(p + n.s, 1.0 + promise) |
             footpoint_detail_above(q + n.t, 1.0 + promise)) >>
            REAL_TOP)
            return doubt;
        if (4.0 * step * step < promise) {
            const REAL ball = footpoint_detail_KIND_proof_ball(step);
            doubt = footpoint_detail_KIND_root(&of, &r, &n, ball, p, q, 0, &error);
            doubt |= footpoint_detail_KIND_keeps(p + n.s, q + n.t, error, promise, &p, &q);
        } else {
            footpoint_detail_KIND_chebyshev(&r, &n, h);
            if (step * step * (0.1 + 10.0 * step) < promise) {
                const REAL ball = 1.5 * step + 1e-6;
                doubt = footpoint_detail_KIND_root(&of, &r, &n, ball, p, q, 1, &error);
                doubt |= footpoint_detail_KIND_keeps(p + h[0], q + h[1], error, promise, &p, &q);
            } else {
                p = footpoint_detail_KIND_kept(p + h[0]);
                q = footpoint_detail_KIND_kept(q + h[1]);
            }
        }
        h[0] = p - x0;
        h[1] = q - y0;
    }
    *xi = p;
    *eta = q;
    if (step < 1e-3)
        footpoint_detail_net_follow(h[0], h[1], &r);
    else
        footpoint_detail_KIND_local(&of, p, q, &r);
    size = of.net.base * of.net.base;
    return doubt | footpoint_detail_KIND_strayed(loc, p, q) |
           footpoint_detail_normal_gap(r.u, r.v, r.d, size, size, 0.0625 * size, least, p + q, gap);
}

/* Answers if that proves nothing. It takes steps from loc that keep to the patch and may follow its border, then
 * searches from scratch. The unit of length is as in footpoint_detail_KIND_answer(). */
FOOTPOINT_COLD int footpoint_detail_KIND_further(footpoint_detail_search *search,
                                                 const REAL *const *x, REAL promise, REAL loc[2],
                                                 REAL *gap)
{
    footpoint_detail_KIND_terms of;
    REAL y[VECTORS][3], at[2], g;
    const REAL *z[VECTORS];
    int exponent = 0, status, i;
    if (footpoint_detail_infinite(loc[0] + loc[1]) >> REAL_TOP ||
        footpoint_detail_scale(x, NODES, VECTORS, y, &exponent) != FOOTPOINT_OK)
        return footpoint_detail_KIND_answer(search, x, NODES, promise, loc, gap);
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    at[0] = footpoint_detail_KIND_kept(loc[0]);
    at[1] = footpoint_detail_KIND_kept(loc[1]);
    footpoint_detail_KIND_expand(z, &of);
    status = footpoint_detail_KIND_steps(&of, promise, at);
    if (status != FOOTPOINT_UNPROVED) {
        const REAL_BITS doubt = footpoint_detail_KIND_strayed(loc, at[0], at[1]) |
                                footpoint_detail_KIND_gap(z, at[0], at[1], 1e-6, &g);
        g = ldexp(g, exponent);
        if (!((doubt | footpoint_detail_infinite(g)) >> REAL_TOP)) {
            loc[0] = at[0];
            loc[1] = at[1];
            *gap = g;
            return status;
        }
    }
    return footpoint_detail_KIND_answer(search, x, NODES, promise, loc, gap);
}
