/* The closest point of a closed bilinear segment if the quick way proves nothing: by descents, seldom. */

/* Vectors of r = c0 + xi a + eta b + xi eta c, d = xS - c0, four times as long; bounds on |a| + |c|, |b| + |c|,
 * |c| and on all of them; and the longest edge. */
typedef struct {
    REAL a[3], b[3], c[3], d[3], first, second, turn, far, longest;
} footpoint_detail_quad4_face;

/* Measures nodes and slave node in a unit of length in which the segment is about 1 long. */
FOOTPOINT_COLD void footpoint_detail_quad4_measure(REAL y[VECTORS][3],
                                                   footpoint_detail_quad4_face *r)
{
    REAL e[4][3], square[4], longest, turn;
    int i, k;
    footpoint_detail_quad4_edges(y, r->a, r->b, r->c, r->d);
    for (k = 0; k < 4; k++) {
        footpoint_detail_from(y[k], y[(k + 1) % 4], e[k]);
        square[k] = footpoint_detail_dot(e[k], e[k]);
    }
    if (square[1] + square[3] <
        square[0] + square[2]) /* c from the shorter edges is more accurate */
        for (i = 0; i < 3; i++)
            r->c[i] = e[1][i] + e[3][i];
    longest = footpoint_detail_greater(square[0], square[1]);
    longest = footpoint_detail_greater(longest, footpoint_detail_greater(square[2], square[3]));
    turn = footpoint_detail_length(r->c);
    r->longest = sqrt(longest);
    r->turn = turn;
    r->first = footpoint_detail_length(r->a) + turn;
    r->second = footpoint_detail_length(r->b) + turn;
    r->far = footpoint_detail_length(r->d) + 2.0 * (r->first + r->second);
}

/* Evaluates the face at (u,v). */
FOOTPOINT_COLD void footpoint_detail_quad4_look(const footpoint_detail_quad4_face *r, REAL u,
                                                REAL v, footpoint_detail_quad4_local *q)
{
    REAL x[3], y[3], w[3];
    int i;
    for (i = 0; i < 3; i++) {
        x[i] = r->a[i] + v * r->c[i];
        y[i] = r->b[i] + u * r->c[i];
        w[i] = r->d[i] - u * r->a[i] - v * y[i];
    }
    q->masked = 0;
    q->u = u;
    q->v = v;
    q->uu = footpoint_detail_dot(x, x);
    q->uv = footpoint_detail_dot(x, y);
    q->vv = footpoint_detail_dot(y, y);
    q->uc = footpoint_detail_dot(x, r->c);
    q->vc = footpoint_detail_dot(y, r->c);
    q->cc = footpoint_detail_dot(r->c, r->c);
    q->dc = footpoint_detail_dot(w, r->c);
    q->f = footpoint_detail_dot(x, w);
    q->g = footpoint_detail_dot(y, w);
    q->dd = footpoint_detail_dot(w, w);
}

/* Computes Newton's step in the coordinates that no edge holds, or the Gauss-Newton step if Newton's may lead uphill. */
FOOTPOINT_COLD void footpoint_detail_quad4_free_step(const footpoint_detail_quad4_local *q, REAL *s,
                                                     REAL *t)
{
    const int held_u = fabs(q->u) >= 1.0 && q->u * q->f >= 0.0;
    const int held_v = fabs(q->v) >= 1.0 && q->v * q->g >= 0.0;
    REAL mixed = q->uv - q->dc, det = q->uu * q->vv - mixed * mixed;
    if (!(det > 1e-6 * (q->uu * q->vv))) {
        mixed = q->uv;
        det = 1.001 * q->uu * q->vv - mixed * mixed + REAL_MIN;
    }
    *s = held_u ? 0.0 : held_v ? q->f / (q->uu + REAL_MIN) : (q->vv * q->f - mixed * q->g) / det;
    *t = held_v ? 0.0 : held_u ? q->g / (q->vv + REAL_MIN) : (q->uu * q->g - mixed * q->f) / det;
}

FOOTPOINT_COLD REAL footpoint_detail_clamp(REAL x)
{
    return x < -1.0 ? -1.0 : x > 1.0 ? 1.0 : x;
}

