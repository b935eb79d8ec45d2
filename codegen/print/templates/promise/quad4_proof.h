/* The proof of a Newton step from nodes: slower, but finer on long faces. */

/* Data for a proof about a segment and a slave node: their vectors x; the vectors of r = c0 + xi a + eta b + xi eta c
 * and d = xS - c0, `over` of the d here; size = a . a + b . b + c . c; and their rounding errors. Coordinates of a are
 * off by some units of rounding of those of |a| + |c| + 0.08 |b|, of b by units of |b| + |c| + 0.08 |a|; of c by units
 * of the former with twist = 1, of the latter with 2, of both with 3; of d by units of |a| + |b| + |c| + |d|. A product
 * of two is off by `rounding`, minus 10 units, of the product of the two bounds, where the bound of d is 0.5 (|a| + |b|
 * + |c|) + |d|. */
typedef struct {
    const REAL *const *x;
    const REAL *a, *b, *c, *d;
    REAL over, size, rounding;
    int twist, masked;
} footpoint_detail_quad4_vectors;

/* Values at (xi,eta), four times: u = r_xi, v = r_eta, w = xS - r, c; and for each coordinate the sum of the absolute
 * values of its terms, U, V, W, C. By rounding u and v are off by 4 units of U and V, w by 7 of W, c by 2 of C. */
typedef struct {
    REAL u[3], v[3], w[3], c[3], U[3], V[3], W[3], C[3];
} footpoint_detail_quad4_place;

FOOTPOINT_PART void footpoint_detail_quad4_visit(const REAL *const *x, REAL xi, REAL eta,
                                                 footpoint_detail_quad4_place *at)
{
    const REAL left = 1.0 - xi, right = 1.0 + xi, below = 1.0 - eta, above = 1.0 + eta;
    const REAL a = left * below, b = right * below, c = right * above, d = left * above;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL ab = x[1][i] - x[0][i], dc = x[2][i] - x[3][i];
        const REAL ad = x[3][i] - x[0][i], bc = x[2][i] - x[1][i];
        const REAL of_a = a * (x[4][i] - x[0][i]), of_b = b * (x[4][i] - x[1][i]);
        const REAL of_c = c * (x[4][i] - x[2][i]), of_d = d * (x[4][i] - x[3][i]);
        at->u[i] = below * ab + above * dc;
        at->U[i] = fabs(below * ab) + fabs(above * dc);
        at->v[i] = left * ad + right * bc;
        at->V[i] = fabs(left * ad) + fabs(right * bc);
        at->w[i] = (of_a + of_b) + (of_c + of_d);
        at->W[i] = (fabs(of_a) + fabs(of_b)) + (fabs(of_c) + fabs(of_d));
        at->c[i] = dc - ab;
        at->C[i] = fabs(dc) + fabs(ab);
    }
}

/* Takes a Newton step to the foot point of r, by xi and eta. The highest bit of the result is not set if a minimum of
 * the distance is proved to lie within promise * max(1, |xi|, |eta|) of the answer.
 *
 * By Newton and Kantorovich, in maximum norms: F = (u . w, v . w) has the Jacobian -H, H = [uu r12; r12 vv], r12 = u .
 * v - c . w; beta = |H^-1|, `step` = |H^-1 F|. In a ball of 1/6, H has the Lipschitz constant L = 4 (|u . c| + |v . c|)
 * + c . c. If h = beta L step <= 0.2625, then there is a root within 1.19 steps, and within 0.71 h step of the exact
 * answer, and H is positive definite on the whole way there.
 *
 * Rounding: F is off by 7 units of U |w| + W |u|, of V |w| + W |v|, and by products of two errors; H by 13 of rows U (U
 * + V) + C W and V (U + V) + C W; Cramer's rule adds 12, as r12^2 is at most 1e-4 det / (2 units); L is off by 40 of C
 * (U + V + C). `tilt` bounds |H^-1| times the errors of H; times a step, these are errors of F, too. It makes beta and
 * errors of F at most 1.06 times as large. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_newton(const REAL *const *x, REAL promise, REAL *xi,
                                                       REAL *eta)
{
    footpoint_detail_quad4_place r;
    REAL UV[3], all[3], uu, vv, r12, mixed, f, g, det, per, s, t, step, off_f, off_g, tilt, off, h;
    REAL both, row, column, room;
    int i;
    footpoint_detail_quad4_visit(x, *xi, *eta, &r);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        UV[i] = r.U[i] + r.V[i];
        all[i] = UV[i] + r.C[i];
    }
    uu = footpoint_detail_dot(r.u, r.u);
    vv = footpoint_detail_dot(r.v, r.v);
    r12 = footpoint_detail_dot(r.u, r.v) - footpoint_detail_dot(r.c, r.w);
    mixed = fabs(r12);
    f = footpoint_detail_dot(r.u, r.w);
    g = footpoint_detail_dot(r.v, r.w);
    det = uu * vv - r12 * r12;
    per = 1.0 / det;
    s = (vv * f - r12 * g) * per;
    t = (uu * g - r12 * f) * per;
    step = footpoint_detail_greater(fabs(s), fabs(t));
    both = 1e-6 * footpoint_detail_dot(r.W, UV);
    off_f = footpoint_detail_weigh(r.U, r.w) + footpoint_detail_weigh(r.W, r.u) + both;
    off_g = footpoint_detail_weigh(r.V, r.w) + footpoint_detail_weigh(r.W, r.v) + both;
    both = footpoint_detail_dot(r.C, r.W);
    row = footpoint_detail_dot(r.U, UV) + both;
    column = footpoint_detail_dot(r.V, UV) + both;
    tilt = 25.0 * REAL_UNIT * per *
           footpoint_detail_greater(vv * row + mixed * column, uu * column + mixed * row);
    off = 7.0 * REAL_UNIT * per *
              footpoint_detail_greater(vv * off_f + mixed * off_g, uu * off_g + mixed * off_f) +
          tilt * step;
    h = 4.0 * (fabs(footpoint_detail_dot(r.u, r.c)) + fabs(footpoint_detail_dot(r.v, r.c))) +
        footpoint_detail_dot(r.c, r.c) + 40.0 * REAL_UNIT * footpoint_detail_dot(r.C, all);
    h *= (footpoint_detail_greater(uu, vv) + mixed) * per * (step + 2.0 * off);
    *xi += s;
    *eta += t;
    room = 0.999 * promise - 2.0 * REAL_UNIT;
    room = footpoint_detail_greater(room, room * footpoint_detail_greater(fabs(*xi), fabs(*eta))) -
           (0.8 * h * step + 1.3 * off);
    return footpoint_detail_bits(room) | footpoint_detail_bits(0.249 - h) |
           footpoint_detail_bits(0.05 - tilt) | footpoint_detail_bits(0.1 - (step + 2.0 * off)) |
           footpoint_detail_bits(det - 20000.0 * REAL_UNIT * (r12 * r12)) |
           footpoint_detail_infinite(room + h + off + s + t) | footpoint_detail_fast();
}

/* The same, not inlined because it is seldom called. */
FOOTPOINT_COLD REAL_BITS footpoint_detail_quad4_prove(const REAL *const *x, REAL promise, REAL *xi,
                                                      REAL *eta)
{
    return footpoint_detail_quad4_newton(x, promise, xi, eta);
}
