/* Steps of four-node faces if the quick steps prove nothing. */

/* Returns the squared distance at (xi,eta), of vectors with over = 1, and, if gauss is not NULL, computes the
 * Gauss-Newton step from there, which leads downhill. */
FOOTPOINT_COLD REAL footpoint_detail_quad4_apart(const REAL a[3], const REAL b[3], const REAL c[3],
                                                 const REAL d[3], REAL xi, REAL eta, REAL *gauss)
{
    REAL u[3], v[3], w[3], uu, uv, vv, f, g, det;
    int i;
    for (i = 0; i < 3; i++) {
        u[i] = a[i] + eta * c[i];
        v[i] = b[i] + xi * c[i];
        w[i] = d[i] - xi * a[i] - eta * v[i];
    }
    if (gauss) {
        uu = footpoint_detail_dot(u, u);
        uv = footpoint_detail_dot(u, v);
        vv = footpoint_detail_dot(v, v);
        f = footpoint_detail_dot(u, w);
        g = footpoint_detail_dot(v, w);
        det = 1.001 * uu * vv - uv * uv + REAL_MIN;
        gauss[0] = (vv * f - uv * g) / det;
        gauss[1] = (uu * g - uv * f) / det;
    }
    return footpoint_detail_dot(w, w);
}

/* Computes the vectors as sums of edges, four times r's. */
FOOTPOINT_COLD void footpoint_detail_quad4_edges(REAL y[VECTORS][3], REAL a[3], REAL b[3],
                                                 REAL c[3], REAL d[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        const REAL ab = y[1][i] - y[0][i], dc = y[2][i] - y[3][i];
        a[i] = ab + dc;
        b[i] = (y[3][i] - y[0][i]) + (y[2][i] - y[1][i]);
        c[i] = dc - ab;
        d[i] = ((y[4][i] - y[0][i]) + (y[4][i] - y[2][i])) +
               ((y[4][i] - y[1][i]) + (y[4][i] - y[3][i]));
    }
}

/* Moves from `at`, where the squared distance is *apart, to `to`, if that is nearer; otherwise by damped Gauss-Newton
 * steps, which lead downhill. Returns 0 if nothing is nearer. */
FOOTPOINT_COLD int footpoint_detail_quad4_nearer(const REAL a[3], const REAL b[3], const REAL c[3],
                                                 const REAL d[3], REAL to[2], REAL at[2],
                                                 REAL *apart)
{
    REAL gauss[2], damp = 1.0, less;
    less = footpoint_detail_quad4_apart(a, b, c, d, to[0], to[1], NULL);
    if (!(less <= *apart * (1.0 + REAL_MARGIN))) {
        (void)footpoint_detail_quad4_apart(a, b, c, d, at[0], at[1], gauss);
        do {
            to[0] = at[0] + damp * gauss[0];
            to[1] = at[1] + damp * gauss[1];
            less = footpoint_detail_quad4_apart(a, b, c, d, to[0], to[1], NULL);
            damp *= 0.25;
        } while (!(less < *apart) && damp > 1e-4);
    }
    if (!(less <= *apart * (1.0 + REAL_MARGIN)))
        return 0;
    at[0] = to[0];
    at[1] = to[1];
    *apart = less;
    return 1;
}

/* Does the same as footpoint_detail_quad4_newton for vectors of footpoint_detail_quad4_edges, which are off by 3 units
 * of |a| + |b| + |c| (and |d|). If |xi| or |eta| is large, products of both weigh nodes, but not these vectors.
 *
 * F is off by 11 units of far (|r_xi|, |r_eta| + |D|), and the error of H counts as 8 step far in place of |D|; sums of
 * any order. The weak inequality of `det` keeps the rounding errors of beta and h below the margins of 0.249 and
 * 0.999. */