/* Moves *q downhill, until steps are within rounding. */
FOOTPOINT_COLD void footpoint_detail_quad4_downhill(const footpoint_detail_quad4_face *r,
                                                    footpoint_detail_quad4_local *q)
{
    footpoint_detail_quad4_local next;
    REAL s, t, moved, before = 9.0;
    int i;
    for (i = 0; i < 100; i++) {
        footpoint_detail_quad4_free_step(q, &s, &t);
        s = footpoint_detail_clamp(q->u + s) - q->u;
        t = footpoint_detail_clamp(q->v + t) - q->v;
        moved = fabs(s) + fabs(t);
        if (!(moved > 0.0) || (moved < REAL_CLOSE && moved >= 0.5 * before))
            return;
        footpoint_detail_quad4_look(r, footpoint_detail_clamp(q->u + s),
                                    footpoint_detail_clamp(q->v + t), &next);
        while (moved > REAL_APART && !(next.dd < q->dd)) {
            s *= 0.25;
            t *= 0.25;
            moved *= 0.25;
            footpoint_detail_quad4_look(r, q->u + s, q->v + t, &next);
        }
        *q = next;
        before = moved;
    }
}

/* Chooses start number k of six: (u,v), nearest points of edges, the middle. */
FOOTPOINT_COLD void footpoint_detail_quad4_begin(const footpoint_detail_quad4_face *r, int k,
                                                 REAL u, REAL v, footpoint_detail_quad4_local *q)
{
    if (k > 0) {
        u = k == 1 ? -1.0 : k == 2 ? 1.0 : 0.0;
        v = k == 3 ? -1.0 : k == 4 ? 1.0 : 0.0;
    }
    footpoint_detail_quad4_look(r, u, v, q);
    if (k == 1 || k == 2)
        footpoint_detail_quad4_look(r, u, footpoint_detail_clamp(q->g / (q->vv + REAL_MIN)), q);
    if (k == 3 || k == 4)
        footpoint_detail_quad4_look(r, footpoint_detail_clamp(q->f / (q->uu + REAL_MIN)), v, q);
}

/* Returns the least value of q0 + q1 t + q2 t^2 for t from lo to hi. */
FOOTPOINT_COLD REAL footpoint_detail_lowest(REAL q0, REAL q1, REAL q2, REAL lo, REAL hi)
{
    const REAL t = q2 > 0.0 ? -0.5 * q1 / q2 : lo;
    const REAL low = q0 + lo * (q1 + lo * q2), high = q0 + hi * (q1 + hi * q2);
    const REAL ends = low < high ? low : high;
    return t > lo && t < hi ? q0 + t * (q1 + t * q2) : ends;
}

/* Returns the least value, for t from 0 to end, of b (a0 + 2 a1 t + a2 t^2) - k^2 if k = k0 + k1 t is < 0, and otherwise of the
 * first term. */
FOOTPOINT_COLD REAL footpoint_detail_quad4_lowest(REAL b, REAL a0, REAL a1, REAL a2, REAL k0,
                                                  REAL k1, REAL end)
{
    const REAL zero = k0 < 0.0 ? -k0 / footpoint_detail_greater(k1, REAL_MIN)
                               : k0 / footpoint_detail_greater(-k1, REAL_MIN);
    const REAL turn = zero < end ? zero : end;
    const REAL lo = k0 < 0.0 ? 0.0 : turn, hi = k0 < 0.0 ? turn : end;
    REAL least = b * footpoint_detail_lowest(a0, 2.0 * a1, a2, 0.0, end), bent;
    if (k0 >= 0.0 && k0 + k1 * end >= 0.0)
        return least;
    bent = footpoint_detail_lowest(b * a0 - k0 * k0, 2.0 * (b * a1 - k0 * k1), b * a2 - k1 * k1, lo,
                                   hi);
    return bent < least ? bent : least;
}

/* Returns a number Q for footpoint_detail_quad4_sole, sharper than footpoint_detail_quad4_least_det: for each pair of signs
 * of s and t that leads into the segment, it takes s t K and |s t| `grows` / 2 together.  If their sum is positive, Q is A
 * times B; weight: of that sum, 1 or a little less. */
