/* Projection along a direction, footpoint_KIND_along, against a certain solver that shares no code with it
 * (line_points.h). Newton's steps in quadruple precision find a point within the promise of each answer, and dist
 * belongs to it. With FOOTPOINT_OK the face has no other point; other statuses are right, and the answer is the nearest
 * point. Faces of ten families at the origin and 1e6 edges away, of sizes from 1e-100 to 1e100; lines in any direction,
 * through nodes, along edges, and touching the face or nearly. 3,200 lines a kind, 1e6 with FOOTPOINT_LONG. */
#include "../../evolve/common/stream.h"
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri6.h"
#include "../support/kind_arguments.h"
#include "../support/line_points.h"
#include "../support/long_cases.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { ROWS = 64, SAMPLES = 50 * ROWS, SAMPLES_LONG = 15625 * ROWS, VECTORS = 10 };
enum { SEED = 20119, SEED_STATUS = 20120, SEED_SIZE = 20121 };
#define CLEAR 1e-9 /* in xi and eta: within this, rounding decides whether a point is on an edge */

#define ALL(F) F(tri3, 3, 3) F(quad4, 4, 4) F(tri6, 6, 3) F(quad8, 8, 4) F(quad9, 9, 4)
#define ALONG(name, nodes, corners)                                                                                    \
    static int along_##name(double(*x)[3], const double *p, double loc[2], double *dist)                               \
    {                                                                                                                  \
        return footpoint_##name##_along(NODES_OF_##name(x, x[nodes]), p, loc, dist);                                   \
    }
ALL(ALONG)
#define ROW(name, nodes, corners) {#name, nodes, corners, along_##name, footpoint_##name##_along_n},

static const struct kind {
    const char *name;
    int nodes, corners;
    int (*along)(double (*x)[3], const double *p, double loc[2], double *dist);
    void (*arrays)(size_t n, const double *const *x, const double *const along[3], double *xi, double *eta,
                   double *dist, int *status);
} kinds[] = {ALL(ROW)};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* ---- samples ---- */

enum family { MILD, STRONG, ARCH, QUARTER, COLLAPSED, FOLDED, WAVY, SLIM, CIRCLE, OFF, FAMILIES };
static const char *const family_name[] = {"mild",   "strong", "arch", "quarter-point", "collapsed",
                                          "folded", "wavy",   "slim", "circular",      "moved"};
/* The families of lines. */
enum lead { ANYWHERE, NORMAL, OBLIQUE, CHORD, NODE_OR_EDGE, TOUCHING, LEADS };

struct line {
    double x[VECTORS][3], p[3]; /* the slave node follows the nodes */
    enum lead lead;
    double far; /* distance of the slave node, in edges */
};

static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};

/* Draws nodes about 1 apart: on an arch or up to half a circle, moved, only mid-side nodes by 0.3 to 0.5, or a quarter
 * from corner A or from edge AB, with C at D, up to 1e4 times as long as wide. */
static void draw_face(const struct kind *k, enum family how, gsl_rng *stream, double (*x)[3])
{
    static const double move[FAMILIES] = {0.1, 0.5, 0.05, 0.02, 0.1, 1.2, 0.1, 0.3, 0.02, 0.1};
    const double rise = gsl_ran_flat(stream, 0.2, 1.5), edge = gsl_ran_flat(stream, -1, 1);
    const double turn = gsl_ran_flat(stream, 0.5, 3.14159);
    const double slim = how == SLIM ? pow(10, gsl_ran_flat(stream, -4, 0)) : 1;
    for (int n = 0; n < k->nodes; n++) {
        const double *const at = k->corners == 3 ? triangle[n] : square[n], low = k->corners == 3 ? 0 : -1;
        double place[2] = {(at[0] - low) / (1 - low), (at[1] - low) / (1 - low)};
        for (int i = 0; i < 2 && how == QUARTER; i++)
            place[i] = place[i] == 0.5 && (i || edge > 0) ? 0.25 : place[i];
        for (int i = 0; i < 3; i++)
            x[n][i] = (i < 2 ? place[i] : 0) + move[how] * gsl_ran_flat(stream, -0.5, 0.5);
        if (how == ARCH)
            x[n][2] += rise * (place[0] * (1 - place[0]) * 4 + (edge > 0 ? place[1] * (1 - place[1]) : 0));
        if (how == WAVY && n >= k->corners)
            x[n][2] += gsl_ran_flat(stream, -1, 1);
        if (how == CIRCLE) {
            const double angle = turn * (x[n][0] - 0.5);
            x[n][2] += cos(angle) / turn;
            x[n][0] = sin(angle) / turn;
        }
        if (how == OFF && n >= k->corners) {
            double to[3];
            gsl_ran_dir_3d(stream, &to[0], &to[1], &to[2]);
            for (int i = 0; i < 3; i++)
                x[n][i] += gsl_ran_flat(stream, 0.3, 0.5) * to[i];
        }
        x[n][1] *= slim;
    }
    if (how == COLLAPSED)
        memcpy(x[3], x[k->corners == 3 ? 0 : 2], sizeof *x);
    if (how == COLLAPSED && k->nodes > 6)
        memcpy(x[6], x[2], sizeof *x);
}

