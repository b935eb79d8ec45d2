/* The paper's configurations (section 6.1), on its lattice and off it. A is the origin and B is (1,0,0). C, D and the
 * slave node S lie on a grid, D in the x-y plane. A configuration belongs to the set if
 *   |AD| <= |AB|;
 *   ABC*D, with C* the projection of C onto the x-y plane, is strictly convex and counter-clockwise;
 *   no corner is nearer to S than A (ties belong to the set);
 *   the contact point, a local minimum of the distance, lies in the box of the scene: A's quarter of the segment;
 *   and, if the scene requires it, Newton's iteration from (0,0) finds it, as in the paper.
 *
 * Coordinates on the lattice are whole multiples, at most 100,000, of a common unit, so that turns, distances and ties are exact.
 * Off the lattice, C, D and S are uniform in the same ranges. */
#include "../common/stream.h"
#include "../common/vec3.h"
#include "../surface/foot_bilinear.h"
#include "samples.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>

/* The grid in units of 1/n of |AB|. */
struct grid {
    int n, xy, xy_step, z, z_step;
};

static bool whole(double v)
{
    return fabs(v - round(v)) <= 1e-9 * fmax(1, fabs(v));
}

static bool common_unit(const struct lattice *l, struct grid *g)
{
    for (int n = 1; n <= 1000; n++)
        if (whole(l->xy.most * n) && whole(l->xy.step * n) && whole(l->z.most * n) && whole(l->z.step * n)) {
            *g = (struct grid){.n = n,
                               .xy = (int)lround(l->xy.most * n),
                               .xy_step = (int)lround(l->xy.step * n),
                               .z = (int)lround(l->z.most * n),
                               .z_step = (int)lround(l->z.step * n)};
            /* Grids are symmetric about 0. */
            g->xy -= g->xy % g->xy_step;
            g->z -= g->z % g->z_step;
            return true;
        }
    return false;
}

/* Returns the z component of (q - p) x (r - q). */
static double turn(const double p[3], const double q[3], const double r[3])
{
    return (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0]);
}

/* Returns true if no corner is nearer to p than A. */
static bool nearest_to_first(double corner[][3], const double p[3])
{
    const double a = vector_distance2(p, corner[0]);
    return !(a > vector_distance2(p, corner[1]) || a > vector_distance2(p, corner[2]) ||
             a > vector_distance2(p, corner[3]));
}

/* Returns true if `steps` Newton steps from (0,0) on (7), (8) end at the foot point. */
static bool newton_finds(const struct sample *s, int steps)
{
    double c0[3], c1[3], c2[3], c3[3], xi = 0, eta = 0;
    for (int k = 0; k < 3; k++) {
        const double a = s->x[0][k], b = s->x[1][k], c = s->x[2][k], d = s->x[3][k];
        c0[k] = (a + b + c + d) / 4;
        c1[k] = (-a + b + c - d) / 4;
        c2[k] = (-a - b + c + d) / 4;
        c3[k] = (a - b + c - d) / 4;
    }
    for (int i = 0; i < steps; i++) {
        double f1 = 0, f2 = 0, e11 = 0, e22 = 0, mixed = 0;
        for (int k = 0; k < 3; k++) {
            const double t1 = c1[k] + c3[k] * eta, t2 = c2[k] + c3[k] * xi;
            const double v = s->xs[k] - c0[k] - c1[k] * xi - t2 * eta;
            f1 += t1 * v;
            f2 += t2 * v;
            e11 += t1 * t1;
            e22 += t2 * t2;
            mixed += t1 * t2 - v * c3[k];
        }
        const double det = e11 * e22 - mixed * mixed;
        if (det == 0)
            return false;
        xi += (f1 * e22 - f2 * mixed) / det;
        eta += (f2 * e11 - f1 * mixed) / det;
    }
    return fabs(xi - s->xi) + fabs(eta - s->eta) < 1e-6;
}

