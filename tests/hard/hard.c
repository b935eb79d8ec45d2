/* The families; see hard.h.  Nothing but sums, products, roots and exp from one stream of 64 bits per case. */
#include "hard.h"

#include <math.h>
#include <string.h>

static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

/* splitmix64 */
static uint64_t next(uint64_t *stream)
{
    uint64_t z = *stream += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static double flat(uint64_t *stream, double low, double high)
{
    return low + (high - low) * ((double)(next(stream) >> 11) * 0x1p-53);
}

static double power(uint64_t *stream, double low, double high)
{
    return pow(10, flat(stream, low, high));
}

static int choose(uint64_t *stream, int n)
{
    return (int)(next(stream) % (uint64_t)n);
}

/* Length 1. */
static void draw_direction(uint64_t *stream, double d[3])
{
    double square;
    do {
        for (int k = 0; k < 3; k++)
            d[k] = flat(stream, -1, 1);
        square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    } while (!(square > 0.01 && square <= 1));
    for (int k = 0; k < 3; k++)
        d[k] /= sqrt(square);
}

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A quadrilateral of edges `aspect` and 1, corners moved. */
static void draw_quad(uint64_t *stream, double aspect, double moved, double warp, struct hard_case *h)
{
    for (int i = 0; i < 4; i++) {
        h->x[i][0] = aspect * corner[i][0] / 2 + flat(stream, -moved, moved);
        h->x[i][1] = corner[i][1] / 2 + flat(stream, -moved, moved);
        h->x[i][2] = flat(stream, -warp, warp);
    }
}

/* Position and its derivatives at (xi,eta). */
static void evaluate(const struct hard_case *h, double xi, double eta, double r[3], double t[3], double u[3],
                     double c[3])
{
    for (int k = 0; k < 3; k++) {
        r[k] = t[k] = u[k] = c[k] = 0;
        for (int i = 0; i < 4; i++) {
            r[k] += h->x[i][k] * (1 + corner[i][0] * xi) * (1 + corner[i][1] * eta) / 4;
            t[k] += h->x[i][k] * corner[i][0] * (1 + corner[i][1] * eta) / 4;
            u[k] += h->x[i][k] * (1 + corner[i][0] * xi) * corner[i][1] / 4;
            c[k] += h->x[i][k] * corner[i][0] * corner[i][1] / 4;
        }
    }
}

/* xS over (xi,eta); where there is no normal, in any direction. */
static void place(uint64_t *stream, struct hard_case *h, double xi, double eta, double gap)
{
    double r[3], t[3], u[3], c[3], n[3], any[3];
    draw_direction(stream, any);
    evaluate(h, xi, eta, r, t, u, c);
    cross(t, u, n);
    const double length = sqrt(dot(n, n));
    for (int k = 0; k < 3; k++)
        h->x[4][k] = r[k] + gap * (length > 0 ? n[k] / length : any[k]);
}

static void place_inside(uint64_t *stream, struct hard_case *h, double gap)
{
    const double xi = flat(stream, -0.99, 0.99), eta = flat(stream, -0.99, 0.99);
    place(stream, h, xi, eta, flat(stream, -gap, gap));
}

/* Turned, scaled and moved by `shift` edges. */
static void move(uint64_t *stream, struct hard_case *h, double scale, double shift)
{
    double frame[3][3], by[3], size = 0;
    draw_direction(stream, frame[0]);
    do {
        draw_direction(stream, by);
        cross(frame[0], by, frame[1]);
        size = sqrt(dot(frame[1], frame[1]));
    } while (!(size > 0.1));
    for (int k = 0; k < 3; k++)
        frame[1][k] /= size;
    cross(frame[0], frame[1], frame[2]);
    draw_direction(stream, by);
    for (int i = 0; i < 5; i++) {
        double y[3];
        for (int k = 0; k < 3; k++)
            y[k] = scale *
                   (frame[0][k] * h->x[i][0] + frame[1][k] * h->x[i][1] + frame[2][k] * h->x[i][2] + shift * by[k]);
        memcpy(h->x[i], y, sizeof y);
    }
}

static void draw_ordinary(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.03, h);
    place_inside(s, h, 0.1);
    move(s, h, power(s, -1, 1), 2);
}