/* Computes tangents by differences, which are exact for degree 2 in each coordinate; relative to corner A, so that
 * distant places lose no digits. */
static void tangents_at(const struct kind *k, struct line *l, const double loc[2], double t[2][3])
{
    for (int j = 0; j < 2; j++) {
        double less[3];
        line_points_offset(k->nodes, l->x, l->x[0], (double[]){loc[0] + (j == 0), loc[1] + (j == 1)}, t[j]);
        line_points_offset(k->nodes, l->x, l->x[0], (double[]){loc[0] - (j == 0), loc[1] - (j == 1)}, less);
        for (int i = 0; i < 3; i++)
            t[j][i] = (t[j][i] - less[i]) / 2;
    }
}

/* Turns the direction into the plane of the tangents; r moves off the face by 1e-16 to 1e-2. */
static void touch(const struct kind *k, gsl_rng *stream, struct line *l, const double loc[2], double r[3])
{
    const double angle = gsl_ran_flat(stream, 0, 6.2832);
    const double off = gsl_rng_uniform_int(stream, 4) ? pow(10, gsl_ran_flat(stream, -16, -2)) : 0;
    double t[2][3];
    tangents_at(k, l, loc, t);
    for (int i = 0; i < 3; i++) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        l->p[i] = cos(angle) * t[0][i] + sin(angle) * t[1][i];
        r[i] += off * (t[0][a] * t[1][b] - t[0][b] * t[1][a]);
    }
}

/* Draws a line through a point on the face or a little beside it, and a slave node on it: in any direction, near the
 * normal of a flat face, near a chord of the face, or touching it there; through a node, or along an edge. */
static void draw_line(const struct kind *k, gsl_rng *stream, struct line *l)
{
    static const double none[3] = {0, 0, 0};
    const double low = k->corners == 3 ? -0.1 : -1.1, far = pow(10, gsl_ran_flat(stream, -4, 4));
    const double along = gsl_ran_flat(stream, -2, 2) * fmax(1, far);
    double loc[2] = {gsl_ran_flat(stream, low, 1.1), gsl_ran_flat(stream, low, 1.1)};
    const double next[2] = {loc[0] + gsl_ran_flat(stream, -0.6, 0.6), loc[1] + gsl_ran_flat(stream, -0.6, 0.6)};
    const enum lead how = (enum lead)gsl_rng_uniform_int(stream, LEADS);
    const int node = (int)gsl_rng_uniform_int(stream, (unsigned long)k->nodes),
              edge = (int)gsl_rng_uniform_int(stream, 4);
    double r[3], s[3];
    for (int i = 0; i < 2 && how == NODE_OR_EDGE && edge; i++)
        loc[i] = (k->corners == 3 ? triangle : square)[node][i];
    line_points_offset(k->nodes, l->x, none, loc, r);
    line_points_offset(k->nodes, l->x, none, next, s);
    l->lead = how;
    l->far = fabs(along);
    for (int i = 0; i < 3; i++)
        l->p[i] = how == ANYWHERE                    ? gsl_ran_gaussian(stream, 1)
                  : how == NORMAL                    ? (i == 2) + gsl_ran_flat(stream, -0.2, 0.2)
                  : how == CHORD                     ? s[i] - r[i] + gsl_ran_flat(stream, -0.05, 0.05)
                  : how == NODE_OR_EDGE && edge == 1 ? l->x[(node + 1) % k->corners][i] - l->x[node % k->corners][i]
                                                     : (i == 2) + gsl_ran_flat(stream, -1, 1);
    if (how == TOUCHING && k->nodes > 3)
        touch(k, stream, l, loc, r);
    for (int i = 0; i < 3; i++)
        l->x[k->nodes][i] = r[i] + along * l->p[i];
}

