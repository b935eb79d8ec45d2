/* Four-node faces from a near start: one expansion about it, Newton's steps, and their proof. */

/* Expands r = A + s ab + t ad + s t c about (xi,eta) = (2 s - 1, 2 t - 1): u = r_s, v = r_t, c = r_st, w = xS - r. */
FOOTPOINT_PART void footpoint_detail_quad4_about(const REAL *const *x, REAL s, REAL t, REAL u[3],
                                                 REAL v[3], REAL c[3], REAL w[3])
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL ab = x[1][i] - x[0][i];
        c[i] = (x[2][i] - x[3][i]) - ab;
        u[i] = ab + t * c[i];
        v[i] = (x[3][i] - x[0][i]) + s * c[i];
        w[i] = ((x[4][i] - x[0][i]) - s * ab) - t * v[i];
    }
}

/* Holds the slopes (f,g) of half the squared distance at a point, its Hessian, and the Hessian's rate of change. */
typedef struct {
    REAL f, g, uu, r12, vv, tu, tv, cc;
} footpoint_detail_quad4_near;

/* Holds bounds for rounding errors, see footpoint_detail_quad4_from(): far^2; for fine promises also lengths. */
typedef struct {
    REAL square, far, u, v, w;
} footpoint_detail_quad4_scales;

/* Computes the slopes at a step (s,t) from the point. */
FOOTPOINT_PART void footpoint_detail_quad4_slopes(const footpoint_detail_quad4_near *r, REAL s,
                                                  REAL t, REAL *f, REAL *g)
{
    const REAL both = r->cc * s * t, tu = r->tu * s, tv = r->tv * t;
    *f = (r->f - r->uu * s - r->r12 * t) - t * ((2.0 * tu + tv) + both);
    *g = (r->g - r->r12 * s - r->vv * t) - s * ((2.0 * tv + tu) + both);
}

/* Moves slopes, Hessian and rate of change by a step (s,t). */
FOOTPOINT_PART footpoint_detail_quad4_near
footpoint_detail_quad4_moved(const footpoint_detail_quad4_near *r, REAL s, REAL t)
{
    const REAL up = s * r->cc, across = t * r->cc;
    footpoint_detail_quad4_near to;
    footpoint_detail_quad4_slopes(r, s, t, &to.f, &to.g);
    to.uu = r->uu + t * (2.0 * r->tu + across);
    to.vv = r->vv + s * (2.0 * r->tv + up);
    to.r12 = r->r12 + 2.0 * (s * r->tu + t * (r->tv + up));
    to.tu = r->tu + across;
    to.tv = r->tv + up;
    to.cc = r->cc;
    return to;
}

/* Computes (*x,*y) = adj H (f,g); returns the larger absolute value. */
FOOTPOINT_PART REAL footpoint_detail_quad4_adjoin(const footpoint_detail_quad4_near *r, REAL f,
                                                  REAL g, REAL *x, REAL *y)
{
    *x = r->vv * f - r->r12 * g;
    *y = r->uu * g - r->r12 * f;
    return footpoint_detail_greater(fabs(*x), fabs(*y));
}

/* Returns det H times a bound on rounding errors of steps within `whole` of the start. */
FOOTPOINT_PART REAL footpoint_detail_quad4_blur(const footpoint_detail_quad4_near *r, REAL row,
                                                const footpoint_detail_quad4_scales *e,
                                                REAL promise, REAL whole)
{
    if (promise < 1e-9) {
        const REAL more = 4.0 * whole * e->far, mixed = fabs(r->r12);
        const REAL k = (e->u + e->w) + more, l = (e->v + e->w) + more;
        return 3.4e-15 * e->far *
               footpoint_detail_greater(r->vv * k + mixed * l, r->uu * l + mixed * k);
    }
    return 8e-15 * (row * e->square);
}

/* Corrects (*s,*t) through the matrix of `at`. Returns the correction's length. */
FOOTPOINT_PART REAL footpoint_detail_quad4_chord(const footpoint_detail_quad4_near *start,
                                                 const footpoint_detail_quad4_near *at, REAL per,
                                                 REAL *s, REAL *t)
{
    REAL x, y, left;
    footpoint_detail_quad4_slopes(start, *s, *t, &x, &y);
    left = footpoint_detail_quad4_adjoin(at, x, y, &x, &y) * per;
    *s += x * per;
    *t += y * per;
    return left;
}

