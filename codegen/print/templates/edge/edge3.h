/* Edges of three nodes: the cubic whose roots are feet of perpendiculars, and proofs about it. */

/* Holds an edge r = C + xi h / 2 + xi^2 k / 2 with h = B - A and k = (A - C) + (B - C). With s = S - C, the derivative
 * of 2 |S - r|^2 is c[0] + xi (c[1] + xi (c[2] + xi c[3])), c[3] >= 0. At minima it rises from < 0 to > 0. */
struct footpoint_detail_parabola {
    REAL h[2], k[2], s[2], c[4];
    REAL hh, size,
        far;      /* squares of lengths: h; h and k together, twice that for A - C and B - C; s */
    REAL wide[2]; /* |A - C| + |B - C|, by coordinates */
};

FOOTPOINT_PART void footpoint_detail_edge3_parabola(const REAL *const *x,
                                                    struct footpoint_detail_parabola *e)
{
    const REAL ax = x[0][0] - x[2][0], ay = x[0][1] - x[2][1];
    const REAL bx = x[1][0] - x[2][0], by = x[1][1] - x[2][1];
    REAL kk;
    e->h[0] = x[1][0] - x[0][0];
    e->h[1] = x[1][1] - x[0][1];
    e->k[0] = ax + bx;
    e->k[1] = ay + by;
    e->s[0] = x[3][0] - x[2][0];
    e->s[1] = x[3][1] - x[2][1];
    e->wide[0] = fabs(ax) + fabs(bx);
    e->wide[1] = fabs(ay) + fabs(by);
    e->hh = footpoint_detail_plane_dot(e->h, e->h);
    kk = footpoint_detail_plane_dot(e->k, e->k);
    e->size = e->hh + kk;
    e->far = footpoint_detail_plane_dot(e->s, e->s);
    e->c[0] = -2.0 * footpoint_detail_plane_dot(e->h, e->s);
    e->c[1] = e->hh - 4.0 * footpoint_detail_plane_dot(e->k, e->s);
    e->c[2] = 3.0 * footpoint_detail_plane_dot(e->h, e->k);
    e->c[3] = 2.0 * kk;
}

/* Computes the cubic at xi, its slope, and half its second derivative. */
FOOTPOINT_PART void footpoint_detail_edge3_values(const REAL c[4], REAL xi, REAL f[3])
{
    const REAL bent = 3.0 * c[3] * xi;
    f[0] = c[0] + xi * (c[1] + xi * (c[2] + xi * c[3]));
    f[1] = c[1] + xi * (2.0 * c[2] + bent);
    f[2] = c[2] + bent;
}

/* Bounds rounding errors at x = |xi|: the result bounds those of the cubic, and what a step below 1/256 leaves of it; 4
 * times the result those of its slope and of half its second derivative.  In units of rounding, h and s are off by one,
 * k by two of `wide`, whose square is at most `size`.  So c[3] is off by 12 size, c[2] by 18, c[1] by 5 and by 24
 * |wide| |s|, c[0] by 8 of these.  The polynomial adds 6, 5, 3 and 1 roundings of its terms; 2 |wide| |s| <= size +
 * far. */
FOOTPOINT_PART REAL footpoint_detail_edge3_rounding(const struct footpoint_detail_parabola *e,
                                                    REAL x)
{
    return REAL_UNIT *
           (e->size * (14.0 + x * (36.0 + x * (42.0 + x * 26.0))) + e->far * (8.0 + x * 20.0));
}

/* Returns a step of third order, back from xi. */
FOOTPOINT_PART REAL footpoint_detail_edge3_step(const REAL f[3])
{
    return f[0] * f[1] / (f[1] * f[1] - f[0] * f[2]);
}

/* Proves a step: the highest bit of the result is not set if a minimum is proved to lie within the promise of xi -
 * step. The slope of the cubic there is at least `slope`, as c[3] >= 0, and nearly so within the promise. Rounding, and
 * the rest that the step leaves of the cubic, are below that times the promise, so that the cubic changes sign within
 * it. If a number is not finite, then the tangent at xi - step, which the gap needs, is not finite, or the inequality
 * fails. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge3_prove(const struct footpoint_detail_parabola *e,
                                                      const REAL f[3], REAL xi, REAL step,
                                                      REAL promise)
{
    const REAL bend = step * (f[2] - step * e->c[3]), mean = f[1] - bend, slope = mean - bend;
    const REAL rest = fabs(f[0] - step * mean);
    const REAL left = 0.99 * promise * slope - rest - footpoint_detail_edge3_rounding(e, fabs(xi));
    return footpoint_detail_bits(left) | footpoint_detail_above(step, 0.00390625) |
           footpoint_detail_fast();
}

/* Computes the tangent, twice r', and S - r, both in the unit of the nodes. */
FOOTPOINT_PART void footpoint_detail_edge3_frame(const struct footpoint_detail_parabola *e, REAL xi,
                                                 REAL t[2], REAL d[2])
{
    const REAL half = 0.5 * xi;
    int j;
    FOOTPOINT_UNROLL
    for (j = 0; j < 2; j++) {
        t[j] = e->h[j] + 2.0 * xi * e->k[j];
        d[j] = e->s[j] - half * (e->h[j] + xi * e->k[j]);
    }
}