static void draw(const struct kind *k, long number, gsl_rng *stream, struct line *l)
{
    const enum family how = (enum family)(number % FAMILIES);
    const int power = (int)gsl_rng_uniform_int(stream, 50);
    const double size = power == 0 ? 1e100 : power == 1 ? 1e-100 : ldexp(1, power - 24);
    double away[3];
    draw_face(k, how, stream, l->x);
    draw_line(k, stream, l);
    for (int i = 0; i < 3; i++)
        away[i] = number / FAMILIES % 2 ? gsl_ran_flat(stream, -1e6, 1e6) : 0;
    for (int n = 0; n <= k->nodes; n++)
        for (int i = 0; i < 3; i++)
            l->x[n][i] = size * (l->x[n][i] + away[i]);
}

/* ---- judgement ---- */

struct tally {
    long lines[4], wrong, unclear, nowhere, family[FAMILIES]; /* indexed by number of points, at most three */
    long all[FAMILIES + 1], proved[FAMILIES + 1]; /* last: mild faces, such lines, slave nodes up to 100 edges away */
    double error;
};

struct answer {
    int status;
    double loc[2], dist;
};

/* Returns the distance of the line from the surface there; mesh length. */
static double off_line(const struct kind *k, struct line *l, const struct answer *a)
{
    double r[3], length = 0, off = 0;
    line_points_offset(k->nodes, l->x, l->x[k->nodes], a->loc, r);
    for (int i = 0; i < 3; i++)
        length += l->p[i] * l->p[i];
    for (int i = 0; i < 3; i++)
        off = fmax(off, fabs(r[i] + a->dist * l->p[i] / sqrt(length)));
    return off;
}

static double span_of(const struct kind *k, struct line *l)
{
    double span = 0;
    for (int n = 0; n < k->nodes; n++)
        for (int i = 0; i < 3; i++)
            span = fmax(span, fabs(l->x[n][i] - l->x[k->nodes][i]));
    return span;
}

static double beyond_of(const struct kind *k, const double loc[2])
{
    return k->corners == 3 ? fmax(-fmin(loc[0], loc[1]), loc[0] + loc[1] - 1) : fmax(fabs(loc[0]), fabs(loc[1])) - 1;
}

static bool is_nowhere(const struct kind *k, struct line *l)
{
    struct line_points wide;
    line_points_find(k->nodes, l->x, l->x[k->nodes], l->p, 5, &wide);
    return wide.count == 0 || !wide.clear;
}

/* Returns true if the distance is right to rounding: 1,000 units of the largest term of coordinates. */
static bool is_distance_of(const struct kind *k, struct line *l, const struct answer *a)
{
    const double reach = fmax(1, fmax(fabs(a->loc[0]), fabs(a->loc[1])));
    const int power = k->nodes == 9 ? 4 : k->nodes == 8 ? 3 : k->nodes == 3 ? 1 : 2;
    double r[3], length = 0, dist = 0;
    line_points_offset(k->nodes, l->x, l->x[k->nodes], a->loc, r);
    for (int i = 0; i < 3; i++) {
        length += l->p[i] * l->p[i];
        dist -= r[i] * l->p[i];
    }
    return fabs(dist / sqrt(length) - a->dist) <= 1.2e-13 * span_of(k, l) * pow(reach, power);
}

/* Returns true if a point lies within the promise of the answer. */
static bool is_point(const struct kind *k, struct line *l, const struct answer *a, double *error)
{
    const double reach = fmax(1, fmax(fabs(a->loc[0]), fabs(a->loc[1])));
    *error = line_points_error(k->nodes, l->x, l->x[k->nodes], l->p, a->loc) / reach;
    return *error <= FOOTPOINT_ALONG_PROMISE && is_distance_of(k, l, a);
}

/* Returns true if no other point lies on the face; `found` covers 0.1 beyond it. */
static bool is_only(const struct kind *k, struct line *l, const struct answer *a, const struct line_points *found,
                    double error)
{
    struct line_points face = *found;
    if (beyond_of(k, a->loc) > 1e-15)
        return false;
    for (double over = 0.005; over > CLEAR && !face.clear;
         over *= 0.05) /* the line touches the surface beyond the edges */
        line_points_find(k->nodes, l->x, l->x[k->nodes], l->p, over, &face);
    for (int i = 0; i < face.count; i++) {
        const struct line_point *const p = &face.point[i];
        if (p->beyond <= 0 && fmax(fabs(p->loc[0] - a->loc[0]), fabs(p->loc[1] - a->loc[1])) > error + 1e-12)
            return false;
    }
    return face.clear;
}

