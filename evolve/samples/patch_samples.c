/* Samples on Gregory and Bezier patches: the paper's data set of section 7.2, configurations of its lattice with random node
 * normals; and meshes of smooth bodies, as contact searches on smoothed surfaces meet them. The vectors of a sample are
 * corners and node normals. */
#include "../common/stream.h"
#include "../common/vec3.h"
#include "../surface/foot_patch.h"
#include "bodies.h"
#include "samples.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- random node normals on the paper's configurations ---- */

static void normalise(double v[3])
{
    const double length = vector_length(v);
    for (int k = 0; k < 3; k++)
        v[k] /= length;
}

/* Computes the facet's unit normal at corner c, and two unit vectors that complete the basis. */
static void corner_basis(double x[4][3], int c, double n[3], double e1[3], double e2[3])
{
    double next[3], last[3];
    for (int k = 0; k < 3; k++) {
        next[k] = x[(c + 1) % 4][k] - x[c][k];
        last[k] = x[(c + 3) % 4][k] - x[c][k];
    }
    vector_cross(next, last, n);
    normalise(n);
    memcpy(e1, next, 3 * sizeof *e1);
    normalise(e1);
    vector_cross(n, e1, e2);
}

/* Draws the node normals of a configuration; `tangent` is that of their largest tilt. */
static void draw_normals(gsl_rng *stream, double tangent, struct sample *s)
{
    for (int c = 0; c < 4; c++) {
        double n[3], e1[3], e2[3], *normal = s->x[PATCH_NORMALS + c];
        const double tilt = tangent * sqrt(gsl_rng_uniform(stream)), turn = 2 * M_PI * gsl_rng_uniform(stream);
        corner_basis(s->x, c, n, e1, e2);
        for (int k = 0; k < 3; k++)
            normal[k] = n[k] + tilt * (cos(turn) * e1[k] + sin(turn) * e2[k]);
        normalise(normal);
    }
}

/* Appends the part's samples on configurations of the lattice's grid, each with several sets of normals, ordered by
 * configuration, then by set: those whose foot points on the patch and on the facet lie in the scene's box. */
static bool on_the_grid(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d)
{
    const struct surface *f = surface_find(scene->segment);
    const size_t sets = (size_t)scene->lattice.normal_sets;
    struct scene of_facets = *scene;
    struct sample_set facets = {0};
    double lo[2], hi[2];
    of_facets.training = (scene->training + sets - 1) / sets;
    if (!lattice_grid(&of_facets, part, &facets, d))
        return false;
    const size_t most = part == PART_HELDOUT ? (scene->heldout + sets - 1) / sets : facets.n;
    gsl_rng *stream = stream_new();
    scene_box(scene, lo, hi);
    for (size_t i = 0; i < facets.n && i < most; i++)
        for (size_t k = 0; k < sets; k++) {
            struct sample s = facets.s[i];
            stream_key(stream, scene->seed, (uint64_t)part, i, 1 + k);
            draw_normals(stream, scene->lattice.tilt, &s);
            if (f->foot(f, &s, lo, hi, (double[]){s.xi, s.eta}))
                sample_set_add(set, &s);
        }
    gsl_rng_free(stream);
    sample_set_free(&facets);
    return set->n > 0 || diag_at(d, scene->path, 0, 0, "no sample's foot point lies in the box");
}

/* ---- meshes of smooth bodies ---- */

/* Coarse and fine meshes, whose nodes are moved by up to a fifth of a segment. */
enum { SIZES = 4, MESHES = SMOOTH_KINDS * SIZES };
static const int size[SMOOTH_KINDS][SIZES] = {{3, 4, 6, 8}, {8, 12, 16, 20}, {4, 6, 8, 12}, {10, 14, 18, 24}};
static const double jitter = 0.2;

/* Draws a body, one of its meshes, a segment, and a slave node over it, with the mesh's node normals. The foot point is
 * the patch's certain closest point. Returns false, to be drawn again, if another point is nearer or the search cannot
 * decide. */
static bool draw_body(const struct sampler *p, struct sample *s)
{
    gsl_rng *stream = p->stream;
    const struct smooth_mesh *m = p->body[gsl_rng_uniform_int(stream, MESHES)];
    const double xi = gsl_ran_flat(stream, -1, 1), eta = gsl_ran_flat(stream, -1, 1);
    struct footpoint_gregory patch;
    struct stationary closest;
    double r[3], n[3];
    smooth_segment(m, gsl_rng_uniform_int(stream, m->segments), m->mean, s->x, s->x + PATCH_NORMALS);
    const double height = p->scene->shapes.gap * sample_shortest_edge(s, 4) * gsl_ran_flat(stream, -1, 1);
    if (patch_points(surface_find(p->scene->segment)->patch, (const double(*)[3])s->x, &patch) != FOOTPOINT_OK ||
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

static struct smooth_mesh **smooth_new(uint64_t seed)
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

/* ---- parts of a scene ---- */

/* Draws a configuration off the grid, with one set of normals. */
static bool draw_facet(const struct sampler *p, struct sample *s)
{
    const struct surface *f = surface_find(p->scene->segment);
    double lo[2], hi[2];
    if (!lattice_draw(p, s))
        return false;
    draw_normals(p->stream, p->scene->lattice.tilt, s);
    scene_box(p->scene, lo, hi);
    return f->foot(f, s, lo, hi, (double[]){s->xi, s->eta});
}

size_t patches_drawn(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH])
{
    if (p->scene->source == SOURCE_LATTICE) {
        const size_t lines = lattice_drawn(p, line);
        snprintf(line[lines], DRAWN_LENGTH,
                 "normals at each corner: tilt uniform in a disc, %d sets a configuration of the grid",
                 p->scene->lattice.normal_sets);
        return lines + 1;
    }
    size_t length = (size_t)snprintf(line[0], DRAWN_LENGTH, "any segment of any of %d meshes of", (int)MESHES);
    for (int k = 0; k < SMOOTH_KINDS; k++)
        length += (size_t)snprintf(line[0] + length, DRAWN_LENGTH - length, "%s %s", k > 0 ? "," : "", smooth_name[k]);
    snprintf(line[0] + length, DRAWN_LENGTH - length, ", coarse to fine; xi, eta and gap uniform");
    return 1;
}

bool patches_prepare(struct sampler *p, struct diag *d)
{
    if (p->scene->source != SOURCE_LATTICE) {
        p->body = smooth_new(p->scene->seed);
        p->draw = draw_body;
    } else if (p->part == PART_TRAINING || p->part == PART_HELDOUT)
        return on_the_grid(p->scene, p->part, &p->listed, d);
    else
        p->draw = draw_facet;
    return true;
}