/* Computes the gap; the highest bit of the result is set if the edge turns back, so that there is no normal. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge3_gap(const struct footpoint_detail_parabola *e,
                                                    REAL xi, REAL *gap)
{
    const REAL twice = xi + xi, quarter = 0.25 * xi;
    const REAL t[2] = {e->h[0] + twice * e->k[0], e->h[1] + twice * e->k[1]};
    const REAL d[2] = {e->s[0] - quarter * (e->h[0] + t[0]), e->s[1] - quarter * (e->h[1] + t[1])};
    const REAL tt = footpoint_detail_plane_dot(t, t);
    *gap = footpoint_detail_plane_cross(d, t) / sqrt(tt);
    return footpoint_detail_bits(tt - REAL_FLAT * e->size) | footpoint_detail_outside(tt);
}

/* Returns xi of the slave node's projection on AB, from which steps start. */
FOOTPOINT_PART REAL footpoint_detail_edge3_begin(const struct footpoint_detail_parabola *e)
{
    return -e->c[0] / e->hh;
}

/* Takes a step, and another whose end is proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge3_proceed(const struct footpoint_detail_parabola *e,
                                                        REAL promise, REAL *xi)
{
    REAL f[3], step;
    REAL_BITS flaw;
    footpoint_detail_edge3_values(e->c, *xi, f);
    *xi -= footpoint_detail_edge3_step(f);
    footpoint_detail_edge3_values(e->c, *xi, f);
    step = footpoint_detail_edge3_step(f);
    flaw = footpoint_detail_edge3_prove(e, f, *xi, step, promise);
    *xi -= step;
    return flaw;
}

FOOTPOINT_PART void footpoint_detail_edge3_at(const REAL *const *x, REAL *xi)
{
    struct footpoint_detail_parabola e;
    footpoint_detail_edge3_parabola(x, &e);
    *xi = footpoint_detail_edge3_begin(&e);
    (void)footpoint_detail_edge3_proceed(&e, 1.0, xi);
}

/* Finds the foot point.  The highest bit of the result is set unless xi is proved and there is a gap. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge3_locate(const REAL *const *x, REAL promise, REAL *xi,
                                                       REAL *gap)
{
    struct footpoint_detail_parabola e;
    REAL_BITS flaw;
    footpoint_detail_edge3_parabola(x, &e);
    *xi = footpoint_detail_edge3_begin(&e);
    flaw = footpoint_detail_edge3_proceed(&e, promise, xi);
    return flaw | footpoint_detail_edge3_gap(&e, *xi, gap);
}

/* Finds the foot point from the last answer. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge3_follow(const REAL *const *x, REAL promise, REAL *xi,
                                                       REAL *gap)
{
    struct footpoint_detail_parabola e;
    const REAL from = *xi;
    REAL_BITS flaw;
    footpoint_detail_edge3_parabola(x, &e);
    flaw = footpoint_detail_edge3_proceed(&e, promise, xi);
    return flaw | footpoint_detail_edge3_gap(&e, *xi, gap) |
           footpoint_detail_above(*xi - from, 1.0);
}

/* Computes shape functions, their derivatives and second derivatives. */
FOOTPOINT_PART void footpoint_detail_edge3_shape(REAL xi, REAL *phi, REAL *slope, REAL *bend)
{
    phi[0] = 0.5 * xi * (xi - 1.0);
    phi[1] = 0.5 * xi * (xi + 1.0);
    phi[2] = 1.0 - xi * xi;
    slope[0] = xi - 0.5;
    slope[1] = xi + 0.5;
    slope[2] = -2.0 * xi;
    bend[0] = bend[1] = 1.0;
    bend[2] = -2.0;
}

/* Computes the line through the slave node in the direction p, and S - r. */
FOOTPOINT_PART void footpoint_detail_edge3_line(const REAL *const *x, const REAL p[2],
                                                struct footpoint_detail_line *l)
{
    struct footpoint_detail_parabola e;
    footpoint_detail_edge3_parabola(x, &e);
    l->a[0] = -2.0 * footpoint_detail_plane_cross(p, e.s);
    l->a[1] = footpoint_detail_plane_cross(p, e.h);
    l->a[2] = footpoint_detail_plane_cross(p, e.k);
    l->far = 2.0 * footpoint_detail_plane_across(p, e.s[0], e.s[1]);
    l->wide = footpoint_detail_plane_across(p, e.wide[0], e.wide[1]);
}

FOOTPOINT_PART void footpoint_detail_edge3_way(const REAL *const *x, REAL xi, REAL d[2])
{
    struct footpoint_detail_parabola e;
    REAL t[2];
    footpoint_detail_edge3_parabola(x, &e);
    footpoint_detail_edge3_frame(&e, xi, t, d);
}