/* Returns true if the direction is 0 or lies, to rounding, in the tangent planes at 16 places. */
static bool is_flat(const struct kind *k, struct line *l)
{
    const double low = k->corners == 3 ? 0 : -1, third = (1 - low) / 3;
    double edges = 0;
    for (int n = 3; n < 3 * k->nodes; n++)
        edges += fabs(l->x[n / 3][n % 3] - l->x[0][n % 3]);
    for (int n = 0; n < 16; n++) {
        const double at[2] = {low + third * (n & 3), low + third * (n >> 2)};
        double t[2][3], sum[2] = {0}, terms, product = line_points_product(k->nodes, l->x, l->p, at, &terms);
        tangents_at(k, l, at, t);
        for (int i = 0; i < 3; i++) {
            sum[0] += fabs(t[0][i]) + fabs(t[1][i]);
            sum[1] += fabs(l->p[i]);
        }
        if (fabs(product) > 1.2e-16 * (k->nodes == 3 ? 16 * terms : 500 * edges * sum[0] * sum[1]))
            return false;
    }
    return true;
}

/* Returns the largest change of the distance for a change of xi and eta by 1. */
static double slope_of(const struct kind *k, struct line *l, const double loc[2])
{
    double t[2][3], sum[2] = {0};
    tangents_at(k, l, loc, t);
    for (int i = 0; i < 6; i++)
        sum[i / 3] += t[i / 3][i % 3] * t[i / 3][i % 3];
    return sqrt(sum[0]) + sqrt(sum[1]);
}

/* Returns true if the answer is the nearest of the points on the face, up to errors of distances. */
static bool is_nearest(const struct kind *k, struct line *l, const struct answer *a, const struct line_points *all)
{
    for (int i = 0; i < all->count; i++) {
        const struct line_point *const p = &all->point[i];
        const double slope = slope_of(k, l, p->loc) + slope_of(k, l, a->loc);
        if (p->beyond < 0 && fabs(a->dist) > fabs(p->dist) + FOOTPOINT_ALONG_PROMISE * slope + 1.2e-13 * span_of(k, l))
            return false;
    }
    return true;
}

/* Returns true if the status fits the number of points on the face. */
static bool is_counted(const struct kind *k, struct line *l, const struct answer *a, int inside)
{
    if (a->status == FOOTPOINT_ERR_DOMAIN)
        return inside == 0 && (k->nodes != 4 || is_nowhere(k, l));
    return a->status == FOOTPOINT_UNPROVED || (a->status == FOOTPOINT_OK && inside == 1) ||
           (a->status == FOOTPOINT_NOT_UNIQUE && inside > 1) ||
           (a->status == FOOTPOINT_OUTSIDE && inside == 0 && beyond_of(k, a->loc) > 0);
}

static bool is_right(const struct kind *k, struct line *l, const struct answer *a, struct tally *t)
{
    struct line_points all;
    const double span = span_of(k, l);
    double error = 0;
    int inside = 0;
    if (a->status == FOOTPOINT_ERR_DEGENERATE)
        return is_flat(k, l);
    line_points_find(k->nodes, l->x, l->x[k->nodes], l->p, 0.1, &all);
    if (a->status >= FOOTPOINT_OK && a->status != FOOTPOINT_UNPROVED && !is_point(k, l, a, &error))
        return false;
    if (a->status == FOOTPOINT_OK && !is_only(k, l, a, &all, error))
        return false;
    t->error = fmax(t->error, error);
    bool clear = all.clear;
    for (int i = 0; i < all.count; i++) {
        const struct line_point *const p = &all.point[i];
        clear = clear && fabs(p->beyond) > CLEAR + 1e-14 * span * p->spread;
        inside += p->beyond < 0;
    }
    t->unclear += !clear && l->lead != TOUCHING && l->lead != NODE_OR_EDGE;
    if (!clear)
        return true;
    t->lines[inside < 3 ? inside : 3]++;
    t->nowhere += a->status == FOOTPOINT_ERR_DOMAIN;
    return is_counted(k, l, a, inside) && (a->status != FOOTPOINT_NOT_UNIQUE || is_nearest(k, l, a, &all));
}

