/* Four-node faces from a near start: one expansion about it, Newton's steps, and their proof. */

/* r = A + s ab + t ad + s t c about (xi,eta) = (2 s - 1, 2 t - 1): u = r_s, v = r_t, c = r_st, w = xS - r. */
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

/* Half of the squared distance about a point: slopes (f,g), the Hessian, and how that changes. */
typedef struct {
    REAL f, g, uu, r12, vv, tu, tv, cc;
} footpoint_detail_quad4_near;

/* What bounds rounding errors, see footpoint_detail_quad4_from(): far^2; for fine promises lengths, too. */
typedef struct {
    REAL square, far, u, v, w;
} footpoint_detail_quad4_scales;

/* The slopes at a step (s,t) from the point. */
FOOTPOINT_PART void footpoint_detail_quad4_slopes(const footpoint_detail_quad4_near *r, REAL s,
                                                  REAL t, REAL *f, REAL *g)
{
    const REAL both = r->cc * s * t, tu = r->tu * s, tv = r->tv * t;
    *f = (r->f - r->uu * s - r->r12 * t) - t * ((2.0 * tu + tv) + both);
    *g = (r->g - r->r12 * s - r->vv * t) - s * ((2.0 * tv + tu) + both);
}

/* All of that. */
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

/* (*s,*t) + H^-1 (f,g); the length of that step in the maximum norm. */
FOOTPOINT_PART REAL footpoint_detail_quad4_chord(const footpoint_detail_quad4_near *r, REAL per,
                                                 REAL f, REAL g, REAL *s, REAL *t)
{
    const REAL x = (r->vv * f - r->r12 * g) * per, y = (r->uu * g - r->r12 * f) * per;
    *s += x;
    *t += y;
    return footpoint_detail_greater(fabs(x), fabs(y));
}

/* A bound on rounding errors of steps within `whole` of the start. */
FOOTPOINT_PART REAL footpoint_detail_quad4_blur(const footpoint_detail_quad4_near *r, REAL per,
                                                REAL beta, const footpoint_detail_quad4_scales *e,
                                                REAL promise, REAL whole)
{
    if (promise < 1e-9) {
        const REAL more = 4.0 * whole * e->far, mixed = fabs(r->r12);
        const REAL k = (e->u + e->w) + more, l = (e->v + e->w) + more;
        return 3.4e-15 * e->far * per *
               footpoint_detail_greater(r->vv * k + mixed * l, r->uu * l + mixed * k);
    }
    return 8e-15 * (beta * e->square);
}

