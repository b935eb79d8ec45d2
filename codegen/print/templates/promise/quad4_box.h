/* Answers in the closed four-node segment, for searches that assume an order of its corners. */

#ifndef FOOTPOINT_OUTSIDE
#define FOOTPOINT_OUTSIDE 1
#endif

/* Computes the gap; see footpoint_detail_quad4_gap(). */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_box_gap(const REAL *const *x, REAL xi, REAL eta,
                                                        REAL least, REAL *gap)
{
    return footpoint_detail_quad4_gap(x, xi, eta, least, gap);
}

/* Returns its highest bit clear if (xi,eta) is in the segment. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_box_beyond(REAL xi, REAL eta)
{
    return footpoint_detail_above(xi, 1.0) | footpoint_detail_above(eta, 1.0);
}

FOOTPOINT_PART REAL footpoint_detail_quad4_box_kept(REAL p)
{
    return p < -1.0 ? -1.0 : p < 1.0 ? p : 1.0;
}

/* Takes up to four Newton steps from (*xi,*eta), until one is proved. The highest bit of the result is not set if a
 * minimum of the distance is proved to lie within `promise` of the answer, and the answer is in the segment. */
FOOTPOINT_FN REAL_BITS footpoint_detail_quad4_box_prove(const REAL *const *x, REAL promise,
                                                        REAL *xi, REAL *eta)
{
    REAL_BITS doubt = (REAL_BITS)1 << REAL_TOP;
    int k;
    for (k = 0; k < 4 && doubt >> REAL_TOP; k++)
        doubt = footpoint_detail_quad4_newton(x, promise, xi, eta);
    return doubt | footpoint_detail_quad4_box_beyond(*xi, *eta);
}

/* Returns 1 if a minimum of the distance on the closed segment is proved to lie within `promise` of `at`, on the edge
 * that holds coordinate j at -1 or 1, and the distance falls beyond that edge. *apart: the squared distance, of vectors
 * four times as long.
 *
 * Along the edge t, r_eta or r_xi, is constant. So g = t . w is linear, and its root lies within |g| / t . t; if g
 * leads outwards beyond an end, that end is the minimum. Over e of the edge the slope across, n . w, changes by at most
 * e (|c . w| + |n . t|) + e^2 |c . t|. Rounding: see footpoint_detail_quad4_visit; slopes are off by 7 units of T |w| +
 * W |t|, N |w| + W |n|, and by the products of two errors; t . t by 11 of T . T. */
FOOTPOINT_COLD int footpoint_detail_quad4_box_border(const REAL *const *x, int j, REAL promise,
                                                     const REAL at[2], REAL *apart)
{
    footpoint_detail_quad4_place r;
    const REAL *const t = j ? r.u : r.v, *const n = j ? r.v : r.u;
    const REAL *const T = j ? r.U : r.V, *const N = j ? r.V : r.U;
    const REAL unit = 8.0 * REAL_UNIT, free = at[1 - j];
    REAL along, across, off, other, tt, error = 0.0, change;
    footpoint_detail_quad4_visit(x, at[0], at[1], &r);
    *apart = footpoint_detail_dot(r.w, r.w);
    along = footpoint_detail_dot(t, r.w) * (free < 0.0 ? -1.0 : 1.0);
    across = footpoint_detail_dot(n, r.w) * (at[j] < 0.0 ? -1.0 : 1.0);
    off = unit * (footpoint_detail_weigh(T, r.w) + footpoint_detail_weigh(r.W, t) +
                  1e-6 * footpoint_detail_dot(T, r.W));
    other = unit * (footpoint_detail_weigh(N, r.w) + footpoint_detail_weigh(r.W, n) +
                    1e-6 * footpoint_detail_dot(N, r.W));
    off += fabs(free) >= 1.0 && along > 0.0 ? -along : fabs(along);
    tt = footpoint_detail_dot(t, t);
    if (off > 0.0) {
        if (!(1e-3 * tt > 12.0 * REAL_UNIT * footpoint_detail_dot(T, T)))
            return 0;
        error = 1.01 * off / tt;
    }
    change = 1.01 * error *
             (footpoint_detail_dot(r.C, r.W) + footpoint_detail_dot(N, T) +
              error * footpoint_detail_dot(r.C, T));
    return error <= 0.999 * promise && across > change + other + REAL_MIN &&
           !(footpoint_detail_fast() >> REAL_TOP);
}

