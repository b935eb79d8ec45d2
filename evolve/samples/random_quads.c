/* Random ordinary segments. A bilinear segment r = c0 + c1 xi + c2 eta + c3 xi eta is made from its mid-lines and c3.
 * Aspect ratio and skew determine c1 and c2; c3 = a c1 + b c2 + g n follows from taper (a, b) and warp (g), where n is
 * the unit normal of c1 and c2. Segments that exceed the scene's limits are drawn again, so little warp is more
 * frequent. In PART_HELDOUT_EVEN aspect ratios (not their logarithms) and angles of warp are uniform. */
#include "../common/vec3.h"
#include "../surface/surface.h"
#include "samples.h"

#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>

double draw_uniform(gsl_rng *stream, double max)
{
    return gsl_ran_flat(stream, -max, max);
}

/* Returns the largest angle between the normals at opposite corners. */
static double warp_of(const struct surface *f, double (*x)[3])
{
    static const double corner[4][2] = {{-1, -1}, {1, 1}, {1, -1}, {-1, 1}};
    double n[4][3], r[3];
    for (int i = 0; i < 4; i++)
        surface_normal(f, x, corner[i][0], corner[i][1], r, n[i]);
    return acos(fmax(-1, fmin(1, fmin(vector_dot(n[0], n[1]), vector_dot(n[2], n[3])))));
}

static void set_corners(const double c1[3], const double c2[3], double a, double b, double g, double (*x)[3])
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            const double c3 = a * c1[k] + b * c2[k] + (k == 2 ? g : 0);
            x[i][k] = c1[k] * corner[i][0] + c2[k] * corner[i][1] + c3 * corner[i][0] * corner[i][1];
        }
}

/* Returns the g of a given warp, by bisection from below. */
static double height_of_warp(const struct surface *f, const double c1[3], const double c2[3], double a, double b,
                             double warp)
{
    double low = 0, high = hypot(c1[0], hypot(c2[0], c2[1])), x[4][3];
    for (int i = 0; i < 60; i++) {
        const double g = (low + high) / 2;
        set_corners(c1, c2, a, b, g, x);
        *(warp_of(f, x) <= warp ? &low : &high) = g;
    }
    return low;
}

/* Draws a segment about the origin, c1 along x, c2 in the x-y plane, mid-lines of length at least 2. Returns false to
 * draw again. */
bool draw_quad(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3])
{
    const double part = gsl_ran_flat(stream, -1, 1), longer = 1 + fabs(part) * (shapes->aspect - 1);
    const double aspect = !shapes->evenly ? pow(shapes->aspect, part) : part < 0 ? 1 / longer : longer;
    const double angle = M_PI_2 + draw_uniform(stream, shapes->skew);
    const double length1 = fmax(1, aspect), length2 = fmax(1, 1 / aspect);
    const double a = draw_uniform(stream, shapes->taper), b = draw_uniform(stream, shapes->taper);
    const double c1[3] = {length1, 0, 0}, c2[3] = {length2 * cos(angle), length2 * sin(angle), 0};
    const double warp = draw_uniform(stream, shapes->warp);
    /* Either the warp of a rectangle with these sides, or the segment's own. */
    const double g = shapes->evenly && shapes->warp > 0 ? copysign(height_of_warp(f, c1, c2, a, b, fabs(warp)), warp)
                                                        : tan(warp / 2) / hypot(1 / length1, 1 / length2);
    set_corners(c1, c2, a, b, g, x);
    for (int i = 0; i < 4; i++) {
        const double *p = x[i], *q = x[(i + 1) % 4], *r = x[(i + 2) % 4];
        if ((q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0]) <= 0)
            return false;
    }
    return shapes->warp == 0 || warp_of(f, x) <= shapes->warp; /* acos resolves a plane only to 1e-8 */
}
