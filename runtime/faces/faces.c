/* Functions of faces of every kind; see footpoint_face.h. */
#include "../certain/quadratic.h"
#include "../certain/robust.h"
#include "../certain/triangle.h"
#include "../footpoint_face.h"
#include "face_table.h"

const struct face *footpoint_face_of(enum footpoint_face face)
{
    switch (face) {
    case FOOTPOINT_TRI3:
        return &footpoint_face_tri3;
    case FOOTPOINT_TRI6:
        return &footpoint_face_tri6;
    case FOOTPOINT_QUAD4:
        return &footpoint_face_quad4;
    case FOOTPOINT_QUAD8:
        return &footpoint_face_quad8;
    case FOOTPOINT_QUAD9:
        return &footpoint_face_quad9;
    case FOOTPOINT_EDGE2:
        return &footpoint_face_edge2;
    case FOOTPOINT_EDGE3:
        return &footpoint_face_edge3;
    default:
        return NULL;
    }
}

static struct rows rows_of(const struct face *f, const double *x)
{
    struct rows r;
    for (int k = 0; k < f->pairs.nodes; k++)
        r.x[k] = x + 3 * k;
    r.s = x + 3 * f->pairs.nodes;
    return r;
}

int footpoint_face_nodes(enum footpoint_face face)
{
    const struct face *const f = footpoint_face_of(face);
    return f ? f->pairs.nodes : 0;
}

int footpoint_face_locate(enum footpoint_face face, const double *x, double loc[2], double *gap)
{
    const struct face *const f = footpoint_face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->pairs.locate(r.x, r.s, loc, gap);
}

int footpoint_track(enum footpoint_face face, const double *x, double loc[2], double *gap)
{
    const struct face *const f = footpoint_face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->track.locate(r.x, r.s, loc, gap);
}

int footpoint_face_along(enum footpoint_face face, const double *x, const double along[3], double loc[2], double *dist)
{
    const struct face *const f = footpoint_face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    struct rows r = rows_of(f, x);
    r.x[f->pairs.nodes] = r.s;
    r.x[f->pairs.nodes + 1] = along;
    return f->along.locate(r.x, r.s, loc, dist);
}

int footpoint_along(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                    const double along[3], double loc[2], double *dist)
{
    const double *const x[] = {xA, xB, xC, xD, xS, along};
    return footpoint_face_quad4.along.locate(x, xS, loc, dist);
}

int footpoint_face_closest(enum footpoint_face face, const double *x, double loc[2], double *distance, int *region)
{
    const struct face *const f = footpoint_face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->closest(r.x, r.s, loc, distance, region);
}

/* Returns the region of a place of the face, as in footpoint_face.h: 0 if it is strictly inside. */
static int region_of(int corners, const double loc[2])
{
    const double u = loc[0], v = loc[1];
    const int edges = corners == 3 ? (v <= 0.0) | (u + v >= 1.0) << 1 | (u <= 0.0) << 2
                                   : (v <= -1.0) | (u >= 1.0) << 1 | (v >= 1.0) << 2 | (u <= -1.0) << 3;
    for (int k = 0; k < corners; k++)
        if (edges >> k & edges >> (k + corners - 1) % corners & 1)
            return 1 + corners + k;
    for (int k = 0; k < corners; k++)
        if (edges >> k & 1)
            return 1 + k;
    return 0;
}

enum { MOST_BOXES = 20000 };

/* Returns 1 if the header proves a foot point inside a plane triangle, which is then the closest point. */
static int is_inside(const struct face *f, const struct robust_start *start)
{
    const double least = 4.0 * f->promise, u = start->loc[0], v = start->loc[1];
    return f->promise > 0.0 && start->status == FOOTPOINT_OK && u > least && v > least && 1.0 - u - v > least;
}

static int closest_of_triangle(const struct face *f, const double *x, const struct robust_start *start, double loc[2],
                               double *distance)
{
    if (!is_inside(f, start))
        return footpoint_triangle_closest(x, loc, distance);
    loc[0] = start->loc[0];
    loc[1] = start->loc[1];
    *distance = fabs(start->distance);
    return FOOTPOINT_OK;
}

