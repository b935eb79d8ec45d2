/* The side of faces on which slave nodes lie: the sign of distances, of headers and of the library, around ridges,
 * valleys and corners at which faces meet, at corners of one face without a normal, and beside and below a face. The
 * reference uses determinants in long double of the rounded coordinates and shares no code with the searches. Each case
 * at the origin and 1e6 edges away; some thousands of each, 1e6 with FOOTPOINT_LONG. */
#include "../../generated/footpoint_plane_quad4.h"
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_float.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri6.h"
#include "../../runtime/footpoint.h"
#include "../../runtime/footpoint_face.h"
#include "../support/long_cases.h"

#include <float.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 3000, SAMPLES_LONG = 1000000, SEED = 20086, SECTORS = 6, MOST = 10 };
#define FAR 1e6

typedef int closest_of(size_t n, const double *const *x, const double xS[3], double loc[2], double *dist, int *region,
                       size_t *which);
static const struct function {
    const char *name;
    enum footpoint_face face;
    int corners, nodes;
    closest_of *of;
} functions[] = {
    {"tri3_exact", FOOTPOINT_TRI3, 3, 3, footpoint_tri3_exact_closest_of},
    {"tri6_accurate", FOOTPOINT_TRI6, 3, 6, footpoint_tri6_accurate_closest_of},
    {"quad4_fast", FOOTPOINT_QUAD4, 4, 4, footpoint_quad4_fast_closest_of},
    {"quad4_medium", FOOTPOINT_QUAD4, 4, 4, footpoint_quad4_medium_closest_of},
    {"quad4_precise", FOOTPOINT_QUAD4, 4, 4, footpoint_quad4_precise_closest_of},
    {"quad4_full", FOOTPOINT_QUAD4, 4, 4, footpoint_quad4_full_closest_of},
    {"plane_quad4_exact", FOOTPOINT_QUAD4, 4, 4, footpoint_plane_quad4_exact_closest_of},
    {"quad8_full", FOOTPOINT_QUAD8, 4, 8, footpoint_quad8_full_closest_of},
    {"quad9_full", FOOTPOINT_QUAD9, 4, 9, footpoint_quad9_full_closest_of},
};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* Faces that share an edge or a corner, each with its own copy of its nodes, and a slave node. */
struct patch {
    int faces;
    double x[SECTORS][MOST][3], xs[3];
};

static long samples(void)
{
    return long_cases(SAMPLES, SAMPLES_LONG);
}

/* ---- vectors ---- */

