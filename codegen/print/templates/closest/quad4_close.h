/* The closest point of a closed bilinear segment from scalar products that a search has, with its proof. */

/* Of the edge u = e the point v nearest to xS, clamped, and its slope outwards; a, b, ... in products as in
 * footpoint_detail_quad4_step.  For edges of v, exchange a and b. */
FOOTPOINT_PART REAL footpoint_detail_quad4_edge(REAL aa, REAL e12, REAL bb, REAL ac, REAL bc,
                                                REAL cc, REAL ad, REAL bd, REAL e, REAL *v)
{
    const REAL along = (bd - ac) - e * e12, square = bb + e * (bc + bc) + cc;
    REAL t = along / (square + REAL_MIN);
    t = footpoint_detail_greater(-1.0, footpoint_detail_least(t, 1.0));
    *v = t;
    return e * (ad - t * (e12 + t * bc)) - (aa + t * (ac + ac + t * cc));
}

/* Where (u,v) is outside of the segment, moves it to an edge or a corner: of xi = 1 or -1 if that has been crossed,
 * unless eta is outside, too, and the distance does not grow inwards there. */
FOOTPOINT_PART void footpoint_detail_quad4_inside(const REAL p[9], REAL *u, REAL *v)
{
    const REAL beyond_u = fabs(*u) - 1.0, beyond_v = fabs(*v) - 1.0, e12 = p[1] - p[8];
    const REAL outside = footpoint_detail_greater(beyond_u, beyond_v);
    const REAL eu = copysign(1.0, *u), ev = copysign(1.0, *v);
    REAL s, t, on;
    on = footpoint_detail_quad4_edge(p[0], e12, p[2], p[3], p[4], p[5], p[6], p[7], eu, &t);
    (void)footpoint_detail_quad4_edge(p[2], e12, p[0], p[4], p[3], p[5], p[7], p[6], ev, &s);
    on = footpoint_detail_pick(beyond_u, footpoint_detail_pick(beyond_v, on, 1.0), -1.0);
    *u = footpoint_detail_pick(outside, footpoint_detail_pick(on, eu, s), *u);
    *v = footpoint_detail_pick(outside, footpoint_detail_pick(on, t, ev), *v);
}

/* 1 to 4: edges, 5 to 8: corners; 0 inside. */
FOOTPOINT_PART int footpoint_detail_quad4_region(REAL u, REAL v)
{
    const int left = u <= -1.0, right = u >= 1.0, below = v <= -1.0, above = v >= 1.0;
    return below + 3 * above + 4 * left + (left & above) + right * (2 + 3 * below + 2 * above);
}

/* What slopes at (u,v), |u| and |v| up to p and q, are off by, finer: by Cauchy and Schwarz, of the bounds on coordinates
 * that footpoint_detail_quad4_vectors has.  Tangents are off by k + 2 units of theirs, xS - r by k + 5, the scalar product
 * adds 3: 2 k + 10 in all, and `rounding` has at least 2 k + 13. */
FOOTPOINT_PART void footpoint_detail_quad4_off_slopes(const REAL products[9],
                                                      const footpoint_detail_quad4_vectors *r,
                                                      REAL p, REAL q, REAL *f, REAL *g)
{
    const REAL a = footpoint_detail_root_bound(products[0]);
    const REAL b = footpoint_detail_root_bound(products[2]);
    const REAL c = footpoint_detail_root_bound(products[5]);
    const REAL first = a + c + 0.08 * b, second = b + c + 0.08 * a;
    const REAL turn = r->twist == 1 ? first : r->twist == 2 ? second : first + second;
    const REAL u = first + q * turn, v = second + p * turn;
    const REAL far =
        fabs(r->over) * footpoint_detail_sum(r->d) + (first + second) + p * first + q * v;
    *f = r->rounding * u * far;
    *g = r->rounding * v * far;
}

