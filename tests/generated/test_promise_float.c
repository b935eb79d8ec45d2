/* The promise of functions in float. With FOOTPOINT_OK a minimum of the distance, or the closest point of the closed
 * face, lies within NAME_PROMISE of xi and eta, on any face, in calls and in arrays. The judge computes in long double
 * from the same floats and shares no code with the judged functions. It takes Newton's steps from the answer, and
 * descends from the lowest points of lines across the face. Some of each family; 1e5 of each hard family and 1e7
 * ordinary answers with FOOTPOINT_LONG, which prints the proved shares. */
#include "../../generated/footpoint_quad4_float.h"
#include "../../runtime/footpoint.h"
#include "../hard/draw.h"
#include "../hard/hard.h"
#include "../support/long_cases.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

typedef long double fine;

enum { CASES = 1000, CASES_LONG = 100000, ORDINARY_LONG = 2500000, STEPS = 60, LINES = 48, BLOCK = 200 };

/* ---- functions: one for each promise ---- */

typedef int one(const float *xA, const float *xB, const float *xC, const float *xD, const float *xS, float loc[2],
                float *gap);
typedef int closest(const float *xA, const float *xB, const float *xC, const float *xD, const float *xS, float loc[2],
                    float *dist, int *region);
typedef void many(size_t n, const float *const *x, float *xi, float *eta, float *gap, int *status);
typedef void closest_many(size_t n, const float *const *x, float *xi, float *eta, float *dist, int *region,
                          int *status);

#define FUNCTION(name, NAME)                                                                                           \
    {                                                                                                                  \
#name, (double)FOOTPOINT_QUAD4_FLOAT_##NAME##_PROMISE, footpoint_quad4_float_##name,                           \
            footpoint_quad4_float_##name##_closest, footpoint_quad4_float_##name##_checked_n,                          \
            footpoint_quad4_float_##name##_closest_n                                                                   \
    }
static const struct function {
    const char *name;
    double promise;
    one *one;
    closest *closest;
    many *many;
    closest_many *closest_many;
} functions[] = {FUNCTION(coarse, COARSE), FUNCTION(medium, MEDIUM), FUNCTION(balanced, BALANCED),
                 FUNCTION(accurate, ACCURATE)};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* ---- families ---- */

static void place(uint64_t *stream, struct hard_case *h)
{
    draw_place(stream, h, draw_flat(stream, -1.2, 1.2), draw_flat(stream, -1.2, 1.2), draw_flat(stream, -0.5, 0.5));
}

static void draw_ordinary(uint64_t *stream, struct hard_case *h)
{
    draw_quad(stream, draw_flat(stream, 1, 3), 0.2, 0.1, h);
    place(stream, h);
    draw_move(stream, h, draw_power(stream, -2, 2), draw_flat(stream, 0, 3));
}

/* Draws a face spanned by two edges, the second the first after a step; the slave node lies beside the first. */
static void draw_swept(uint64_t *stream, struct hard_case *h)
{
    const double step = draw_power(stream, -2, 0), along = draw_flat(stream, 0, 1);
    for (int i = 0; i < 3; i++) {
        h->x[0][i] = draw_flat(stream, -1, 1);
        h->x[1][i] = draw_flat(stream, -1, 1);
        h->x[3][i] = h->x[0][i] + step * draw_flat(stream, -1, 1);
        h->x[2][i] = h->x[1][i] + step * draw_flat(stream, -1, 1);
    }
    for (int i = 0; i < 3; i++)
        h->x[4][i] = h->x[0][i] + along * (h->x[1][i] - h->x[0][i]) + step * draw_flat(stream, -1, 1);
}

static void draw_sliver(uint64_t *stream, struct hard_case *h)
{
    draw_quad(stream, draw_power(stream, 0.5, 4), 0.3, 0.3, h);
    place(stream, h);
    draw_move(stream, h, 1, draw_choose(stream, 2));
}

static void draw_taper(uint64_t *stream, struct hard_case *h)
{
    const double taper = 1 - draw_power(stream, -4, 0);
    draw_quad(stream, draw_flat(stream, 1, 3), 0.1, 0.1, h);
    for (int i = 0; i < 3; i++) {
        const double middle = 0.5 * (h->x[2][i] + h->x[3][i]);
        h->x[2][i] += taper * (middle - h->x[2][i]);
        h->x[3][i] += taper * (middle - h->x[3][i]);
    }
    place(stream, h);
}