FOOTPOINT_COLD REAL footpoint_detail_quad4_sharp_det(const footpoint_detail_quad4_local *q,
                                                     REAL grows, REAL weight)
{
    REAL least = q->uu * q->vv, by_s, by_t, s, t;
    for (s = -1.0; s < 2.0; s += 2.0)
        for (t = -1.0; t < 2.0; t += 2.0) {
            const REAL k = weight * (s * t * (q->uv - q->dc) + 0.5 * grows);
            if (s * q->u >= 1.0 || t * q->v >= 1.0)
                continue;
            by_t = footpoint_detail_quad4_lowest(q->vv, q->uu, t * q->uc, q->cc, k,
                                                 weight * s * q->vc, 1.0 - t * q->v);
            by_s = footpoint_detail_quad4_lowest(q->uu, q->vv, s * q->vc, q->cc, k,
                                                 weight * t * q->uc, 1.0 - s * q->u);
            by_t = by_s > by_t ? by_s : by_t;
            least = by_t < least ? by_t : least;
        }
    return least;
}

/* Proves footpoint_detail_quad4_sole; or, if slack > 0, that no point is nearer than q by more than `slack`.
 *
 * Rounding, u = REAL_UNIT, with the bounds on |r_xi|, |r_eta|, |c| and |D|: first, second, turn, far.  Edges are off by
 * u of their lengths, a, b, c by 2 u first, second, turn, computed from the shorter pair of edges, r_xi by 6 u
 * first, r_eta by 6 u second, D by 12 u far.  So slopes are off by 24 u first far and 24 u second far, products by
 * 15 u of the bounds of both factors, and `mixed` by 20 u (first second + far turn); Q, as |t| <= 2, by 600 u first second
 * times that. */
FOOTPOINT_COLD int footpoint_detail_quad4_certain(const footpoint_detail_quad4_face *r,
                                                  const footpoint_detail_quad4_local *q,
                                                  REAL promise, REAL slack)
{
    const REAL unit = REAL_UNIT, close = REAL_CLOSE;
    const REAL ac = fabs(footpoint_detail_dot(r->a, r->c)),
               bc = fabs(footpoint_detail_dot(r->b, r->c));
    const REAL off_mixed = 20.0 * unit * (r->first * r->second + r->far * r->turn);
    footpoint_detail_quad4_bounds bounds;
    REAL f, g, grows, det;
    bounds.wide = 1.001 * (footpoint_detail_dot(r->a, r->a) + 2.0 * ac + q->cc);
    bounds.high = 1.001 * (footpoint_detail_dot(r->b, r->b) + 2.0 * bc + q->cc);
    bounds.off_f = 24.0 * unit * (r->first * r->far);
    bounds.off_g = 24.0 * unit * (r->second * r->far);
    bounds.off_det = 30.0 * off_mixed * (r->first * r->second);
    bounds.off_rows = off_mixed + 15.0 * unit * (r->first * r->first + r->second * r->second);
    grows = footpoint_detail_quad4_grows(0, q->u, q->f, bounds.off_f, &f);
    grows += footpoint_detail_quad4_grows(0, q->v, q->g, bounds.off_g, &g);
    if (slack > 0.0) {
        slack = (slack * sqrt(q->dd) - 2.0 * (f + g)) / (2.0 * (bounds.wide + bounds.high));
        det = footpoint_detail_quad4_sharp_det(q, grows, 1.0 / (1.0 + slack));
        return slack > 0.0 && !(footpoint_detail_fast() >> REAL_TOP) && det > bounds.off_det;
    }
    det = footpoint_detail_quad4_sharp_det(q, grows, 1.0);
    if (promise < close && !(footpoint_detail_quad4_within(q, &bounds, close, promise) >> REAL_TOP))
        promise = close;
    return !(footpoint_detail_quad4_sole(q, &bounds, promise, f, g, det) >> REAL_TOP);
}

/* Returns 1 if the closest point is proved to be the apex of a triangle: an edge whose ends coincide, with q on it.
 * All lines from there lie between the edges beside it, and if along both of these the distance grows, it does so
 * along all. */