static void count(long number, const struct line *l, const struct answer *a, struct tally *t)
{
    const enum family how = (enum family)(number % FAMILIES);
    t->all[how]++;
    t->proved[how] += a->status != FOOTPOINT_UNPROVED;
    if (how == MILD && l->lead < CHORD && l->far <= 100) {
        t->all[FAMILIES]++;
        t->proved[FAMILIES] += a->status != FOOTPOINT_UNPROVED;
    }
}

static void judge(const struct kind *k, long number, struct line *l, const struct answer *a, struct tally *t)
{
    if (is_right(k, l, a, t))
        return;
    t->family[number % FAMILIES]++;
    if (t->wrong++ < 5)
        printf("# %s, line %ld (%s): status %d, %.17g %.17g, %.17g\n", k->name, number, family_name[number % FAMILIES],
               a->status, a->loc[0], a->loc[1], a->dist);
}

static struct answer answer_of(const struct kind *k, struct line *l)
{
    struct answer a = {0, {7, 7}, 7};
    a.status = k->along(l->x, l->p, a.loc, &a.dist);
    return a;
}

/* Calls both functions for ROWS lines. */
static void ask(const struct kind *k, struct line *l, struct answer one[ROWS], struct answer row[ROWS])
{
    double column[3 * VECTORS][ROWS], p[3][ROWS], xi[ROWS], eta[ROWS], dist[ROWS];
    const double *columns[3 * VECTORS], *const directions[3] = {p[0], p[1], p[2]};
    int status[ROWS];
    for (int i = 0; i < 3 * k->nodes + 3; i++) {
        columns[i] = column[i];
        for (int n = 0; n < ROWS; n++)
            column[i][n] = l[n].x[i / 3][i % 3];
    }
    for (int i = 0; i < 3 * ROWS; i++)
        p[i / ROWS][i % ROWS] = l[i % ROWS].p[i / ROWS];
    k->arrays(ROWS, columns, directions, xi, eta, dist, status);
    for (int n = 0; n < ROWS; n++) {
        one[n] = answer_of(k, &l[n]);
        row[n] = (struct answer){status[n], {xi[n], eta[n]}, dist[n]};
        assert_true(one[n].status >= FOOTPOINT_OK || (one[n].loc[0] == 7 && one[n].loc[1] == 7 && one[n].dist == 7));
    }
}

static long compare(const struct kind *k, long samples)
{
    struct tally t = {0};
    struct line lines[ROWS];
    struct answer one[ROWS], row[ROWS];
    gsl_rng *stream = stream_new();
    for (long first = 0; first < samples; first += ROWS) {
        for (int n = 0; n < ROWS; n++) {
            stream_key(stream, SEED, (uint64_t)(k - kinds), (uint64_t)(first + n), 0);
            draw(k, first + n, stream, &lines[n]);
        }
        ask(k, lines, one, row);
        for (int n = 0; n < ROWS; n++) {
            judge(k, first + n, &lines[n], &one[n], &t);
            count(first + n, &lines[n], &one[n], &t);
            if (row[n].status != one[n].status ||
                (one[n].status >= FOOTPOINT_OK &&
                 (row[n].loc[0] != one[n].loc[0] || row[n].loc[1] != one[n].loc[1] || row[n].dist != one[n].dist)))
                judge(k, first + n, &lines[n], &row[n], &t);
        }
    }
    gsl_rng_free(stream);
    printf(
        "# %s: %ld of %ld wrong; %ld lines beside the face, %ld meet it once, %ld twice, %ld more often; %ld meet the "
        "surface nowhere; %ld unclear; off a point by %.1e\n",
        k->name, t.wrong, samples, t.lines[0], t.lines[1], t.lines[2], t.lines[3], t.nowhere, t.unclear, t.error);
    printf("# %s: proved of ordinary ones %.2f %%; of all", k->name,
           100.0 * (double)t.proved[FAMILIES] / (double)t.all[FAMILIES]);
    for (int i = 0; i < FAMILIES; i++)
        printf(", %s %.1f %%%s", family_name[i], 100.0 * (double)t.proved[i] / (double)t.all[i],
               i + 1 < FAMILIES ? "" : "\n");
    for (int i = 0; i < FAMILIES; i++)
        if (t.family[i])
            printf("# %s: %ld wrong on %s faces\n", k->name, t.family[i], family_name[i]);
    assert_true(100 * t.proved[FAMILIES] >= 99 * t.all[FAMILIES]);
    assert_true(t.unclear < samples / 100 && t.lines[0] > samples / 10 && t.lines[1] > samples / 10);
    assert_true(k->nodes == 3 || t.lines[2] > samples / 100);
    return t.wrong;
}