/* Labels the sample. Returns false if it has no contact point that belongs to the set. */
static bool label(const struct lattice *l, struct sample *s)
{
    const double lo[2] = {l->xi[0], l->eta[0]}, hi[2] = {l->xi[1], l->eta[1]};
    return foot_bilinear(s, lo, hi) && (l->newton == 0 || newton_finds(s, l->newton));
}

static void add_slaves(const struct lattice *l, const struct grid *g, double corner[4][3], struct sample_set *set)
{
    struct sample s = {0};
    double p[3];
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            s.x[i][k] = corner[i][k] / g->n;
    for (p[0] = -g->xy; p[0] <= g->xy; p[0] += g->xy_step)
        for (p[1] = -g->xy; p[1] <= g->xy; p[1] += g->xy_step)
            for (p[2] = -g->z; p[2] <= g->z; p[2] += g->z_step) {
                for (int k = 0; k < 3; k++)
                    s.xs[k] = p[k] / g->n;
                if (nearest_to_first(corner, p) && label(l, &s))
                    sample_set_add(set, &s);
            }
}

/* Returns the sample reflected in the x-y plane, which keeps xi and eta. */
static struct sample mirrored(const struct sample *s)
{
    struct sample m = *s;
    for (int i = 0; i < 4; i++)
        m.x[i][2] = 0 - s->x[i][2];
    m.xs[2] = 0 - s->xs[2];
    m.gap = 0 - s->gap;
    return m;
}

/* Appends the mirror images of one C's samples, in the order of enumeration. */
static void add_mirrored(const struct sample_set *from, struct sample_set *set)
{
    for (size_t first = 0, end; first < from->n; first = end) {
        const double *xs = from->s[first].xs;
        for (end = first + 1; end < from->n && from->s[end].xs[0] == xs[0] && from->s[end].xs[1] == xs[1];)
            end++;
        for (size_t i = end; i-- > first;) {
            const struct sample image = mirrored(&from->s[i]);
            sample_set_add(set, &image);
        }
    }
}

/* Appends all heights of C from the lowest. Heights below the plane are mirror images of those above it. */
static void add_heights(const struct lattice *l, const struct grid *g, double corner[4][3], struct sample_set *set)
{
    const int heights = g->z / g->z_step;
    struct sample_set *above = new_array((size_t)heights + 1, sizeof *above);
    for (int i = 1; i <= heights; i++) {
        corner[2][2] = i * g->z_step;
        add_slaves(l, g, corner, &above[i]);
    }
    for (int i = heights; i >= 1; i--)
        add_mirrored(&above[i], set);
    corner[2][2] = 0;
    add_slaves(l, g, corner, set);
    for (int i = 1; i <= heights; i++) {
        for (size_t k = 0; k < above[i].n; k++)
            sample_set_add(set, &above[i].s[k]);
        sample_set_free(&above[i]);
    }
    free(above);
}

static void enumerate(const struct lattice *l, const struct grid *g, struct sample_set *set)
{
    double corner[4][3] = {{0, 0, 0}, {g->n, 0, 0}}, *c = corner[2], *d = corner[3];
    for (d[0] = -g->xy; d[0] <= g->xy; d[0] += g->xy_step)
        for (d[1] = -g->xy; d[1] <= g->xy; d[1] += g->xy_step) {
            if (vector_distance2(corner[0], d) > vector_distance2(corner[0], corner[1]) ||
                turn(d, corner[0], corner[1]) <= 0)
                continue;
            for (c[0] = -g->xy; c[0] <= g->xy; c[0] += g->xy_step)
                for (c[1] = -g->xy; c[1] <= g->xy; c[1] += g->xy_step) {
                    if (turn(corner[0], corner[1], c) <= 0 || turn(corner[1], c, d) <= 0 || turn(c, d, corner[0]) <= 0)
                        continue;
                    add_heights(l, g, corner, set);
                }
        }
}

/* Returns a number that is uniform in -max..max. */
static double within(gsl_rng *stream, double max)
{
    return max * (2 * gsl_rng_uniform(stream) - 1);
}