static void cross(const long double a[3], const long double b[3], long double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static long double dot(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static long double length(const long double a[3])
{
    return sqrtl(dot(a, a));
}

static void difference(const double a[3], const double b[3], long double d[3])
{
    for (int i = 0; i < 3; i++)
        d[i] = (long double)b[i] - (long double)a[i];
}

/* Turns and moves all points alike, at random. */
static void move(gsl_rng *stream, double (*x)[3], size_t n, double away)
{
    double q[4], at[3];
    gsl_ran_dir_nd(stream, 4, q);
    for (int i = 0; i < 3; i++)
        at[i] = away * gsl_ran_flat(stream, -1, 1);
    const double r[3][3] = {
        {1 - 2 * (q[2] * q[2] + q[3] * q[3]), 2 * (q[1] * q[2] - q[0] * q[3]), 2 * (q[1] * q[3] + q[0] * q[2])},
        {2 * (q[1] * q[2] + q[0] * q[3]), 1 - 2 * (q[1] * q[1] + q[3] * q[3]), 2 * (q[2] * q[3] - q[0] * q[1])},
        {2 * (q[1] * q[3] - q[0] * q[2]), 2 * (q[2] * q[3] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2])}};
    for (size_t k = 0; k < n; k++) {
        const double y[3] = {x[k][0], x[k][1], x[k][2]};
        for (int i = 0; i < 3; i++)
            x[k][i] = at[i] + (r[i][0] * y[0] + r[i][1] * y[1] + r[i][2] * y[2]);
    }
}

/* Adds the middles of straight edges, and of the face. */
static void add_middles(const struct function *f, double x[MOST][3])
{
    for (int k = 0; k < f->nodes - f->corners; k++)
        for (int i = 0; i < 3; i++)
            x[f->corners + k][i] = k < f->corners ? 0.5 * (x[k][i] + x[(k + 1) % f->corners][i])
                                                  : 0.25 * (x[0][i] + x[1][i] + x[2][i] + x[3][i]);
}

/* ---- calls ---- */

/* Returns the sign from a header or the library, proved or not; 0: no answer. */
static int sign_of(const struct function *f, const struct patch *p, int library)
{
    const double *x[SECTORS * MOST];
    double xyz[SECTORS * MOST][3], loc[2], dist = 0;
    int seg[SECTORS * MOST], region, status;
    size_t which;
    const size_t all = (size_t)(p->faces * f->nodes);
    for (size_t k = 0; k < all; k++) {
        x[k] = p->x[k / (size_t)f->nodes][k % (size_t)f->nodes];
        memcpy(xyz[k], x[k], sizeof xyz[k]);
        seg[k] = (int)k;
    }
    if (library)
        status = footpoint_face_select(f->face, xyz[0], (size_t)p->faces, seg, p->xs, &which, loc, &dist, &region);
    else
        status = f->of((size_t)p->faces, x, p->xs, loc, &dist, &region, &which);
    return status < FOOTPOINT_OK ? 0 : dist < 0 ? -1 : 1;
}

static void ask(const struct function *f, const struct patch *p, int truth, const char *what, double h)
{
    for (int library = 0; library < 2; library++) {
        const int sign = sign_of(f, p, library);
        if (sign != truth)
            fail_msg("%s%s, %s, %g away: sign %d, truth %d", f->name, library ? " by the library" : "", what, h, sign,
                     truth);
    }
}

/* Returns true if a height over a face exceeds rounding: of the search, and of middle nodes, which bend faces far from
 * the origin. Nodes of straight edges bend nothing. */
static int is_clear(const struct function *f, double origin, long double height, long double away)
{
    const long double bent = f->nodes > f->corners ? 8 * DBL_EPSILON * origin : 0;
    return fabsl(height) > 1e-6L * away + 1e-14L + bent;
}

/* ---- ridges and valleys ---- */

/* Draws two faces at a right, sharp or blunt edge from (0,0,0) to (0,1,0), outside of their upper angle. */
static void draw_ridge(gsl_rng *stream, const struct function *f, int valley, double angle, struct patch *p)
{
    const double s = sin(0.5 * angle), c = cos(0.5 * angle);
    p->faces = 2;
    for (int side = 0; side < 2; side++) {
        double corner[4][3] = {{0, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 1, 0}};
        for (int k = 1; k < 3; k++) {
            const double reach = gsl_ran_flat(stream, 0.5, 1.5);
            corner[k][0] += side ? -s * reach : s * reach;
            corner[k][1] += gsl_ran_flat(stream, -0.2, 0.2);
            corner[k][2] -= c * reach;
        }
        const int back = side != valley; /* corners are ordered as seen from outside */
        for (int k = 0; k < 4; k++)
            memcpy(p->x[side][back ? 3 - k : k], corner[f->corners == 3 && k == 2 ? 1 : k], sizeof *corner);
        if (f->corners == 3) {
            const int order[2][3] = {{0, 1, 3}, {0, 2, 3}};
            double y[4][3];
            memcpy(y, p->x[side], sizeof y);
            for (int k = 0; k < 3; k++)
                memcpy(p->x[side][k], y[order[back][k]], sizeof *y);
        }
    }
}

/* Returns the true side, from the ends of the common edge and a node of each face beside it. */
static int truth_of_ridge(const struct function *f, double origin, const struct patch *p, const double end[2][3],
                          double beside[2][3], int *clear)
{
    long double edge[3], d[3], height[2];
    difference(end[0], end[1], edge);
    difference(end[0], p->xs, d);
    const long double along = dot(d, edge) / dot(edge, edge);
    for (int i = 0; i < 3; i++)
        d[i] -= along * edge[i];
    *clear = 1;
    for (int side = 0; side < 2; side++) {
        long double a[3], n[3];
        difference(end[0], beside[side], a);
        cross(edge, a, n);
        height[side] = (side ? 1 : -1) * dot(n, d) / length(n); /* > 0 above */
        *clear &= is_clear(f, origin, height[side], length(d));
    }
    return height[0] < 0 && height[1] < 0 ? -1 : 1;
}

static void ridges_and_valleys(void **state)
{
    (void)state;
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    gsl_rng_set(stream, SEED);
    for (int m = 0; m < FUNCTIONS; m++)
        for (long n = 0, asked = 0; n < samples(); n++) {
            const struct function *const f = &functions[m];
            const int valley = (int)(n & 1);
            const double origin = n & 2 ? FAR : 0;
            const double angle = gsl_ran_flat(stream, 5, 175) * M_PI / 180, h = pow(10, gsl_ran_flat(stream, -12, -1));
            const double turn = gsl_ran_flat(stream, 0, 2 * M_PI), t = gsl_ran_flat(stream, 0.2, 0.8);
            struct patch p;
            double points[2 * 4 + 3][3] = {{0}};
            int clear;
            draw_ridge(stream, f, valley, angle, &p);
            for (int side = 0; side < 2; side++)
                memcpy(points[4 * side], p.x[side], sizeof(double[4][3]));
            points[8][1] = 0;
            points[9][1] = 1;
            points[10][0] = h * cos(turn);
            points[10][1] = t;
            points[10][2] = h * sin(turn);
            move(stream, points, 11, origin);
            for (int side = 0; side < 2; side++)
                for (int k = 0; k < f->corners; k++) {
                    memcpy(p.x[side][k], points[4 * side + k], sizeof *points);
                }
            memcpy(p.xs, points[10], sizeof p.xs);
            double beside[2][3];
            for (int side = 0; side < 2; side++) {
                for (int k = 0; k < f->corners; k++)
                    if (memcmp(p.x[side][k], points[8], sizeof *points) != 0 &&
                        memcmp(p.x[side][k], points[9], sizeof *points) != 0)
                        memcpy(beside[side], p.x[side][k], sizeof *beside);
                add_middles(f, p.x[side]);
            }
            const int truth = truth_of_ridge(f, origin, &p, (const double(*)[3])(points + 8), beside, &clear);
            if (!clear)
                continue;
            asked++;
            ask(f, &p, valley ? -truth : truth, valley ? "valley" : "ridge", h);
        }
    gsl_rng_free(stream);
}

/* ---- slim triangles ---- */

/* Two triangles of a slim wall meet a triangle of the plate below at right angles. The slave node is within 1e-10 of
 * the wall, so errors in xi and eta, aspect ratio times rounding, exceed its distance. */
static void slim_triangles(void **state)
{
    (void)state;
    const struct function *const f = &functions[0];
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    gsl_rng_set(stream, SEED + 2);
    for (long n = 0; n < samples(); n++) {
        const double h = pow(10, gsl_ran_flat(stream, -5, -2)), t = gsl_ran_flat(stream, 0.05, 0.95);
        const double deep = pow(10, gsl_ran_flat(stream, -12, -10)), below = h * pow(10, gsl_ran_flat(stream, -7, -1));
        const int outside = (int)(n & 1);
        const double faces[3][3][3] = {
            {{0, 0, h}, {1, 1, h}, {0, 1, h}}, {{0, 1, 0}, {0, 1, h}, {1, 1, 0}}, {{0, 1, h}, {1, 1, h}, {1, 1, 0}}};
        struct patch p = {.faces = 3, .xs = {t, outside ? 1 + deep : 1 - deep, h - below}};
        for (int k = 0; k < 3; k++)
            memcpy(p.x[(n / 2 + k) % 3], faces[k], sizeof faces[k]);
        if (below > 2 * deep)
            ask(f, &p, outside ? 1 : -1, "slim triangle", deep);
    }
    gsl_rng_free(stream);
}

/* ---- corners ---- */

/* Draws faces around a corner at 0, ordered by azimuth as seen from above: ends[k] to ends[k + 1], at random below or
 * above the corner, so that the surface is star-shaped. Edges and faces with middle nodes bend away from their
 * tangents. */
static int draw_corner(gsl_rng *stream, const struct function *f, struct patch *p, double ends[SECTORS + 1][3])
{
    double azimuth[SECTORS], bend[SECTORS][3];
    const double reach = gsl_ran_flat(stream, 0, 2), most = f->nodes > f->corners ? 0.05 : 0;
    p->faces = 3 + (int)gsl_rng_uniform_int(stream, SECTORS - 2);
    for (int k = 0; k < p->faces; k++) {
        azimuth[k] = 2 * M_PI * (k + gsl_ran_flat(stream, -0.2, 0.2)) / p->faces;
        const double end[3] = {cos(azimuth[k]), sin(azimuth[k]), gsl_ran_flat(stream, -1, 1) - reach};
        for (int i = 0; i < 3; i++) {
            ends[k][i] = end[i];
            bend[k][i] = gsl_ran_flat(stream, -most, most);
        }
    }
    memcpy(ends[p->faces], ends[0], sizeof *ends);
    for (int k = 0; k < p->faces; k++) {
        const int next = (k + 1) % p->faces, last = f->corners - 1;
        double(*const x)[3] = p->x[k];
        for (int i = 0; i < 3; i++) {
            x[0][i] = 0;
            x[1][i] = ends[k][i] + bend[k][i];
            x[last][i] = ends[next][i] + bend[next][i];
            if (f->corners == 4)
                x[2][i] = x[1][i] + x[3][i];
        }
        add_middles(f, x);
        for (int i = 0; i < 3 && f->nodes > f->corners; i++) {
            x[f->corners][i] = 0.5 * ends[k][i] + 0.25 * bend[k][i];
            x[f->nodes == 6 ? 5 : 7][i] = 0.5 * ends[next][i] + 0.25 * bend[next][i];
        }
    }
    return p->faces;
}

/* Collapses some of the four-node faces to triangles, with one node twice, the corner or another. */
static void collapse_some(gsl_rng *stream, const struct function *f, struct patch *p)
{
    for (int k = 0; k < p->faces && f->nodes == 4; k++) {
        double(*const x)[3] = p->x[k], a[3], b[3];
        memcpy(a, x[1], sizeof a);
        memcpy(b, x[3], sizeof b);
        switch (gsl_rng_uniform_int(stream, 6)) {
        case 0: /* 0 a a b */
            memcpy(x[2], a, sizeof a);
            break;
        case 1: /* 0 a b b */
            memcpy(x[2], b, sizeof b);
            break;
        case 2: /* 0 0 a b */
            memcpy(x[1], x[0], sizeof a);
            memcpy(x[2], a, sizeof a);
            break;
        case 3: /* a b 0 0 */
            memcpy(x[2], x[0], sizeof a);
            memcpy(x[3], x[0], sizeof a);
            memcpy(x[0], a, sizeof a);
            memcpy(x[1], b, sizeof b);
            break;
        default:
            break;
        }
    }
}

/* Returns 1 above the cone of the ends, along `up`. */
static int truth_of_corner(const struct function *f, double origin, int faces, const double *corner,
                           double ends[SECTORS + 1][3], const double up[3], const double xs[3], int *clear)
{
    long double d[3], axis[3];
    int truth = 0;
    difference(corner, xs, d);
    difference(corner, up, axis);
    *clear = 1;
    for (int k = 0; k < faces; k++) {
        long double a[3], b[3], n[3], ahead[3], beyond[3];
        difference(corner, ends[k], a);
        difference(corner, ends[k + 1], b);
        cross(a, b, n);
        cross(axis, a, ahead);
        cross(b, axis, beyond);
        const long double height = dot(n, d) / length(n);
        *clear &= is_clear(f, origin, height, length(d)) &&
                  (f->nodes == f->corners || fabsl(height) > dot(d, d)); /* the cone is tangential to bent faces */
        if (dot(ahead, d) >= 0 && dot(beyond, d) >= 0)
            truth = dot(n, d) > 0 ? 1 : -1;
    }
    *clear &= truth != 0;
    return truth;
}

static void corners(void **state)
{
    (void)state;
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    gsl_rng_set(stream, SEED + 1);
    for (int m = 0; m < FUNCTIONS; m++)
        for (long n = 0; n < samples(); n++) {
            const struct function *const f = &functions[m];
            const double origin = n & 1 ? FAR : 0, h = pow(10, gsl_ran_flat(stream, -12, -1.5));
            struct patch p;
            double ends[SECTORS + 1][3], points[SECTORS * MOST + SECTORS + 5][3], way[3];
            const int faces = draw_corner(stream, f, &p, ends), all = faces * f->nodes;
            int clear;
            collapse_some(stream, f, &p);
            memset(points[0], 0, sizeof *points); /* the corner */
            for (int k = 0; k < all; k++)
                memcpy(points[1 + k], p.x[k / f->nodes][k % f->nodes], sizeof *points);
            memcpy(points[1 + all], ends, sizeof ends);
            gsl_ran_dir_3d(stream, &way[0], &way[1], &way[2]);
            for (int i = 0; i < 3; i++) {
                points[all + SECTORS + 2][i] = h * way[i];
                points[all + SECTORS + 3][i] = i == 2;
            }
            move(stream, points, (size_t)all + SECTORS + 4, origin);
            for (int k = 0; k < all; k++)
                memcpy(p.x[k / f->nodes][k % f->nodes], points[1 + k], sizeof *points);
            memcpy(p.xs, points[all + SECTORS + 2], sizeof p.xs);
            const int truth =
                truth_of_corner(f, origin, faces, points[0], points + 1 + all, points[all + SECTORS + 3], p.xs, &clear);
            if (clear)
                ask(f, &p, truth, "corner", h);
        }
    gsl_rng_free(stream);
}

/* ---- a corner of one face, nearly without a normal ---- */

typedef int closest(const double[3], const double[3], const double[3], const double[3], const double[3], double[2],
                    double *, int *);

static int robust(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                  double loc[2], double *dist, int *region)
{
    (void)region;
    return footpoint_robust(xA, xB, xC, xD, xS, loc, dist);
}

/* Computes four times the normal r_xi x r_eta of a four-node face. */
static void bilinear_normal(double (*x)[3], long double xi, long double eta, long double n[3])
{
    long double u[3], v[3];
    for (int i = 0; i < 3; i++) {
        u[i] = ((long double)x[1][i] - x[0][i]) * (1 - eta) + ((long double)x[2][i] - x[3][i]) * (1 + eta);
        v[i] = ((long double)x[3][i] - x[0][i]) * (1 - xi) + ((long double)x[2][i] - x[1][i]) * (1 + xi);
    }
    cross(u, v, n);
}

/* Draws a slave node and a face with a short edge at its first corner, where |r_xi x r_eta| is about 1/1024 of its value
 * 1/1024 of the way to the middle. */
static void draw_short_edge(gsl_rng *stream, double x[5][3])
{
    const double edge = pow(10, gsl_ran_flat(stream, -7, -5)), far = pow(10, gsl_ran_flat(stream, -4, 0.3));
    for (int k = 0; k < 5; k++)
        gsl_ran_dir_3d(stream, &x[k][0], &x[k][1], &x[k][2]);
    for (int i = 0; i < 3; i++) {
        x[0][i] = 0;
        x[2][i] *= 8;
        x[3][i] *= edge;
        x[4][i] *= far;
    }
}

static void corners_nearly_without_a_normal(void **state)
{
    static closest *const ways[] = {footpoint_quad4_fast_closest, footpoint_quad4_accurate_closest,
                                    footpoint_quad4_full_closest, robust};
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    long judged[sizeof ways / sizeof *ways][2] = {{0}};
    (void)state;
    gsl_rng_set(stream, SEED + 2);
    for (long k = 0; k < 10 * samples(); k++) {
        double x[5][3], loc[2], dist;
        long double n[3], m[3], d[3];
        int region;
        draw_short_edge(stream, x);
        bilinear_normal(x, -1, -1, n);
        bilinear_normal(x, -1023.0L / 1024, -1023.0L / 1024, m);
        difference(x[0], x[4], d);
        const long double share = 1024 * length(n) / length(m);
        const int inside = share < 1;
        const long double ahead = inside ? dot(m, d) / length(m) : dot(n, d) / length(n);
        if (fabsl(share - 1) < 1e-6L || share < 0.1L || share > 10 || fabsl(ahead) < 1e-7L * length(d))
            continue;
        for (size_t w = 0; w < sizeof ways / sizeof *ways; w++)
            if (ways[w](x[0], x[1], x[2], x[3], x[4], loc, &dist, &region) >= FOOTPOINT_OK && loc[0] == -1 &&
                loc[1] == -1) {
                judged[w][inside]++;
                if ((ahead < 0) != (dist < 0))
                    fail_msg("way %zu, case %ld: distance %g, but %Lg ahead", w, k, dist, ahead);
            }
    }
    for (size_t w = 0; w < sizeof ways / sizeof *ways; w++)
        assert_true(judged[w][0] > samples() / 100 && judged[w][1] > samples() / 100);
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_nearly_without_a_normal),
        cmocka_unit_test(ridges_and_valleys),
        cmocka_unit_test(slim_triangles),
        cmocka_unit_test(corners),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