static void draw_around(uint64_t *s, struct hard_case *h)
{
    const double aspect = flat(s, 1, 3);
    draw_quad(s, aspect, 0.15, 0.03, h);
    h->x[4][0] = aspect * flat(s, -1.5, 1.5);
    h->x[4][1] = flat(s, -1.5, 1.5);
    h->x[4][2] = flat(s, -1, 1);
    move(s, h, 1, 2);
}

static void draw_warp(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.6, h);
    place_inside(s, h, 1);
    move(s, h, 1, 2);
}

static void draw_triangle(uint64_t *s, struct hard_case *h)
{
    const double near = power(s, -14, -1);
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    for (int k = 0; k < 3; k++)
        h->x[2][k] = h->x[3][k] + near * (h->x[2][k] - h->x[3][k]);
    place_inside(s, h, 0.3);
    move(s, h, 1, 2);
}

static void draw_collapsed(uint64_t *s, struct hard_case *h)
{
    const int i = choose(s, 4);
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    memcpy(h->x[i], h->x[(i + 1) % 4], sizeof h->x[i]);
    place_inside(s, h, 0.3);
    move(s, h, 1, 2);
}

static void draw_repeated(uint64_t *s, struct hard_case *h)
{
    const int kind = choose(s, 5);
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    if (kind == 0) /* opposite corners */
        memcpy(h->x[2], h->x[0], sizeof h->x[0]);
    if (kind == 1) /* two edges */
        memcpy(h->x[1], h->x[0], sizeof h->x[0]), memcpy(h->x[3], h->x[2], sizeof h->x[0]);
    if (kind == 2 || kind == 3) /* three or four corners */
        for (int i = 1; i < kind + 1; i++)
            memcpy(h->x[i], h->x[0], sizeof h->x[0]);
    if (kind == 4) /* a line */
        for (int i = 1; i < 4; i++) {
            const double t = flat(s, -1, 1);
            for (int k = 0; k < 3; k++)
                h->x[i][k] = h->x[0][k] + t * (k + 1);
        }
    place_inside(s, h, 0.3);
    move(s, h, 1, 2);
}

/* The Hessian's determinant vanishes at the gap (t.u +- |t| |u|)/(c.n). */
static void draw_focal(uint64_t *s, struct hard_case *h)
{
    double r[3], t[3], u[3], c[3], n[3];
    const double xi = flat(s, -0.99, 0.99), eta = flat(s, -0.99, 0.99);
    draw_quad(s, flat(s, 1, 3), 0.15, 0.4, h);
    evaluate(h, xi, eta, r, t, u, c);
    cross(t, u, n);
    const double turn = dot(c, n) / sqrt(dot(n, n)), most = sqrt(dot(t, t) * dot(u, u));
    const double gap = (dot(t, u) + (choose(s, 2) ? most : -most)) / turn;
    const double off = choose(s, 4) ? (choose(s, 2) ? 1 : -1) * power(s, -15, -1) : 0;
    place(s, h, xi, eta, fabs(gap) < 100 ? gap * (1 + off) : 1);
    move(s, h, 1, 2);
}

static void draw_far(uint64_t *s, struct hard_case *h)
{
    double d[3];
    const double distance = flat(s, 5, 50);
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    draw_direction(s, d);
    for (int k = 0; k < 3; k++)
        h->x[4][k] = distance * d[k];
    move(s, h, 1, 2);
}

static void draw_farther(uint64_t *s, struct hard_case *h)
{
    const double distance = power(s, 2, 13);
    draw_quad(s, flat(s, 1, 3), 0.15, 0.03, h);
    draw_direction(s, h->x[4]);
    for (int k = 0; k < 3; k++)
        h->x[4][k] *= distance;
    move(s, h, 1, 2);
}