static void lines_meet_faces(void **state)
{
    const long samples = long_cases(SAMPLES, SAMPLES_LONG);
    long wrong = 0;
    (void)state;
    for (int k = 0; k < KINDS; k++)
        wrong += compare(&kinds[k], samples);
    assert_int_equal(wrong, 0);
}

/* ---- statuses ---- */

enum flaw { NONE, NODE, DIRECTION, SHORT, NO_AREA, IN_PLANE, FLAWS };

/* Spoils a line: not finite, without a direction, on a face without area or in the plane of a face. */
static void spoil(const struct kind *k, int number, enum flaw how, struct line *l)
{
    const double bad = number % 3 == 0 ? NAN : number % 3 == 1 ? INFINITY : -INFINITY;
    if (how == NODE)
        l->x[number % (k->nodes + 1)][number % 3] = bad;
    for (int i = 0; i < 3; i++) {
        l->p[i] = how == DIRECTION && i == number % 3 ? bad : how == SHORT ? 0 : l->p[i];
        for (int n = 0; n < k->nodes && how == NO_AREA; n++)
            l->x[n][i] = (n + 0.25 * number) * (i + 1);
        for (int n = 0; n < k->nodes && how == IN_PLANE; n++)
            l->x[n][i] = i == 2 ? 0.5 : k->corners == 3 ? triangle[n][i] : square[n][i];
        if (how == IN_PLANE) {
            l->x[k->nodes][i] = number / 6 % 2 ? 0.5 : 0.25 * i;
            l->p[i] = i == 2 ? 0 : 1 + i;
        }
    }
}

static void statuses_are_right(void **state)
{
    gsl_rng *stream = stream_new();
    (void)state;
    stream_key(stream, SEED_STATUS, 0, 0, 0);
    for (int k = 0; k < KINDS; k++) {
        struct line lines[ROWS];
        struct answer one[ROWS], row[ROWS];
        for (int n = 0; n < ROWS; n++) {
            draw(&kinds[k], n, stream, &lines[n]);
            spoil(&kinds[k], n, (enum flaw)(n % FLAWS), &lines[n]);
        }
        ask(&kinds[k], lines, one, row);
        for (int n = 0; n < ROWS; n++) {
            assert_int_equal(one[n].status, row[n].status);
            assert_true(n % FLAWS == NONE ||
                        one[n].status == (n % FLAWS < SHORT ? FOOTPOINT_ERR_NOT_FINITE : FOOTPOINT_ERR_DEGENERATE));
        }
    }
    gsl_rng_free(stream);
}

/* Lines through points that approach a corner with C = D, and lines that approach one that touches an arch, below and
 * above its top. */
static void nearly_singular_lines(void **state)
{
    (void)state;
    for (int e = 0; e <= 12; e++) {
        const double near = pow(10, -e);
        for (int k = 0; k < KINDS; k++) {
            struct line l = {.p = {0, 0, 1}};
            if (kinds[k].corners == 3)
                continue;
            for (int n = 0; n < kinds[k].nodes; n++) {
                l.x[n][0] = square[n][0] * (1 - square[n][1]) / 2;
                l.x[n][1] = square[n][1];
            }
            const double s[3] = {0.3 * near, 1 - near, 0.5};
            memcpy(l.x[kinds[k].nodes], s, sizeof s);
            const struct answer a = answer_of(&kinds[k], &l);
            assert_true(a.status == FOOTPOINT_OK ||
                        (a.status == FOOTPOINT_UNPROVED && e > (kinds[k].nodes > 4 ? 2 : 3)));
            if (kinds[k].nodes == 4 || e <= 6)
                assert_true(fabs(a.dist - 0.5) < 1e-12 && off_line(&kinds[k], &l, &a) < 1e-12);
        }
        for (int k = 2; k < KINDS; k++)
            for (int above = 0; above < 2; above++) {
                struct line l = {.p = {1, 0.01, 0}};
                for (int n = 0; n < kinds[k].nodes; n++) {
                    const double *const at = kinds[k].corners == 3 ? triangle[n] : square[n];
                    memcpy(l.x[n], at, 2 * sizeof *at);
                    l.x[n][2] = 1 - (at[0] - 0.3) * (at[0] - 0.3);
                }
                const double s[3] = {0.37, 0.1, above ? 1 + 0.01 * near : 1 - 0.01 * near};
                memcpy(l.x[kinds[k].nodes], s, sizeof s);
                const struct answer a = answer_of(&kinds[k], &l);
                if (a.status != FOOTPOINT_UNPROVED || e <= (above ? 8 : 4))
                    assert_true(above ? a.status == FOOTPOINT_ERR_DOMAIN || a.status == FOOTPOINT_OUTSIDE
                                      : a.status == FOOTPOINT_NOT_UNIQUE && off_line(&kinds[k], &l, &a) < 1e-12);
            }
    }
}

