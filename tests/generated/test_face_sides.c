/* The side of one face on which slave nodes lie. Headers, footpoint_robust, footpoint_face_robust and
 * footpoint_face_closest agree, with the side of the face's plane, at corners without a normal: those of collapsed
 * edges and of 180 degrees. Nodes beside a face do not penetrate, nodes below it do. At the origin and 1e6 edges away;
 * some thousands of each, 1e6 with FOOTPOINT_LONG. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri6.h"
#include "../../runtime/footpoint_face.h"
#include "../support/long_cases.h"

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

enum { SAMPLES = 2000, SAMPLES_LONG = 1000000, SEED = 20087, MOST = 10 };
#define FAR 1e6

static const struct kind {
    enum footpoint_face face;
    int corners, nodes;
} kinds[] = {{FOOTPOINT_TRI3, 3, 3},
             {FOOTPOINT_TRI6, 3, 6},
             {FOOTPOINT_QUAD4, 4, 4},
             {FOOTPOINT_QUAD8, 4, 8},
             {FOOTPOINT_QUAD9, 4, 9}};
enum { KINDS = sizeof kinds / sizeof *kinds };

static long samples(void)
{
    return long_cases(SAMPLES, SAMPLES_LONG);
}

/* ---- answers ---- */

struct answer {
    const char *who;
    int status, region;
    double loc[2], dist;
};

/* Collects the answers of all functions that return a signed distance; returns their number. */
static int ask_all(const struct kind *k, const double *x, struct answer a[8])
{
    const double *const s = x + 3 * k->nodes;
    int n = 0;
    a[n] = (struct answer){.who = "footpoint_face_robust"};
    a[n].status = footpoint_face_robust(k->face, x, a[n].loc, &a[n].dist, &a[n].region);
    n++;
    a[n] = (struct answer){.who = "footpoint_face_closest"};
    a[n].status = footpoint_face_closest(k->face, x, a[n].loc, &a[n].dist, &a[n].region);
    n++;
    if (k->face != FOOTPOINT_QUAD4)
        return n;
    a[n] = (struct answer){.who = "footpoint_robust"};
    a[n].status = footpoint_robust(x, x + 3, x + 6, x + 9, s, a[n].loc, &a[n].dist);
    a[n].region = a[n].status == FOOTPOINT_OUTSIDE;
    n++;
    a[n] = (struct answer){.who = "footpoint_quad4_accurate_closest"};
    a[n].status = footpoint_quad4_accurate_closest(x, x + 3, x + 6, x + 9, s, a[n].loc, &a[n].dist, &a[n].region);
    n++;
    a[n] = (struct answer){.who = "footpoint_quad4_full_closest"};
    a[n].status = footpoint_quad4_full_closest(x, x + 3, x + 6, x + 9, s, a[n].loc, &a[n].dist, &a[n].region);
    return n + 1;
}

/* ---- faces ---- */

static double height_over(const double *a, const double *b, const double *c, const double *s)
{
    long double u[3], v[3], d[3], n[3], size = 0, height = 0;
    for (int i = 0; i < 3; i++) {
        u[i] = (long double)b[i] - a[i];
        v[i] = (long double)c[i] - a[i];
        d[i] = (long double)s[i] - a[i];
    }
    for (int i = 0; i < 3; i++) {
        n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
        size += n[i] * n[i];
        height += n[i] * d[i];
    }
    return (double)(height / sqrtl(size));
}

static double distance(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* Draws corners of a plane face about 1 long, in its plane; middle nodes follow. */
static void draw_corners(gsl_rng *stream, const struct kind *k, double (*x)[3])
{
    static const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int c = 0; c < k->corners; c++) {
        x[c][0] = corner[c][0] + gsl_ran_flat(stream, -0.2, 0.2);
        x[c][1] = corner[c][1] + gsl_ran_flat(stream, -0.2, 0.2);
        x[c][2] = 0;
    }
}

static void add_middles(const struct kind *k, double (*x)[3])
{
    for (int c = 0; c < k->nodes - k->corners; c++)
        for (int i = 0; i < 3; i++)
            x[k->corners + c][i] = c < k->corners ? 0.5 * (x[c][i] + x[(c + 1) % k->corners][i])
                                                  : 0.25 * (x[0][i] + x[1][i] + x[2][i] + x[3][i]);
}

static void move(gsl_rng *stream, double (*x)[3], int n, double away)
{
    double q[4], at[3];
    gsl_ran_dir_nd(stream, 4, q);
    for (int i = 0; i < 3; i++)
        at[i] = away * gsl_ran_flat(stream, -1, 1);
    const double w = q[0], a = q[1], b = q[2], c = q[3];
    const double r[3][3] = {{w * w + a * a - b * b - c * c, 2 * (a * b - w * c), 2 * (a * c + w * b)},
                            {2 * (a * b + w * c), w * w - a * a + b * b - c * c, 2 * (b * c - w * a)},
                            {2 * (a * c - w * b), 2 * (b * c + w * a), w * w - a * a - b * b + c * c}};
    for (int k = 0; k < n; k++) {
        const double y[3] = {x[k][0], x[k][1], x[k][2]};
        for (int i = 0; i < 3; i++)
            x[k][i] = at[i] + (r[i][0] * y[0] + r[i][1] * y[1] + r[i][2] * y[2]);
    }
}

