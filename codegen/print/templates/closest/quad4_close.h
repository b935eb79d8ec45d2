/* The closest point of a closed bilinear segment, with its proof, from scalar products that a search has. */

/* Finds the point v of the edge u = e nearest to xS, clamped, and returns its slope outwards; a, b, ... in products as in
 * footpoint_detail_quad4_step.  For edges of v, exchange a and b. */
FOOTPOINT_PART REAL footpoint_detail_quad4_edge(int masked, REAL aa, REAL e12, REAL bb, REAL ac,
                                                REAL bc, REAL cc, REAL ad, REAL bd, REAL e, REAL *v)
{
    const REAL along = (bd - ac) - e * e12, square = bb + e * (bc + bc) + cc;
    REAL t = along / (square + REAL_MIN);
    t = footpoint_detail_greater_of(masked, -1.0, footpoint_detail_least_of(masked, t, 1.0));
    *v = t;
    return e * (ad - t * (e12 + t * bc)) - (aa + t * (ac + ac + t * cc));
}

/* Moves (u,v), if outside of the segment, to an edge or a corner: to xi = 1 or -1 if that has been crossed,
 * unless eta is outside, too, and the distance does not grow inwards there. */
FOOTPOINT_PART void footpoint_detail_quad4_inside(int masked, const REAL p[9], REAL *u, REAL *v)
{
    const REAL beyond_u = fabs(*u) - 1.0, beyond_v = fabs(*v) - 1.0, e12 = p[1] - p[8];
    const REAL outside = footpoint_detail_greater_of(masked, beyond_u, beyond_v);
    const REAL eu = copysign(1.0, *u), ev = copysign(1.0, *v);
    REAL s, t, on;
    on = footpoint_detail_quad4_edge(masked, p[0], e12, p[2], p[3], p[4], p[5], p[6], p[7], eu, &t);
    (void)footpoint_detail_quad4_edge(masked, p[2], e12, p[0], p[4], p[3], p[5], p[7], p[6], ev,
                                      &s);
    on = footpoint_detail_pick_of(masked, beyond_u,
                                  footpoint_detail_pick_of(masked, beyond_v, on, 1.0), -1.0);
    *u = footpoint_detail_pick_of(masked, outside, footpoint_detail_pick_of(masked, on, eu, s), *u);
    *v = footpoint_detail_pick_of(masked, outside, footpoint_detail_pick_of(masked, on, t, ev), *v);
}

/* Returns the region: 1 to 4: edges, 5 to 8: corners; 0 inside. */
FOOTPOINT_PART int footpoint_detail_quad4_region(REAL u, REAL v)
{
    const int left = u <= -1.0, right = u >= 1.0, below = v <= -1.0, above = v >= 1.0;
    return below + 3 * above + 4 * left + (left & above) + right * (2 + 3 * below + 2 * above);
}

/* Examines (u,v) of the closed segment: at = {u, v, square of the distance with its sign}.  The highest bit of the result is
 * not set if the closest point is proved to lie there, see footpoint_detail_quad4_sole; *beyond has its highest bit set if the
 * distance exceeds the longest edge.  Products of eight lengths must be finite, see footpoint_detail_outside. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_touch(const REAL p[9],
                                                      const footpoint_detail_quad4_vectors *r,
                                                      REAL promise, REAL per, REAL u, REAL v,
                                                      REAL at[3], REAL_BITS *beyond)
{
    footpoint_detail_quad4_local q;
    footpoint_detail_quad4_bounds bounds;
    const REAL apart = 8.0 * (r->size + p[5]);
    const REAL inside = footpoint_detail_least_of(r->masked, 1.0 - fabs(u), 1.0 - fabs(v));
    const REAL close =
        promise < REAL_FINE ? REAL_CLOSE : promise; /* proved for the whole segment */
    REAL x[3], y[3], w[3], n[3], nn, longest, f, g, grows, area;
    REAL_BITS doubt;
    int i;
    footpoint_detail_quad4_here(p, r, promise < close, u, v, x, y, w, &q, &bounds);
    area = bounds.wide * bounds.high;
    longest = 4.0 * footpoint_detail_greater_of(r->masked, bounds.wide, bounds.high);
    footpoint_detail_cross(x, y, n);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        n[i] *= copysign(1.0, per);
    nn = footpoint_detail_dot(n, n);
    at[0] = u;
    at[1] = v;
    at[2] =
        copysign(per * per * q.dd,
                 footpoint_detail_facing(n, w, q.dd, apart, apart * (q.uu + q.vv),
                                         footpoint_detail_pick_of(r->masked, inside, 0.0, 1.0)));
    *beyond = footpoint_detail_above(q.dd, longest);
    grows = footpoint_detail_quad4_grows(r->masked, u, q.f, bounds.off_f, &f);
    grows += footpoint_detail_quad4_grows(r->masked, v, q.g, bounds.off_g, &g);
    doubt = footpoint_detail_quad4_sole(&q, &bounds, close, f, g,
                                        footpoint_detail_quad4_least_det(&q, grows));
    if (promise < close)
        doubt |= footpoint_detail_quad4_within(&q, &bounds, close, promise);
    return doubt | footpoint_detail_outside(area * area) |
           footpoint_detail_bits(nn - footpoint_detail_greater_of(r->masked, 1e5 * REAL_UNIT,
                                                                  REAL_INWARD * REAL_INWARD) *
                                          area);
}

/* Moves from (xi,eta) to the closest point by one step, for the finest promise by two, from far outside directly;
 * FOOTPOINT_UNPROVED without a proof.  per: the factor of the vectors; lanes = 1: no branches, for a loop over
 * arrays, with the same result. */
FOOTPOINT_PART int footpoint_detail_quad4_close(const REAL products[9],
                                                const footpoint_detail_quad4_vectors *r,
                                                REAL promise, REAL per, int lanes, REAL xi,
                                                REAL eta, REAL at[3], int *region)
{
    const REAL far = footpoint_detail_greater_of(r->masked, fabs(xi), fabs(eta)) - 1.1;
    REAL u = xi, v = eta;
    REAL_BITS doubt, beyond;
    if (lanes || footpoint_detail_pick_of(r->masked, far, 0.0, 1.0) > 0.0) {
        (void)footpoint_detail_quad4_step(products, r, promise, &u, &v);
        if (promise < 1e-11)
            (void)footpoint_detail_quad4_step(products, r, promise, &u, &v);
    }
    u = footpoint_detail_pick_of(r->masked, far, xi, u);
    v = footpoint_detail_pick_of(r->masked, far, eta, v);
    footpoint_detail_quad4_inside(r->masked, products, &u, &v);
    doubt = footpoint_detail_quad4_touch(products, r, promise, per, u, v, at, &beyond);
    if (lanes || !(doubt >> REAL_TOP)) /* NaN raises no exception */
        *region = footpoint_detail_quad4_region(at[0], at[1]);
    return FOOTPOINT_UNPROVED * (int)(doubt >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((beyond & ~doubt) >> REAL_TOP);
}