/* Finds the nearest of the proved minima on the edges; returns 0 if there is none. */
FOOTPOINT_COLD int footpoint_detail_quad4_box_edges(const REAL *const *x, REAL promise, REAL at[2])
{
    REAL least = 0.0, apart;
    int edge, k, found = 0;
    for (edge = 0; edge < 4; edge++) {
        const int j = edge / 2;
        REAL to[2] = {0.0, 0.0};
        to[j] = edge % 2 ? 1.0 : -1.0;
        for (k = 0; k < 2; k++) { /* the second step removes rounding errors of the first */
            footpoint_detail_quad4_place r;
            const REAL *const t = j ? r.u : r.v;
            REAL moved;
            footpoint_detail_quad4_visit(x, to[0], to[1], &r);
            moved = footpoint_detail_dot(t, r.w) / (footpoint_detail_dot(t, t) + REAL_MIN);
            to[1 - j] = footpoint_detail_quad4_box_kept(to[1 - j] + moved);
        }
        if (!footpoint_detail_quad4_box_border(x, j, promise, to, &apart) ||
            (found && !(apart < least)))
            continue;
        found = 1;
        least = apart;
        at[0] = to[0];
        at[1] = to[1];
    }
    return found;
}

/* Takes steps from `at` to a minimum in the segment. If they lead outside, or `anyway`, it looks for a minimum on an
 * edge, FOOTPOINT_OUTSIDE. y: as for footpoint_detail_quad4_repair, which continues to 1e-5 because its steps stop at a
 * hundredth of a promise. */
FOOTPOINT_COLD int footpoint_detail_quad4_box_steps(REAL y[VECTORS][3], REAL promise, int anyway,
                                                    REAL at[2])
{
    const REAL *const x[VECTORS] = {y[0], y[1], y[2], y[3], y[4]};
    const REAL fine = promise < 1e-5 ? promise : 1e-5;
    const int status = footpoint_detail_quad4_repair(y, fine, &at[0], &at[1]);
    if (status == FOOTPOINT_OK && !(footpoint_detail_quad4_box_beyond(at[0], at[1]) >> REAL_TOP))
        return FOOTPOINT_OK;
    if ((anyway || status == FOOTPOINT_OK) && footpoint_detail_quad4_box_edges(x, promise, at))
        return FOOTPOINT_OUTSIDE;
    return FOOTPOINT_UNPROVED;
}

/* Moves `at` into the segment. Returns FOOTPOINT_OK if a minimum is proved so little beyond it that it is within
 * `promise` of the answer. */
FOOTPOINT_COLD int footpoint_detail_quad4_box_keep(REAL y[VECTORS][3], REAL promise, REAL at[2])
{
    const REAL *const x[VECTORS] = {y[0], y[1], y[2], y[3], y[4]};
    int i, proved = !(footpoint_detail_quad4_prove(x, 0.4 * promise, &at[0], &at[1]) >> REAL_TOP);
    for (i = 0; i < 2; i++) {
        const REAL kept = footpoint_detail_quad4_box_kept(at[i]);
        proved = proved && fabs(at[i] - kept) <= 0.5 * promise;
        at[i] = kept;
    }
    return proved ? FOOTPOINT_OK : FOOTPOINT_UNPROVED;
}

/* Answers from (*xi,*eta), otherwise from the middle, or from the middle of a quarter. */
FOOTPOINT_COLD int footpoint_detail_quad4_box_repair(REAL y[VECTORS][3], REAL promise, REAL *xi,
                                                     REAL *eta)
{
    REAL at[2], first[2] = {0.0, 0.0};
    int k, i, status = FOOTPOINT_UNPROVED;
    at[0] = footpoint_detail_quad4_box_kept(*xi);
    at[1] = footpoint_detail_quad4_box_kept(*eta);
    for (k = 0; k < 6 && status == FOOTPOINT_UNPROVED; k++) {
        if (k > 0) {
            at[0] = k == 1 ? 0.0 : k % 2 ? 0.5 : -0.5;
            at[1] = k == 1 ? 0.0 : k > 3 ? 0.5 : -0.5;
        }
        status = footpoint_detail_quad4_box_steps(y, promise, k == 1, at);
        for (i = 0; i < 2 && k == 0; i++)
            first[i] = at[i];
    }
    if (status == FOOTPOINT_UNPROVED) {
        status = footpoint_detail_quad4_box_keep(y, promise, first);
        at[0] = first[0];
        at[1] = first[1];
    }
    *xi = at[0];
    *eta = at[1];
    return status;
}