FOOTPOINT_COLD int footpoint_detail_quad4_apex(const footpoint_detail_quad4_face *r,
                                               REAL y[VECTORS][3],
                                               const footpoint_detail_quad4_local *q)
{
    const REAL off = 24.0 * REAL_UNIT * r->far;
    footpoint_detail_quad4_local end;
    REAL sign;
    int k;
    for (k = 0; k < 4; k++) {
        const REAL at = k == 1 || k == 2 ? 1.0 : -1.0;
        const int along = k % 2 == 0; /* an edge of xi */
        int grows = 1;
        if (!((along ? q->v : q->u) * at >= 1.0) || !footpoint_detail_same(y[k], y[(k + 1) % 4]))
            continue;
        for (sign = -1.0; sign < 2.0; sign += 2.0) {
            footpoint_detail_quad4_look(r, along ? sign : at, along ? at : sign, &end);
            grows &= along ? at * end.g > off * r->second : at * end.f > off * r->first;
        }
        if (grows || footpoint_detail_same(y[k], y[4]))
            return !(footpoint_detail_fast() >> REAL_TOP);
    }
    return 0;
}

/* Finds the nearest point by descents, as q, and its status.  A tie is proved, too: no point is nearer by more than
 * REAL_TIE of the longest edge, and another, elsewhere in space, is not farther by more. */
FOOTPOINT_COLD int footpoint_detail_quad4_seek(const footpoint_detail_quad4_face *r,
                                               REAL y[VECTORS][3], REAL promise, REAL u, REAL v,
                                               footpoint_detail_quad4_local *q)
{
    const REAL close = 4.0 * REAL_TIE * r->longest; /* vectors are four times as long */
    footpoint_detail_quad4_local found[6];
    int best = 0, k, i;
    for (k = 0; k < 6; k++) {
        footpoint_detail_quad4_begin(r, k, u, v, &found[k]);
        footpoint_detail_quad4_downhill(r, &found[k]);
        best = found[k].dd < found[best].dd ? k : best;
        *q = found[best];
        if (best == k && (footpoint_detail_quad4_certain(r, q, promise, 0.0) ||
                          footpoint_detail_quad4_apex(r, y, q)))
            return FOOTPOINT_OK;
    }
    for (k = 0; k < 6; k++) {
        REAL apart[3];
        for (i = 0; i < 3; i++)
            apart[i] = (found[k].u - q->u) * r->a[i] + (found[k].v - q->v) * r->b[i] +
                       (found[k].u * found[k].v - q->u * q->v) * r->c[i];
        if (sqrt(found[k].dd) <= sqrt(q->dd) + close &&
            footpoint_detail_length(apart) > 4.0 * REAL_APART * r->longest)
            return footpoint_detail_quad4_certain(r, q, promise, close) ? FOOTPOINT_NOT_UNIQUE
                                                                        : FOOTPOINT_UNPROVED;
    }
    return FOOTPOINT_UNPROVED;
}

/* Returns the squared distance at q with its sign, in vectors four times as long. */
FOOTPOINT_COLD REAL footpoint_detail_quad4_signed(const footpoint_detail_quad4_face *r,
                                                  const footpoint_detail_quad4_local *q)
{
    const REAL size =
        8.0 * (footpoint_detail_dot(r->a, r->a) + footpoint_detail_dot(r->b, r->b) + 2.0 * q->cc);
    REAL x[3], y[3], w[3], n[3], m[3];
    int i;
    for (i = 0; i < 3; i++) {
        x[i] = r->a[i] + q->v * r->c[i];
        y[i] = r->b[i] + q->u * r->c[i];
        w[i] = r->d[i] - q->u * r->a[i] - q->v * y[i];
    }
    footpoint_detail_cross(x, y, n);
    footpoint_detail_cross(r->a, r->b, m);
    for (i = 0; i < 3; i++) /* the normal is linear on the way to the middle */
        m[i] = n[i] + REAL_INWARD * (m[i] - n[i]);
    return copysign(q->dd,
                    footpoint_detail_side(x, y, m, w, q->dd, size,
                                          footpoint_detail_quad4_region(q->u, q->v) ? 1.0 : 0.0));
}