/* The highest bit of the result is not set if the closest point, known to be within `close` of q, is within promise: see
 * footpoint_detail_quad4_finer, of which this is the form without branches. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_within(const footpoint_detail_quad4_local *q,
                                                       const footpoint_detail_quad4_bounds *r,
                                                       REAL off_mixed, REAL close, REAL promise)
{
    const REAL in_u = 1.0 - fabs(q->u), in_v = 1.0 - fabs(q->v);
    const REAL bend = (4.0 * (fabs(q->uc) + fabs(q->vc)) + 2.0 * q->cc) * (close * close);
    const REAL f = fabs(q->f) + r->off_f + bend, g = fabs(q->g) + r->off_g + bend;
    const REAL mixed = q->uv - q->dc, turn = fabs(mixed) + off_mixed;
    const REAL det = q->uu * q->vv - mixed * mixed;
    const REAL held = 2.0 * close * (r->wide + r->high + fabs(q->dc));
    const REAL both =
        promise * det - 1.05 * footpoint_detail_greater(q->vv * f + turn * g, q->uu * g + turn * f);
    const REAL of_u = promise * q->uu - 1.05 * f, of_v = promise * q->vv - 1.05 * g;
    const REAL clear_u = footpoint_detail_pick(in_u, in_u - close, q->u * q->f - r->off_f - held);
    const REAL clear_v = footpoint_detail_pick(in_v, in_v - close, q->v * q->g - r->off_g - held);
    const REAL room = footpoint_detail_pick(in_u, footpoint_detail_pick(in_v, both, of_u),
                                            footpoint_detail_pick(in_v, of_v, 1.0));
    return footpoint_detail_bits(clear_u) | footpoint_detail_bits(clear_v) |
           footpoint_detail_bits(room) |
           footpoint_detail_bits(footpoint_detail_pick(footpoint_detail_least(in_u, in_v),
                                                       det - 1000.0 * r->off_det, 1.0)) |
           footpoint_detail_infinite(room + clear_u + clear_v);
}

/* At (u,v) of the closed segment: at = {u, v, square of the distance with its sign}.  The result's highest bit is
 * not set if the closest point is proved to lie there, see footpoint_detail_quad4_sole; *beyond has its set if the
 * distance is longer than the longest edge.
 *
 * Rounding, in units u = 1.12e-16 and with S = a . a + b . b + c . c, |xi| and |eta| <= 1: vectors are off by k u of
 * what bounds them, k <= 0.5 rounding / u - 6.5, products by `rounding`.  These bounds are at most 1.42 sqrt(S) for
 * a and b, 2.53 sqrt(S) for c and |D| + 3.5 sqrt(S) for d.  So slopes are off by (k + 3) u sqrt(S) (5.4 |D| + 12.6
 * sqrt(S)) or less; products at (u,v) by 26 S `rounding`, D . c by 29.3 S + 1.3 D . D of it, `mixed` by 55 S + 1.3 D
 * . D; and Q, as |t| <= 2 and, where Q > 0, |mixed| <= 2 S, by 40 S times that.  Products of eight lengths have to
 * be numbers, see footpoint_detail_outside. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_touch(const REAL p[9],
                                                      const footpoint_detail_quad4_vectors *r,
                                                      REAL promise, REAL per, REAL u, REAL v,
                                                      REAL at[3], REAL_BITS *beyond)
{
    footpoint_detail_quad4_local q;
    footpoint_detail_quad4_bounds bounds;
    const REAL size = r->size, off = r->rounding * size, apart = 8.0 * (size + p[5]);
    const REAL inside = footpoint_detail_least(1.0 - fabs(u), 1.0 - fabs(v));
    const REAL close = promise < 1e-11 ? 1e-9 : promise; /* what is proved of the whole segment */
    REAL x[3], y[3], w[3], n[3], nn, y12, longest, f, g, grows, area, reach;
    REAL_BITS doubt;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        x[i] = r->a[i] + v * r->c[i];
        y[i] = r->b[i] + u * r->c[i];
        w[i] = r->over * r->d[i] - u * r->a[i] - v * y[i];
    }
    q.u = u;
    q.v = v;
    q.cc = p[5];
    q.uc = p[3] + v * p[5];
    q.vc = p[4] + u * p[5];
    y12 = u * p[3] + v * q.vc;
    q.uu = p[0] + v * (p[3] + q.uc);
    q.vv = p[2] + u * (p[4] + q.vc);
    q.uv = p[1] + y12;
    q.dc = p[8] - y12;
    q.f = footpoint_detail_dot(x, w);
    q.g = footpoint_detail_dot(y, w);
    q.dd = footpoint_detail_dot(w, w);
    bounds.wide = p[0] + 2.0 * fabs(p[3]) + p[5] + 30.0 * off;
    bounds.high = p[2] + 2.0 * fabs(p[4]) + p[5] + 30.0 * off;
    reach = 6.0 * size + q.dd;
    bounds.off_f = bounds.off_g = (1.35 * r->rounding - 1e-15) * reach;
    if (promise < close)
        footpoint_detail_quad4_off_slopes(p, r, fabs(u), fabs(v), &bounds.off_f, &bounds.off_g);
    bounds.off_det = 375.0 * (off * reach);
    area = bounds.wide * bounds.high;
    longest = 4.0 * footpoint_detail_greater(bounds.wide, bounds.high);
    footpoint_detail_cross(x, y, n);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        n[i] *= copysign(1.0, per);
    nn = footpoint_detail_dot(n, n);
    at[0] = u;
    at[1] = v;
    at[2] = copysign(per * per * q.dd,
                     footpoint_detail_facing(n, w, q.dd, apart, apart * (q.uu + q.vv),
                                             footpoint_detail_pick(inside, 0.0, 1.0)));
    *beyond = footpoint_detail_above(q.dd, longest);
    grows = footpoint_detail_quad4_grows(u, q.f, bounds.off_f, &f);
    grows += footpoint_detail_quad4_grows(v, q.g, bounds.off_g, &g);
    doubt = footpoint_detail_quad4_sole(&q, &bounds, close, f, g,
                                        footpoint_detail_quad4_least_det(&q, grows));
    if (promise < close)
        doubt |= footpoint_detail_quad4_within(
            &q, &bounds, r->rounding * (55.0 * size + 1.3 * q.dd), close, promise);
    return doubt | footpoint_detail_outside(area * area) | footpoint_detail_bits(nn - REAL_INWARD * REAL_INWARD * area);
}

