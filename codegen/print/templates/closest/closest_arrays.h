/* Closest points over arrays of faces and slave nodes, and of one slave node over many faces. */

/* Roots of the squares in dist, and once more what NAME_closest does in another unit of length, behind the loop. */
FOOTPOINT_PART void
footpoint_detail_KIND_closest_n(footpoint_detail_nearest *nearest, size_t n, const REAL *const *x,
                                int scalable, REAL *FOOTPOINT_RESTRICT xi,
                                REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT dist,
                                int *FOOTPOINT_RESTRICT region, int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[3];
        status[i] = nearest(row, zero, at, &region[i]);
        xi[i] = at[0];
        eta[i] = at[1];
        dist[i] = at[2];
    }
    for (i = 0; i < n; i++)
        dist[i] = footpoint_detail_signed_root(dist[i]);
    for (i = 0; i < n; i++)
        if (status[i] != FOOTPOINT_OK) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            REAL at[3];
            int where = region[i];
            at[0] = xi[i];
            at[1] = eta[i];
            at[2] = dist[i];
            status[i] = status[i] == FOOTPOINT_ERR_DOMAIN
                            ? footpoint_detail_KIND_closest_beyond(row, at, &where)
                            : footpoint_detail_KIND_closest(nearest, row, scalable, at, &where);
            if (status[i] == FOOTPOINT_OK) {
                xi[i] = at[0];
                eta[i] = at[1];
                dist[i] = at[2];
                region[i] = where;
            }
        }
}

/* The vectors of face i and its slave node. */
FOOTPOINT_PART void footpoint_detail_KIND_row(const REAL *const *x, const REAL *xS, size_t i,
                                              const REAL *row[VECTORS])
{
    int k;
    for (k = 0; k < SEGMENT_VECTORS; k++)
        row[k] = x[SEGMENT_VECTORS * i + (size_t)k];
    row[SEGMENT_VECTORS] = xS;
}

/* Returns 1 if xS lies behind the surface that n faces make at loc, in `region` > 0 of face `which`. */
FOOTPOINT_COLD int footpoint_detail_KIND_behind_all(size_t n, const REAL *const *x, const REAL *xS,
                                                    size_t which, const REAL loc[2], int region)
{
    const REAL *row[VECTORS], *end[2];
    REAL fan[3] = {0.0, 0.0, 0.0}, t;
    size_t i;
    footpoint_detail_KIND_row(x, xS, which, row);
    t = footpoint_detail_KIND_feature(row, loc, region, end);
    for (i = 0; i < n; i++) {
        footpoint_detail_KIND_row(x, xS, i, row);
        footpoint_detail_KIND_add_face(row, end, t, fan);
    }
    footpoint_detail_KIND_row(x, xS, which, row);
    return footpoint_detail_KIND_behind(row, loc, 1, fan);
}

/* The nearest of n faces, and the side of the surface that they make.  A face is searched once more, by a descent, if errors of
 * the search may hide that it is the nearest. */
FOOTPOINT_PART int footpoint_detail_KIND_closest_of(footpoint_detail_nearest *nearest, size_t n,
                                                    const REAL *const *x, const REAL *xS,
                                                    int scalable, REAL loc[2], REAL *dist,
                                                    int *region, size_t *which)
{
    const REAL *row[VECTORS], *chosen[VECTORS];
    REAL best[3] = {0.0, 0.0, 0.0}, best_least = 0.0;
    int found = FOOTPOINT_ERR_DOMAIN, best_where = 0;
    size_t i, best_i = 0;
    for (i = 0; i < n; i++) {
        REAL at[3], least;
        int where, status, none, contest, k;
        footpoint_detail_KIND_row(x, xS, i, row);
        status = footpoint_detail_KIND_closest(nearest, row, scalable, at, &where);
        if (status != FOOTPOINT_OK) {
            found = found == FOOTPOINT_OK ? found : status;
            continue;
        }
        least = footpoint_detail_KIND_least(row, at, where);
        none = found != FOOTPOINT_OK;
        contest = !none && least < fabs(best[2]) && best_least < fabs(at[2]);
        if (contest && best_least < fabs(best[2])) {
            footpoint_detail_KIND_row(x, xS, best_i, chosen);
            (void)footpoint_detail_KIND_closest_from(chosen, best, best, &best_where);
            best_least = fabs(best[2]);
        }
        if (least < fabs(at[2]) && (contest || where > 0)) {
            (void)footpoint_detail_KIND_closest_from(row, at, at, &where);
            least = fabs(at[2]);
        }
        if (!none && fabs(at[2]) >= fabs(best[2]))
            continue;
        found = FOOTPOINT_OK;
        for (k = 0; k < 3; k++)
            best[k] = at[k];
        best_where = where;
        best_least = least;
        best_i = i;
    }
    if (found == FOOTPOINT_OK) {
        if (best_where > 0)
            best[2] = footpoint_detail_KIND_behind_all(n, x, xS, best_i, best, best_where)
                          ? -fabs(best[2])
                          : fabs(best[2]);
        *which = best_i;
    }
    return footpoint_detail_closest_answer(found, best, best_where, loc, dist, region);
}
