/* Closest points of bilinear segments over arrays, and of one slave node over many. */

/* Answers to n pairs; what the loop does not prove follows behind it. */
FOOTPOINT_PART void footpoint_detail_quad4_proved_closest_n(
    footpoint_detail_quad4_nearby *nearby, size_t n, const REAL *const *x, int scalable,
    REAL promise, REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
    REAL *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT region, int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[3];
        status[i] = nearby(row, 1, zero, at, &region[i]);
        xi[i] = at[0];
        eta[i] = at[1];
        dist[i] = at[2];
    }
    for (i = 0; i < n; i++)
        dist[i] = footpoint_detail_signed_root(dist[i]);
    for (i = 0; i < n; i++)
        if (status[i] == FOOTPOINT_UNPROVED) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            REAL at[3];
            at[0] = xi[i];
            at[1] = eta[i];
            status[i] =
                footpoint_detail_quad4_proved_again(nearby, row, scalable, promise, at, &region[i]);
            xi[i] = at[0];
            eta[i] = at[1];
            dist[i] = at[2];
        }
}

/* A distance that no point of the segment is nearer than, for an answer `at` of that status: by slopes, or by the
 * ball about the corners. */
FOOTPOINT_COLD REAL footpoint_detail_quad4_none_nearer(const REAL *const *x, REAL promise,
                                                       int status, const REAL at[3])
{
    REAL u[3], v[3], d[3], e[3], f, g, least, most = 0.0;
    int k;
    if (status == FOOTPOINT_OK) {
        footpoint_detail_quad4_surface(x, at[0], at[1], u, v, d);
        (void)footpoint_detail_quad4_grows(at[0], footpoint_detail_dot(u, d), 0.0, &f);
        (void)footpoint_detail_quad4_grows(at[1], footpoint_detail_dot(v, d), 0.0, &g);
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
    return footpoint_detail_greater(least - sqrt(most) - 1e-14 * (least + sqrt(most)), 0.0);
}

/* The nearest segment so far: its number, answer and status, and a lower bound of its distance. */
typedef struct {
    size_t which;
    REAL at[3], least;
    int region, status;
} footpoint_detail_quad4_candidate;

/* An answer to rounding, if it is proved. */
FOOTPOINT_COLD void footpoint_detail_quad4_refine(footpoint_detail_quad4_nearby *nearby,
                                                  const REAL *const *x, const REAL *xS,
                                                  REAL promise, footpoint_detail_quad4_candidate *c)
{
    footpoint_detail_quad4_candidate finer = *c;
    const REAL *row[VECTORS];
    footpoint_detail_quad4_row(x, xS, c->which, row);
    if (c->status != FOOTPOINT_OK || c->least >= fabs(c->at[2]))
        return;
    if (footpoint_detail_quad4_proved_again(nearby, row, 0, promise, finer.at, &finer.region) !=
        FOOTPOINT_OK)
        return;
    finer.least = fabs(finer.at[2]);
    *c = finer;
}

/* The nearest of n segments, and the side of the surface that they make.  FOOTPOINT_UNPROVED if another whose answer
 * is not proved may be nearer; where errors of two answers could hide which is nearer, both are refined. */
FOOTPOINT_PART int footpoint_detail_quad4_proved_closest_of(footpoint_detail_quad4_nearby *nearby,
                                                            size_t n, const REAL *const *x,
                                                            const REAL *xS, int scalable,
                                                            REAL promise, REAL loc[2], REAL *dist,
                                                            int *region, size_t *which)
{
    footpoint_detail_quad4_candidate best = {0, {0.0, 0.0, 0.0}, 0.0, 0, FOOTPOINT_ERR_DOMAIN};
    REAL hidden = -1.0; /* what no unproved one is nearer than; < 0: there is none */
    size_t i;
    for (i = 0; i < n; i++) {
        footpoint_detail_quad4_candidate c, loser;
        const REAL *row[VECTORS];
        c.which = i;
        footpoint_detail_quad4_row(x, xS, i, row);
        c.status =
            footpoint_detail_quad4_proved_closest(nearby, row, scalable, promise, c.at, &c.region);
        if (c.status < FOOTPOINT_OK) {
            best.status = best.status < FOOTPOINT_OK ? c.status : best.status;
            continue;
        }
        c.least = footpoint_detail_quad4_none_nearer(row, promise, c.status, c.at);
        if (best.status >= FOOTPOINT_OK) {
            if (c.least < fabs(best.at[2]) && best.least < fabs(c.at[2])) {
                footpoint_detail_quad4_refine(nearby, x, xS, promise, &best);
                footpoint_detail_quad4_refine(nearby, x, xS, promise, &c);
            }
            loser = fabs(c.at[2]) < fabs(best.at[2]) ? best : c;
            if (loser.status == FOOTPOINT_UNPROVED && (hidden < 0.0 || loser.least < hidden))
                hidden = loser.least;
        }
        if (best.status < FOOTPOINT_OK || fabs(c.at[2]) < fabs(best.at[2]))
            best = c;
    }
    if (best.status < FOOTPOINT_OK)
        return best.status;
    if (best.region > 0)
        best.at[2] = footpoint_detail_quad4_behind_all(n, x, xS, best.which, best.at, best.region)
                         ? -fabs(best.at[2])
                         : fabs(best.at[2]);
    if (hidden >= 0.0 && hidden < fabs(best.at[2]))
        best.status = FOOTPOINT_UNPROVED;
    *which = best.which;
    return footpoint_detail_quad4_proved_answer(best.status, best.at, best.region, loc, dist,
                                                region);
}
