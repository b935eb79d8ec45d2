/* The nearest of many faces, at any distance; see footpoint_face_select.
 *
 * A face lies in a sphere. About c, the mean of its corners, their bilinear (or linear) interpolation is no farther
 * away than the farthest corner. Mid-side nodes add their distances from the middles of chords times shape functions >=
 * 0, which add up to at most 4/3 (tri6) or 2 (quad8: 2 - xi^2 - eta^2). The middle of a quad9 face adds its distance
 * from the quad8 face, times (1 - xi^2) (1 - eta^2). A face whose sphere is farther away than an answer is skipped. The
 * face with the nearest node comes first, so that most faces are skipped. */
#include "../footpoint_face.h"
#include "../geometry/vector.h"
#include "face_table.h"

#include <float.h>

/* Coordinates are differences from xS, each right to rounding. All quantities derived from them add less than 220
 * rounding errors (of 2^-53) of the largest. */
#define SPHERE_ERROR (256.0 * DBL_EPSILON)
/* Errors of distances, relative to that, with a reserve: footpoint_face_robust promises 1e-10. */
#define DISTANCE_ERROR 1e-9

struct candidate {
    size_t which;
    double loc[2], distance;
    int region, status;
    double least, size; /* lower bound on the distance from xS; largest difference of coordinates */
};

/* Returns the nodes of one of the candidates. */
static struct rows candidate_of(const struct face *f, const double *xyz, const int *seg, size_t which,
                                const double xS[3])
{
    struct rows r = {.s = xS};
    for (int k = 0; k < f->pairs.nodes; k++)
        r.x[k] = xyz + 3 * (size_t)seg[which * (size_t)f->pairs.nodes + (size_t)k];
    return r;
}

/* ---- spheres ---- */

static int is_finite(const struct rows *r, int nodes)
{
    int finite = vector_finite(r->s);
    for (int k = 0; k < nodes; k++)
        finite = finite && vector_finite(r->x[k]);
    return finite;
}

/* Computes the nodes relative to xS; returns the largest coordinate. */
static double seen_from(const struct rows *r, int nodes, double (*y)[3])
{
    double size = 0.0;
    for (int k = 0; k < nodes; k++)
        for (int i = 0; i < 3; i++) {
            y[k][i] = r->x[k][i] - r->s[i];
            size = fmax(size, fabs(y[k][i]));
        }
    return size;
}

static double distance_of(const double a[3], const double b[3])
{
    double d[3];
    vector_sub(a, b, d);
    return sqrt(vector_dot(d, d));
}

/* Returns by how much nodes other than corners increase the radius. */
static double bulge_of(const double (*y)[3], int nodes, int corners)
{
    double most = 0.0, at[3], middle[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < corners; k++) {
        for (int i = 0; i < 3; i++) {
            at[i] = 0.5 * (y[k][i] + y[(k + 1) % corners][i]);
            middle[i] += 0.5 * y[corners + k][i] - 0.25 * y[k][i];
        }
        most = fmax(most, distance_of(y[corners + k], at));
    }
    return (corners == 3 ? 4.0 / 3.0 : 2.0) * most + (nodes == 9 ? distance_of(y[8], middle) : 0.0);
}

/* Returns a lower bound on the distance of the face, y being its nodes relative to xS; 0 if squares overflow or
 * underflow. */
static double least_distance(const double (*y)[3], int nodes, double size)
{
    const int corners = nodes == 3 || nodes == 6 ? 3 : 4;
    const double origin[3] = {0.0, 0.0, 0.0};
    double centre[3] = {0.0, 0.0, 0.0}, radius = 0.0;
    if (!(size > 1e-140 && size < 1e140))
        return 0.0;
    for (int k = 0; k < corners; k++)
        for (int i = 0; i < 3; i++)
            centre[i] += y[k][i] / corners;
    for (int k = 0; k < corners; k++)
        radius = fmax(radius, distance_of(y[k], centre));
    if (nodes > corners)
        radius += bulge_of(y, nodes, corners);
    return distance_of(centre, origin) - radius - SPHERE_ERROR * size;
}

/* Returns the candidate with the node nearest to xS. */
static size_t with_nearest_node(const struct face *f, const double *xyz, size_t candidates, const int *seg,
                                const double xS[3])
{
    double nearest = DBL_MAX;
    size_t which = 0;
    for (size_t i = 0; i < candidates; i++) {
        const struct rows r = candidate_of(f, xyz, seg, i, xS);
        for (int k = 0; k < f->pairs.nodes && is_finite(&r, f->pairs.nodes); k++) {
            const double distance = distance_of(r.x[k], xS);
            if (distance < nearest) {
                nearest = distance;
                which = i;
            }
        }
    }
    return which;
}

/* ---- answers ---- */

/* Finds the closest point of one face: the header's, or, without a proof, the certain one. */
static void find_closest(enum footpoint_face face, const struct face *f, const struct rows *r, struct candidate *c)
{
    double x[3 * PAIRS_MOST_VECTORS], loc[2], distance;
    int region;
    c->status = f->closest(r->x, r->s, c->loc, &c->distance, &c->region);
    if (c->status == FOOTPOINT_OK || c->status == FOOTPOINT_NOT_UNIQUE)
        return;
    for (int i = 0; i < 3 * (f->pairs.nodes + 1); i++)
        x[i] = i < 3 * f->pairs.nodes ? r->x[i / 3][i % 3] : r->s[i % 3];
    const int status = footpoint_face_robust(face, x, loc, &distance, &region);
    if (status < FOOTPOINT_OK || status == FOOTPOINT_NO_AREA)
        return;
    c->loc[0] = loc[0];
    c->loc[1] = loc[1];
    c->distance = distance;
    c->region = region;
    c->status = status == FOOTPOINT_OUTSIDE ? FOOTPOINT_OK : status;
}

