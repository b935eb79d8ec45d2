/* Samples of a user's own mesh.
 *
 * Real pairs are a slave node and a master face whose certain foot point lies within the face, or up to a tenth of it
 * outside, and nearer than the scene's distance. One half, chosen by seed, trains; the other half is held out.
 *
 * Random slave nodes over the master faces are added, in separate streams for training and for the held-out set. The
 * logarithm of their |gap| is uniform, from 1e-4 of the face's shortest edge to the distance, so most lie near the
 * face.
 *
 * Slave nodes are sorted by x, and a face visits only those in its range of x. Nodes of the face and of elements around
 * it are excluded: they belong to the slave surface, too, but never come into contact with the face; their gap is 0, or
 * depends only on the mesh. */
#include "../common/stream.h"
#include "../input/mesh.h"
#include "../surface/surface.h"
#include "samples.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A slave node on a master face. */
struct pair {
    int slave, node[SEGMENT_VECTORS];
    struct sample s;
};

struct pairs {
    struct pair *pair; /* owned */
    size_t n, room;
};

struct slave {
    double x;
    int node;
};

/* ---- neighbours ---- */

/* The neighbours of one face at a time: nodes of the elements under contact surfaces that share a node with the face. They
 * include the face's own nodes and nodes on the opposite side of an element. */
struct neighbours {
    const struct mesh *mesh; /* not owned */
    size_t *first;           /* nodes + 1: index in `element` of the node's first element */
    size_t *element;         /* indices into mesh->element */
    size_t *last;            /* indexed by node: number of the last face whose neighbour it was, from 1, or 0 */
    size_t face;             /* number of the current face */
};

static struct neighbours neighbours_new(struct arena *a, const struct mesh *mesh)
{
    struct neighbours n = {.mesh = mesh,
                           .first = arena_array(a, mesh->nodes + 1, sizeof *n.first),
                           .last = arena_array(a, mesh->nodes, sizeof *n.last)};
    for (size_t e = 0; e < mesh->elements; e++)
        for (int i = 0; i < mesh->element[e].nodes; i++)
            n.first[mesh->element[e].node[i]]++;
    for (size_t node = 0; node < mesh->nodes; node++)
        n.first[node + 1] += n.first[node];
    n.element = arena_array(a, n.first[mesh->nodes], sizeof *n.element);
    for (size_t e = mesh->elements; e-- > 0;) /* turns ends into beginnings */
        for (int i = 0; i < mesh->element[e].nodes; i++)
            n.element[--n.first[mesh->element[e].node[i]]] = e;
    return n;
}

/* Finds the neighbours of `face`. */
static void neighbours_of(struct neighbours *n, const struct mesh_face *face)
{
    n->face++;
    for (int i = 0; i < face->nodes; i++)
        for (size_t k = n->first[face->node[i]]; k < n->first[face->node[i] + 1]; k++) {
            const struct mesh_element *e = &n->mesh->element[n->element[k]];
            for (int j = 0; j < e->nodes; j++)
                n->last[e->node[j]] = n->face;
        }
}

/* ---- real pairs ---- */

static int by_x(const void *a, const void *b)
{
    const struct slave *p = a, *q = b;
    return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->node > q->node) - (p->node < q->node);
}

static int by_nodes(const void *a, const void *b)
{
    const struct pair *p = a, *q = b;
    for (int i = 0; i < SEGMENT_VECTORS; i++)
        if (p->node[i] != q->node[i])
            return p->node[i] < q->node[i] ? -1 : 1;
    return (p->slave > q->slave) - (p->slave < q->slave);
}

static void set_nodes(const struct mesh *mesh, const struct mesh_face *face, struct sample *s)
{
    for (int i = 0; i < face->nodes; i++)
        memcpy(s->x[i], mesh->xyz[face->node[i]], sizeof s->x[i]);
}

