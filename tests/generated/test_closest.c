/* Closest points of closed faces, NAME_closest and NAME_closest_n, on faces as scenes draw them, against
 * footpoint_robust, which shares no code with them. Slave nodes lie in the scenes' ranges and up to an edge beside the
 * face. 50,000 of each scene, 1e7 with FOOTPOINT_LONG. */
#include "../../codegen/genome/genome.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/samples/samples.h"
#include "../../generated/footpoint_parallelogram_quad4.h"
#include "../../generated/footpoint_plane_quad4.h"
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_float.h"
#include "../../generated/footpoint_rectangle_quad4.h"
#include "../../generated/footpoint_tri3.h"
#include "../../runtime/footpoint.h"
#include "../support/long_cases.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 50000, SAMPLES_LONG = 10000000, SEED = 20083, ROWS = 64 };
#define TIE 1e-7 /* in xi and eta: within this, rounding hides the region */

typedef int closest(const double *const *x, double loc[2], double *dist, int *region);
typedef void closest_n(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region,
                       int *status);

#define NODES_quad4(x) (x)[0], (x)[1], (x)[2], (x)[3], (x)[4]
#define NODES_tri3(x) (x)[0], (x)[1], (x)[2], (x)[3]
#define WRAP(kind, name, promise)                                                                                      \
    static int one_##name(const double *const *x, double loc[2], double *dist, int *region)                            \
    {                                                                                                                  \
        return footpoint_##name##_closest(NODES_##kind(x), loc, dist, region);                                         \
    }                                                                                                                  \
    static void many_##name(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region,      \
                            int *status)                                                                               \
    {                                                                                                                  \
        footpoint_##name##_closest_n(n, x, xi, eta, dist, region, status);                                             \
    }
#define ALL(F)                                                                                                         \
    F(quad4, quad4_fast, 1e-1)                                                                                         \
    F(quad4, quad4_coarse, 1e-1)                                                                                       \
    F(quad4, quad4_gauss2, 1e-2)                                                                                       \
    F(quad4, quad4_medium, 1e-2)                                                                                       \
    F(quad4, quad4_balanced, 1e-3)                                                                                     \
    F(quad4, quad4_fine, 1e-5)                                                                                         \
    F(quad4, quad4_precise, 1e-7)                                                                                      \
    F(quad4, quad4_accurate, 1e-10)                                                                                    \
    F(quad4, quad4_full, 1e-12)                                                                                        \
    F(quad4, plane_quad4_fast, 1e-1)                                                                                   \
    F(quad4, plane_quad4_coarse, 1e-1)                                                                                 \
    F(quad4, plane_quad4_exact, 1e-12)                                                                                 \
    F(quad4, parallelogram_quad4_exact, 1e-12)                                                                         \
    F(quad4, rectangle_quad4_exact, 1e-12)                                                                             \
    F(tri3, tri3_exact, 1e-12)
ALL(WRAP)
#define ROW(kind, name, promise) {#kind, #name, one_##name, many_##name, promise},
static struct function {
    const char *kind, *name;
    closest *one;
    closest_n *many;
    double worst; /* largest error of xi and eta with FOOTPOINT_OK */
} functions[] = {ALL(ROW)};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* A slave node, the last of x, and its certain answer. */
struct question {
    double x[5][3], longest;
    double loc[2], dist;
    int region;
};

/* Faces of a scene, and the range of slave nodes. */
struct face {
    const struct scene *scene;
    const struct surface *surface;
    size_t corners;
    gsl_rng *stream;
};

/* Returns the region of a point, from its coordinates. */
static int region_of(size_t corners, double xi, double eta)
{
    if (corners == 3) {
        if (xi > 0 && eta > 0 && 1 - xi - eta > 2e-16)
            return 0;
        return xi >= 1 ? 5 : eta >= 1 ? 6 : xi <= 0 && eta <= 0 ? 4 : eta <= 0 ? 1 : xi <= 0 ? 3 : 2;
    }
    static const int region[3][3] = {{5, 1, 6}, {4, 0, 2}, {8, 3, 7}};
    return region[eta >= 1 ? 2 : eta > -1][xi >= 1 ? 2 : xi > -1];
}