FOOTPOINT_COLD REAL_BITS footpoint_detail_quad4_far(const REAL a[3], const REAL b[3],
                                                    const REAL c[3], const REAL d[3], REAL promise,
                                                    REAL *xi, REAL *eta)
{
    const REAL p = *xi, q = *eta, x = fabs(p), y = fabs(q), cc = footpoint_detail_dot(c, c);
    const REAL u[3] = {a[0] + q * c[0], a[1] + q * c[1], a[2] + q * c[2]};
    const REAL v[3] = {b[0] + p * c[0], b[1] + p * c[1], b[2] + p * c[2]};
    const REAL w[3] = {d[0] - p * a[0] - q * v[0], d[1] - p * a[1] - q * v[1],
                       d[2] - p * a[2] - q * v[2]};
    const REAL uu = footpoint_detail_dot(u, u), vv = footpoint_detail_dot(v, v);
    const REAL r12 = footpoint_detail_dot(u, v) - footpoint_detail_dot(c, w), mixed = fabs(r12);
    const REAL f = footpoint_detail_dot(u, w), g = footpoint_detail_dot(v, w);
    const REAL det = uu * vv - r12 * r12, per = 1.0 / det;
    const REAL s = (vv * f - r12 * g) * per, t = (uu * g - r12 * f) * per;
    const REAL step = footpoint_detail_greater(fabs(s), fabs(t));
    const REAL twist = footpoint_detail_sum(c), first = footpoint_detail_sum(a);
    const REAL second = footpoint_detail_sum(b);
    const REAL far = footpoint_detail_sum(d) + (1.0 + x) * (1.0 + y) * (first + second + twist);
    const REAL away = footpoint_detail_sum(w) + 8.0 * step * far;
    const REAL off_f = first + y * twist + away, off_g = second + x * twist + away;
    const REAL off =
        11.0 * REAL_UNIT * far * per *
        footpoint_detail_greater(vv * off_f + mixed * off_g, uu * off_g + mixed * off_f);
    const REAL turns = fabs(footpoint_detail_dot(u, c)) + fabs(footpoint_detail_dot(v, c));
    const REAL h = (footpoint_detail_greater(uu, vv) + mixed) * per * (step + 2.0 * off) *
                   (4.0 * turns + cc + 1000.0 * REAL_UNIT * (far * far));
    const REAL weak = footpoint_detail_greater(1e-6, 20000.0 * REAL_UNIT);
    REAL room;
    *xi = p + s;
    *eta = q + t;
    room = 0.999 * promise *
               footpoint_detail_greater(1.0, footpoint_detail_greater(fabs(*xi), fabs(*eta))) -
           (0.8 * h * step + 1.2 * off);
    return footpoint_detail_bits(room) | footpoint_detail_bits(0.249 - h) |
           footpoint_detail_bits(0.083 - step) |
           footpoint_detail_bits(det * (1.0 - weak) - weak * (r12 * r12)) |
           footpoint_detail_infinite(room + h + off + s + t) | footpoint_detail_fast();
}

/* Takes up to 20 steps from (*xi,*eta) until one is proved; otherwise FOOTPOINT_UNPROVED. y: the vectors in a unit of
 * length in which the segment is about 1 long. */
FOOTPOINT_COLD int footpoint_detail_quad4_repair(REAL y[VECTORS][3], REAL promise, REAL *xi,
                                                 REAL *eta)
{
    REAL a[3], b[3], c[3], d[3], at[2], to[2], other[2], apart, moved;
    const REAL *const x[VECTORS] = {y[0], y[1], y[2], y[3], y[4]};
    int steps, status = FOOTPOINT_UNPROVED;
    footpoint_detail_quad4_edges(y, a, b, c, d);
    at[0] = fabs(*xi) < 1e3 ? *xi : 0.0;
    at[1] = fabs(*eta) < 1e3 ? *eta : 0.0;
    apart = footpoint_detail_quad4_apart(a, b, c, d, at[0], at[1], NULL);
    for (steps = 0; steps < 20; steps++) {
        to[0] = at[0];
        to[1] = at[1];
        if (!(footpoint_detail_quad4_prove(x, promise, &to[0], &to[1]) >> REAL_TOP)) {
            at[0] = to[0];
            at[1] = to[1];
            status = FOOTPOINT_OK;
            break;
        }
        other[0] = at[0];
        other[1] = at[1];
        if (!(footpoint_detail_quad4_far(a, b, c, d, promise, &other[0], &other[1]) >> REAL_TOP)) {
            at[0] = other[0];
            at[1] = other[1];
            status = FOOTPOINT_OK;
            break;
        }
        moved = fabs(to[0] - at[0]) + fabs(to[1] - at[1]);
        if (moved < 1e-4) { /* near a minimum, where rounding hides which is nearer */
            at[0] = to[0];
            at[1] = to[1];
        } else if (!footpoint_detail_quad4_nearer(a, b, c, d, to, at, &apart))
            break;
        if (moved < 0.01 * promise) /* rounding prevents the proof */
            break;
    }
    *xi = at[0];
    *eta = at[1];
    return status;
}
