/* The nearest of several faces whose answers are not proved. */

/* Finds the nearest of n faces, and the side of their surface.  A face is searched again, by a descent, if errors of the search may
 * hide that it is the nearest. */
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