/* Slave nodes at the limits of numbers: the distance is finite, or there is no answer. */
static void distances_are_finite(void **state)
{
    static const double size[] = {1e-300, 1e-3, 1, 1e5, 1e300}, length[] = {1e-300, 1e-100, 1e-60, 1, 1e100};
    (void)state;
    for (int n = 0; n < 25 * KINDS; n++) {
        const struct kind *const k = &kinds[n % KINDS];
        struct line l[ROWS];
        struct answer one[ROWS], row[ROWS];
        double away[ROWS];
        for (int r = 0; r < ROWS; r++) {
            const double d[3] = {r % 2, r % 3 == 0, 1};
            away[r] = 1.79e308 * pow(10, -r * r / 20.0);
            for (int i = 0; i < 3 * k->nodes; i++) {
                const double *const at = k->corners == 3 ? triangle[i / 3] : square[i / 3];
                l[r].x[i / 3][i % 3] = i % 3 == 2 ? 0 : size[n / KINDS % 5] * at[i % 3];
            }
            for (int i = 0; i < 3; i++) {
                l[r].x[k->nodes][i] = away[r] * d[i];
                l[r].p[i] = length[n / KINDS / 5] * d[i];
            }
        }
        ask(k, l, one, row);
        for (int r = 0; r < ROWS; r++) {
            assert_int_equal(one[r].status, row[r].status);
            assert_true(one[r].status < FOOTPOINT_OK ? one[r].status == FOOTPOINT_ERR_DOMAIN
                                                     : isfinite(one[r].dist) && isfinite(row[r].dist));
            const bool straight = r % 2 == 0 && r % 3 != 0; /* no product is rounded or contracted */
            assert_true(!straight || away[r] > 1e300 * fmin(1, size[n / KINDS % 5]) || one[r].status >= FOOTPOINT_OK);
        }
    }
}

/* Any unit of length and any length of the direction have the same answers. */
static void size_does_not_matter(void **state)
{
    gsl_rng *stream = stream_new();
    (void)state;
    stream_key(stream, SEED_SIZE, 0, 0, 0);
    for (int n = 0; n < ROWS * KINDS; n++) {
        const struct kind *const k = &kinds[n % KINDS];
        struct line l;
        draw(k, n, stream, &l);
        if (l.lead == NODE_OR_EDGE || fabs(log10(span_of(k, &l))) > 50) /* rounding decides; or overflow */
            continue;
        const struct answer usual = answer_of(k, &l);
        for (int power = -900; power <= 900; power += 150) {
            struct line m = l;
            for (int i = 0; i < 3 * k->nodes + 3; i++)
                m.x[i / 3][i % 3] = ldexp(l.x[i / 3][i % 3], power);
            for (int i = 0; i < 3; i++)
                m.p[i] = ldexp(l.p[i], -power);
            const struct answer a = answer_of(k, &m);
            assert_int_equal(a.status, usual.status);
            for (int i = 0; i < 2 && a.status >= FOOTPOINT_OK; i++)
                assert_true(fabs(a.loc[i] - usual.loc[i]) <= 1e-9 * (1 + fabs(a.loc[i])));
            if (a.status >= FOOTPOINT_OK)
                assert_true(fabs(ldexp(a.dist, -power) - usual.dist) <= 1e-9 * span_of(k, &l));
        }
    }
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_meet_faces),      cmocka_unit_test(statuses_are_right),
        cmocka_unit_test(nearly_singular_lines), cmocka_unit_test(distances_are_finite),
        cmocka_unit_test(size_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