/* Returns the index of the first of n slaves, ascending in x, whose x is not below `x`. */
static size_t first_from(const struct slave *slave, size_t n, double x)
{
    size_t first = 0;
    for (size_t last = n; first < last;) {
        const size_t middle = first + (last - first) / 2;
        if (slave[middle].x < x)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

/* Returns the largest sum of negative shape functions at points up to MESH_OVERHANG outside of a face. All shape
 * functions sum to 1, so such a point exceeds the range of the nodes' coordinates by at most this part of the range. */
static double negative_part(int nodes)
{
    return nodes > 4 ? 1.3 : 2 * MESH_OVERHANG * (1 + MESH_OVERHANG); /* nine nodes: 1.27 at the corners */
}

static void search(const struct scene *scene, const struct mesh *mesh, const struct mesh_pair *p,
                   struct neighbours *around, struct pairs *found)
{
    const struct surface *surface = surface_find(scene->segment);
    const double distance = scene->mesh.distance;
    double lo[2], hi[2];
    scene_box(scene, lo, hi);
    struct slave *slave = new_array(p->slaves, sizeof *slave);
    for (size_t i = 0; i < p->slaves; i++)
        slave[i] = (struct slave){mesh->xyz[p->slave[i]][0], p->slave[i]};
    qsort(slave, p->slaves, sizeof *slave, by_x);
    for (size_t f = 0; f < p->masters; f++) {
        struct pair pair = {0};
        double least = INFINITY, most = -INFINITY;
        memcpy(pair.node, p->master[f].node, (size_t)p->master[f].nodes * sizeof *pair.node);
        set_nodes(mesh, &p->master[f], &pair.s);
        for (int i = 0; i < p->master[f].nodes; i++) {
            least = fmin(least, pair.s.x[i][0]);
            most = fmax(most, pair.s.x[i][0]);
        }
        neighbours_of(around, &p->master[f]);
        const double margin = distance + negative_part(p->master[f].nodes) * (most - least);
        for (size_t i = first_from(slave, p->slaves, least - margin); i < p->slaves && slave[i].x <= most + margin;
             i++) {
            pair.slave = slave[i].node;
            memcpy(pair.s.xs, mesh->xyz[pair.slave], sizeof pair.s.xs);
            if (around->last[pair.slave] == around->face || !surface->foot(surface, &pair.s, lo, hi, NULL) ||
                !(fabs(pair.s.gap) < distance))
                continue;
            APPEND(found->pair, found->n, found->room) = pair;
        }
    }
    free(slave);
}

/* Keeps each slave node and face once; surfaces may occur in several contact pairs. */
static void remove_repeated(struct pairs *found)
{
    size_t n = 0;
    if (found->n == 0)
        return;
    qsort(found->pair, found->n, sizeof *found->pair, by_nodes);
    for (size_t i = 1; i < found->n; i++)
        if (by_nodes(&found->pair[n], &found->pair[i]) != 0)
            found->pair[++n] = found->pair[i];
    found->n = n + 1;
}

static void find_pairs(const struct scene *scene, const struct mesh *mesh, struct pairs *found)
{
    struct arena memory = {NULL};
    struct neighbours around = neighbours_new(&memory, mesh);
    for (size_t i = 0; i < mesh->pairs; i++)
        search(scene, mesh, &mesh->pair[i], &around, found);
    arena_free(&memory);
    remove_repeated(found);
}

/* Draws a slave node over a face, both at random. */
static bool draw_pair(const struct sampler *sampler, struct sample *s)
{
    const struct scene *scene = sampler->scene;
    const struct mesh *mesh = sampler->mesh;
    const struct mesh_pair *p = &mesh->pair[gsl_rng_uniform_int(sampler->stream, mesh->pairs)];
    if (p->masters == 0)
        return false;
    set_nodes(mesh, &p->master[gsl_rng_uniform_int(sampler->stream, p->masters)], s);
    const double edge = sample_shortest_edge(s, scene->segment->corners), most = scene->mesh.distance;
    /* The distance may be less than ten times 1e-4 of an edge, and an edge may be 0. */
    const double least = edge > 0 ? fmin(1e-4 * edge, 0.1 * most) : 1e-4 * most;
    if (!place_slave(sampler->stream, scene, least, most, s))
        return false;
    sample_order(s, scene->order);
    return true;
}

/* Adds the part's half of the real pairs, but at most `most`, so that most training samples are random. */
static void add_half(const struct scene *scene, const struct pairs *found, bool training, size_t most,
                     struct sample_set *set)
{
    gsl_rng *stream = stream_new();
    const size_t half = (found->n + 1) / 2, from = training ? 0 : half, to = training ? half : found->n;
    stream_key(stream, scene->seed, PART_TRAINING, 0, 0);
    if (found->n > 0)
        gsl_ran_shuffle(stream, found->pair, found->n, sizeof *found->pair);
    gsl_rng_free(stream);
    for (size_t i = from; i < to && i < from + most; i++) {
        sample_order(&found->pair[i].s, scene->order);
        sample_set_add(set, &found->pair[i].s);
        set->real++;
    }
}

size_t mesh_drawn(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH])
{
    const size_t real = p->listed.real;
    snprintf(line[0], DRAWN_LENGTH,
             "heldout: over master faces at random, xi and eta uniform, |gap| from 1e-4 of the face's shortest edge to "
             "%g, its logarithm uniform",
             p->scene->mesh.distance);
    snprintf(line[1], DRAWN_LENGTH, "heldout: of these, %zu are nodes of the mesh%s; training has as many others", real,
             real < MESH_FEW ? ", too few to go by" : "");
    return 2;
}

bool mesh_prepare(struct sampler *p, struct diag *d)
{
    const struct scene *scene = p->scene;
    struct pairs found = {0};
    p->mesh = mesh_read(scene->mesh.file, d);
    p->draw = draw_pair;
    if (!p->mesh)
        return false;
    mesh_keep_faces(p->mesh, scene->segment);
    if (p->part == PART_VALIDATION)
        return true;
    const bool training = p->part == PART_TRAINING;
    find_pairs(scene, p->mesh, &found);
    add_half(scene, &found, training, training ? samples_wanted(scene, p->part) / 2 : found.n, &p->listed);
    free(found.pair);
    return true;
}
