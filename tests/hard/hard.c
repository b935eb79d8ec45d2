/* Draws the families; see hard.h.  Families beyond any mesh are in wild.c. */
#include "hard.h"

#include "draw.h"
#include "wild.h"

#include <math.h>
#include <string.h>

static void place_inside(uint64_t *stream, struct hard_case *h, double gap)
{
    const double xi = draw_flat(stream, -0.99, 0.99), eta = draw_flat(stream, -0.99, 0.99);
    draw_place(stream, h, xi, eta, draw_flat(stream, -gap, gap));
}

static void draw_ordinary(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.03, h);
    place_inside(s, h, 0.1);
    draw_move(s, h, draw_power(s, -1, 1), 2);
}

static void draw_around(uint64_t *s, struct hard_case *h)
{
    const double aspect = draw_flat(s, 1, 3);
    draw_quad(s, aspect, 0.15, 0.03, h);
    h->x[4][0] = aspect * draw_flat(s, -1.5, 1.5);
    h->x[4][1] = draw_flat(s, -1.5, 1.5);
    h->x[4][2] = draw_flat(s, -1, 1);
    draw_move(s, h, 1, 2);
}

static void draw_warp(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.6, h);
    place_inside(s, h, 1);
    draw_move(s, h, 1, 2);
}

static void draw_triangle(uint64_t *s, struct hard_case *h)
{
    const double near = draw_power(s, -14, -1);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    for (int k = 0; k < 3; k++)
        h->x[2][k] = h->x[3][k] + near * (h->x[2][k] - h->x[3][k]);
    place_inside(s, h, 0.3);
    draw_move(s, h, 1, 2);
}

static void draw_collapsed(uint64_t *s, struct hard_case *h)
{
    const int i = draw_choose(s, 4);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    memcpy(h->x[i], h->x[(i + 1) % 4], sizeof h->x[i]);
    place_inside(s, h, 0.3);
    draw_move(s, h, 1, 2);
}

static void draw_repeated(uint64_t *s, struct hard_case *h)
{
    const int kind = draw_choose(s, 5);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    if (kind == 0) /* opposite corners */
        memcpy(h->x[2], h->x[0], sizeof h->x[0]);
    if (kind == 1) /* two edges */
        memcpy(h->x[1], h->x[0], sizeof h->x[0]), memcpy(h->x[3], h->x[2], sizeof h->x[0]);
    if (kind == 2 || kind == 3) /* three or four corners */
        for (int i = 1; i < kind + 1; i++)
            memcpy(h->x[i], h->x[0], sizeof h->x[0]);
    if (kind == 4) /* a line */
        for (int i = 1; i < 4; i++) {
            const double t = draw_flat(s, -1, 1);
            for (int k = 0; k < 3; k++)
                h->x[i][k] = h->x[0][k] + t * (k + 1);
        }
    place_inside(s, h, 0.3);
    draw_move(s, h, 1, 2);
}

/* Places xS near a gap (t.u +- |t| |u|)/(c.n), at which the Hessian's determinant vanishes. */
static void draw_focal(uint64_t *s, struct hard_case *h)
{
    double r[3], t[3], u[3], c[3], n[3];
    const double xi = draw_flat(s, -0.99, 0.99), eta = draw_flat(s, -0.99, 0.99);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.4, h);
    draw_evaluate(h, xi, eta, r, t, u, c);
    draw_cross(t, u, n);
    const double turn = draw_dot(c, n) / sqrt(draw_dot(n, n)), most = sqrt(draw_dot(t, t) * draw_dot(u, u));
    const double gap = (draw_dot(t, u) + (draw_choose(s, 2) ? most : -most)) / turn;
    const double off = draw_choose(s, 4) ? (draw_choose(s, 2) ? 1 : -1) * draw_power(s, -15, -1) : 0;
    draw_place(s, h, xi, eta, fabs(gap) < 100 ? gap * (1 + off) : 1);
    draw_move(s, h, 1, 2);
}

static void draw_far(uint64_t *s, struct hard_case *h)
{
    double d[3];
    const double distance = draw_flat(s, 5, 50);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    draw_direction(s, d);
    for (int k = 0; k < 3; k++)
        h->x[4][k] = distance * d[k];
    draw_move(s, h, 1, 2);
}

static void draw_farther(uint64_t *s, struct hard_case *h)
{
    const double distance = draw_power(s, 2, 13);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.03, h);
    draw_direction(s, h->x[4]);
    for (int k = 0; k < 3; k++)
        h->x[4][k] *= distance;
    draw_move(s, h, 1, 2);
}

static void draw_plane(uint64_t *s, struct hard_case *h)
{
    const double aspect = draw_flat(s, 1, 3);
    draw_quad(s, aspect, 0.45, 0, h);
    h->x[4][0] = aspect * draw_flat(s, -1.5, 1.5);
    h->x[4][1] = draw_flat(s, -1.5, 1.5);
    h->x[4][2] = draw_choose(s, 2) ? 0 : draw_flat(s, -0.2, 0.2);
    if (draw_choose(s, 2))
        draw_move(s, h, 1, 2);
}