/* Answers after the quick way has proved nothing and ended in `at`: in a unit of length in which the segment is about 1 long,
 * if it is far from that, then by descents.  at[2]: the distance. */
FOOTPOINT_COLD int footpoint_detail_quad4_proved_again(footpoint_detail_nearby *nearby,
                                                       const REAL *const *x, int scalable,
                                                       REAL promise, REAL at[3], int *region)
{
    footpoint_detail_quad4_face r;
    footpoint_detail_quad4_local q;
    REAL y[VECTORS][3], n[3], edges;
    const REAL *z[VECTORS];
    int exponent = 0, i, status = footpoint_detail_scale(x, NODES, VECTORS, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    footpoint_detail_quad4_measure(y, &r);
    if (footpoint_detail_infinite(r.far * r.far) >> REAL_TOP)
        return FOOTPOINT_ERR_DOMAIN;
    footpoint_detail_cross(r.a, r.b, n);
    edges = footpoint_detail_dot(r.a, r.a) + footpoint_detail_dot(r.b, r.b) + 2.0 * r.turn * r.turn;
    if (footpoint_detail_bits(footpoint_detail_dot(n, n) - REAL_FLAT * (edges * edges)) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    status = FOOTPOINT_UNPROVED;
    if (scalable && (exponent > REAL_ORDINARY || exponent < -REAL_ORDINARY)) {
        for (i = 0; i < VECTORS; i++)
            z[i] = y[i];
        status = nearby(z, 0, 0.0, at, region);
        at[2] = footpoint_detail_signed_root(at[2]);
    }
    if (status == FOOTPOINT_UNPROVED) {
        for (i = 0; i < 2; i++)
            at[i] =
                footpoint_detail_infinite(at[i]) >> REAL_TOP ? 0.0 : footpoint_detail_clamp(at[i]);
        status = footpoint_detail_quad4_seek(&r, y, promise, at[0], at[1], &q);
        at[0] = q.u;
        at[1] = q.v;
        at[2] = 0.25 * footpoint_detail_signed_root(footpoint_detail_quad4_signed(&r, &q));
        *region = footpoint_detail_quad4_region(q.u, q.v);
        if (status != FOOTPOINT_UNPROVED && fabs(at[2]) > r.longest)
            status = FOOTPOINT_ERR_DOMAIN;
    }
    at[2] = ldexp(at[2], exponent);
    return status;
}

/* Returns a lower bound on the distance of the segment, for an answer `at` of that status: by slopes, or by the
 * ball about the corners. */
FOOTPOINT_COLD REAL footpoint_detail_quad4_none_nearer(const REAL *const *x, REAL promise,
                                                       int status, const REAL at[3])
{
    REAL u[3], v[3], d[3], e[3], f, g, least, most = 0.0;
    int k;
    if (status == FOOTPOINT_OK) {
        footpoint_detail_quad4_surface(x, at[0], at[1], u, v, d);
        (void)footpoint_detail_quad4_grows(0, at[0], footpoint_detail_dot(u, d), 0.0, &f);
        (void)footpoint_detail_quad4_grows(0, at[1], footpoint_detail_dot(v, d), 0.0, &g);
        least = at[2] * at[2] - 2.0 * promise * (f + g);
        return sqrt(footpoint_detail_greater(least, 0.0));
    }
    if (status == FOOTPOINT_NOT_UNIQUE)
        return fabs(at[2]);
    footpoint_detail_quad4_surface(x, 0.0, 0.0, u, v, d);
    for (k = 0; k < 4; k++) {
        footpoint_detail_from(x[k], x[4], e);
        for (int i = 0; i < 3; i++)
            e[i] -= d[i];
        most = footpoint_detail_greater(most, footpoint_detail_dot(e, e));
    }
    least = sqrt(footpoint_detail_dot(d, d));
    return footpoint_detail_greater(least - sqrt(most) - 100.0 * REAL_UNIT * (least + sqrt(most)),
                                    0.0);
}
