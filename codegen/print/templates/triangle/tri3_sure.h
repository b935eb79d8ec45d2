/* The proof of closest points of the closed triangle, whose squared distance is convex. */

/* Returns a, b or c. */
FOOTPOINT_PART REAL footpoint_detail_tri3_choose(const REAL how[4], REAL a, REAL b, REAL c)
{
    const REAL base = 1.0 - how[3]; /* inside: a */
    return footpoint_detail_either(base * how[1], footpoint_detail_either(base * how[0], a, b), c);
}

/* Proves an answer: the highest bit of the result is not set if the closest point of the triangle is proved to lie
 * within `promise` of the result of footpoint_detail_tri3_find.
 *
 * From corner P, the first of the nearest edge, or A, edges e and h lead to the next corners. Let r = P + a e + b h, D
 * = xS - r, and slopes F = e . D and G = h . D. Let (s,t) lead from here to the closest point. At that point no
 * feasible direction leads downhill, so |s e + t h|^2 <= s F + t G. Terms < 0 of feasible steps are left out: f and g
 * bound the slopes F and G of the others. So |s e + t h|^2 <= 2 (hh f^2 + ee g^2) / |e x h|^2, and s^2 and t^2 are at
 * most hh and ee over |e x h|^2 times that. At the end of e, feasible steps lead along -e and h - e. On an edge, xi and
 * eta change by at most |s| + |t|.
 *
 * If G leads outwards even at the closest point of the edge, by e . h s, then that point is the closest of all, and s
 * is at most f / ee.
 *
 * Rounding, as in footpoint_detail_tri3_prove: D is off by 4 units of T, slopes by 9 of |e| . T and |h| . T. More than
 * half of |e x h|^2 is left, because it exceeds REAL_FLAT of the square of all edges. On an edge, xi and eta add up to
 * 1 within a unit. 16 REAL_MIN exceed all underflow. */
FOOTPOINT_PART REAL_BITS footpoint_detail_tri3_sure(const REAL *const *x, REAL promise,
                                                    const REAL at[3], const REAL how[4])
{
    const REAL unit = REAL_UNIT, inside = how[3], edge = 1.0 - inside;
    const REAL a = footpoint_detail_either(inside, how[2], at[0]), b = inside * at[1];
    const REAL start = edge * footpoint_detail_step(REAL_MIN - a);
    const REAL end = edge * footpoint_detail_step(a - 1.0);
    REAL e[3], h[3], n[3], ee, hh, nn, m = 0.0, F = 0.0, G = 0.0, off_f = 0.0, off_g = 0.0;
    REAL f, g, most, moved, room, other, out;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL p = footpoint_detail_tri3_choose(how, x[0][i], x[1][i], x[2][i]);
        const REAL w = x[3][i] - p;
        REAL d, all;
        e[i] = footpoint_detail_tri3_choose(how, x[1][i], x[2][i], x[0][i]) - p;
        h[i] = footpoint_detail_tri3_choose(how, x[2][i], x[0][i], x[1][i]) - p;
        d = w - a * e[i] - b * h[i];
        all = fabs(w) + fabs(a * e[i]) + fabs(b * h[i]);
        F += e[i] * d;
        G += h[i] * d;
        off_f += fabs(e[i]) * all;
        off_g += fabs(h[i]) * all;
        m += fabs(e[i] * h[i]);
    }
    footpoint_detail_cross(e, h, n);
    ee = footpoint_detail_dot(e, e);
    hh = footpoint_detail_dot(h, h);
    nn = footpoint_detail_dot(n, n);
    off_f *= 9.0 * unit;
    off_g *= 9.0 * unit;
    f = footpoint_detail_either(end, footpoint_detail_either(start, fabs(F), F), -F) + off_f;
    g = footpoint_detail_either(inside, G + off_g + end * (off_f - F), fabs(G) + off_g);
    f = 0.5 * (f + fabs(f));
    g = 0.5 * (g + fabs(g));
    moved = 1.01 * f / (ee + REAL_MIN);
    out = -(G + 1.01 * (off_g + m * moved));
    room = 0.99 * promise - moved;
    /* at the end of e, h - e replaces h */
    hh = footpoint_detail_either(end, hh, 2.0 * (ee + hh));
    most = 0.5 * (ee + hh + fabs(ee - hh)) * footpoint_detail_either(inside, 8.0, 2.0);
    other = 0.49 * promise * nn;
    other = other * other - most * (hh * (f * f) + ee * (g * g));
    return ((footpoint_detail_bits(room) | footpoint_detail_bits(out) |
             footpoint_detail_bits(0.5 - inside)) &
            footpoint_detail_bits(other - 16.0 * REAL_MIN)) |
           footpoint_detail_infinite(room + other + out) | footpoint_detail_tri3_fast();
}

/* Finds an answer with its proof, the square of the distance in at.  FOOTPOINT_UNPROVED also if nodes may need another
 * unit of length. */
FOOTPOINT_PART int footpoint_detail_tri3_nearby(const REAL *const *x, REAL promise, REAL least,
                                                REAL at[3], int *region)
{
    REAL how[4];
    const int status = footpoint_detail_tri3_find(x, least, at, how, region);
    const int doubt = (int)(footpoint_detail_tri3_sure(x, promise, at, how) >> REAL_TOP);
    const int open = (status == FOOTPOINT_ERR_DEGENERATE) | ((status == FOOTPOINT_OK) & doubt);
    return FOOTPOINT_UNPROVED * open + status * (1 - open);
}

/* Does the same in a unit of length in which the triangle is about 1 long, with the distance in at. */
FOOTPOINT_COLD int footpoint_detail_tri3_proved_again(footpoint_detail_nearby *nearby,
                                                      const REAL *const *x, int scalable,
                                                      REAL promise, REAL at[3], int *region)
{
    REAL y[VECTORS][3], how[4];
    const REAL *z[VECTORS];
    int exponent = 0, i, status = footpoint_detail_scale(x, NODES, VECTORS, y, &exponent);
    (void)nearby;
    (void)scalable;
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    status = footpoint_detail_tri3_find(z, 1e-6, at, how, region);
    if (status == FOOTPOINT_OK && footpoint_detail_tri3_sure(z, promise, at, how) >> REAL_TOP)
        status = FOOTPOINT_UNPROVED;
    at[2] = ldexp(footpoint_detail_signed_root(at[2]), exponent);
    return status;
}

/* Returns a lower bound on the distance of the triangle. The squared distance is convex, so along the way to a corner
 * it falls by at most twice the slope. */
FOOTPOINT_COLD REAL footpoint_detail_tri3_none_nearer(const REAL *const *x, REAL promise,
                                                      int status, const REAL at[3])
{
    REAL u[3], v[3], d[3], f, g, most, size, least;
    (void)promise;
    if (status == FOOTPOINT_OK)
        return fabs(at[2]);
    footpoint_detail_tri3_surface(x, at[0], at[1], u, v, d);
    f = footpoint_detail_dot(u, d);
    g = footpoint_detail_dot(v, d);
    most = f > g ? f : g;
    most = (most > 0.0 ? most : 0.0) - at[0] * f - at[1] * g;
    size = footpoint_detail_dot(u, u) + footpoint_detail_dot(v, v) + footpoint_detail_dot(d, d);
    least = footpoint_detail_dot(d, d) - 2.0 * most - 900.0 * REAL_UNIT * size;
    return sqrt(least > 0.0 ? least : 0.0);
}