/* Takes Newton's step with the matrix M of `at`, a correction through M if `correct`, and up to `more` corrections
 * while the error is too large. `at` is (*s,*t) from `start`, no farther than `before`; (*s,*t) moves along. The
 * highest bit of the result is not set if the end is proved, see footpoint_detail_quad4_from(). */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_stage(const footpoint_detail_quad4_near *start,
                                                      const footpoint_detail_quad4_near *at,
                                                      const footpoint_detail_quad4_scales *e,
                                                      REAL promise, int correct, int more,
                                                      REAL before, REAL *s, REAL *t)
{
    const REAL det = at->uu * at->vv - at->r12 * at->r12, per = 1.0 / det, mixed = fabs(at->r12);
    const REAL row = footpoint_detail_greater(at->uu, at->vv) + mixed, a = 2.0 * fabs(at->tu);
    const REAL b = 2.0 * fabs(at->tv), both = (a + b) + at->cc;
    const REAL turn = footpoint_detail_greater(at->vv * (a + both) + mixed * (b + both),
                                               at->uu * (b + both) + mixed * (a + both));
    REAL x, y, left, ball, off, h, room, error;
    ball = footpoint_detail_quad4_adjoin(at, at->f, at->g, &x, &y) * per;
    *s += x * per;
    *t += y * per;
    left = 0.5 * ball;
    if (correct)
        left = footpoint_detail_quad4_chord(start, at, per, s, t);
    ball += 2.0 * left;
    off = footpoint_detail_quad4_blur(at, row, e, promise, before + ball) * per;
    ball += 16.0 * off;
    h = (ball * turn + 3e-14 * (row * e->square)) * per;
    room = footpoint_detail_greater(h, 0.6 * (before + ball));
    error = 2.61 * (h * left + off);
    while (more-- > 0 && footpoint_detail_above(error, promise) >> REAL_TOP &&
           !(footpoint_detail_above(room, 0.2) >> REAL_TOP)) {
        left = footpoint_detail_quad4_chord(start, at, per, s, t);
        error = 2.61 * (h * left + off);
    }
    return footpoint_detail_above(error, promise) | footpoint_detail_above(room, 0.2) |
           footpoint_detail_bits(at->uu) | footpoint_detail_bits(det) |
           footpoint_detail_outside(det);
}

/* Takes up to two such steps from (*s,*t), each with its own matrix, until one is proved. This is seldom needed. */
FOOTPOINT_APART REAL_BITS footpoint_detail_quad4_stages(const footpoint_detail_quad4_near *start,
                                                        const footpoint_detail_quad4_scales *e,
                                                        REAL promise, REAL *s, REAL *t)
{
    REAL_BITS doubt = footpoint_detail_infinite(*s + *t);
    int k;
    for (k = 0; k < 2 && !(doubt >> REAL_TOP); k++) {
        const footpoint_detail_quad4_near at = footpoint_detail_quad4_moved(start, *s, *t);
        const REAL before = footpoint_detail_greater(fabs(*s), fabs(*t));
        doubt = footpoint_detail_quad4_stage(start, &at, e, promise, 1, 0, before, s, t);
        if (!(doubt >> REAL_TOP))
            return doubt;
        doubt = footpoint_detail_infinite(*s + *t);
    }
    return (REAL_BITS)1 << REAL_TOP;
}

