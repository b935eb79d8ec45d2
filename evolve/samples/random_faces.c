/* Random ordinary faces of elements. Corners are drawn as for bilinear segments (random_quads.c); a triangle is half of
 * a parallelogram. Mid-side nodes lie on a body with random principal curvatures, so that the longest edge rises by up
 * to `curve` of its length. They then move by up to `shift` of the shortest edge in x, y and z. A middle node moves
 * likewise from the place that the edges imply. Faces that fold over, or turn by more than 60 degrees, are drawn
 * again. */
#include "samples.h"

#include "../common/vec3.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

static bool draw_corners(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3])
{
    double corner[4][3];
    if (!draw_quad(surface_find(segment_find("quad4")), stream, shapes, corner))
        return false;
    for (int i = 0; i < (f->triangle ? 3 : 4); i++)
        memcpy(x[i], corner[f->triangle && i == 2 ? 3 : i], sizeof corner[i]);
    return true;
}

/* Draws a quadratic form xx, xy, yy with principal curvatures up to `most`: two uniform numbers, or a uniform larger
 * one and the other up to it. */
static void draw_curvature(gsl_rng *stream, double most, bool evenly, double form[3])
{
    const double k1 = gsl_ran_flat(stream, -most, most), smaller = evenly ? fabs(k1) : most,
                 k2 = gsl_ran_flat(stream, -smaller, smaller);
    const double angle = gsl_ran_flat(stream, 0, M_PI), c = cos(angle), s = sin(angle);
    form[0] = k1 * c * c + k2 * s * s;
    form[1] = (k1 - k2) * c * s;
    form[2] = k1 * s * s + k2 * c * c;
}

static void shift(gsl_rng *stream, double most, double x[3])
{
    for (int k = 0; k < 3; k++)
        x[k] += gsl_ran_flat(stream, -most, most);
}

static void draw_middles(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3])
{
    const size_t corners = f->triangle ? 3 : 4;
    double longest = 0, shortest = INFINITY, form[3];
    for (size_t i = 0; i < corners; i++) {
        const double *a = x[i], *b = x[(i + 1) % corners], edge = hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
        longest = fmax(longest, edge);
        shortest = fmin(shortest, edge);
    }
    draw_curvature(stream, 8 * shapes->curve / longest, shapes->evenly, form);
    for (size_t i = 0; i < corners; i++) {
        const double *a = x[i], *b = x[(i + 1) % corners], dx = b[0] - a[0], dy = b[1] - a[1];
        double *m = x[corners + i];
        for (int k = 0; k < 3; k++)
            m[k] = (a[k] + b[k]) / 2;
        m[2] -= (form[0] * dx * dx + 2 * form[1] * dx * dy + form[2] * dy * dy) / 8;
        shift(stream, shapes->shift * shortest, m);
    }
    if (f->nodes <= 2 * corners)
        return;
    double *middle = x[2 * corners];
    for (int k = 0; k < 3; k++) {
        double ends = 0, sides = 0;
        for (size_t i = 0; i < corners; i++) {
            ends += x[i][k];
            sides += x[corners + i][k];
        }
        middle[k] = f->triangle ? (4 * sides - ends) / 9 : sides / 2 - ends / 4;
    }
    shift(stream, shapes->shift * shortest, middle);
}

/* Returns true if the area element is nowhere below a fifth of its value in the middle, and all normals lie within 60
 * degrees of the normal there. */
static bool unfolded(const struct surface *f, const struct shapes *shapes, double (*x)[3])
{
    enum { STEPS = 8 };
    const double middle = f->triangle ? 1.0 / 3 : 0, reach = 1 + (f->triangle ? 1 : 2) * shapes->overhang;
    const double lo = f->triangle ? -shapes->overhang : -reach;
    double first[3] = {0};
    for (int i = -1; i <= STEPS * (STEPS + 2); i++) {
        const double xi = i < 0 ? middle : lo + (reach - lo) * (i % (STEPS + 1)) / STEPS;
        const double eta = i < 0 ? middle : lo + (reach - lo) * (i / (STEPS + 1)) / STEPS;
        double r[3][3], n[3];
        if (f->triangle && xi + eta > reach * (1 + 1e-12))
            continue;
        f->point(f, x, xi, eta, r);
        vector_cross(r[1], r[2], n);
        if (i < 0)
            memcpy(first, n, sizeof first);
        const double along = vector_dot(n, first);
        const double nn = vector_dot(n, n);
        const double ff = vector_dot(first, first);
        if (!(along > 0.5 * sqrt(nn * ff) && nn > 0.04 * ff))
            return false;
    }
    return true;
}

bool draw_face(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3])
{
    if (!draw_corners(f, stream, shapes, x))
        return false;
    if (f->nodes <= 3) /* a plane triangle does not fold */
        return true;
    draw_middles(f, stream, shapes, x);
    return unfolded(f, shapes, x);
}