/* From (xi,eta) by one step, for the finest promise two, or from far outside none, to the closest point;
 * FOOTPOINT_UNPROVED if that is not proved.  per: the factor of the vectors; lanes = 1: no branches, for a loop over
 * arrays, with the same result. */
FOOTPOINT_PART int footpoint_detail_quad4_close(const REAL products[9],
                                                const footpoint_detail_quad4_vectors *r,
                                                REAL promise, REAL per, int lanes, REAL xi,
                                                REAL eta, REAL at[3], int *region)
{
    const REAL far = footpoint_detail_greater(fabs(xi), fabs(eta)) - 1.1;
    REAL u = xi, v = eta;
    REAL_BITS doubt, beyond;
    if (lanes || footpoint_detail_pick(far, 0.0, 1.0) > 0.0) {
        (void)footpoint_detail_quad4_step(products, r, promise, &u, &v);
        if (promise < 1e-11)
            (void)footpoint_detail_quad4_step(products, r, promise, &u, &v);
    }
    u = footpoint_detail_pick(far, xi, u);
    v = footpoint_detail_pick(far, eta, v);
    footpoint_detail_quad4_inside(products, &u, &v);
    doubt = footpoint_detail_quad4_touch(products, r, promise, per, u, v, at, &beyond);
    if (lanes || !(doubt >> REAL_TOP)) /* NaN raises no exception */
        *region = footpoint_detail_quad4_region(at[0], at[1]);
    return FOOTPOINT_UNPROVED * (int)(doubt >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((beyond & ~doubt) >> REAL_TOP);
}