/* Moves from (*xi,*eta) to the foot point and computes the gap there; stages: 2 from the end of such steps, otherwise
 * 3. The highest bit of the result is not set if a minimum of the distance is proved to lie within `promise` of the
 * answer, which is at most 2/3 away. Any start is allowed, also NaN.
 *
 * Newton's step and a correction through the same matrix are proved together, with one quotient. Fine promises take a
 * step before, except from nearby, because they would need many corrections through the first matrix.
 *
 * Let F be the slopes and M a matrix near H^-1. Then z + M F(z) contracts by q = |1 - M H(z)|. Consider the ball about
 * the point of M in which q <= h <= 0.2. It holds the iterates, and no zero of det H. It also holds a root within (q
 * |x| + R) / (1 - q) of the last iterate, where x is the last correction and R bounds the rounding errors of |M F|.
 * |H(z) - H| has rows of at most |z| times 4 |tu| + 2 |tv| + cc and 2 |tu| + 4 |tv| + cc, where |z| <= 1/3; `turn`
 * bounds det |M| times these. Newton's step is the first iterate. Without a correction, half of it stands for |x|,
 * because q grows from 0 with |z|. Each further correction is less than a fifth of the one before, so the ball holds
 * it, too. 2.61 is twice 1.3, as xi = 2 s - 1; 1 / (1 - q) <= 1.25.
 *
 * Let U, V, C, W be the lengths of u, v, c, w, S >= |ab| + |ad| + |c|, and far = W + (1 + |s|) (1 + |t|) S. In units of
 * rounding, u is off by 5 (1 + |t|) S, w by 12 far, u . w by 18 far (U + W), row s of H by 57 far^2, its changes within
 * 1/3 by 27 far^2. So slopes at z are off by 24 far (U + W + 4 |z| far). For fine promises the code counts 30 instead
 * of 24, including the sum for xi; for others 70 far^2, with |z| <= 1/3. M differs from H^-1, and from its use, by 25
 * far^2 |M|: q is larger by at most |M| 3e-14 far^2. Sums may have any order. If det is well within the range of
 * numbers, underflow is below these bounds.
 *
 * The normal at a step is u x v + s (u x c) + t (c x v), the last two of which are normal to c. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_from(const REAL *const *x, REAL promise, REAL least,
                                                     int stages, REAL *xi, REAL *eta, REAL *gap)
{
    const REAL p = 0.5 + 0.5 * *xi, q = 0.5 + 0.5 * *eta, reach = 1.0 + p * p + q * q;
    const int fine = promise < 1e-9;
    REAL u[3], v[3], c[3], w[3], n[3], by_s[3], by_t[3], s, t, size, nn, mixed;
    REAL_BITS doubt;
    footpoint_detail_quad4_near r;
    footpoint_detail_quad4_scales e;
    int i;
    footpoint_detail_quad4_about(x, p, q, u, v, c, w);
    r.uu = footpoint_detail_dot(u, u);
    r.vv = footpoint_detail_dot(v, v);
    r.r12 = footpoint_detail_dot(u, v) - footpoint_detail_dot(c, w);
    r.tu = footpoint_detail_dot(u, c);
    r.tv = footpoint_detail_dot(v, c);
    r.cc = footpoint_detail_dot(c, c);
    r.f = footpoint_detail_dot(u, w);
    r.g = footpoint_detail_dot(v, w);
    size = reach * reach * ((r.uu + r.vv) + 3.0 * reach * r.cc);
    e.far = e.u = e.v = e.w = 0.0;
    if (fine) {
        const REAL twist = footpoint_detail_root_bound(r.cc);
        e.u = footpoint_detail_root_bound(r.uu);
        e.v = footpoint_detail_root_bound(r.vv);
        e.w = footpoint_detail_root_bound(footpoint_detail_dot(w, w));
        e.far = e.w + (1.0 + fabs(p)) * (1.0 + fabs(q)) *
                          ((e.u + e.v) + (1.0 + fabs(p) + fabs(q)) * twist);
        e.square = e.far * e.far;
    } else
        e.square = 2.0 * footpoint_detail_dot(w, w) + 24.0 * size;
    (void)least;
    if (footpoint_detail_infinite(r.uu * r.vv - r.r12 * r.r12) >> REAL_TOP) {
        *gap = 0.0;
        return (REAL_BITS)1 << REAL_TOP; /* compilers' maxima raise exceptions on NaN */
    }
    footpoint_detail_cross(u, v, n);
    footpoint_detail_cross(u, c, by_s);
    footpoint_detail_cross(c, v, by_t);
    mixed = footpoint_detail_dot(c, n);
    if (stages != 2 && promise < 1e-6) {
        const REAL per = 1.0 / (r.uu * r.vv - r.r12 * r.r12);
        footpoint_detail_quad4_near at;
        REAL before;
        (void)footpoint_detail_quad4_adjoin(&r, r.f, r.g, &s, &t);
        s *= per;
        t *= per;
        before = footpoint_detail_greater(fabs(s), fabs(t));
        at = footpoint_detail_quad4_moved(&r, s, t);
        doubt = footpoint_detail_quad4_stage(&r, &at, &e, promise, fine, !fine, before, &s, &t);
    } else {
        s = t = 0.0;
        doubt = footpoint_detail_quad4_stage(&r, &r, &e, promise, 1, 2, 0.0, &s, &t);
    }
    if (!fine && doubt >> REAL_TOP) {
        const footpoint_detail_quad4_near start = r;
        const footpoint_detail_quad4_scales scales = e;
        REAL to_s = s, to_t = t;
        doubt = footpoint_detail_quad4_stages(&start, &scales, promise, &to_s, &to_t);
        s = to_s;
        t = to_t;
    }
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        n[i] = (n[i] + s * by_s[i]) + t * by_t[i];
    nn = footpoint_detail_dot(n, n);
    *xi += 2.0 * s;
    *eta += 2.0 * t;
    *gap = (footpoint_detail_dot(w, n) + s * t * mixed) / sqrt(nn);
    return doubt | footpoint_detail_bits(nn - 1e4 * REAL_FLAT * (size * size)) |
           footpoint_detail_fast();
}
