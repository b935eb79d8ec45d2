/* The proof of a Newton step from vectors: dearer, and finer on long faces. */

/* A Newton step to the foot point of r = c0 + xi a + eta b + xi eta c, d = (xS - c0) / over, by xi and eta.  The highest bit of
 * what it returns is not set if a minimum of the distance is proved to lie within promise * max(1, |xi|, |eta|) of the answer.
 *
 * By Newton and Kantorovich, in maximum norms: F = (r_xi . D, r_eta . D), D = xS - r, has the Jacobian -H, H = [uu r12; r12 vv];
 * beta = |H^-1|, `step` = |H^-1 F|.  In the ball of twice the step, of at most 1/6, H has the Lipschitz constant
 * 4 (|r_xi . c| + |r_eta . c|) + c . c.  If h = beta Lipschitz step <= 1/4, then there is a root in the ball within 0.8 h step
 * of the answer, and H is positive definite all the way there.  Rounding: if coordinates of a, b, c (and d) are off by
 * k units of rounding of |a| + |b| + |c| (and |d|) there, and rounding = (k + 8) units, then F is off by no more than
 * rounding far (|r_xi|, |r_eta| + |D|), and what H is off by counts as much as 8 step far in place of |D|; sums of any order.
 * The weak inequality of `det` keeps the rounding errors of beta and h below what 0.249 and 0.999 leave. */
FOOTPOINT_COLD REAL_BITS footpoint_detail_quad4_prove(const REAL a[3], const REAL b[3],
                                                      const REAL c[3], const REAL d[3], REAL over,
                                                      REAL rounding, REAL promise, REAL *xi,
                                                      REAL *eta)
{
    const REAL p = *xi, q = *eta, x = fabs(p), y = fabs(q), cc = footpoint_detail_dot(c, c);
    const REAL u[3] = {a[0] + q * c[0], a[1] + q * c[1], a[2] + q * c[2]};
    const REAL v[3] = {b[0] + p * c[0], b[1] + p * c[1], b[2] + p * c[2]};
    const REAL w[3] = {over * d[0] - p * a[0] - q * v[0], over * d[1] - p * a[1] - q * v[1],
                       over * d[2] - p * a[2] - q * v[2]};
    const REAL uu = footpoint_detail_dot(u, u), vv = footpoint_detail_dot(v, v);
    const REAL r12 = footpoint_detail_dot(u, v) - footpoint_detail_dot(c, w), mixed = fabs(r12);
    const REAL f = footpoint_detail_dot(u, w), g = footpoint_detail_dot(v, w);
    const REAL det = uu * vv - r12 * r12, per = 1.0 / det;
    const REAL s = (vv * f - r12 * g) * per, t = (uu * g - r12 * f) * per;
    const REAL step = footpoint_detail_greater(fabs(s), fabs(t));
    const REAL twist = footpoint_detail_sum(c), first = footpoint_detail_sum(a);
    const REAL second = footpoint_detail_sum(b);
    const REAL far =
        fabs(over) * footpoint_detail_sum(d) + (1.0 + x) * (1.0 + y) * (first + second + twist);
    const REAL away = footpoint_detail_sum(w) + 8.0 * step * far;
    const REAL off_f = first + y * twist + away, off_g = second + x * twist + away;
    const REAL off =
        rounding * far * per *
        footpoint_detail_greater(vv * off_f + mixed * off_g, uu * off_g + mixed * off_f);
    const REAL turns = fabs(footpoint_detail_dot(u, c)) + fabs(footpoint_detail_dot(v, c));
    const REAL h = (footpoint_detail_greater(uu, vv) + mixed) * per * (step + 2.0 * off) *
                   (4.0 * turns + cc + 1e-13 * (far * far));
    REAL room, other;
    *xi = p + s;
    *eta = q + t;
    room = 0.999 * promise *
               footpoint_detail_greater(1.0, footpoint_detail_greater(fabs(*xi), fabs(*eta))) -
           (0.8 * h * step + 1.2 * off);
    other = 0.249 - h;
    room = other < room ? other : room;
    other = 0.083 - step;
    room = other < room ? other : room;
    other = det * (1.0 - 1e-6) - 1e-6 * (r12 * r12);
    room = other < room ? other : room;
    return footpoint_detail_bits(room) | footpoint_detail_infinite(room + h + off + s + t) |
           footpoint_detail_fast();
}
