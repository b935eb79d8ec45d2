/* Finds foot points of curved faces; see curved.h.
 *
 * The header proves a minimum of the distance to the whole surface.  On ordinary faces another test proves that it is the closest
 * point of the face.  If this fails, the header searches the closest point; if that is not proved, a certain search decides. */
#include "curved.h"

#include "../certain/quadratic.h"
#include "pairs.h"

#define SAME 1e-10 /* error of a certain search's distance over the largest difference of coordinates */

enum { MOST_BOXES = 20000 };

static int is_inside(int nodes, const double loc[2])
{
    return nodes == 6 ? loc[0] > 0.0 && loc[1] > 0.0 && loc[0] + loc[1] < 1.0
                      : fabs(loc[0]) < 1.0 && fabs(loc[1]) < 1.0;
}

/* Finds the closest point with certainty, and a bound on the error of its distance. */
static int closest_for_certain(const struct curved *k, const double *const *x, const double *s, double loc[2],
                               double *distance, double *error)
{
    double all[3 * PAIRS_MOST_VECTORS], most = 0.0;
    int boxes = MOST_BOXES;
    for (int i = 0; i < 3 * k->nodes + 3; i++) {
        all[i] = i < 3 * k->nodes ? x[i / 3][i % 3] : s[i % 3];
        most = fmax(most, fabs(all[i] - s[i % 3]));
    }
    *error = SAME * most;
    return footpoint_quadratic_closest(k->nodes, all, loc, loc, distance, &boxes);
}

/* Returns 1 if the proved minimum at `at`, `gap` away, is a certain foot point: no point of the face is nearer, or it lies outside
 * and the closest point on an edge. */
static int is_certain(const struct curved *k, const double *const *x, const double *s, const double at[2], double gap)
{
    double loc[2] = {at[0], at[1]}, distance, error;
    if (!is_inside(k->nodes, loc))
        loc[0] = loc[1] = k->nodes == 6 ? 1.0 / 3.0 : 0.0;
    const int status = closest_for_certain(k, x, s, loc, &distance, &error);
    if (status != FOOTPOINT_OK && status != FOOTPOINT_NOT_UNIQUE)
        return 0;
    return is_inside(k->nodes, at) ? fabs(gap) <= distance + error : !is_inside(k->nodes, loc);
}

/* Completes footpoint_curved_locate if the search's answer, with `status`, is not proved to be the closest point.  Writes at and
 * gap. */
static int look_elsewhere(const struct curved *k, const double *const *x, const double *s, int status, double at[2],
                          double *gap)
{
    double closest[2], distance;
    int region;
    const int proof = k->closest(x, s, closest, &distance, &region);
    if (proof == FOOTPOINT_OK && region == 0) {
        at[0] = closest[0];
        at[1] = closest[1];
        *gap = distance;
        return FOOTPOINT_OK;
    }
    if (status != FOOTPOINT_OK)
        return status;
    return (proof == FOOTPOINT_OK ? !is_inside(k->nodes, at) : is_certain(k, x, s, at, *gap)) ? FOOTPOINT_OK
                                                                                              : FOOTPOINT_UNPROVED;
}

int footpoint_curved_locate(const struct curved *k, const double *const *x, const double *s, double loc[2], double *gap)
{
    double at[2], g;
    int status = k->search(x, s, at, &g);
    if (status == FOOTPOINT_ERR_NOT_FINITE)
        return status;
    if (status != FOOTPOINT_OK || !k->is_closest(x, s, at))
        status = look_elsewhere(k, x, s, status, at, &g);
    if (status < FOOTPOINT_OK)
        return status;
    loc[0] = at[0];
    loc[1] = at[1];
    *gap = g;
    return status;
}

void footpoint_curved_check(const struct curved *k, const double *const *columns, const double *xi, const double *eta,
                            int *status)
{
    for (int i = 0; i < PAIRS_BLOCK; i++) {
        const double loc[2] = {xi[i], eta[i]}, *x[PAIRS_MOST_VECTORS];
        double y[PAIRS_MOST_VECTORS][3];
        if (status[i] != FOOTPOINT_OK)
            continue;
        for (int n = 0; n <= k->nodes; n++) {
            x[n] = y[n];
            for (int j = 0; j < 3; j++)
                y[n][j] = columns[3 * n + j][i];
        }
        if (!k->is_closest(x, x[k->nodes], loc))
            status[i] = FOOTPOINT_UNPROVED;
    }
}
