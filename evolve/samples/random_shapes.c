/* Random samples of ordinary faces (random_quads.c, random_faces.c). The slave node is r(xi,eta) + gap n(xi,eta). The
 * sample is then rotated, scaled and moved at random, and labelled with its certain foot point. */
#include "../common/stream.h"
#include "../common/vec3.h"
#include "../surface/surface.h"
#include "samples.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

static double draw_gap(gsl_rng *stream, double least, double most)
{
    if (least == 0)
        return draw_uniform(stream, most);
    const double part = draw_uniform(stream, 1);
    return copysign(least * pow(most / least, fabs(part)), part);
}

bool place_slave(gsl_rng *stream, const struct scene *scene, double least, double most, struct sample *s)
{
    const struct surface *f = surface_find(scene->segment);
    double lo[2], hi[2], wide[2][2], at[2], r[3], n[3];
    scene_box(scene, lo, hi);
    for (int k = 0; k < 2; k++) {
        const double middle = (lo[k] + hi[k]) / 2, half = (hi[k] - lo[k]) / 2 * (1 + 1e-9);
        at[k] = gsl_ran_flat(stream, lo[k], hi[k]);
        wide[0][k] = middle - half;
        wide[1][k] = middle + half;
    }
    const double h = draw_gap(stream, least, most);
    if ((scene->segment->triangle && at[0] + at[1] > hi[0]) || !surface_normal(f, s->x, at[0], at[1], r, n))
        return false;
    for (int k = 0; k < 3; k++)
        s->xs[k] = r[k] + h * n[k];
    return f->foot(f, s, wide[0], wide[1], at) && fabs(s->xi - at[0]) + fabs(s->eta - at[1]) < 1e-6;
}

/* Computes the rotation of a random unit quaternion. */
static void random_rotation(gsl_rng *stream, double q[3][3])
{
    double v[4];
    gsl_ran_dir_nd(stream, 4, v);
    const double w = v[0], x = v[1], y = v[2], z = v[3];
    const double m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    memcpy(q, m, sizeof m);
}

/* Rotates, scales by 1e-3..1e3 (uniform logarithm) and moves by a few edges. Normals are only turned. */
static void move(gsl_rng *stream, const struct segment_kind *kind, double (*x)[3])
{
    double q[3][3], shift[3];
    random_rotation(stream, q);
    const double scale = pow(10, draw_uniform(stream, 3));
    for (int k = 0; k < 3; k++)
        shift[k] = draw_uniform(stream, 10);
    for (size_t i = 0; i < segment_vectors(kind); i++) {
        const double v[3] = {x[i][0], x[i][1], x[i][2]};
        const bool node = i < strlen(kind->nodes);
        for (int k = 0; k < 3; k++)
            x[i][k] = node ? scale * (vector_dot(q[k], v) + shift[k]) : vector_dot(q[k], v);
    }
}

static void swap(double *a, double *b)
{
    const double t = *a;
    *a = *b;
    *b = t;
}

void sample_order(struct sample *s, enum corner_order order)
{
    int nearest = 0;
    if (order == CORNERS_ANY)
        return;
    for (int i = 1; i < 4; i++)
        if (vector_distance2(s->xs, s->x[i]) < vector_distance2(s->xs, s->x[nearest]))
            nearest = i;
    for (; nearest > 0; nearest--) {
        /* B becomes A: the new xi is eta, the new eta is -xi. */
        double first[3];
        memcpy(first, s->x[0], sizeof first);
        memmove(s->x[0], s->x[1], 3 * sizeof first);
        memcpy(s->x[3], first, sizeof first);
        swap(&s->xi, &s->eta);
        s->eta = -s->eta;
    }
    if (order == CORNERS_NEAREST_SHORTER && vector_distance2(s->x[0], s->x[3]) > vector_distance2(s->x[0], s->x[1])) {
        for (int k = 0; k < 3; k++)
            swap(&s->x[1][k], &s->x[3][k]);
        swap(&s->xi, &s->eta);
        s->gap = -s->gap;
    }
}

size_t shapes_drawn(const struct sampler *sampler, char line[DRAWN_LINES][DRAWN_LENGTH])
{
    const struct scene *scene = sampler->scene;
    const struct shapes *p = &scene->shapes;
    const bool warps = !scene->segment->triangle && p->warp > 0;
    const bool curves = strlen(scene->segment->nodes) > scene->segment->corners;
    size_t lines = 0;
    snprintf(line[lines++], DRAWN_LENGTH, "logarithm of aspect%s%s%s%s, gap, xi and eta uniform in these limits",
             p->skew > 0 ? ", skew" : "", !scene->segment->triangle && p->taper > 0 ? ", two tapers" : "",
             warps ? ", warp (a rectangle's of such sides)" : "", curves ? ", two principal curvatures, shifts" : "");
    if (warps)
        snprintf(line[lines++], DRAWN_LENGTH, "again where the segment's own warp is beyond its limit");
    snprintf(line[lines++], DRAWN_LENGTH,
             "heldout_even (shown where mean or 99 %% differ by more than 1.5): aspect%s%s uniform",
             warps ? ", the segment's own warp" : "", curves ? ", the larger curvature" : "");
    return lines;
}

static bool shapes_draw(const struct sampler *p, struct sample *s)
{
    const struct scene *scene = p->scene;
    struct shapes shapes = scene->shapes;
    const struct surface *f = surface_find(scene->segment);
    const size_t corners = scene->segment->corners;
    double shortest = INFINITY;
    shapes.evenly = p->part == PART_HELDOUT_EVEN;
    if (!(f->shape ? draw_face : draw_quad)(f, p->stream, &shapes, s->x))
        return false;
    move(p->stream, scene->segment, s->x);
    for (size_t k = 0; k < corners; k++)
        shortest = fmin(shortest, sqrt(vector_distance2(s->x[k], s->x[(k + 1) % corners])));
    if (!place_slave(p->stream, scene, 0, shapes.gap * shortest, s))
        return false;
    sample_order(s, scene->order);
    return true;
}

bool shapes_prepare(struct sampler *p, struct diag *d)
{
    (void)d;
    p->draw = shapes_draw;
    return true;
}