/* Decides which of two answers is nearer if rounding hides that, by the header's search for both. Returns true if c
 * wins, with the more accurate answer in *c; otherwise it is in *best. */
static int wins(const struct face *f, const double *xyz, const int *seg, const double xS[3], struct candidate *best,
                struct candidate *c)
{
    const double apart = fabs(c->distance) - fabs(best->distance);
    if (!(fabs(apart) <= DISTANCE_ERROR * fmax(c->size, best->size)))
        return apart < 0.0;
    const struct rows first = candidate_of(f, xyz, seg, best->which, xS),
                      second = candidate_of(f, xyz, seg, c->which, xS);
    const double *x[2 * PAIRS_MOST_VECTORS];
    double loc[2], distance;
    size_t which;
    int region;
    for (int k = 0; k < f->pairs.nodes; k++) {
        x[k] = first.x[k];
        x[f->pairs.nodes + k] = second.x[k];
    }
    if (f->nearest(2, x, xS, loc, &distance, &region, &which) < FOOTPOINT_OK)
        return apart < 0.0;
    struct candidate *const winner = which ? c : best;
    winner->loc[0] = loc[0];
    winner->loc[1] = loc[1];
    winner->distance = distance;
    winner->region = region;
    return which == 1;
}

/* Returns 1 if xS lies behind the surface of all candidates at loc, on an edge or a corner of one of them. */
static int is_behind_all(const struct face *f, const double *xyz, size_t candidates, const int *seg, const double xS[3],
                         const struct candidate *best)
{
    const struct rows chosen = candidate_of(f, xyz, seg, best->which, xS);
    const double *end[2], t = f->feature(chosen.x, best->loc, best->region, end);
    double fan[3] = {0.0, 0.0, 0.0};
    for (size_t i = 0; i < candidates; i++) {
        const struct rows r = candidate_of(f, xyz, seg, i, xS);
        f->add_face(r.x, r.s, end, t, fan);
    }
    return f->behind(chosen.x, chosen.s, best->loc, 1, fan);
}

/* ---- the search ---- */

/* The best answer so far, and a lower bound on the distances of unproved answers. */
struct search {
    enum footpoint_face face;
    const struct face *f;
    struct candidate best;
    double hidden;
};

static void visit(struct search *s, const double *xyz, const int *seg, const double xS[3], size_t which)
{
    const struct rows r = candidate_of(s->f, xyz, seg, which, xS);
    const int found = s->best.status >= FOOTPOINT_OK;
    const int nodes = s->f->pairs.nodes;
    double y[PAIRS_MOST_VECTORS][3];
    struct candidate c = {.which = which};
    if (is_finite(&r, nodes)) {
        c.size = seen_from(&r, nodes, y);
        /* z of edges does not count: no edge is skipped */
        c.least = s->f->robust ? 0.0 : least_distance((const double(*)[3])y, nodes, c.size);
    }
    if (found && c.least > fabs(s->best.distance) + DISTANCE_ERROR * s->best.size)
        return;
    find_closest(s->face, s->f, &r, &c);
    if (c.status < FOOTPOINT_OK) {
        s->best.status = found ? s->best.status : c.status;
        return;
    }
    const int better = !found || wins(s->f, xyz, seg, xS, &s->best, &c);
    const struct candidate *const loser = better ? &s->best : &c;
    if (found && loser->status == FOOTPOINT_UNPROVED)
        s->hidden = fmin(s->hidden, loser->least);
    if (better)
        s->best = c;
}

int footpoint_face_select(enum footpoint_face face, const double *xyz, size_t candidates, const int *seg,
                          const double xS[3], size_t *chosen, double loc[2], double *distance, int *region)
{
    struct search s = {face, footpoint_face_of(face), {.status = FOOTPOINT_ERR_DOMAIN}, DBL_MAX};
    if (!s.f)
        return FOOTPOINT_ERR_ARGUMENT;
    for (size_t i = 0; i < candidates * (size_t)s.f->pairs.nodes; i++)
        if (seg[i] < 0)
            return FOOTPOINT_ERR_ARGUMENT;
    const size_t first = with_nearest_node(s.f, xyz, candidates, seg, xS);
    if (candidates > 0)
        visit(&s, xyz, seg, xS, first);
    for (size_t i = 0; i < candidates; i++)
        if (i != first)
            visit(&s, xyz, seg, xS, i);
    if (s.best.status < FOOTPOINT_OK)
        return s.best.status;
    *chosen = s.best.which;
    loc[0] = s.best.loc[0];
    loc[1] = s.best.loc[1];
    *region = s.best.region;
    *distance = s.best.distance;
    if (*region > 0)
        *distance = copysign(*distance, is_behind_all(s.f, xyz, candidates, seg, xS, &s.best) ? -1.0 : 1.0);
    return s.hidden < fabs(*distance) ? FOOTPOINT_UNPROVED : s.best.status;
}