/* ---- corners without a normal ---- */

/* Moves corner c onto the next, or between its neighbours. */
static void spoil(gsl_rng *stream, int c, int straight, double (*x)[3])
{
    const double t = gsl_ran_flat(stream, 0.3, 0.7);
    const double *const next = x[(c + 1) % 4], *const before = x[(c + 3) % 4];
    for (int i = 0; i < 3; i++)
        x[c][i] = straight ? (1 - t) * next[i] + t * before[i] : next[i];
}

/* Draws slave nodes at, over and beside corner c, and anywhere near the face. */
static void draw_slave(gsl_rng *stream, long n, const double corner[3], double xs[3])
{
    const double wide = n % 4 == 0 ? 0 : n % 4 == 1 ? 1e-6 : 0.4;
    for (int i = 0; i < 3; i++)
        xs[i] = n % 4 == 3 ? gsl_ran_flat(stream, -0.5, 1.5) : corner[i] + wide * gsl_ran_flat(stream, -1, 1);
    xs[2] = gsl_ran_flat(stream, -0.4, 0.4);
}

static void corners_without_normals(void **state)
{
    (void)state;
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    gsl_rng_set(stream, SEED);
    for (int m = 2; m < KINDS; m++)
        for (long n = 0; n < samples(); n++) {
            const struct kind *const k = &kinds[m];
            const int straight = (int)(n / 4 % 2), c = (int)(n / 8 % 4);
            double x[MOST][3], longest = 0;
            struct answer a[8];
            draw_corners(stream, k, x);
            spoil(stream, c, straight, x);
            add_middles(k, x);
            draw_slave(stream, n, x[c], x[k->nodes]);
            move(stream, x, k->nodes + 1, n / 32 % 2 ? FAR : 0);
            if (!straight) /* one point, however rounding places the middle of the edge */
                memcpy(x[k->corners + c], x[c], k->nodes > 4 ? sizeof *x : 0);
            const double height = height_over(x[(c + 1) % 4], x[(c + 2) % 4], x[(c + 3) % 4], x[k->nodes]);
            for (int i = 0; i < 4; i++)
                longest = fmax(longest, distance(x[i], x[(i + 1) % 4]));
            const int all = ask_all(k, x[0], a);
            assert_true(a[0].status >= FOOTPOINT_OK);
            for (int i = 0; i < all; i++) {
                if (a[i].status == FOOTPOINT_ERR_DOMAIN && fabs(a[0].dist) > (1 - 1e-9) * longest)
                    continue;
                if (a[i].status < FOOTPOINT_OK)
                    fail_msg("%d nodes, sample %ld: %s has no answer: %d", k->nodes, n, a[i].who, a[i].status);
                if (fabs(height) > 1e-3 * fabs(a[0].dist) + 1e-8 && (a[i].dist < 0) != (height < 0))
                    fail_msg("%d nodes, sample %ld: %s: distance %g, height %g", k->nodes, n, a[i].who, a[i].dist,
                             height);
            }
        }
    gsl_rng_free(stream);
}

/* ---- beside and below ---- */

/* Draws a slave node in the tangent plane of a point of an edge, `beside` outside of it at right angles; or, if
 * `beside` is 0, below a point inside of a plane face. */
static void draw_node(gsl_rng *stream, const struct kind *k, double beside, double below, double (*x)[3])
{
    double *const xs = x[k->nodes], e[3], w[3], ee = 0, we = 0, size = 0;
    const int all = k->corners, c = (int)gsl_rng_uniform_int(stream, (unsigned long)all), next = (c + 1) % all;
    const double t = gsl_ran_flat(stream, 0.1, 0.9);
    for (int i = 0; i < 3; i++) {
        e[i] = x[next][i] - x[c][i];
        w[i] = (1 - t) * (x[(c + all - 1) % all][i] - x[c][i]) + t * (x[(c + 2) % all][i] - x[next][i]);
        ee += e[i] * e[i];
        we += w[i] * e[i];
    }
    for (int i = 0; i < 3; i++) {
        w[i] -= beside > 0 ? we / ee * e[i] : 0;
        size += w[i] * w[i];
    }
    for (int i = 0; i < 3; i++)
        xs[i] = x[c][i] + t * e[i] + (beside > 0 ? -beside / sqrt(size) : 0.3) * w[i] - (i == 2 ? below : 0);
}

/* Draws a slave node in the plane of a face whose corners c and c + 1 coincide: beside that point, at right angles to
 * an adjacent edge, so that points inside are as near as rounding can resolve. */