static void draw_plane(uint64_t *s, struct hard_case *h)
{
    const double aspect = flat(s, 1, 3);
    draw_quad(s, aspect, 0.45, 0, h);
    h->x[4][0] = aspect * flat(s, -1.5, 1.5);
    h->x[4][1] = flat(s, -1.5, 1.5);
    h->x[4][2] = choose(s, 2) ? 0 : flat(s, -0.2, 0.2);
    if (choose(s, 2))
        move(s, h, 1, 2);
}

static void draw_offset(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    move(s, h, power(s, -2, 2), choose(s, 2) ? 1e6 : power(s, 5, 9));
}

/* In float, an edge is not resolved from 1e7 edges away. */
static void draw_offset_float(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    move(s, h, power(s, -2, 2), choose(s, 2) ? 1e6 : power(s, 1, 8));
}

static void draw_scale_float(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    move(s, h, power(s, -4, 4), 2);
}

static void draw_extreme_float(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    move(s, h, choose(s, 2) ? power(s, -46, -4) : power(s, 4, 39), 2);
}

static void draw_scale(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    move(s, h, power(s, -9, 9), 2);
}

static void draw_aspect(uint64_t *s, struct hard_case *h)
{
    static const double aspects[] = {1e2, 1e3, 1e4, 1e6};
    draw_quad(s, aspects[choose(s, 4)], 0.15, 0.1, h);
    if (choose(s, 3))
        place_inside(s, h, 0.3);
    else
        place(s, h, flat(s, -1.5, 1.5), flat(s, -1.5, 1.5), flat(s, -1, 1));
    move(s, h, 1, 2);
}

static void draw_edge(uint64_t *s, struct hard_case *h)
{
    const double side = choose(s, 2) ? 1 : -1, other = choose(s, 2) ? 1 : -1;
    const double off = choose(s, 2) ? 0 : (choose(s, 2) ? 1 : -1) * power(s, -16, -2);
    const int kind = choose(s, 3);
    draw_quad(s, flat(s, 1, 3), 0.15, choose(s, 2) ? 0.1 : 0, h);
    const double along = kind == 2 ? other : flat(s, -1, 1);
    place(s, h, kind ? side + off : along, kind ? along : side + off, choose(s, 2) ? 0 : flat(s, -0.3, 0.3));
    if (choose(s, 2))
        move(s, h, 1, 2);
}

/* A corner drawn in beyond the other diagonal, or two corners exchanged. */
static void draw_folded(uint64_t *s, struct hard_case *h)
{
    double keep[3];
    const double aspect = flat(s, 1, 3), t = flat(s, 0.5, 0.9);
    draw_quad(s, aspect, 0.15, choose(s, 2) ? 0.1 : 0, h);
    if (choose(s, 2)) {
        for (int k = 0; k < 3; k++)
            h->x[2][k] += t * (h->x[0][k] - h->x[2][k]);
    } else {
        memcpy(keep, h->x[2], sizeof keep);
        memcpy(h->x[2], h->x[3], sizeof keep);
        memcpy(h->x[3], keep, sizeof keep);
    }
    h->x[4][0] = aspect * flat(s, -1, 1);
    h->x[4][1] = flat(s, -1, 1);
    h->x[4][2] = flat(s, -0.5, 0.5);
    move(s, h, 1, 2);
}

/* Any five points: beyond every scene. */
static void draw_beyond(uint64_t *s, struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            h->x[i][k] = flat(s, -1, 1);
    move(s, h, 1, 2);
}

/* A saddle with xS on its axis: two closest points beyond the focal distance. */
static void draw_symmetric(uint64_t *s, struct hard_case *h)
{
    const double warp = flat(s, 0.1, 1), aspect = choose(s, 2) ? 1 : flat(s, 1, 2);
    for (int i = 0; i < 4; i++) {
        h->x[i][0] = aspect * corner[i][0];
        h->x[i][1] = corner[i][1];
        h->x[i][2] = warp * corner[i][0] * corner[i][1];
    }
    h->x[4][0] = h->x[4][1] = 0;
    h->x[4][2] = flat(s, -3, 3);
}

