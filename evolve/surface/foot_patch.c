/* The certain closest point on a Gregory patch: the nearest among its stationary points (foot_patch_boxes.c), the
 * stationary points of its edges, and its corners. Edges are cubic curves: signs of Bernstein coefficients isolate the
 * zeros of a quintic. */
#include "foot_patch.h"

#include "surface.h"

#include <math.h>
#include <string.h>

#define MARGIN 1e-13 /* for rounding, in units of the patch's size */

int patch_points(enum patch_kind kind, const double x[][3], struct footpoint_gregory *patch)
{
    if (kind == PATCH_GREGORY)
        return footpoint_gregory_points(x, x + PATCH_NORMALS, patch);
    struct footpoint_bezier net;
    const int status = footpoint_bezier_points(x, x + PATCH_NORMALS, &net);
    if (status != FOOTPOINT_OK)
        return status;
    patch->net = net;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            memcpy(patch->twin[i][j], net.p[1 + i][1 + j], sizeof net.p[0][0]);
    return FOOTPOINT_OK;
}

static struct patch_box box_of(const double lo[2], const double hi[2])
{
    return (struct patch_box){{(1 + lo[0]) / 2, (1 + hi[0]) / 2}, {(1 + lo[1]) / 2, (1 + hi[1]) / 2}};
}

int foot_patch_stationary(const struct footpoint_gregory *patch, const double xs[3], const double lo[2],
                          const double hi[2], struct stationary found[PATCH_STATIONARY_MAX])
{
    struct patch_local l;
    const struct patch_box box = box_of(lo, hi);
    return patch_localise(patch, xs, &l) ? patch_boxes_search(&l, &box, found) : PATCH_UNCERTAIN;
}

struct edge_search {
    const struct patch_local *l;
    int edge, budget; /* v = 0, v = 1, u = 0, u = 1; intervals that may still be examined */
    struct stationary *best;
};

static void offer(const struct patch_local *l, double u, double v, struct stationary *best)
{
    const struct stationary s = patch_point_at(l, u, v, false);
    if (s.distance < best->distance)
        *best = s;
}

/* Offers the points of an edge where its quintic may vanish, in the interval [start, start + width]; b contains its
 * Bernstein coefficients there. Returns false if there are too many. */
static bool search_edge(struct edge_search *e, const double b[6], double start, double width)
{
    double a[6], left[6], least = b[0], most = b[0];
    for (int k = 1; k < 6; k++) {
        least = fmin(least, b[k]);
        most = fmax(most, b[k]);
    }
    if (least > MARGIN || most < -MARGIN)
        return true;
    if (e->budget-- == 0)
        return false;
    if (width < 1e-12) {
        const double t = start + width / 2;
        offer(e->l, e->edge < 2 ? t : e->edge - 2, e->edge < 2 ? e->edge : t, e->best);
        return true;
    }
    memcpy(a, b, sizeof a); /* becomes the right half's */
    for (int k = 0; k < 6; k++) {
        left[k] = a[0];
        for (int i = 0; i + k < 5; i++)
            a[i] = (a[i] + a[i + 1]) / 2;
    }
    return search_edge(e, left, start, width / 2) && search_edge(e, a, start + width / 2, width / 2);
}

/* Computes r' . r of an edge's cubic. */
static void edge_quintic(const struct patch_local *l, int edge, double b[6])
{
    static const double three[4] = {1, 3, 3, 1}, two[3] = {1, 2, 1}, five[6] = {1, 5, 10, 10, 5, 1};
    memset(b, 0, 6 * sizeof *b);
    for (int c = 0; c < 3; c++) {
        double p[4];
        for (int k = 0; k < 4; k++)
            p[k] = edge < 2 ? l->p[k][3 * edge][c] : l->p[3 * (edge - 2)][k][c];
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 3; j++)
                b[i + j] += three[i] * two[j] / five[i + j] * p[i] * 3 * (p[j + 1] - p[j]);
    }
}

bool foot_patch_closest(const struct footpoint_gregory *patch, const double xs[3], struct stationary *closest)
{
    const struct patch_box whole = {{0, 1}, {0, 1}};
    struct stationary found[PATCH_STATIONARY_MAX], best = {.distance = INFINITY};
    struct patch_local l;
    if (!patch_localise(patch, xs, &l))
        return false;
    const int n = patch_boxes_search(&l, &whole, found);
    if (n == PATCH_UNCERTAIN)
        return false;
    for (int k = 0; k < 4; k++)
        offer(&l, k / 2, k % 2, &best);
    for (int k = 0; k < 4; k++) {
        struct edge_search e = {&l, k, 4000, &best};
        double b[6];
        edge_quintic(&l, k, b);
        if (!search_edge(&e, b, 0, 1))
            return false;
    }
    for (int k = n - 1; k >= 0; k--)
        if (found[k].minimum && found[k].distance <= best.distance)
            best = found[k];
    *closest = best;
    return true;
}

bool foot_patch_closest_near(const struct footpoint_gregory *patch, const double xs[3], const double lo[2],
                             const double hi[2], const double near[2], struct stationary *closest)
{
    const struct patch_box box = box_of(lo, hi);
    struct patch_local l;
    long double u = (1 + (long double)near[0]) / 2, v = (1 + (long double)near[1]) / 2;
    bool minimum;
    if (!patch_localise(patch, xs, &l) || !patch_polish(&l, &u, &v, &minimum) || !minimum ||
        !patch_boxes_none_nearer(&l, &box, (double)u, (double)v))
        return false;
    *closest = patch_point_at(&l, u, v, minimum);
    return true;
}

/* Computes (xs - r).n; returns false if the surface has no normal. */
static bool gap_at(const struct footpoint_gregory *patch, const double xs[3], double xi, double eta, double *gap)
{
    struct patch_local l;
    struct patch_jet jet;
    if (!patch_localise(patch, xs, &l))
        return false;
    patch_evaluate(&l, (1 + (long double)xi) / 2, (1 + (long double)eta) / 2, &jet);
    long double n[3];
    long_cross(jet.u, jet.v, n);
    const long double length = sqrtl(long_dot(n, n));
    *gap = (double)(-l.size * long_dot(jet.r, n) / length);
    return length > 0;
}

bool surface_foot_patch(const struct surface *f, struct sample *s, const double lo[2], const double hi[2],
                        const double near[2])
{
    struct footpoint_gregory patch;
    struct stationary found[PATCH_STATIONARY_MAX];
    if (patch_points(f->patch, (const double(*)[3])s->x, &patch) != FOOTPOINT_OK)
        return false;
    const bool known = near && foot_patch_closest_near(&patch, s->xs, lo, hi, near, found);
    const int n = known ? 1 : foot_patch_stationary(&patch, s->xs, lo, hi, found);
    for (int k = 0; k < n; k++)
        if (found[k].minimum && stationary_inside(&found[k], lo, hi) &&
            gap_at(&patch, s->xs, found[k].xi, found[k].eta, &s->gap)) {
            s->xi = found[k].xi;
            s->eta = found[k].eta;
            return true;
        }
    return false;
}

void surface_point_patch(const struct surface *f, double (*x)[3], double xi, double eta, double r[3][3])
{
    struct footpoint_gregory patch = {0};
    struct footpoint_jet jet;
    patch_points(f->patch, (const double(*)[3])x, &patch);
    footpoint_gregory_jet(&patch, xi, eta, &jet);
    for (int k = 0; k < 3; k++) {
        r[0][k] = patch.net.origin[k] + jet.r[k];
        r[1][k] = jet.r_xi[k];
        r[2][k] = jet.r_eta[k];
    }
}