/* Returns 1 if products of eight lengths stay in the range of double. */
static int is_of_ordinary_size(const struct face *f, const double *x)
{
    double size = 0.0;
    for (int i = 0; i < 3 * f->pairs.nodes; i++)
        size = fmax(size, fabs(x[i] - x[3 * f->pairs.nodes + i % 3]));
    return size > 1e-30 && size < 1e30;
}

/* Returns |xS - r| at loc, or `otherwise` if the face has no normal there. */
static double distance_at(const struct face *f, const double *x, const double loc[2], double otherwise)
{
    const struct rows r = rows_of(f, x);
    double phi[9], a[3], b[3], normal[3], gap, square = 0.0;
    if (f->place(r.x, r.s, loc, phi, a, b, normal, &gap) != FOOTPOINT_OK)
        return otherwise;
    for (int i = 0; i < 3; i++) {
        double d = 0.0;
        for (int k = 0; k < f->pairs.nodes; k++)
            d += phi[k] * (r.s[i] - r.x[k][i]);
        square += d * d;
    }
    return sqrt(square);
}

/* Finds the closest point by a certain search, from `at` and, where that is not proved, from the middle: on some slim faces the
 * descent from one of them crawls. */
static int closest_for_certain(int nodes, const double *x, const double at[2], double loc[2], double *distance)
{
    const double middle = nodes == 6 ? 1.0 / 3.0 : 0.0, from[2] = {middle, middle};
    int boxes = MOST_BOXES;
    double second[2], away;
    const int status = footpoint_quadratic_closest(nodes, x, at ? at : from, loc, distance, &boxes);
    if (status != FOOTPOINT_UNPROVED || !at)
        return status;
    const int other = footpoint_quadratic_closest(nodes, x, from, second, &away, &boxes);
    if (other == FOOTPOINT_UNPROVED && !(away < *distance))
        return status;
    loc[0] = second[0];
    loc[1] = second[1];
    *distance = away;
    return other;
}

/* Finds the closest point: the header's foot point if it is proved to be closest, its closest point if that is proved, otherwise
 * by a certain search. */
static int closest_of_curved(const struct face *f, const double *x, const struct robust_start *start, double loc[2],
                             double *distance)
{
    const struct rows r = rows_of(f, x);
    double at[2] = {start->loc[0], start->loc[1]}, away = start->distance;
    int region;
    if (is_of_ordinary_size(f, x) && ((start->status == FOOTPOINT_OK && f->is_closest(r.x, r.s, at)) ||
                                      f->closest(r.x, r.s, at, &away, &region) == FOOTPOINT_OK)) {
        loc[0] = at[0];
        loc[1] = at[1];
        *distance = distance_at(f, x, loc, fabs(away));
        return FOOTPOINT_OK;
    }
    return closest_for_certain(f->pairs.nodes, x, start->status >= FOOTPOINT_OK ? start->loc : NULL, loc, distance);
}

/* Completes footpoint_face_robust from the results of f->start. */
static int robust_from(const struct face *f, const double *x, const struct robust_start *start, double loc[2],
                       double *distance, int *region)
{
    const struct rows r = rows_of(f, x);
    const int nodes = f->pairs.nodes, corners = nodes == 3 || nodes == 6 ? 3 : 4;
    const double *const all[] = {x, x + 3, x + 6, x + 9, x + 12};
    if (f->robust)
        return f->robust(r.x, r.s, loc, distance, region);
    const int status = nodes == 3   ? closest_of_triangle(f, x, start, loc, distance)
                       : nodes == 4 ? footpoint_robust_from(all, start, loc, distance)
                                    : closest_of_curved(f, x, start, loc, distance);
    if (status < FOOTPOINT_OK)
        return status;
    *region = region_of(corners, loc);
    if (nodes != 4 && status != FOOTPOINT_NO_AREA)
        *distance = copysign(*distance, f->behind(r.x, r.s, loc, *region > 0, NULL) ? -1.0 : 1.0);
    return status == FOOTPOINT_OK && *region ? FOOTPOINT_OUTSIDE : status;
}