static void draw_offset(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    draw_move(s, h, draw_power(s, -2, 2), draw_choose(s, 2) ? 1e6 : draw_power(s, 5, 9));
}

/* Moves a case less far: in float, an edge is not resolved from 1e7 edges away. */
static void draw_offset_float(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    draw_move(s, h, draw_power(s, -2, 2), draw_choose(s, 2) ? 1e6 : draw_power(s, 1, 8));
}

static void draw_scale_float(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    draw_move(s, h, draw_power(s, -4, 4), 2);
}

static void draw_extreme_float(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    draw_move(s, h, draw_choose(s, 2) ? draw_power(s, -46, -4) : draw_power(s, 4, 39), 2);
}

static void draw_scale(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    draw_move(s, h, draw_power(s, -9, 9), 2);
}

static void draw_aspect(uint64_t *s, struct hard_case *h)
{
    static const double aspects[] = {1e2, 1e3, 1e4, 1e6};
    draw_quad(s, aspects[draw_choose(s, 4)], 0.15, 0.1, h);
    if (draw_choose(s, 3))
        place_inside(s, h, 0.3);
    else
        draw_place(s, h, draw_flat(s, -1.5, 1.5), draw_flat(s, -1.5, 1.5), draw_flat(s, -1, 1));
    draw_move(s, h, 1, 2);
}

static void draw_edge(uint64_t *s, struct hard_case *h)
{
    const double side = draw_choose(s, 2) ? 1 : -1, other = draw_choose(s, 2) ? 1 : -1;
    const double off = draw_choose(s, 2) ? 0 : (draw_choose(s, 2) ? 1 : -1) * draw_power(s, -16, -2);
    const int kind = draw_choose(s, 3);
    draw_quad(s, draw_flat(s, 1, 3), 0.15, draw_choose(s, 2) ? 0.1 : 0, h);
    const double along = kind == 2 ? other : draw_flat(s, -1, 1);
    draw_place(s, h, kind ? side + off : along, kind ? along : side + off,
               draw_choose(s, 2) ? 0 : draw_flat(s, -0.3, 0.3));
    if (draw_choose(s, 2))
        draw_move(s, h, 1, 2);
}

/* Draws a corner in beyond the other diagonal, or exchanges two corners. */
static void draw_folded(uint64_t *s, struct hard_case *h)
{
    double keep[3];
    const double aspect = draw_flat(s, 1, 3), t = draw_flat(s, 0.5, 0.9);
    draw_quad(s, aspect, 0.15, draw_choose(s, 2) ? 0.1 : 0, h);
    if (draw_choose(s, 2)) {
        for (int k = 0; k < 3; k++)
            h->x[2][k] += t * (h->x[0][k] - h->x[2][k]);
    } else {
        memcpy(keep, h->x[2], sizeof keep);
        memcpy(h->x[2], h->x[3], sizeof keep);
        memcpy(h->x[3], keep, sizeof keep);
    }
    h->x[4][0] = aspect * draw_flat(s, -1, 1);
    h->x[4][1] = draw_flat(s, -1, 1);
    h->x[4][2] = draw_flat(s, -0.5, 0.5);
    draw_move(s, h, 1, 2);
}

/* Draws any five points, beyond every scene. */
static void draw_beyond(uint64_t *s, struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            h->x[i][k] = draw_flat(s, -1, 1);
    draw_move(s, h, 1, 2);
}

/* Draws a saddle with xS on its axis: two closest points beyond the focal distance. */
static void draw_symmetric(uint64_t *s, struct hard_case *h)
{
    const double warp = draw_flat(s, 0.1, 1), aspect = draw_choose(s, 2) ? 1 : draw_flat(s, 1, 2);
    for (int i = 0; i < 4; i++) {
        h->x[i][0] = aspect * draw_corner[i][0];
        h->x[i][1] = draw_corner[i][1];
        h->x[i][2] = warp * draw_corner[i][0] * draw_corner[i][1];
    }
    h->x[4][0] = h->x[4][1] = 0;
    h->x[4][2] = draw_flat(s, -3, 3);
}

/* Draws the same near the height at which one closest point becomes two, and next to the axis. */
static void draw_cusp(uint64_t *s, struct hard_case *h)
{
    const double warp = draw_flat(s, 0.1, 1), aspect = draw_choose(s, 2) ? 1 : draw_flat(s, 1, 2);
    for (int i = 0; i < 4; i++) {
        h->x[i][0] = aspect * draw_corner[i][0];
        h->x[i][1] = draw_corner[i][1];
        h->x[i][2] = warp * draw_corner[i][0] * draw_corner[i][1];
    }
    h->x[4][2] = aspect / warp * (1 + (draw_choose(s, 2) ? 1 : -1) * draw_power(s, -16, -2));
    for (int k = 0; k < 2; k++)
        h->x[4][k] = draw_choose(s, 3) ? (draw_choose(s, 2) ? 1 : -1) * draw_power(s, -16, -2) : 0;
    if (draw_choose(s, 2))
        draw_move(s, h, 1, 2);
}

/* Draws coordinates on a coarse grid, with coincidences of every kind. */
static void draw_grid(uint64_t *s, struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            h->x[i][k] = draw_choose(s, 4) - 1;
}