/* Returns the distance of (xi,eta) from the border of its region, in xi and eta. */
static double to_border(size_t corners, double xi, double eta)
{
    double least = 1;
    const double value[5] = {corners == 3 ? xi : 1 + xi, corners == 3 ? eta : 1 + eta,
                             corners == 3 ? 1 - xi - eta : 1 - xi, 1 - eta, 1 - xi};
    for (int i = 0; i < 5; i++)
        if (value[i] > 0)
            least = fmin(least, value[i]);
    return least;
}

static double clamp(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

/* Draws a foot point in the scene's ranges and its slave node, or moves the slave node along the tangents, up to the
 * face's length beyond it. */
static void place(const struct face *f, bool beside, struct question *q)
{
    const double low = f->corners == 3 ? 0 : -1, over = beside ? 1 - low : 0.1 * (1 - low);
    const struct shapes *shapes = &f->scene->shapes;
    double loc[2], foot[2], r[3][3], n[3], normal[3], point[3], shortest = HUGE_VAL, x[SEGMENT_VECTORS][3] = {{0}};
    for (int k = 0; k < 2; k++) {
        loc[k] = gsl_ran_flat(f->stream, low - over, 1 + over);
        foot[k] = clamp(loc[k], low, 1);
    }
    if (f->corners == 3 && foot[0] + foot[1] > 1)
        foot[1] = 1 - foot[0];
    q->longest = 0;
    for (size_t i = 0; i < f->corners; i++) {
        double square = 0;
        for (int k = 0; k < 3; k++) {
            x[i][k] = q->x[i][k];
            square += (q->x[(i + 1) % f->corners][k] - q->x[i][k]) * (q->x[(i + 1) % f->corners][k] - q->x[i][k]);
        }
        q->longest = fmax(q->longest, sqrt(square));
        shortest = fmin(shortest, sqrt(square));
    }
    f->surface->point(f->surface, x, foot[0], foot[1], r);
    assert_true(surface_normal(f->surface, x, foot[0], foot[1], point, normal));
    memcpy(n, normal, sizeof n);
    const double gap = gsl_ran_flat(f->stream, -shapes->gap, shapes->gap) * shortest;
    for (int k = 0; k < 3; k++)
        q->x[f->corners][k] = r[0][k] + (loc[0] - foot[0]) * r[1][k] + (loc[1] - foot[1]) * r[2][k] + gap * n[k];
}

/* Finds the certain answer; returns false if there is none. */
static bool answer(const struct face *f, struct question *q)
{
    static const int triangle[9] = {0, 1, 2, 6, 3, 4, 5, 6, 6};
    const double *const d = f->corners == 3 ? q->x[2] : q->x[3]; /* a triangle is a quadrilateral with C = D */
    const int status = footpoint_robust(q->x[0], q->x[1], q->x[2], d, q->x[f->corners], q->loc, &q->dist);
    if (status != FOOTPOINT_OK && status != FOOTPOINT_OUTSIDE)
        return false;
    if (f->corners == 3) {
        const double xi = q->loc[0], eta = q->loc[1];
        q->loc[0] = 0.25 * (1 + xi) * (1 - eta);
        q->loc[1] = 0.5 * (1 + eta);
        q->region = triangle[region_of(4, xi, eta)];
    } else
        q->region = region_of(4, q->loc[0], q->loc[1]);
    return true;
}

static void draw(const struct face *f, bool beside, struct question *q)
{
    double x[SEGMENT_VECTORS][3];
    do {
        const bool drawn = f->corners == 3 ? draw_face(f->surface, f->stream, &f->scene->shapes, x)
                                           : draw_quad(f->surface, f->stream, &f->scene->shapes, x);
        if (!drawn)
            continue;
        memcpy(q->x, x, f->corners * sizeof *x);
        place(f, beside, q);
        if (answer(f, q))
            return;
    } while (true);
}

/* Errors of one function. */
struct errors {
    size_t answers, far, unproved, wrong, region, side;
    double loc, dist;
};

static void ask(const struct function *m, const struct face *f, const struct question *q, struct errors *e)
{
    const double *const x[5] = {q->x[0], q->x[1], q->x[2], q->x[3], q->x[4]};
    double loc[2] = {7, 7}, dist = 7;
    int region = 7;
    const int status = m->one(x, loc, &dist, &region);
    const double over = fabs(q->dist) / q->longest - 1;
    if (status == FOOTPOINT_ERR_DOMAIN) {
        e->far++;
        assert_true(over > -1e-9 - m->worst);
        assert_true(loc[0] == 7 && loc[1] == 7 && dist == 7 && region == 7);
        return;
    }
    e->answers++;
    e->unproved += status == FOOTPOINT_UNPROVED;
    if (status == FOOTPOINT_UNPROVED)
        return;
    assert_int_equal(status, FOOTPOINT_OK);
    assert_true(over < 1e-12);
    const double off = fmax(fabs(loc[0] - q->loc[0]), fabs(loc[1] - q->loc[1]));
    const double longer = (fabs(dist) - fabs(q->dist)) / q->longest;
    e->loc = fmax(e->loc, off);
    e->dist = fmax(e->dist, fabs(longer));
    if (!(longer > -1e-10)) /* no point is nearer than the closest */
        fail_msg("%s: distance %a, certain %a", m->name, dist, q->dist);
    assert_int_equal(region, region_of(f->corners, loc[0], loc[1]));
    e->wrong += off > fmax(m->worst, TIE);
    e->region += region != q->region &&
                 fmin(to_border(f->corners, loc[0], loc[1]), to_border(f->corners, q->loc[0], q->loc[1])) > TIE;
    e->side += region == 0 && q->region == 0 && dist * q->dist < 0 && fabs(q->dist) > fmax(m->worst, 1e-9) * q->longest;
}

static void check_scene(const char *name, const char *prefix)
{
    struct diag d = {0};
    struct scene *scene = scene_read(".", name, &d);
    if (!scene)
        fail_msg("%s", d.text);
    const struct surface *surface = surface_find(scene->segment);
    const struct face f = {scene, surface, surface->nodes, stream_new()};
    const size_t samples = (size_t)long_cases(SAMPLES, SAMPLES_LONG);
    struct errors e[FUNCTIONS] = {{0}};
    for (size_t i = 0; i < samples; i++) {
        struct question q;
        stream_key(f.stream, SEED, 0, i, 0);
        draw(&f, i % 2, &q);
        for (int m = 0; m < FUNCTIONS; m++)
            if (strncmp(functions[m].name, prefix, strlen(prefix)) == 0)
                ask(&functions[m], &f, &q, &e[m]);
    }
    for (int m = 0; m < FUNCTIONS; m++) {
        if (e[m].answers == 0)
            continue;
        if (e[m].wrong > 0 || (functions[m].worst < 1e-2 && e[m].region > 0) || e[m].side > 0 ||
            e[m].far * 100 > samples * 5 || e[m].unproved > e[m].answers / 1000)
            fail_msg("%s: %zu answers, %zu far, %zu unproved; error %g (%g), %zu wrong, %zu regions, %zu sides",
                     functions[m].name, e[m].answers, e[m].far, e[m].unproved, e[m].loc, functions[m].worst, e[m].wrong,
                     e[m].region, e[m].side);
        if (functions[m].worst < 1e-3 && e[m].dist > 1e-9)
            fail_msg("%s: distance off by %g", functions[m].name, e[m].dist);
    }
    gsl_rng_free(f.stream);
    scene_free(scene);
}

static void answers_match_footpoint_robust(void **state)
{
    (void)state;
    check_scene("quad4", "quad4");
    check_scene("plane-quad4", "plane_quad4");
    check_scene("parallelogram-quad4", "parallelogram_quad4");
    check_scene("rectangle-quad4", "rectangle_quad4");
    check_scene("tri3", "tri3");
}

/* Draws a face, 64 slave nodes around it, within and beyond the range, and coordinates that are NaN, infinite or too
 * small. */
static void draw_rows(double x[ROWS][5][3], size_t vectors)
{
    static const double corner[4][3] = {{0, 0, 0}, {1, 0, 0}, {1.1, 1, 0}, {0, 0.9, 0.05}};
    const size_t nodes = vectors - 1;
    gsl_rng *stream = stream_new();
    stream_key(stream, SEED, 1, vectors, 0);
    for (int i = 0; i < ROWS; i++) {
        for (size_t k = 0; k < nodes; k++)
            for (int j = 0; j < 3; j++)
                x[i][k][j] = corner[nodes == 3 && k == 2 ? 3 : k][j];
        for (int j = 0; j < 3; j++)
            x[i][nodes][j] = j == 2 ? gsl_ran_flat(stream, -0.2, 0.2) : gsl_ran_flat(stream, -1, 2.5);
        for (size_t k = 0; k < vectors; k++)
            for (int j = 0; j < 3; j++) {
                if (i % 8 == 5)
                    x[i][k][j] = ldexp(x[i][k][j], i % 16 == 5 ? 900 : -900);
                if (i % 8 == 7 && k < nodes)
                    x[i][k][j] = i % 16 == 7 ? 1 : (double)(k * k);
            }
        if (i % 8 == 3)
            x[i][(size_t)i / 8 % vectors][i % 3] = i % 16 == 3 ? NAN : -INFINITY;
        if (i % 8 == 1)
            x[i][nodes][2] = i % 16 == 1 ? 1e200 : 3;
    }
    gsl_rng_free(stream);
}

/* Checks statuses, and that arrays have the answers of calls. */
static void arrays_are_answered_as_one(void **state)
{
    (void)state;
    for (int m = 0; m < FUNCTIONS; m++) {
        const size_t vectors = strcmp(functions[m].kind, "tri3") == 0 ? 4 : 5;
        double x[ROWS][5][3], column[15][ROWS], xi[ROWS], eta[ROWS], dist[ROWS];
        const double *columns[15];
        int region[ROWS], status[ROWS], many[4] = {0};
        draw_rows(x, vectors);
        for (size_t k = 0; k < 3 * vectors; k++) {
            columns[k] = column[k];
            for (int i = 0; i < ROWS; i++)
                column[k][i] = x[i][k / 3][k % 3];
        }
        functions[m].many(ROWS, columns, xi, eta, dist, region, status);
        for (int i = 0; i < ROWS; i++) {
            const double *const p[5] = {x[i][0], x[i][1], x[i][2], x[i][3], x[i][4]};
            double loc[2], d;
            int where;
            const int one = functions[m].one(p, loc, &d, &where);
            assert_int_equal(status[i], one);
            many[-one]++;
            if (i % 8 == 3)
                assert_int_equal(one, FOOTPOINT_ERR_NOT_FINITE);
            if (i % 8 == 7)
                assert_int_equal(one, FOOTPOINT_ERR_DEGENERATE);
            if (i % 8 == 1)
                assert_int_equal(one, FOOTPOINT_ERR_DOMAIN);
            if (one != FOOTPOINT_OK)
                continue;
            assert_int_equal(region[i], where);
#ifdef __FMA__ /* compilers fuse operations, differently in each place */
            assert_true(fabs(xi[i] - loc[0]) + fabs(eta[i] - loc[1]) < 1e-9 && fabs(dist[i] - d) <= 1e-9 * fabs(d));
#else
            assert_true(xi[i] == loc[0] && eta[i] == loc[1] && dist[i] == d);
#endif
        }
        assert_true(many[FOOTPOINT_OK] > 16);
    }
}

/* Answers are equal in any unit of length, and nearly equal at any place. */
static void size_does_not_matter(void **state)
{
    (void)state;
    double x[ROWS][5][3];
    draw_rows(x, 5);
    for (int m = 0; m < FUNCTIONS; m++)
        for (int i = 0; i < ROWS; i += 2)
            for (int power = -950; power <= 950; power += 50) {
                double y[5][3], loc[2][2], d[2];
                int region[2];
                for (int k = 0; k < 15; k++)
                    y[k / 3][k % 3] = ldexp(x[i][k / 3][k % 3], power);
                if (strcmp(functions[m].kind, "tri3") == 0) {
                    memcpy(x[i][3], x[i][4], sizeof x[i][3]);
                    memcpy(y[3], y[4], sizeof y[3]);
                }
                const double *const p[5] = {x[i][0], x[i][1], x[i][2], x[i][3], x[i][4]};
                const double *const q[5] = {y[0], y[1], y[2], y[3], y[4]};
                const int status = functions[m].one(p, loc[0], &d[0], &region[0]);
                assert_int_equal(functions[m].one(q, loc[1], &d[1], &region[1]), status);
                if (status != FOOTPOINT_OK)
                    continue;
                assert_int_equal(region[0], region[1]);
                assert_true(loc[0][0] == loc[1][0] && loc[0][1] == loc[1][1] && ldexp(d[0], power) == d[1]);
            }
}

/* A quadrilateral with C = D is a triangle. */
static void a_collapsed_edge_is_a_corner(void **state)
{
    (void)state;
    const double a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {0.3, 1, 0}, beyond[3] = {0.3, 1.2, 0.1},
                 over[3] = {0.4, 0.3, -0.1};
    const double *const x[2][5] = {{a, b, c, c, beyond}, {a, b, c, c, over}};
    double loc[2], d;
    int region;
    for (int m = 0; m < FUNCTIONS; m++)
        if (strcmp(functions[m].name, "quad4_full") == 0) {
            assert_int_equal(functions[m].one(x[0], loc, &d, &region), FOOTPOINT_OK);
            assert_true(fabs(d - sqrt(0.05)) < 1e-15 && loc[1] == 1 && (region == 3 || region == 7 || region == 8));
            assert_int_equal(functions[m].one(x[1], loc, &d, &region), FOOTPOINT_OK);
            assert_true(fabs(d + 0.1) < 1e-12 && region == 0);
        }
}

/* Among faces about a node, the face of footpoint_select_closest is found, with its answer; faces without an answer are
 * skipped. */
static void the_nearest_of_many_faces(void **state)
{
    (void)state;
    enum { FACES = 4 }; /* about node 4 of 3 x 3 */
    gsl_rng *stream = stream_new();
    stream_key(stream, SEED, 3, 0, 0);
    for (int round = 0; round < 2000; round++) {
        double x[9][3], xs[3], loc[2] = {7, 7}, dist = 7, certain, one[2], d;
        const double *corner[4 * FACES];
        int seg[FACES][4], region = 77, where, chosen;
        size_t which = 77;
        for (int k = 0; k < 9; k++)
            for (int j = 0; j < 3; j++)
                x[k][j] = (j == 0 ? k % 3 : j == 1 ? k / 3 : 0) + gsl_ran_flat(stream, -0.15, 0.15);
        for (int i = 0; i < FACES; i++) {
            const int a = i % 2 + 3 * (i / 2), node[4] = {a, a + 1, a + 4, a + 3};
            for (int k = 0; k < 4; k++)
                corner[4 * i + k] = x[seg[i][k] = node[k]];
        }
        for (int j = 0; j < 3; j++)
            xs[j] = j == 2 ? gsl_ran_flat(stream, -0.2, 0.2) : gsl_ran_flat(stream, 0.2, 1.8);
        const int status = footpoint_quad4_full_closest_of(FACES, corner, xs, loc, &dist, &region, &which);
        assert_int_equal(status, FOOTPOINT_OK);
        assert_int_equal(footpoint_select_closest(x[0], 4, FACES, seg[0], xs, &chosen, &certain), FOOTPOINT_OK);
        assert_true(fabs(fabs(dist) - certain) < 1e-9);
        const double *const *c = corner + 4 * which;
        assert_int_equal(footpoint_quad4_full_closest(c[0], c[1], c[2], c[3], xs, one, &d, &where), FOOTPOINT_OK);
        assert_true(one[0] == loc[0] && one[1] == loc[1] && d == dist && where == region);
        assert_true((int)which == chosen || region > 0); /* the faces share an edge */
    }
    gsl_rng_free(stream);
}

/* A ridge and a valley of two faces, steeper than a right angle. At their common edge each face sees the slave node on
 * its own side. The right side belongs to the face that it lies more directly over. */
static void sides_of_a_sharp_edge(void **state)
{
    (void)state;
    for (int valley = 0; valley < 2; valley++)
        for (int first = 0; first < 2; first++) {
            const double z = valley ? 1 : -1,
                         x[6][3] = {{-0.3, 0, z}, {0, 0, 0}, {0, 1, 0}, {-0.3, 1, z}, {0.3, 0, z}, {0.3, 1, z}};
            const double *const left[4] = {x[0], x[1], x[2], x[3]}, *const right[4] = {x[1], x[4], x[5], x[2]};
            const double *corner[12], xs[3] = {0.05, 0.5, valley ? -0.02 : 0.02}, none[3] = {NAN, 0, 0};
            double loc[2], dist = 7;
            int region;
            size_t which = 77;
            memcpy(corner, first ? left : right, sizeof left);
            memcpy(corner + 4, first ? right : left, sizeof left);
            assert_int_equal(footpoint_quad4_full_closest_of(2, corner, xs, loc, &dist, &region, &which), FOOTPOINT_OK);
            assert_true(valley ? dist < 0 : dist > 0);
            for (int k = 8; k < 12; k++)
                corner[k] = x[0]; /* no area */
            assert_int_equal(footpoint_quad4_full_closest_of(3, corner, xs, loc, &dist, &region, &which), FOOTPOINT_OK);
            assert_int_equal(footpoint_quad4_full_closest_of(1, corner + 8, xs, loc, &dist, &region, &which),
                             FOOTPOINT_ERR_DEGENERATE);
            assert_int_equal(footpoint_quad4_full_closest_of(2, corner, none, loc, &dist, &region, &which),
                             FOOTPOINT_ERR_NOT_FINITE);
            assert_int_equal(footpoint_quad4_full_closest_of(0, corner, xs, loc, &dist, &region, &which),
                             FOOTPOINT_ERR_DOMAIN);
        }
}

/* In single precision the region is the same, except near its border, and distances agree to some units of the last
 * place. */
static void in_single_precision(void **state)
{
    (void)state;
    struct diag d;
    struct scene *scene = scene_read(".", "quad4", &d);
    assert_non_null(scene);
    const struct face f = {scene, surface_find(scene->segment), 4, stream_new()};
    int unproved = 0;
    for (int i = 0; i < SAMPLES; i++) {
        struct question q;
        float x[5][3], loc[2] = {7, 7}, dist = 7;
        int region;
        stream_key(f.stream, SEED, 2, (uint64_t)i, 0);
        draw(&f, i % 2, &q);
        for (int k = 0; k < 15; k++)
            q.x[k / 3][k % 3] = (double)(x[k / 3][k % 3] = (float)q.x[k / 3][k % 3]);
        if (!answer(&f, &q) || fabs(q.dist) > 0.999 * q.longest)
            continue;
        const int status = footpoint_quad4_float_precise_closest(x[0], x[1], x[2], x[3], x[4], loc, &dist, &region);
        assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_UNPROVED);
        unproved += status == FOOTPOINT_UNPROVED;
        const double off = fmax(fabs((double)loc[0] - q.loc[0]), fabs((double)loc[1] - q.loc[1]));
        if (!(fabs(fabs((double)dist) - fabs(q.dist)) < 1e-6 * q.longest && off < 1e-2 &&
              (region == q.region || off < 5e-3)))
            fail_msg("sample %d: (%g,%g) %d, certain (%g,%g) %d, distance %g, %g", i, (double)loc[0], (double)loc[1],
                     region, q.loc[0], q.loc[1], q.region, (double)dist, q.dist);
    }
    assert_true(unproved <= SAMPLES / 50);
    gsl_rng_free(f.stream);
    scene_free(scene);
}