/* Draws C, D and S. */
bool lattice_draw(const struct sampler *p, struct sample *s)
{
    gsl_rng *stream = p->stream;
    const struct lattice *l = &p->scene->lattice;
    double *a = s->x[0], *b = s->x[1], *c = s->x[2], *d = s->x[3];
    b[0] = 1; /* the other coordinates of A and B stay 0 */
    d[0] = within(stream, fmin(1, l->xy.most));
    d[1] = fmin(1, l->xy.most) * gsl_rng_uniform_pos(stream);
    if (vector_distance2(a, d) > 1)
        return false;
    c[0] = within(stream, l->xy.most);
    c[1] = within(stream, l->xy.most);
    if (!(turn(a, b, c) > 0 && turn(b, c, d) > 0 && turn(c, d, a) > 0))
        return false;
    c[2] = within(stream, l->z.most);
    s->xs[0] = within(stream, l->xy.most);
    s->xs[1] = within(stream, l->xy.most);
    s->xs[2] = within(stream, l->z.most);
    return nearest_to_first(s->x, s->xs) && label(l, s);
}

static int by_place(const void *a, const void *b)
{
    const struct sample *p = a, *q = b;
    const double *x = &p->x[0][0], *y = &q->x[0][0];
    for (int i = 0; i < 12; i++)
        if (x[i] != y[i])
            return x[i] < y[i] ? -1 : 1;
    for (int i = 0; i < 3; i++)
        if (p->xs[i] != q->xs[i])
            return p->xs[i] < q->xs[i] ? -1 : 1;
    return 0;
}

/* Appends the samples, of n, that are not mirror images of one of the m training samples. */
static void add_strangers(const struct sample *s, size_t n, const struct sample *training, size_t m,
                          struct sample_set *set)
{
    struct sample *image = new_array(m, sizeof *image);
    for (size_t i = 0; i < m; i++)
        image[i] = mirrored(&training[i]);
    qsort(image, m, sizeof *image, by_place);
    for (size_t i = 0; i < n; i++)
        if (!bsearch(&s[i], image, m, sizeof *image, by_place))
            sample_set_add(set, &s[i]);
    free(image);
}

size_t lattice_drawn(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH])
{
    const struct lattice *l = &p->scene->lattice;
    snprintf(line[0], DRAWN_LENGTH,
             "heldout: configurations of a grid of steps %g in x, y and %g in z that training left, equally often",
             l->xy.step, l->z.step);
    snprintf(line[1], DRAWN_LENGTH, "heldout_random: x, y, z of C, D and S uniform in the same ranges");
    return 2;
}

bool lattice_grid(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d)
{
    struct sample_set all = {0};
    struct grid g;
    if (!common_unit(&scene->lattice, &g))
        return diag_at(d, scene->path, 0, 0, "the lattice's ranges and steps have no common unit 1/n with n <= 1000");
    enumerate(&scene->lattice, &g, &all);
    if (all.n <= scene->training) {
        diag_at(d, scene->path, 0, 0, "the lattice holds %zu configurations; training takes %zu and leaves none", all.n,
                scene->training);
        sample_set_free(&all);
        return false;
    }
    /* Shuffle by the scene's seed. The first `training` samples train; the others are held out, except mirror
     * images. */
    gsl_rng *stream = stream_new();
    stream_key(stream, scene->seed, PART_TRAINING, 0, 0);
    gsl_ran_shuffle(stream, all.s, all.n, sizeof *all.s);
    gsl_rng_free(stream);
    if (part == PART_TRAINING)
        for (size_t i = 0; i < scene->training; i++)
            sample_set_add(set, &all.s[i]);
    else
        add_strangers(all.s + scene->training, all.n - scene->training, all.s, scene->training, set);
    sample_set_free(&all);
    return true;
}

bool lattice_prepare(struct sampler *p, struct diag *d)
{
    if (p->part == PART_TRAINING || p->part == PART_HELDOUT)
        return lattice_grid(p->scene, p->part, &p->listed, d);
    p->draw = lattice_draw;
    return true;
}