/* The same about the height where one closest point becomes two, and next to the axis. */
static void draw_cusp(uint64_t *s, struct hard_case *h)
{
    const double warp = flat(s, 0.1, 1), aspect = choose(s, 2) ? 1 : flat(s, 1, 2);
    for (int i = 0; i < 4; i++) {
        h->x[i][0] = aspect * corner[i][0];
        h->x[i][1] = corner[i][1];
        h->x[i][2] = warp * corner[i][0] * corner[i][1];
    }
    h->x[4][2] = aspect / warp * (1 + (choose(s, 2) ? 1 : -1) * power(s, -16, -2));
    for (int k = 0; k < 2; k++)
        h->x[4][k] = choose(s, 3) ? (choose(s, 2) ? 1 : -1) * power(s, -16, -2) : 0;
    if (choose(s, 2))
        move(s, h, 1, 2);
}

/* Coordinates on a coarse grid: coincidences of every kind. */
static void draw_grid(uint64_t *s, struct hard_case *h)
{
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            h->x[i][k] = choose(s, 4) - 1;
}

static void draw_extreme(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    move(s, h, choose(s, 2) ? power(s, -323, -280) : power(s, 280, 307.5), 2);
}

static void draw_not_finite(uint64_t *s, struct hard_case *h)
{
    draw_quad(s, flat(s, 1, 3), 0.15, 0.1, h);
    place_inside(s, h, 0.3);
    const int n = 1 + choose(s, 3);
    for (int i = 0; i < n; i++) {
        const int kind = choose(s, 3);
        h->x[choose(s, 5)][choose(s, 3)] = kind == 0 ? (double)NAN : kind == 1 ? HUGE_VAL : -HUGE_VAL;
    }
}

const struct hard_family hard_families[] = {
    {"ordinary", "what meshes hold, foot point inside", draw_ordinary, draw_ordinary, 1},
    {"around", "the same, slave nodes all around", draw_around, draw_around, 1},
    {"warp", "warp and gap up to the edge", draw_warp, draw_warp, 1},
    {"triangle", "C near D, to 1e-14 of the edge", draw_triangle, draw_triangle, 1},
    {"collapsed", "an edge of no length", draw_collapsed, draw_collapsed, 1},
    {"repeated", "repeated nodes, corners in a line", draw_repeated, draw_repeated, 1},
    {"focal", "gap near 1/curvature", draw_focal, draw_focal, 1},
    {"far", "5 to 50 edges away", draw_far, draw_far, 1},
    {"farther", "1e2 to 1e13 edges away", draw_farther, draw_farther, 1},
    {"plane", "plane, with exterior roots", draw_plane, draw_plane, 1},
    {"offset", "1e5 to 1e9 edges from the origin", draw_offset, draw_offset_float, 1},
    {"scale", "edges of 1e-9 to 1e9", draw_scale, draw_scale_float, 1},
    {"aspect", "aspect ratio 1e2 to 1e6", draw_aspect, draw_aspect, 1},
    {"edge", "over edges and corners", draw_edge, draw_edge, 1},
    {"folded", "not convex, or crossing itself", draw_folded, draw_folded, 1},
    {"beyond", "five points at random", draw_beyond, draw_beyond, 1},
    {"symmetric", "on the axis of a saddle", draw_symmetric, draw_symmetric, 1},
    {"cusp", "where one closest point becomes two", draw_cusp, draw_cusp, 1},
    {"grid", "coordinates -1, 0, 1, 2", draw_grid, draw_grid, 1},
    {"extreme", "denormal and huge coordinates", draw_extreme, draw_extreme_float, 1},
    {"not-finite", "NaN and infinities", draw_not_finite, draw_not_finite, 0},
};

const int hard_family_count = sizeof hard_families / sizeof *hard_families;

static uint64_t stream_of(int family, uint64_t seed, uint64_t index)
{
    uint64_t stream = seed * 0x100000001b3u + (uint64_t)family;
    stream = next(&stream) + index;
    return next(&stream);
}

void hard_draw(int family, uint64_t seed, uint64_t index, struct hard_case *h)
{
    uint64_t stream = stream_of(family, seed, index);
    hard_families[family].draw(&stream, h);
}

/* volatile: gcc 12 -O3 vectorises the two conversions into none. */
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