static void draw_folded(uint64_t *stream, struct hard_case *h)
{
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++)
            h->x[k][i] = draw_flat(stream, -1, 1);
}

static void draw_far(uint64_t *stream, struct hard_case *h)
{
    draw_quad(stream, draw_flat(stream, 1, 3), 0.2, 0.1, h);
    draw_place(stream, h, draw_flat(stream, -9, 9), draw_flat(stream, -9, 9), draw_power(stream, 0, 6));
}

static void draw_offset(uint64_t *stream, struct hard_case *h)
{
    draw_ordinary(stream, h);
    draw_move(stream, h, 1, draw_power(stream, 0, 7));
}

static void draw_tiny(uint64_t *stream, struct hard_case *h)
{
    draw_ordinary(stream, h);
    draw_move(stream, h, draw_power(stream, -45, -8), draw_choose(stream, 2));
}

static void draw_huge(uint64_t *stream, struct hard_case *h)
{
    draw_ordinary(stream, h);
    draw_move(stream, h, draw_power(stream, 8, 38), draw_choose(stream, 2));
}

/* Scales each coordinate of each point separately. */
static void draw_mixed(uint64_t *stream, struct hard_case *h)
{
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++)
            h->x[k][i] = draw_sign(stream) * draw_power(stream, -8, 0);
}

static const struct family {
    const char *name;
    void (*draw)(uint64_t *stream, struct hard_case *h);
    double least; /* percentage that NAME proves with the finest promise */
} families[] = {{"ordinary", draw_ordinary, 99}, {"swept", draw_swept, 30},  {"sliver", draw_sliver, 0},
                {"taper", draw_taper, 50},       {"folded", draw_folded, 0}, {"far", draw_far, 0},
                {"offset", draw_offset, 50},     {"tiny", draw_tiny, 50},    {"huge", draw_huge, 50},
                {"mixed", draw_mixed, 0}};
enum { FAMILIES = sizeof families / sizeof *families };

struct single {
    float x[5][3];
};

static struct single rounded(const struct hard_case *h)
{
    struct single s;
    for (int k = 0; k < 15; k++)
        s.x[k / 3][k % 3] = fabs(h->x[k / 3][k % 3]) <= (double)FLT_MAX || isnan(h->x[k / 3][k % 3])
                                ? (float)h->x[k / 3][k % 3]
                                : (float)copysign(HUGE_VAL, h->x[k / 3][k % 3]);
    return s;
}

/* ---- the judge ---- */

/* Returns half the squared distance at z, and computes its downhill slopes g and its Hessian. */
static fine slopes(const struct single *s, const fine z[2], fine g[2], fine H[3])
{
    fine half = g[0] = g[1] = H[0] = H[1] = H[2] = 0;
    for (int i = 0; i < 3; i++) {
        const fine A = 0, B = (fine)s->x[1][i] - s->x[0][i], C = (fine)s->x[2][i] - s->x[0][i];
        const fine D = (fine)s->x[3][i] - s->x[0][i], S = (fine)s->x[4][i] - s->x[0][i];
        const fine c = (A - B + C - D) / 4, u = (B - A + C - D) / 4 + z[1] * c, v = (D - A + C - B) / 4 + z[0] * c;
        const fine d = S - (A + B + C + D) / 4 - z[0] * (u - z[1] * c) - z[1] * v;
        half += d * d / 2;
        g[0] += u * d;
        g[1] += v * d;
        H[0] += u * u;
        H[1] += u * v - c * d;
        H[2] += v * v;
    }
    return half;
}

/* Takes Newton's steps from z until they converge; returns true if they end at a minimum. */
static bool minimum_near(const struct single *s, fine z[2])
{
    for (int k = 0; k < STEPS; k++) {
        fine g[2], H[3];
        slopes(s, z, g, H);
        const fine det = H[0] * H[2] - H[1] * H[1];
        const fine p = (H[2] * g[0] - H[1] * g[1]) / det, q = (H[0] * g[1] - H[1] * g[0]) / det;
        if (!(fabsl(p) + fabsl(q) < 1e3L)) /* NaN, too */
            return false;
        z[0] += p;
        z[1] += q;
        if (k > 1 && fabsl(p) + fabsl(q) < 1e-10L * (1 + fabsl(z[0]) + fabsl(z[1])))
            return det > 0 && H[0] > 0;
    }
    return false;
}