/* Answers from last answers, 0.05 off or NaN, are within their promises. */
static void from_last_answers(void **state)
{
    (void)state;
    struct diag d;
    struct scene *scene = scene_read(".", "quad4", &d);
    assert_non_null(scene);
    const struct face f = {scene, surface_find(scene->segment), 4, stream_new()};
    int unproved = 0;
    for (int i = 0; i < SAMPLES / 10; i++) {
        struct question q;
        double dist = 7;
        int region;
        stream_key(f.stream, SEED, 3, (uint64_t)i, 0);
        draw(&f, i % 2, &q);
        if (!answer(&f, &q) || fabs(q.dist) > 0.999 * q.longest)
            continue;
        double loc[2] = {q.loc[0] + (i % 5 ? 0.05 : (double)NAN), q.loc[1] - 0.05};
        const int status =
            footpoint_quad4_fine_closest_from(q.x[0], q.x[1], q.x[2], q.x[3], q.x[4], loc, &dist, &region);
        assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_UNPROVED);
        unproved += status == FOOTPOINT_UNPROVED;
        assert_true(status != FOOTPOINT_OK || fmax(fabs(loc[0] - q.loc[0]), fabs(loc[1] - q.loc[1])) <= 1.01e-5);
        assert_true(fabs(fabs(dist) - fabs(q.dist)) < 1e-4 * q.longest);
    }
    assert_true(unproved <= SAMPLES / 500);
    gsl_rng_free(f.stream);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_match_footpoint_robust),
        cmocka_unit_test(arrays_are_answered_as_one),
        cmocka_unit_test(size_does_not_matter),
        cmocka_unit_test(a_collapsed_edge_is_a_corner),
        cmocka_unit_test(the_nearest_of_many_faces),
        cmocka_unit_test(sides_of_a_sharp_edge),
        cmocka_unit_test(in_single_precision),
        cmocka_unit_test(from_last_answers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