int footpoint_face_robust(enum footpoint_face face, const double *x, double loc[2], double *distance, int *region)
{
    const struct face *const f = footpoint_face_of(face);
    struct robust_start start = {FOOTPOINT_UNPROVED, {0.0, 0.0}, 0.0};
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    if (face == FOOTPOINT_QUAD4) {
        const int status = footpoint_robust(r.x[0], r.x[1], r.x[2], r.x[3], r.s, loc, distance);
        *region = status >= FOOTPOINT_OK ? region_of(4, loc) : *region;
        return status;
    }
    if (!f->robust && (face != FOOTPOINT_TRI3 || f->promise > 0.0))
        start.status = f->start.locate(r.x, r.s, start.loc, &start.distance);
    return robust_from(f, x, &start, loc, distance, region);
}

int footpoint_face_place(enum footpoint_face face, const double *x, const double loc[2], double *phi, double *r_xi,
                         double *r_eta, double *normal, double *gap)
{
    const struct face *const f = footpoint_face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->place(r.x, r.s, loc, phi, r_xi, r_eta, normal, gap);
}

int footpoint_face_differentiate(enum footpoint_face face, const double *x, const double loc[2], double *phi,
                                 double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                                 double *d_gap)
{
    const struct face *const f = footpoint_face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->differentiate(r.x, r.s, loc, phi, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap);
}

int footpoint_face_hessian(enum footpoint_face face, const double *x, const double loc[2], double *gap, double *d_xi,
                           double *d_eta, double *d_gap, double *d_normal, double *hessian)
{
    const struct face *const f = footpoint_face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->hessian(r.x, r.s, loc, gap, d_xi, d_eta, d_gap, d_normal, hessian);
}

int footpoint_face_differentiate_along(enum footpoint_face face, const double *x, const double along[3],
                                       const double loc[2], double *dist, double *d_xi, double *d_eta, double *d_dist,
                                       double *h_xi, double *h_eta, double *h_dist)
{
    const struct face *const f = footpoint_face_of(face);
    double *const d[] = {d_xi, d_eta, d_dist}, *const h[] = {h_xi, h_eta, h_dist};
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->differentiate_along(r.x, r.s, along, loc, dist, d, h);
}

/* ---- many pairs ---- */

size_t footpoint_face_locate_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                   const int *slave, double *loc, double *gap, int *status)
{
    const struct face *const f = footpoint_face_of(face);
    const struct pairs pairs = {n, xyz, NULL, nodes, seg, slave, NULL};
    return footpoint_pairs_locate(f ? &f->pairs : NULL, &pairs, loc, gap, status);
}

size_t footpoint_track_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                             const int *slave, double *loc, double *gap, int *status)
{
    const struct face *const f = footpoint_face_of(face);
    const struct pairs pairs = {n, xyz, NULL, nodes, seg, slave, NULL};
    return footpoint_pairs_locate(f ? &f->track : NULL, &pairs, loc, gap, status);
}

size_t footpoint_face_along_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                  const int *slave, const double *along, double *loc, double *dist, int *status)
{
    const struct face *const f = footpoint_face_of(face);
    const struct pairs pairs = {n, xyz, NULL, nodes, seg, slave, along};
    return footpoint_pairs_locate(f ? &f->along : NULL, &pairs, loc, dist, status);
}

struct robust_answers {
    const struct face *face;
    double *loc, *distance;
    int *region;
};

static int finish_robust(const void *of, size_t pair, const double *x, int status, const double loc[2], double gap)
{
    const struct robust_answers *const to = of;
    const int found = status >= FOOTPOINT_OK;
    const struct robust_start start = {status, {found ? loc[0] : 0.0, found ? loc[1] : 0.0}, gap};
    int region;
    const int outcome = robust_from(to->face, x, &start, to->loc + 2 * pair, to->distance + pair, &region);
    if (outcome >= FOOTPOINT_OK && to->region)
        to->region[pair] = region;
    return outcome;
}

size_t footpoint_face_robust_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                   const int *slave, double *loc, double *distance, int *region, int *status)
{
    const struct face *const f = footpoint_face_of(face);
    const struct pairs pairs = {n, xyz, NULL, nodes, seg, slave, NULL};
    const struct robust_answers to = {f, loc, distance, region};
    return footpoint_pairs_finish(f ? &f->start : NULL, &pairs, finish_robust, &to, status);
}