/* Returns true if an answer with status OK is as near to a minimum as promised. */
static bool holds(const struct single *s, const float loc[2], double promise)
{
    fine z[2] = {loc[0], loc[1]};
    const fine most = (fine)promise * fmaxl(1, fmaxl(fabsl(z[0]), fabsl(z[1])));
    return minimum_near(s, z) && fabsl(z[0] - loc[0]) <= most && fabsl(z[1] - loc[1]) <= most;
}

static fine clamp(fine x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* Takes Newton's steps from z on the closed face, shortened to lead downhill, until they converge; returns half the
 * squared distance. */
static fine settle(const struct single *s, fine z[2])
{
    fine g[2], H[3], half = slopes(s, z, g, H);
    for (int k = 0; k < STEPS; k++) {
        const bool held[2] = {(z[0] >= 1 && g[0] >= 0) || (z[0] <= -1 && g[0] <= 0),
                              (z[1] >= 1 && g[1] >= 0) || (z[1] <= -1 && g[1] <= 0)};
        const fine det = H[0] * H[2] - H[1] * H[1];
        fine step[2] = {H[0] > 0 ? g[0] / H[0] : 0, H[2] > 0 ? g[1] / H[2] : 0}, to[2], G[2], K[3], less;
        if (!held[0] && !held[1] && det > 0) {
            step[0] = (H[2] * g[0] - H[1] * g[1]) / det;
            step[1] = (H[0] * g[1] - H[1] * g[0]) / det;
        }
        for (int i = 0; i < 2; i++)
            step[i] = held[i] ? 0 : step[i];
        do {
            for (int i = 0; i < 2; i++)
                to[i] = clamp(z[i] + step[i]);
            less = slopes(s, to, G, K);
            step[0] /= 4;
            step[1] /= 4;
        } while (less > half && fabsl(step[0]) + fabsl(step[1]) > 1e-12L);
        const fine moved = fabsl(to[0] - z[0]) + fabsl(to[1] - z[1]);
        if (!(less <= half))
            return half;
        memcpy(z, to, sizeof to);
        memcpy(g, G, sizeof g);
        memcpy(H, K, sizeof H);
        half = less;
        if (moved < 1e-13L)
            return half;
    }
    return half;
}

/* Finds the nearest point of the line of constant eta. */
static fine line(const struct single *s, fine eta, fine z[2])
{
    fine g[2], H[3];
    z[0] = 0;
    z[1] = eta;
    slopes(s, z, g, H);
    z[0] = H[0] > 0 ? clamp(g[0] / H[0]) : 0;
    return slopes(s, z, g, H);
}

/* Finds the nearest point of the face, by descents from lines that are nearer than their neighbours. */
static fine nearest(const struct single *s, fine best[2])
{
    fine half[LINES + 1], z[LINES + 1][2], least = INFINITY;
    for (int k = 0; k <= LINES; k++)
        half[k] = line(s, 2 * (fine)k / LINES - 1, z[k]);
    for (int k = 0; k <= LINES; k++) {
        if ((k > 0 && half[k - 1] < half[k]) || (k < LINES && half[k + 1] < half[k]))
            continue;
        const fine here = settle(s, z[k]);
        if (here < least) {
            least = here;
            memcpy(best, z[k], sizeof z[k]);
        }
    }
    return least;
}

/* Returns the distance in space between two places. */
static fine apart(const struct single *s, const fine a[2], const fine b[2])
{
    fine square = 0;
    for (int i = 0; i < 3; i++) {
        const fine B = (fine)s->x[1][i] - s->x[0][i], C = (fine)s->x[2][i] - s->x[0][i];
        const fine D = (fine)s->x[3][i] - s->x[0][i], c = C - B - D, u = B + C - D, v = D + C - B;
        const fine d = (a[0] - b[0]) * u + (a[1] - b[1]) * v + (a[0] * a[1] - b[0] * b[1]) * c;
        square += d * d / 16;
    }
    return sqrtl(square);
}

/* Returns true if a closest point with status OK is as near to the nearest point of all as promised; `least`: its
 * distance, at `best`. */
static bool is_closest(const struct single *s, const float loc[2], double promise, fine least, const fine best[2])
{
    fine z[2] = {loc[0], loc[1]};
    const fine half = settle(s, z);
    if (least < half * (1 - 1e-15L) && apart(s, z, best) > 0)
        memcpy(z, best, sizeof z); /* another valley */
    return fabsl(z[0] - loc[0]) <= (fine)promise && fabsl(z[1] - loc[1]) <= (fine)promise;
}

/* ---- tests ---- */

static void report(const struct function *f, const char *family, const struct single *s, const float loc[2])
{
    for (int k = 0; k < 5; k++)
        print_error("{%a, %a, %a},\n", (double)s->x[k][0], (double)s->x[k][1], (double)s->x[k][2]);
    fail_msg("%s, %s: OK at (%.9g, %.9g)", f->name, family, (double)loc[0], (double)loc[1]);
}

struct tally {
    long asked, ok, closest_asked, closest_ok;
};

/* Judges all functions' answers to one case. */
static void judge(const char *family, const struct single *s, bool is_global, struct tally count[FUNCTIONS])
{
    fine best[2] = {0, 0}, least = -1;
    for (int f = 0; f < FUNCTIONS; f++) {
        float loc[2] = {7, 7}, gap = 7;
        int region, status = functions[f].one(s->x[0], s->x[1], s->x[2], s->x[3], s->x[4], loc, &gap);
        assert_true(status >= FOOTPOINT_OK ? isfinite(loc[0] + loc[1]) && isfinite(gap) : loc[0] == 7 && gap == 7);
        if (status == FOOTPOINT_OK && !holds(s, loc, functions[f].promise))
            report(&functions[f], family, s, loc);
        count[f].asked++;
        count[f].ok += status == FOOTPOINT_OK;
        if (!is_global)
            continue;
        status = functions[f].closest(s->x[0], s->x[1], s->x[2], s->x[3], s->x[4], loc, &gap, &region);
        count[f].closest_asked += status >= FOOTPOINT_OK;
        count[f].closest_ok += status == FOOTPOINT_OK;
        if (status != FOOTPOINT_OK)
            continue;
        least = least < 0 ? nearest(s, best) : least;
        if (!is_closest(s, loc, functions[f].promise, least, best))
            report(&functions[f], family, s, loc);
    }
}

static double percent(long part, long all)
{
    return 100 * (double)part / (double)(all ? all : 1);
}

static void print(const char *family, const struct tally count[FUNCTIONS])
{
    for (int f = 0; f < FUNCTIONS && getenv("FOOTPOINT_LONG"); f++)
        print_message("%-10s %-14s OK %8.4f %% of %ld, closest %8.4f %% of %ld\n", functions[f].name, family,
                      percent(count[f].ok, count[f].asked), count[f].asked,
                      percent(count[f].closest_ok, count[f].closest_asked), count[f].closest_asked);
}

static void answers_keep_the_promise(void **state)
{
    (void)state;
    for (int family = 0; family < FAMILIES; family++) {
        uint64_t stream = 6262 + (uint64_t)family;
        struct tally count[FUNCTIONS] = {{0}};
        const long n = long_cases(CASES, family ? CASES_LONG : ORDINARY_LONG);
        for (long k = 0; k < n; k++) {
            struct hard_case h;
            families[family].draw(&stream, &h);
            const struct single s = rounded(&h);
            judge(families[family].name, &s, k < CASES_LONG, count);
        }
        print(families[family].name, count);
        if (percent(count[FUNCTIONS - 1].ok, count[FUNCTIONS - 1].asked) < families[family].least)
            fail_msg("%s: %ld of %ld proved", families[family].name, count[FUNCTIONS - 1].ok,
                     count[FUNCTIONS - 1].asked);
    }
}

static void answers_to_hard_cases_keep_the_promise(void **state)
{
    (void)state;
    for (int family = 0; family < hard_family_count; family++) {
        struct tally count[FUNCTIONS] = {{0}};
        for (long k = 0; k < long_cases(CASES, CASES_LONG) / 4 && hard_families[family].draw_float; k++) {
            struct hard_case h;
            hard_draw_float(family, 5, (uint64_t)k, &h);
            const struct single s = rounded(&h);
            judge(hard_families[family].name, &s, true, count);
        }
        print(hard_families[family].name, count);
    }
}

/* Arrays return the answers of calls, to the bit, or to rounding if compilers fuse operations. */
static void arrays_match_single_calls(void **state)
{
    static struct single s[BLOCK];
    static float column[15][BLOCK], xi[2][BLOCK], eta[2][BLOCK], gap[2][BLOCK];
    static int region[BLOCK], status[2][BLOCK];
    const float *x[15];
    uint64_t stream = 63;
    (void)state;
    for (int i = 0; i < BLOCK; i++) {
        struct hard_case h;
        families[i % FAMILIES].draw(&stream, &h);
        s[i] = rounded(&h);
        for (int k = 0; k < 15; k++)
            column[k][i] = s[i].x[k / 3][k % 3];
    }
    for (int k = 0; k < 15; k++)
        x[k] = column[k];
    for (const struct function *f = functions; f < functions + FUNCTIONS; f++) {
        f->many(BLOCK, x, xi[0], eta[0], gap[0], status[0]);
        f->closest_many(BLOCK, x, xi[1], eta[1], gap[1], region, status[1]);
        for (int i = 0; i < BLOCK; i++) {
            float loc[2][2], g[2];
            int where = 0;
            const float *const y[5] = {s[i].x[0], s[i].x[1], s[i].x[2], s[i].x[3], s[i].x[4]};
            const int alone[2] = {f->one(y[0], y[1], y[2], y[3], y[4], loc[0], &g[0]),
                                  f->closest(y[0], y[1], y[2], y[3], y[4], loc[1], &g[1], &where)};
            for (int k = 0; k < 2; k++) {
                const float found[2] = {xi[k][i], eta[k][i]};
                if (status[k][i] == FOOTPOINT_OK && k == 0 && !holds(&s[i], found, f->promise))
                    report(f, "in an array", &s[i], found);
#ifndef __FMA__
                assert_int_equal(status[k][i], alone[k]);
                if (alone[k] >= FOOTPOINT_OK)
                    assert_true(loc[k][0] == found[0] && loc[k][1] == found[1] && g[k] == gap[k][i]);
                if (alone[1] >= FOOTPOINT_OK)
                    assert_int_equal(where, region[i]);
#else
                (void)alone;
#endif
            }
        }
    }
}

/* With two faces, OK means that no point of either is nearer than the returned distance, up to rounding. */
static void the_nearest_of_two_faces_is_proved(void **state)
{
    uint64_t stream = 64;
    long proved = 0;
    (void)state;
    for (int i = 0; i < BLOCK; i++) {
        struct hard_case h[2];
        for (int k = 0; k < 2; k++)
            draw_swept(&stream, &h[k]);
        memcpy(h[1].x[4], h[0].x[4], sizeof h[0].x[4]);
        const struct single s[2] = {rounded(&h[0]), rounded(&h[1])};
        const float *nodes[8];
        fine best[2], least = INFINITY;
        float loc[2], dist;
        int region;
        size_t which;
        for (int k = 0; k < 8; k++)
            nodes[k] = s[k / 4].x[k % 4];
        if (footpoint_quad4_float_accurate_closest_of(2, nodes, s[0].x[4], loc, &dist, &region, &which) != FOOTPOINT_OK)
            continue;
        proved++;
        for (int k = 0; k < 2; k++)
            least = fminl(least, sqrtl(2 * nearest(&s[k], best)));
        assert_true(fabsl(fabsl((fine)dist) - least) <= 1e-5L);
    }
    assert_true(proved > BLOCK / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(answers_keep_the_promise),
        cmocka_unit_test(answers_to_hard_cases_keep_the_promise),
        cmocka_unit_test(arrays_match_single_calls),
        cmocka_unit_test(the_nearest_of_two_faces_is_proved),
    };
    return cmocka_run_group_tests_name("float promises", tests, NULL, NULL);
}
