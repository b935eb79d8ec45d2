/* Proved answers of plane triangles, from any search. */

/* Returns its highest bit set if the compiler may change results, in which case nothing is proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_tri3_fast(void)
{
    return (REAL_BITS)FOOTPOINT_LOOSE << REAL_TOP;
}

/* Takes a Newton step from (xi,eta) to the foot point of a plane triangle, which it reaches up to rounding. The highest
 * bit of the result is not set if the foot point is proved to lie within promise * max(1, |xi|, |eta|) of the answer.
 *
 * Let e be the unit of rounding, and u, v and w the edges AB, AC and AS. Coordinates of d = w - xi u - eta v are off by
 * 4 e T with T = |w| + |xi u| + |eta v|. So f = u . d is off by e |u| . (4 T + 5 |d|), and g = v . d likewise, for sums
 * in any order. Products of edges are off by 5 e uu, 5 e vv and 5 e m with m >= |u . v|. The determinant is off by 24 e
 * uu vv, at most REAL_CRAMER / 1.2 of itself. So REAL_CRAMER of f and g covers Cramer's rule, and 1.01 covers the
 * rounding of bounds. */
FOOTPOINT_PART REAL_BITS footpoint_detail_tri3_prove(const REAL *const *x, REAL promise, REAL *xi,
                                                     REAL *eta)
{
    const REAL p = *xi, q = *eta, unit = REAL_UNIT;
    REAL uu = 0.0, uv = 0.0, vv = 0.0, m = 0.0, f = 0.0, g = 0.0, ut = 0.0, vt = 0.0;
    REAL det, per, s, t, off_f, off_g, first, second, greater, room, other;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL u = x[1][i] - x[0][i], v = x[2][i] - x[0][i], w = x[3][i] - x[0][i];
        const REAL d = w - p * u - q * v,
                   all = 4.0 * (fabs(w) + fabs(p * u) + fabs(q * v)) + 5.0 * fabs(d);
        uu += u * u;
        uv += u * v;
        vv += v * v;
        m += fabs(u * v);
        f += u * d;
        g += v * d;
        ut += fabs(u) * all;
        vt += fabs(v) * all;
    }
    det = uu * vv - uv * uv;
    per = 1.0 / det;
    s = (vv * f - uv * g) * per;
    t = (uu * g - uv * f) * per;
    off_f = unit * ut + REAL_CRAMER * fabs(f);
    off_g = unit * vt + REAL_CRAMER * fabs(g);
    *xi = p + s;
    *eta = q + t;
    first = vv * off_f + m * off_g;
    second = uu * off_g + m * off_f;
    greater = 0.5 * (fabs(*xi) + fabs(*eta) + fabs(fabs(*xi) - fabs(*eta)));
    room = 0.99 * promise * (0.5 * (1.0 + greater + fabs(1.0 - greater)));
    other = room - 1.01 * per * second;
    room -= 1.01 * per * first;
    return footpoint_detail_bits(room) | footpoint_detail_bits(other) |
           footpoint_detail_bits(det - REAL_WEAK * (uu * vv)) |
           footpoint_detail_infinite(room + other + *xi + *eta) | footpoint_detail_tri3_fast();
}

/* Answers if a search leaves a doubt: repeats it in a unit of length in which the triangle is about 1 long. */
FOOTPOINT_COLD int footpoint_detail_tri3_answer(footpoint_detail_search *search,
                                                const REAL *const *x, int nodes, REAL promise,
                                                REAL loc[2], REAL *gap)
{
    REAL y[VECTORS][3], xi, eta, g;
    const REAL *z[VECTORS];
    int exponent = 0, i, unproved;
    const int status = footpoint_detail_scale(x, nodes, VECTORS, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    if (search(z, 1, 0.0, &xi, &eta, &g) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    unproved = (int)(footpoint_detail_tri3_prove(z, promise, &xi, &eta) >> REAL_TOP);
    if (footpoint_detail_tri3_gap(z, xi, eta, 1e-6, &g) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    g = ldexp(g, exponent);
    if (footpoint_detail_infinite(g) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE; /* the distance overflows */
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return unproved ? FOOTPOINT_UNPROVED : FOOTPOINT_OK;
}