/* Newton's step from (*s,*t), and with `correct` a correction through the same matrix.  The highest bit of the result
 * is not set if the end is proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_stage(const footpoint_detail_quad4_near *start,
                                                      const footpoint_detail_quad4_scales *e,
                                                      REAL promise, int correct, REAL *s, REAL *t)
{
    const footpoint_detail_quad4_near at = footpoint_detail_quad4_moved(start, *s, *t);
    const REAL before = footpoint_detail_greater(fabs(*s), fabs(*t));
    const REAL det = at.uu * at.vv - at.r12 * at.r12, per = 1.0 / det;
    const REAL step = footpoint_detail_quad4_chord(&at, per, at.f, at.g, s, t);
    const REAL beta = (footpoint_detail_greater(at.uu, at.vv) + fabs(at.r12)) * per;
    const REAL a = fabs(at.tu), b = fabs(at.tv);
    const REAL turn = 2.0 * ((a + b) + footpoint_detail_greater(a, b)) + at.cc;
    REAL left = 0.5 * step, ball, off, h, error, f, g;
    if (correct) {
        footpoint_detail_quad4_slopes(start, *s, *t, &f, &g);
        left = footpoint_detail_quad4_chord(&at, per, f, g, s, t);
    }
    ball = step + 2.0 * left;
    off = footpoint_detail_quad4_blur(&at, per, beta, e, promise, before + ball);
    ball += 16.0 * off;
    h = beta * (ball * turn + 3e-14 * e->square);
    error = 2.61 * (h * left + off);
    h = footpoint_detail_greater(h, 0.6 * (before + ball));
    return footpoint_detail_above(error, promise) | footpoint_detail_above(h, 0.2) |
           footpoint_detail_bits(at.uu) | footpoint_detail_bits(det) |
           footpoint_detail_outside(det);
}

/* From (*xi,*eta) to the foot point, and the gap there, by Newton's step and then up to `stages`, 1 in a loop over
 * arrays.  The highest bit of the result is not set if a minimum of the distance is proved to lie within `promise` of
 * the answer, which is 2/3 away at most.  Any start will do, NaN too.
 *
 * With the slopes F and M near H^-1, z + M F(z) contracts by q = |1 - M H(z)|.  A ball about the point that M is of,
 * in which q <= h <= 0.2, holds the iterates, a root within (q |x| + R) / (1 - q) of the last one, x being the last
 * correction and R the rounding errors of |M F|, and no zero of det H.  |H(z) - H| <= |z| (4 |tu| + 2 |tv| + cc) in
 * row s, where |z| <= 1/3.  Newton's step is the first iterate; as q grows from 0 with |z|, half of it stands for
 * |x|.  2.61 is twice 1.3, as xi = 2 s - 1; 1 / (1 - q) <= 1.25.
 *
 * With the lengths U, V, C, W of u, v, c, w and S >= |ab| + |ad| + |c|, let far = W + (1 + |s|) (1 + |t|) S.  In
 * units of rounding, u is off by 5 (1 + |t|) S, w by 12 far, u . w by 18 far (U + W), row s of H by 57 far^2, its
 * changes within 1/3 by 27 far^2, so that slopes at z are by 24 far (U + W + 4 |z| far), for which 30 stand, the sum
 * for xi included, and with |z| <= 1/3 70 far^2.  M differs from H^-1, and what it multiplies, by 25 far^2 |M|: q is
 * larger by |M| 3e-14 far^2 at most.  Sums of any order.  Where det is well within the range of numbers, what
 * underflows is below these bounds. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_from(const REAL *const *x, REAL promise, REAL least,
                                                     int stages, REAL *xi, REAL *eta, REAL *gap)
{
    const REAL p = 0.5 + 0.5 * *xi, q = 0.5 + 0.5 * *eta, reach = 1.0 + p * p + q * q;
    const int correct = promise < (stages > 1 ? 1e-9 : 1e-6);
    REAL u[3], v[3], c[3], w[3], n[3], s = 0.0, t = 0.0, size, nn;
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
    if (promise < 1e-9) {
        const REAL twist = footpoint_detail_root_bound(r.cc);
        e.u = footpoint_detail_root_bound(r.uu);
        e.v = footpoint_detail_root_bound(r.vv);
        e.w = footpoint_detail_root_bound(footpoint_detail_dot(w, w));
        e.far = e.w + (1.0 + fabs(p)) * (1.0 + fabs(q)) *
                          ((e.u + e.v) + (1.0 + fabs(p) + fabs(q)) * twist);
        e.square = e.far * e.far;
    } else
        e.square = 2.0 * footpoint_detail_dot(w, w) + 24.0 * size;
    {
        const REAL per = 1.0 / (r.uu * r.vv - r.r12 * r.r12);
        REAL f, g;
        (void)footpoint_detail_quad4_chord(&r, per, r.f, r.g, &s, &t);
        if (stages == 1 && promise < 1e-9) {
            footpoint_detail_quad4_slopes(&r, s, t, &f, &g);
            (void)footpoint_detail_quad4_chord(&r, per, f, g, &s, &t);
        }
    }
    (void)least;
    if (stages > 1 && footpoint_detail_infinite(s + t) >> REAL_TOP) {
        *xi = *eta = *gap = s + t;
        return (REAL_BITS)1 << REAL_TOP; /* compilers' maxima of NaN raise exceptions */
    }
    do
        doubt = footpoint_detail_quad4_stage(&r, &e, promise, correct, &s, &t);
    while (--stages > 0 && doubt >> REAL_TOP);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        w[i] += s * t * c[i];
        u[i] += t * c[i];
        v[i] += s * c[i];
    }
    footpoint_detail_cross(u, v, n);
    nn = footpoint_detail_dot(n, n);
    *xi += 2.0 * s;
    *eta += 2.0 * t;
    *gap = footpoint_detail_dot(w, n) / sqrt(nn);
    return doubt | footpoint_detail_bits(nn - 1e4 * REAL_FLAT * (size * size)) |
           footpoint_detail_fast();
}