static void draw_beside_collapsed(gsl_rng *stream, int c, double beside, double (*x)[3])
{
    const int ahead = (int)gsl_rng_uniform_int(stream, 2), along = (c + (ahead ? 2 : 3)) % 4;
    const int other = (c + (ahead ? 3 : 2)) % 4;
    double ee = 0, we = 0, size = 0, e[3], w[3];
    for (int i = 0; i < 3; i++) {
        e[i] = x[along][i] - x[c][i];
        w[i] = x[other][i] - x[c][i];
        ee += e[i] * e[i];
        we += w[i] * e[i];
    }
    for (int i = 0; i < 3; i++) {
        w[i] -= we / ee * e[i];
        size += w[i] * w[i];
    }
    for (int i = 0; i < 3; i++)
        x[4][i] = x[c][i] - beside / sqrt(size) * w[i];
}

static int penetrates(const struct answer *a)
{
    return a->status == FOOTPOINT_OK && a->dist < 0 && a->region == 0;
}

static void nodes_beside_collapsed_corners_do_not_penetrate(void **state)
{
    (void)state;
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    gsl_rng_set(stream, SEED + 3);
    for (int m = 2; m < KINDS; m++)
        for (long n = 0; n < samples(); n++) {
            const struct kind *const k = &kinds[m];
            const int c = (int)(n % 4), away = (int)(n / 4 % 2);
            double x[MOST][3];
            struct answer a[8];
            draw_corners(stream, k, x);
            spoil(stream, c, 0, x);
            draw_beside_collapsed(stream, c, pow(10, gsl_ran_flat(stream, away ? -6 : -9, -0.2)), x);
            memcpy(x[k->nodes], x[4], sizeof *x);
            add_middles(k, x);
            move(stream, x, k->nodes + 1, away ? FAR : 0);
            memcpy(x[k->corners + c], x[c], k->nodes > 4 ? sizeof *x : 0);
            const double away_from = distance(x[c], x[k->nodes]);
            const int all = ask_all(k, x[0], a);
            for (int i = 0; i < all; i++) {
                if (penetrates(&a[i]) || (!away && a[i].status >= FOOTPOINT_OK && a[i].dist < 0))
                    fail_msg("%d nodes, sample %ld: %s: region %d, %g", k->nodes, n, a[i].who, a[i].region, a[i].dist);
                if (a[i].status == FOOTPOINT_OK && fabs(fabs(a[i].dist) - away_from) > (away ? 1e-9 : 1e-14))
                    fail_msg("%d nodes, sample %ld: %s: distance %g, not %g", k->nodes, n, a[i].who, a[i].dist,
                             away_from);
            }
        }
    gsl_rng_free(stream);
}

static void nodes_beside_do_not_penetrate(void **state)
{
    (void)state;
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    gsl_rng_set(stream, SEED + 1);
    for (int m = 0; m < KINDS; m++)
        for (long n = 0; n < samples(); n++) {
            const struct kind *const k = &kinds[m];
            const int warped = n % 2 && k->corners == 4, away = (int)(n / 2 % 2);
            const double beside = pow(10, gsl_ran_flat(stream, away ? -6 : -9, 1));
            double x[MOST][3];
            struct answer a[8];
            draw_corners(stream, k, x);
            if (warped)
                x[0][2] = gsl_ran_flat(stream, -0.2, 0.2);
            draw_node(stream, k, beside, 0, x);
            add_middles(k, x);
            move(stream, x, k->nodes + 1, away ? FAR : 0);
            const int all = ask_all(k, x[0], a);
            for (int i = 0; i < all; i++) {
                if (penetrates(&a[i]))
                    fail_msg("%d nodes, sample %ld: %s says that it penetrates", k->nodes, n, a[i].who);
                if (!warped && !away && a[i].status >= FOOTPOINT_OK && a[i].dist < 0)
                    fail_msg("%d nodes, sample %ld: %s: behind, %g", k->nodes, n, a[i].who, a[i].dist);
            }
        }
    gsl_rng_free(stream);
}

static void nodes_below_penetrate(void **state)
{
    (void)state;
    gsl_rng *stream = gsl_rng_alloc(gsl_rng_taus2);
    gsl_rng_set(stream, SEED + 2);
    for (int m = 0; m < KINDS; m++)
        for (long n = 0; n < samples(); n++) {
            const struct kind *const k = &kinds[m];
            const int away = (int)(n / 2 % 2);
            double x[MOST][3];
            struct answer a[8];
            draw_corners(stream, k, x);
            draw_node(stream, k, 0, pow(10, gsl_ran_flat(stream, -15, -3)), x);
            add_middles(k, x);
            move(stream, x, k->nodes + 1, away ? FAR : 0);
            const double *const third = x[k->corners == 3 ? 2 : 3];
            const double height = height_over(x[0], x[1], third, x[k->nodes]);
            const int all = ask_all(k, x[0], a);
            for (int i = 0; i < all; i++)
                if (height < (away ? -1e-8 : -1e-15) && !penetrates(&a[i]))
                    fail_msg("%d nodes, sample %ld: %s: status %d, %g, height %g", k->nodes, n, a[i].who, a[i].status,
                             a[i].dist, height);
        }
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(corners_without_normals),
        cmocka_unit_test(nodes_beside_do_not_penetrate),
        cmocka_unit_test(nodes_beside_collapsed_corners_do_not_penetrate),
        cmocka_unit_test(nodes_below_penetrate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
