/* Proved closest points: single, over arrays, and for a slave node over many segments. */

/* Finds an answer, with the distance in at. */
FOOTPOINT_PART int footpoint_detail_KIND_proved_closest(footpoint_detail_nearby *nearby,
                                                        const REAL *const *x, int scalable,
                                                        REAL promise, REAL at[3], int *region)
{
    const int status = nearby(x, 0, 0.0, at, region);
    if (status == FOOTPOINT_UNPROVED)
        return footpoint_detail_KIND_proved_again(nearby, x, scalable, promise, at, region);
    at[2] = footpoint_detail_signed_root(at[2]);
    return status;
}

/* Writes its answer for the caller, if there is an answer. */
FOOTPOINT_PART int footpoint_detail_KIND_proved_answer(int status, const REAL at[3], int where,
                                                       REAL loc[2], REAL *dist, int *region)
{
    const int good = status < FOOTPOINT_OK ? status : FOOTPOINT_OK;
    (void)footpoint_detail_closest_answer(good, at, where, loc, dist, region);
    return status;
}

/* Answers n pairs; pairs that the loop does not prove follow after it. */
FOOTPOINT_PART void footpoint_detail_KIND_proved_closest_n(
    footpoint_detail_nearby *nearby, size_t n, const REAL *const *x, int scalable, REAL promise,
    REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT dist,
    int *FOOTPOINT_RESTRICT region, int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i = footpoint_detail_KIND_closest_blocks(nearby, n, x, xi, eta, dist, region, status);
    FOOTPOINT_EACH
    for (; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[3];
        status[i] = nearby(row, !footpoint_detail_masks(), zero, at, &region[i]);
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
                footpoint_detail_KIND_proved_again(nearby, row, scalable, promise, at, &region[i]);
            xi[i] = at[0];
            eta[i] = at[1];
            dist[i] = at[2];
        }
}

/* The nearest segment so far: its number, answer and status, and a lower bound of its distance. */
typedef struct {
    size_t which;
    REAL at[3], least;
    int region, status;
} footpoint_detail_KIND_candidate;

/* Refines an answer to rounding, if that is proved. */
FOOTPOINT_COLD void footpoint_detail_KIND_refine(footpoint_detail_nearby *nearby,
                                                 const REAL *const *x, const REAL *xS, REAL promise,
                                                 footpoint_detail_KIND_candidate *c)
{
    footpoint_detail_KIND_candidate finer = *c;
    const REAL *row[VECTORS];
    footpoint_detail_KIND_row(x, xS, c->which, row);
    if (c->status != FOOTPOINT_OK || c->least >= fabs(c->at[2]))
        return;
    if (footpoint_detail_KIND_proved_again(nearby, row, 0, promise, finer.at, &finer.region) !=
        FOOTPOINT_OK)
        return;
    finer.least = fabs(finer.at[2]);
    *c = finer;
}

/* Finds the nearest of n segments, and the side of their surface.  FOOTPOINT_UNPROVED if another segment without a proved
 * answer may be nearer; if errors of two answers could hide which is nearer, both are refined. */
FOOTPOINT_PART int footpoint_detail_KIND_proved_closest_of(footpoint_detail_nearby *nearby,
                                                           size_t n, const REAL *const *x,
                                                           const REAL *xS, int scalable,
                                                           REAL promise, REAL loc[2], REAL *dist,
                                                           int *region, size_t *which)
{
    footpoint_detail_KIND_candidate best = {0, {0.0, 0.0, 0.0}, 0.0, 0, FOOTPOINT_ERR_DOMAIN};
    REAL hidden = -1.0; /* lower bound on the distances of unproved segments; < 0: all are proved */
    size_t i;
    for (i = 0; i < n; i++) {
        footpoint_detail_KIND_candidate c, loser;
        const REAL *row[VECTORS];
        c.which = i;
        footpoint_detail_KIND_row(x, xS, i, row);
        c.status =
            footpoint_detail_KIND_proved_closest(nearby, row, scalable, promise, c.at, &c.region);
        if (c.status < FOOTPOINT_OK) {
            best.status = best.status < FOOTPOINT_OK ? c.status : best.status;
            continue;
        }
        c.least = footpoint_detail_KIND_none_nearer(row, promise, c.status, c.at);
        if (best.status >= FOOTPOINT_OK) {
            if (c.least < fabs(best.at[2]) && best.least < fabs(c.at[2])) {
                footpoint_detail_KIND_refine(nearby, x, xS, promise, &best);
                footpoint_detail_KIND_refine(nearby, x, xS, promise, &c);
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
        best.at[2] = footpoint_detail_KIND_behind_all(n, x, xS, best.which, best.at, best.region)
                         ? -fabs(best.at[2])
                         : fabs(best.at[2]);
    if (hidden >= 0.0 && hidden < fabs(best.at[2]))
        best.status = FOOTPOINT_UNPROVED;
    *which = best.which;
    return footpoint_detail_KIND_proved_answer(best.status, best.at, best.region, loc, dist,
                                               region);
}
