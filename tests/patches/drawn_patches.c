/* Patches of edges about 2, with normals of a body of some curvature; see drawn_patches.h. */
#include "drawn_patches.h"

#include "../hard/draw.h"

#include <math.h>
#include <string.h>

enum { VECTORS = PATCH_VECTORS };

/* Places the slave node over a point in or beside the patch. */
static void draw_slave(struct patch_case *f, double xi, double eta, double gap)
{
    struct patch_net t;
    patch_wide r[3][3];
    const double beyond = 1e-6; /* where Gregory patches are continued */
    const patch_wide z[2] = {fmax(-1 - beyond, fmin(1 + beyond, xi)), fmax(-1 - beyond, fmin(1 + beyond, eta))};
    double u[3], v[3], n[3];
    patch_net_make(f, &t);
    patch_net_at(f, &t, z, r);
    for (int i = 0; i < 3; i++) {
        u[i] = (double)r[1][i];
        v[i] = (double)r[2][i];
    }
    draw_cross(u, v, n);
    const double length = sqrt(draw_dot(n, n));
    for (int i = 0; i < 3; i++)
        f->x[8][i] =
            (double)(r[0][i] + (xi - z[0]) * u[i] + (eta - z[1]) * v[i]) + (length > 0 ? gap * n[i] / length : 0);
}

/* Draws corners of a quadrilateral with edges 2 and 2 `width`, skewed, tapered and warped, and normals of a body of
 * curvature `bend`, tilted by `tilt`. */
static void draw_corners(uint64_t *stream, struct patch_case *f, double width, double bend, double tilt)
{
    static const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double skew = draw_flat(stream, -0.5, 0.5), taper = draw_flat(stream, -0.3, 0.3);
    const double k = draw_flat(stream, -bend, bend), l = draw_flat(stream, -bend, bend) / width;
    for (int c = 0; c < 4; c++) {
        const double x = at[c][0] * (1 + taper * at[c][1]) + skew * at[c][1], y = width * at[c][1];
        double *const n = f->x[4 + c], d[3];
        draw_direction(stream, d);
        f->x[c][0] = x;
        f->x[c][1] = y;
        f->x[c][2] = (k * x * x + l * y * y) / 2;
        n[0] = -k * x + tilt * d[0];
        n[1] = -l * y + tilt * d[1];
        n[2] = 1 + tilt * d[2];
        const double length = sqrt(draw_dot(n, n));
        for (int i = 0; i < 3; i++)
            n[i] /= length;
    }
}

/* Turns the patch, moves it by `shift`, and scales it by 2^exponent. */
static void move(uint64_t *stream, struct patch_case *f, double shift, int exponent)
{
    double axis[3][3], to[3];
    draw_direction(stream, axis[0]);
    do
        draw_direction(stream, axis[1]);
    while (fabs(draw_dot(axis[0], axis[1])) > 0.9);
    draw_cross(axis[0], axis[1], axis[2]);
    const double length = sqrt(draw_dot(axis[2], axis[2]));
    for (int i = 0; i < 3; i++)
        axis[2][i] /= length;
    draw_cross(axis[2], axis[0], axis[1]);
    draw_direction(stream, to);
    for (int v = 0; v < VECTORS; v++) {
        const bool normal = v >= 4 && v < 8;
        double y[3] = {0, 0, 0};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                y[i] += axis[j][i] * f->x[v][j];
        for (int i = 0; i < 3; i++)
            f->x[v][i] = normal ? y[i] : ldexp(y[i] + shift * to[i], exponent);
    }
}

/* Draws -1 or 1, a number near them, or one between. */
static double draw_near_border(uint64_t *stream)
{
    const double sign = draw_sign(stream);
    switch (draw_choose(stream, 4)) {
    case 0:
        return sign;
    case 1:
        return sign * (1 + draw_sign(stream) * draw_power(stream, -14, -1));
    default:
        return draw_flat(stream, -1.3, 1.3);
    }
}

static void draw_wild(uint64_t *stream, struct patch_case *f)
{
    const int variant = draw_choose(stream, 8), corner = draw_choose(stream, 4);
    draw_corners(stream, f, draw_power(stream, -1, 0), 0.5, variant & 1 ? 0.1 : 1);
    draw_slave(f, draw_flat(stream, -1.5, 1.5), draw_flat(stream, -1.5, 1.5),
               draw_power(stream, -3, variant & 2 ? 3 : 0) * draw_sign(stream));
    if (variant == 4)
        for (int v = 0; v < 2; v++)
            memcpy(f->x[4 * v + corner], f->x[4 * v + (corner + 1) % 4], sizeof f->x[0]);
    else if (variant == 5)
        memcpy(f->x[corner], f->x[(corner + 1) % 4], sizeof f->x[0]);
    else if (variant == 6)
        draw_direction(stream, f->x[4 + corner]);
    else if (variant == 7)
        for (int i = 0; i < 3; i++)
            f->x[corner][i] += draw_flat(stream, 0.5, 1.2) * (f->x[(corner + 2) % 4][i] - f->x[corner][i]);
    move(stream, f, draw_power(stream, 0, variant & 1 ? 6 : 0), draw_choose(stream, 3) * 330 - 330);
}

void patch_draw(uint64_t *stream, enum patch_group group, struct patch_case *f)
{
    const double width = draw_power(stream, -3, 0);
    switch (group) {
    case PATCH_ORDINARY:
        draw_corners(stream, f, draw_power(stream, -0.3, 0.3), 0.15, 0.03);
        draw_slave(f, draw_flat(stream, -1, 1), draw_flat(stream, -1, 1), draw_flat(stream, -0.2, 0.2));
        break;
    case PATCH_STRONG:
        draw_corners(stream, f, draw_power(stream, -0.3, 0.3), 0.5, draw_flat(stream, 0, 0.6));
        draw_slave(f, draw_flat(stream, -1.1, 1.1), draw_flat(stream, -1.1, 1.1), draw_flat(stream, -0.3, 0.3));
        break;
    case PATCH_SLIVER:
        draw_corners(stream, f, width, 0.15 * width, 0.02);
        draw_slave(f, draw_flat(stream, -1.1, 1.1), draw_flat(stream, -1.1, 1.1), width * draw_flat(stream, -0.5, 0.5));
        break;
    case PATCH_BORDER:
        draw_corners(stream, f, draw_power(stream, -0.3, 0.3), 0.2, 0.05);
        draw_slave(f, draw_near_border(stream), draw_near_border(stream), draw_flat(stream, -0.2, 0.2));
        break;
    default:
        draw_wild(stream, f);
        return;
    }
    move(stream, f, 10, 0);
}