static void draw_extreme(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    draw_move(s, h, draw_choose(s, 2) ? draw_power(s, -323, -280) : draw_power(s, 280, 307.5), 2);
}

static void draw_not_finite(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, draw_flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    const int n = 1 + draw_choose(s, 3);
    for (int i = 0; i < n; i++) {
        const int kind = draw_choose(s, 3);
        h->x[draw_choose(s, 5)][draw_choose(s, 3)] = kind == 0 ? (double)NAN : kind == 1 ? HUGE_VAL : -HUGE_VAL;
    }
}

const struct hard_family hard_families[] = {
    {"ordinary", "what meshes hold, foot point inside", draw_ordinary, draw_ordinary, 1, 1},
    {"around", "the same, slave nodes all around", draw_around, draw_around, 1, 1},
    {"warp", "warp and gap up to the edge", draw_warp, draw_warp, 1, 1},
    {"triangle", "C near D, to 1e-14 of the edge", draw_triangle, draw_triangle, 1, 1},
    {"collapsed", "an edge of no length", draw_collapsed, draw_collapsed, 1, 1},
    {"repeated", "repeated nodes, corners in a line", draw_repeated, draw_repeated, 1, 1},
    {"focal", "gap near 1/curvature", draw_focal, draw_focal, 1, 1},
    {"far", "5 to 50 edges away", draw_far, draw_far, 1, 1},
    {"farther", "1e2 to 1e13 edges away", draw_farther, draw_farther, 1, 1},
    {"plane", "plane, with exterior roots", draw_plane, draw_plane, 1, 1},
    {"offset", "1e5 to 1e9 edges from the origin", draw_offset, draw_offset_float, 1, 1},
    {"scale", "edges of 1e-9 to 1e9", draw_scale, draw_scale_float, 1, 1},
    {"aspect", "aspect ratio 1e2 to 1e6", draw_aspect, draw_aspect, 1, 1},
    {"edge", "over edges and corners", draw_edge, draw_edge, 1, 1},
    {"folded", "not convex, or crossing itself", draw_folded, draw_folded, 1, 1},
    {"beyond", "five points at random", draw_beyond, draw_beyond, 1, 1},
    {"symmetric", "on the axis of a saddle", draw_symmetric, draw_symmetric, 1, 1},
    {"cusp", "where one closest point becomes two", draw_cusp, draw_cusp, 1, 1},
    {"grid", "coordinates -1, 0, 1, 2", draw_grid, draw_grid, 1, 1},
    {"extreme", "denormal and huge coordinates", draw_extreme, draw_extreme_float, 1, 0},
    {"not-finite", "NaN and infinities", draw_not_finite, draw_not_finite, 0, 0},
    {"flat", "nearly plane, of any shape", wild_flat, NULL, 1, 1},
    {"flat-quad", "nearly plane, xS near it", wild_flat_quad, NULL, 1, 1},
    {"flat-crossing", "nearly plane, crossing itself", wild_flat_crossing, NULL, 1, 1},
    {"flat-needle", "nearly plane, narrow", wild_flat_needle, NULL, 1, 1},
    {"flat-collapsed", "nearly plane, an edge of no length", wild_flat_collapsed, NULL, 1, 1},
    {"flat-pairs", "two pairs of corners coincide", wild_flat_pairs, NULL, 1, 1},
    {"scales-4", "coordinates mixed over 4 decades", wild_scales4, NULL, 1, 1},
    {"scales-8", "over 8 decades", wild_scales8, NULL, 1, 1},
    {"scales-16", "over 16 decades", wild_scales16, NULL, 1, 1},
    {"needle", "aspect ratio to 1e8", wild_needle, NULL, 1, 1},
    {"pitchfork", "where a saddle's closest point splits", wild_pitchfork, NULL, 1, 1},
    {"on-corner", "xS is a corner", wild_on_corner, NULL, 1, 1},
    {"on-edge", "xS on an edge to the last bit", wild_on_edge, NULL, 1, 1},
    {"pinch", "where two edges cross", wild_pinch, NULL, 1, 1},
    {"worst", "the worst that were found", wild_worst, NULL, 1, 1},
};

const int hard_family_count = sizeof hard_families / sizeof *hard_families;

static uint64_t stream_of(int family, uint64_t seed, uint64_t index)
{
    uint64_t stream = seed * 0x100000001b3u + (uint64_t)family;
    stream = draw_next(&stream) + index;
    return draw_next(&stream);
}

void hard_draw(int family, uint64_t seed, uint64_t index, struct hard_case *h)
{
    uint64_t stream = stream_of(family, seed, index);
    hard_families[family].draw(&stream, h);
}

/* volatile, because gcc 12 -O3 would vectorise away the two conversions. */
void hard_draw_float(int family, uint64_t seed, uint64_t index, struct hard_case *h)
{
    uint64_t stream = stream_of(family, seed, index);
    hard_families[family].draw_float(&stream, h);
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            const volatile float nearest = (float)h->x[i][k];
            h->x[i][k] = (double)nearest;
        }
}
