/* Samples on meshes of smooth bodies; see body_samples.h. */
#include "body_samples.h"

#include "../../codegen/base/base.h"
#include "../common/stream.h"
#include "../surface/foot_patch.h"
#include "bodies.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>

/* Coarse and fine meshes, whose nodes are moved by up to a fifth of a segment. */
enum { SIZES = 4, MESHES = SMOOTH_KINDS * SIZES };
static const int size[SMOOTH_KINDS][SIZES] = {{3, 4, 6, 8}, {8, 12, 16, 20}, {4, 6, 8, 12}, {10, 14, 18, 24}};
static const double jitter = 0.2;

static double shortest_edge(double x[4][3])
{
    double shortest = INFINITY;
    for (int c = 0; c < 4; c++) {
        const double *p = x[c], *q = x[(c + 1) % 4];
        shortest = fmin(shortest, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
    }
    return shortest;
}

bool smooth_draw(gsl_rng *stream, struct smooth_mesh *const *mesh, double gap, enum patch_kind kind, struct sample *s)
{
    const struct smooth_mesh *m = mesh[gsl_rng_uniform_int(stream, MESHES)];
    const double xi = gsl_ran_flat(stream, -1, 1), eta = gsl_ran_flat(stream, -1, 1);
    struct footpoint_gregory patch;
    struct stationary closest;
    double r[3], n[3];
    smooth_segment(m, gsl_rng_uniform_int(stream, m->segments), m->mean, s->x, s->x + PATCH_NORMALS);
    const double height = gap * shortest_edge(s->x) * gsl_ran_flat(stream, -1, 1);
    if (patch_points(kind, (const double(*)[3])s->x, &patch) != FOOTPOINT_OK ||
        footpoint_gregory_normal(&patch, xi, eta, n) != FOOTPOINT_OK)
        return false;
    footpoint_gregory_position(&patch, xi, eta, r);
    for (int k = 0; k < 3; k++)
        s->xs[k] = r[k] + height * n[k];
    const bool known =
        foot_patch_closest_near(&patch, s->xs, (double[]){-1, -1}, (double[]){1, 1}, (double[]){xi, eta}, &closest);
    if ((!known && !foot_patch_closest(&patch, s->xs, &closest)) || !closest.minimum ||
        fabs(closest.xi - xi) + fabs(closest.eta - eta) > 1e-6)
        return false;
    s->xi = closest.xi;
    s->eta = closest.eta;
    return footpoint_gregory_gap(&patch, s->xs, s->xi, s->eta, &s->gap) == FOOTPOINT_OK;
}

size_t smooth_drawn(char line[DRAWN_LINES][DRAWN_LENGTH])
{
    size_t length = (size_t)snprintf(line[0], DRAWN_LENGTH, "any segment of any of %d meshes of", (int)MESHES);
    for (int k = 0; k < SMOOTH_KINDS; k++)
        length += (size_t)snprintf(line[0] + length, DRAWN_LENGTH - length, "%s %s", k > 0 ? "," : "", smooth_name[k]);
    snprintf(line[0] + length, DRAWN_LENGTH - length, ", coarse to fine; xi, eta and gap uniform");
    return 1;
}

struct smooth_mesh **smooth_new(uint64_t seed)
{
    struct smooth_mesh **mesh = new_array(MESHES, sizeof(struct smooth_mesh *));
    for (int k = 0; k < MESHES; k++)
        mesh[k] =
            smooth_mesh_new((enum smooth_kind)(k / SIZES), size[k / SIZES][k % SIZES], jitter, seed + (uint64_t)k);
    return mesh;
}

void smooth_free(struct smooth_mesh **mesh)
{
    for (int k = 0; mesh && k < MESHES; k++)
        smooth_mesh_free(mesh[k]);
    free(mesh);
}

void smooth_samples(const struct smooth *smooth, enum sample_part part, size_t count, struct sample_set *set)
{
    struct smooth_mesh **mesh = smooth_new(smooth->seed);
    gsl_rng *stream = stream_new();
    for (size_t i = 0; i < count; i++) {
        struct sample s = {0};
        stream_key(stream, smooth->seed, (uint64_t)part, i, 0);
        while (!smooth_draw(stream, mesh, smooth->gap, smooth->kind, &s))
            continue;
        sample_set_add(set, &s);
    }
    smooth_free(mesh);
    gsl_rng_free(stream);
}
