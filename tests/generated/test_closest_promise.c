/* FOOTPOINT_OK of closest points of four-node faces means that the closest point, edges and corners included, lies within
 * NAME_PROMISE of xi and eta, in the returned region. The judge bounds distances to lines of constant eta, interval by
 * interval, then takes Newton's steps in quadruple precision; it shares no code with the judged functions. Some of each
 * family; 80,000 with FOOTPOINT_LONG, which prints shares of proofs. */
#include "../../generated/footpoint_plane_quad4.h"
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_rectangle_quad4.h"
#include "../hard/draw.h"
#include "../hard/hard.h"
#include "../support/long_cases.h"

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

__extension__ typedef __float128 wide;
typedef long double fine;

enum { CASES = 60, CASES_LONG = 80000, STEPS = 80, STACK = 4000, PAIRS = 200, SEVERAL = 3, ANSWERS = 6 };
#define BORDER 1e-9  /* in xi and eta: within this of a border, both regions are right */
#define NOT_HERE 7.0 /* initial value of outputs */

/* ---- functions ---- */

typedef int one(const double *const *x, double loc[2], double *dist, int *region);
typedef void many(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region, int *status);
typedef int of_many(size_t n, const double *const *x, const double *xs, double loc[2], double *dist, int *region,
                    size_t *which);

#define WRAP(name, capitals)                                                                                           \
    static int one_##name(const double *const *x, double loc[2], double *dist, int *region)                            \
    {                                                                                                                  \
        return footpoint_##name##_closest(x[0], x[1], x[2], x[3], x[4], loc, dist, region);                            \
    }                                                                                                                  \
    static void many_##name(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region,      \
                            int *status)                                                                               \
    {                                                                                                                  \
        footpoint_##name##_closest_n(n, x, xi, eta, dist, region, status);                                             \
    }                                                                                                                  \
    static int of_##name(size_t n, const double *const *x, const double *xs, double loc[2], double *dist, int *region, \
                         size_t *which)                                                                                \
    {                                                                                                                  \
        return footpoint_##name##_closest_of(n, x, xs, loc, dist, region, which);                                      \
    }
#define ALL(F)                                                                                                         \
    F(quad4_coarse, QUAD4_COARSE)                                                                                      \
    F(quad4_medium, QUAD4_MEDIUM)                                                                                      \
    F(quad4_balanced, QUAD4_BALANCED)                                                                                  \
    F(quad4_fine, QUAD4_FINE)                                                                                          \
    F(quad4_precise, QUAD4_PRECISE)                                                                                    \
    F(quad4_accurate, QUAD4_ACCURATE)                                                                                  \
    F(quad4_full, QUAD4_FULL)                                                                                          \
    F(plane_quad4_coarse, PLANE_QUAD4_COARSE)                                                                          \
    F(plane_quad4_exact, PLANE_QUAD4_EXACT)                                                                            \
    F(rectangle_quad4_exact, RECTANGLE_QUAD4_EXACT)
ALL(WRAP)
#define ROW(name, capitals) {#name, FOOTPOINT_##capitals##_PROMISE, one_##name, many_##name, of_##name},
static const struct function {
    const char *name;
    double promise;
    one *one;
    many *many;
    of_many *of_many;
} functions[] = {ALL(ROW)};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

/* ---- families ---- */

/* Draws xS beside or over the face, up to `away` of its longest edge from it. */
static void draw_slave(uint64_t *stream, struct hard_case *h, double away)
{
    double r[3], t[3], u[3], c[3], d[3], longest = 0;
    for (int k = 0; k < 4; k++) {
        double square = 0;
        for (int i = 0; i < 3; i++)
            square += (h->x[k][i] - h->x[(k + 1) % 4][i]) * (h->x[k][i] - h->x[(k + 1) % 4][i]);
        longest = fmax(longest, sqrt(square));
    }
    draw_evaluate(h, draw_flat(stream, -1, 1), draw_flat(stream, -1, 1), r, t, u, c);
    draw_direction(stream, d);
    const double far = longest * draw_flat(stream, 0, away);
    for (int i = 0; i < 3; i++)
        h->x[4][i] = r[i] + far * d[i];
}

static void draw_ordinary(uint64_t *stream, struct hard_case *h)
{
    draw_quad(stream, draw_flat(stream, 1, 3), 0.2, 0.1, h);
    draw_slave(stream, h, 1);
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
    draw_quad(stream, draw_power(stream, 1, 3), 0.2, 0.1, h);
    draw_slave(stream, h, 1);
}

static void draw_needle(uint64_t *stream, struct hard_case *h)
{
    draw_quad(stream, draw_power(stream, 3, 6), 0.3, 0.3, h);
    draw_slave(stream, h, draw_power(stream, -6, 0));
}

static void draw_taper(uint64_t *stream, struct hard_case *h)
{
    const double taper = draw_choose(stream, 2) ? draw_flat(stream, 0, 0.99) : 0.99;
    draw_quad(stream, draw_flat(stream, 1, 3), 0.1, 0.1, h);
    for (int i = 0; i < 3; i++) {
        const double middle = 0.5 * (h->x[2][i] + h->x[3][i]);
        h->x[2][i] += taper * (middle - h->x[2][i]);
        h->x[3][i] += taper * (middle - h->x[3][i]);
    }
    draw_slave(stream, h, 1);
}

static void draw_folded(uint64_t *stream, struct hard_case *h)
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            h->x[k][i] = draw_flat(stream, -1, 1);
    draw_slave(stream, h, 1);
}

/* Draws C = D, two or three coinciding points, xS on a node. */
static void draw_coincident(uint64_t *stream, struct hard_case *h)
{
    draw_ordinary(stream, h);
    const int which = draw_choose(stream, 6), k = draw_choose(stream, 4);
    const int to = which == 4 ? (k + 2) % 4 : (k + 1) % 4;
    if (which < 5)
        memcpy(h->x[to], h->x[k], sizeof h->x[k]);
    if (which == 3)
        memcpy(h->x[(k + 2) % 4], h->x[k], sizeof h->x[k]);
    if (which > 3 || which == 1)
        memcpy(h->x[4], h->x[draw_choose(stream, 4)], sizeof h->x[4]);
}

static void draw_far(uint64_t *stream, struct hard_case *h)
{
    draw_quad(stream, draw_flat(stream, 1, 3), 0.2, 0.1, h);
    draw_slave(stream, h, draw_power(stream, 0, 2));
}

/* Draws slave nodes over edges and corners of flat faces, and equally near to two points, to rounding. */
static void draw_tie(uint64_t *stream, struct hard_case *h)
{
    static const double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double warp = draw_choose(stream, 2) ? 0 : draw_flat(stream, 0, 2), over = draw_flat(stream, -1, 1);
    for (int k = 0; k < 4; k++) {
        h->x[k][0] = square[k][0];
        h->x[k][1] = square[k][1];
        h->x[k][2] = warp * square[k][0] * square[k][1];
    }
    h->x[4][0] = warp > 0 ? 0 : draw_choose(stream, 2) ? 1 : draw_flat(stream, -1, 1);
    h->x[4][1] = warp > 0 ? draw_choose(stream, 2) * over : draw_choose(stream, 2) ? -1 : draw_flat(stream, -1, 1);
    h->x[4][2] = warp > 0 ? draw_choose(stream, 3) * draw_flat(stream, -1, 1) : over;
}

static void draw_offset(uint64_t *stream, struct hard_case *h)
{
    draw_ordinary(stream, h);
    draw_move(stream, h, draw_power(stream, -3, 3), draw_power(stream, 3, 9));
}

static void draw_sized(uint64_t *stream, struct hard_case *h)
{
    draw_ordinary(stream, h);
    draw_move(stream, h, draw_power(stream, 0, 1) * (draw_choose(stream, 2) ? 1e299 : 1e-299), 0);
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
    double least; /* percentage proved to 1e-3 and to 1e-7 */
} families[] = {{"ordinary", draw_ordinary, 99.9},  {"swept", draw_swept, 85}, {"sliver", draw_sliver, 90},
                {"needle", draw_needle, 0},         {"taper", draw_taper, 85}, {"folded", draw_folded, 0},
                {"coincident", draw_coincident, 0}, {"far", draw_far, 0},      {"tie", draw_tie, 0},
                {"offset", draw_offset, 0},         {"sized", draw_sized, 99}, {"mixed", draw_mixed, 0}};
enum { FAMILIES = sizeof families / sizeof *families };

/* ---- the judge ---- */

/* The face about its node A, in a unit of length in which it is about 1 long. */
struct judged {
    wide x[5][3];
    fine y[5][3];
    double longest, unit;
    bool known; /* the nearest point, and half its squared distance */
    wide at[2], least;
};

static double size_of(wide x)
{
    return fabs((double)x);
}

static void take(const struct hard_case *h, struct judged *j)
{
    double most = 0;
    int exponent;
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++) {
            j->x[k][i] = (wide)h->x[k][i] - h->x[0][i];
            most = k < 4 ? fmax(most, size_of(j->x[k][i])) : most;
        }
    (void)frexp(most, &exponent);
    j->unit = ldexp(1, exponent);
    j->longest = 0;
    j->known = false;
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++)
            j->y[k][i] = (fine)(j->x[k][i] /= j->unit);
    for (int k = 0; k < 4; k++) {
        double square = 0;
        for (int i = 0; i < 3; i++)
            square += (double)((j->x[k][i] - j->x[(k + 1) % 4][i]) * (j->x[k][i] - j->x[(k + 1) % 4][i]));
        j->longest = fmax(j->longest, sqrt(square));
    }
}

/* Returns half the squared distance at z, and computes its downhill slopes g and its Hessian. */
static wide slopes(const struct judged *j, const wide z[2], wide g[2], wide H[3])
{
    wide half = g[0] = g[1] = H[0] = H[1] = H[2] = 0;
    for (int i = 0; i < 3; i++) {
        const wide A = j->x[0][i], B = j->x[1][i], C = j->x[2][i], D = j->x[3][i], S = j->x[4][i];
        const wide c = (A - B + C - D) / 4, u = (B - A + C - D) / 4 + z[1] * c, v = (D - A + C - B) / 4 + z[0] * c;
        const wide d = S - (A + B + C + D) / 4 - z[0] * (u - z[1] * c) - z[1] * v;
        half += d * d / 2;
        g[0] += u * d;
        g[1] += v * d;
        H[0] += u * u;
        H[1] += u * v - c * d;
        H[2] += v * v;
    }
    return half;
}

static wide clamp(wide x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* Takes downhill Newton's steps from z on the closed face until they converge; returns half the squared distance. */
static wide settle(const struct judged *j, wide z[2])
{
    wide g[2], H[3], half = slopes(j, z, g, H);
    for (int k = 0; k < STEPS; k++) {
        const bool held[2] = {(z[0] >= 1 && g[0] >= 0) || (z[0] <= -1 && g[0] <= 0),
                              (z[1] >= 1 && g[1] >= 0) || (z[1] <= -1 && g[1] <= 0)};
        const wide det = H[0] * H[2] - H[1] * H[1];
        wide s[2] = {g[0], g[1]}, to[2], G[2], K[3], less;
        if (!held[0] && !held[1] && det > 0) {
            s[0] = (H[2] * g[0] - H[1] * g[1]) / det;
            s[1] = (H[0] * g[1] - H[1] * g[0]) / det;
        } else if (held[0] || held[1])
            for (int i = 0; i < 2; i++)
                s[i] = held[i] || !(H[2 * i] > 0) ? 0 : g[i] / H[2 * i];
        do {
            for (int i = 0; i < 2; i++)
                to[i] = clamp(z[i] + s[i]);
            less = slopes(j, to, G, K);
            s[0] /= 4;
            s[1] /= 4;
        } while (less > half && size_of(s[0]) + size_of(s[1]) > 1e-20);
        const double moved = size_of(to[0] - z[0]) + size_of(to[1] - z[1]);
        if (less > half)
            return half;
        memcpy(z, to, sizeof to);
        memcpy(g, G, sizeof g);
        memcpy(H, K, sizeof H);
        half = less;
        if (moved < 1e-28)
            return half;
    }
    return half;
}

/* Returns the distance to the line of constant eta = v, and xi of its nearest point. */
static fine line(const struct judged *j, fine v, fine *xi)
{
    fine e[3], d[3], ee = 0, ed = 0, square = 0;
    for (int i = 0; i < 3; i++) {
        const fine left = j->y[0][i] + (1 + v) / 2 * (j->y[3][i] - j->y[0][i]);
        e[i] = j->y[1][i] + (1 + v) / 2 * (j->y[2][i] - j->y[1][i]) - left;
        d[i] = j->y[4][i] - left;
        ee += e[i] * e[i];
        ed += e[i] * d[i];
    }
    const fine t = ee > 0 ? fminl(fmaxl(ed / ee, 0), 1) : 0;
    for (int i = 0; i < 3; i++)
        square += (d[i] - t * e[i]) * (d[i] - t * e[i]);
    *xi = 2 * t - 1;
    return sqrtl(square);
}

/* Finds a point that is nearest to within 1e-5 of the longest edge: the distance to a line of constant eta changes no
 * faster than the longer of the edges along which the line moves. */
static void find_nearest(struct judged *j)
{
    static double middle[STACK], half[STACK];
    double rate = 0;
    fine best = HUGE_VALL;
    int n = 0;
    for (int k = 0; k < 2; k++) {
        double square = 0;
        for (int i = 0; i < 3; i++)
            square += (double)((j->y[3 - k][i] - j->y[k][i]) * (j->y[3 - k][i] - j->y[k][i]));
        rate = fmax(rate, 0.5 * sqrt(square));
    }
    for (int k = 0; k < 16; k++) {
        middle[n] = (2 * k - 15) / 16.0;
        half[n++] = 1 / 16.0;
    }
    for (j->known = true; n > 0;) {
        const double v = middle[--n], h = half[n];
        fine xi;
        const fine d = line(j, v, &xi);
        if (d < best || (n < 16 && h > 0.06 && n % 4 == 0)) { /* other valleys, too */
            wide to[2] = {xi, v};
            const wide there = settle(j, to);
            if (best == HUGE_VALL || there < j->least) {
                j->least = there;
                memcpy(j->at, to, sizeof to);
            }
            best = fminl(d, sqrtl(2 * (fine)j->least));
        }
        if (d - rate * h < best - 1e-5 * j->longest)
            for (int k = -1; k < 2; k += 2) {
                assert_true(n < STACK);
                middle[n] = v + 0.5 * k * h;
                half[n++] = 0.5 * h;
            }
    }
}

static int region_of(wide xi, wide eta)
{
    static const int region[3][3] = {{5, 1, 6}, {4, 0, 2}, {8, 3, 7}};
    return region[eta >= 1 ? 2 : eta > -1][xi >= 1 ? 2 : xi > -1];
}

/* Returns true if z lies in the region, or beside its border. */
static bool in_region(const wide z[2], int region)
{
    for (int i = -1; i < 2; i++)
        for (int k = -1; k < 2; k++)
            if (region_of(clamp(z[0] + i * BORDER), clamp(z[1] + k * BORDER)) == region)
                return true;
    return false;
}

/* Returns the squared distance between two points of the face. */
static double apart(const struct judged *j, const wide a[2], const wide b[2])
{
    wide sum = 0;
    for (int i = 0; i < 3; i++) {
        const wide A = j->x[0][i], B = j->x[1][i], C = j->x[2][i], D = j->x[3][i];
        const wide ra = (1 - a[1]) * ((1 - a[0]) * A + (1 + a[0]) * B) + (1 + a[1]) * ((1 - a[0]) * D + (1 + a[0]) * C);
        const wide rb = (1 - b[1]) * ((1 - b[0]) * A + (1 + b[0]) * B) + (1 + b[1]) * ((1 - b[0]) * D + (1 + b[0]) * C);
        sum += (ra - rb) * (ra - rb);
    }
    return size_of(sum) / 16;
}

/* Returns the violated part of the status's promise; NULL: none. */
static const char *fault(struct judged *j, double promise, int status, const double loc[2], double dist, int region)
{
    wide g[2], H[3], z[2] = {loc[0], loc[1]};
    if (!(fabs(loc[0]) <= 1 && fabs(loc[1]) <= 1 && dist < HUGE_VAL && dist > -HUGE_VAL))
        return "no point of the face";
    if (region != region_of(loc[0], loc[1]))
        return "another region than xi and eta";
    const double here = sqrt(2 * (double)slopes(j, z, g, H)), scale = j->longest + here;
    if (fabs(fabs(dist) / j->unit - here) > 1e-13 * scale)
        return "the distance is another";
    if (status == FOOTPOINT_UNPROVED)
        return NULL;
    if (!j->known)
        find_nearest(j);
    if (status == FOOTPOINT_OK && size_of(j->at[0] - loc[0]) <= promise && size_of(j->at[1] - loc[1]) <= promise &&
        in_region(j->at, region))
        return NULL;
    const wide near = settle(j, z); /* a place at least as far as the judge's */
    if (status == FOOTPOINT_NOT_UNIQUE)
        return here <= sqrt(2 * (double)j->least) + 1.001e-10 * j->longest ? NULL
                                                                           : "a tie, and another point is nearer";
    if (size_of(near - j->least) > 1e-28 * scale * scale && j->least < near && apart(j, z, j->at) > 1e-40)
        memcpy(z, j->at, sizeof z); /* another valley */
    if (size_of(z[0] - loc[0]) > promise || size_of(z[1] - loc[1]) > promise)
        return "beyond the promise";
    return in_region(z, region) ? NULL : "another region";
}

/* ---- tests ---- */

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

static void expect(const struct function *f, const char *family, const struct hard_case *h, struct judged *j,
                   int status, const double loc[2], double dist, int region)
{
    const char *const wrong = status < FOOTPOINT_OK ? NULL : fault(j, f->promise, status, loc, dist, region);
    if (wrong) {
        for (int k = 0; k < 5; k++)
            print_error("{%a, %a, %a},\n", h->x[k][0], h->x[k][1], h->x[k][2]);
        fail_msg("%s, %s: status %d at (%.17g, %.17g), distance %.17g, region %d: %s", f->name, family, status, loc[0],
                 loc[1], dist, region, wrong);
    }
}

/* Judges all functions' answers to one case; counts statuses, indexed by function. */
static void judge(const char *family, const struct hard_case *h, bool all, long count[FUNCTIONS][ANSWERS])
{
    const double *const x[5] = {h->x[0], h->x[1], h->x[2], h->x[3], h->x[4]};
    struct judged j;
    take(h, &j);
    for (int i = 0; i < FUNCTIONS; i++) {
        double loc[2] = {NOT_HERE, NOT_HERE}, dist = NOT_HERE;
        int region = 7;
        const int status = functions[i].one(x, loc, &dist, &region);
        if (status < FOOTPOINT_OK)
            assert_true(loc[0] == NOT_HERE && loc[1] == NOT_HERE && dist == NOT_HERE && region == 7);
        if (all)
            expect(&functions[i], family, h, &j, status, loc, dist, region);
        count[i][status < FOOTPOINT_OK ? ANSWERS - 1 : status]++;
    }
}

static void closest_points_of_hard_faces_keep_the_promise(void **state)
{
    (void)state;
    for (int family = 0; family < hard_family_count; family++)
        for (long k = 0; k < cases() / 4; k++) {
            long count[FUNCTIONS][ANSWERS] = {{0}};
            struct hard_case h;
            hard_draw(family, 3, (uint64_t)k, &h);
            judge(hard_families[family].name, &h, true, count);
        }
}

/* Closest points keep the promise and are proved often enough. */
static void closest_points_keep_the_promise(void **state)
{
    (void)state;
    for (int family = 0; family < FAMILIES; family++) {
        uint64_t stream = 6161 + (uint64_t)family;
        long count[FUNCTIONS][ANSWERS] = {{0}};
        for (long k = 0; k < 10 * cases(); k++) {
            struct hard_case h;
            families[family].draw(&stream, &h);
            judge(families[family].name, &h, k % 10 == 0, count);
        }
        for (int i = 0; i < FUNCTIONS; i++) {
            const long *c = count[i], answers = c[FOOTPOINT_OK] + c[FOOTPOINT_NOT_UNIQUE] + c[FOOTPOINT_UNPROVED];
            const double proved = 100 * (double)c[FOOTPOINT_OK] / (double)(answers ? answers : 1);
            if (functions[i].promise > 1e-9 && proved < families[family].least)
                fail_msg("%s, %s: %ld of %ld proved", functions[i].name, families[family].name, c[0], answers);
            if (getenv("FOOTPOINT_LONG"))
                print_message("%-22s %-11s OK %8.4f %% of %ld, ties %ld, unproved %ld, errors %ld\n", functions[i].name,
                              families[family].name, proved, answers, c[FOOTPOINT_NOT_UNIQUE], c[FOOTPOINT_UNPROVED],
                              c[ANSWERS - 1]);
        }
    }
}

/* Draws n cases of all families in turn. */
static void draw_all(int n, struct hard_case *h)
{
    uint64_t stream = 62;
    for (int i = 0; i < n; i++) {
        const int family = i % (FAMILIES + hard_family_count);
        if (family >= FAMILIES)
            hard_draw(family - FAMILIES, 4, (uint64_t)i, &h[i]);
        else
            families[family].draw(&stream, &h[i]);
    }
}

/* Arrays of any length give the answers of calls, to the bit unless operations are fused, and write nothing else. */
static void arrays_match_single_calls(void **state)
{
    static const size_t length[] = {1, 2, 3, 7, 8, 9, 31, 32, 33, 74}; /* PAIRS in all */
    static struct hard_case h[PAIRS];
    static double column[15][PAIRS], xi[PAIRS + 1], eta[PAIRS + 1], dist[PAIRS + 1];
    static int region[PAIRS + 1], status[PAIRS + 1], where;
    static struct judged j[PAIRS];
    const double *x[15];
    (void)state;
    draw_all(PAIRS, h);
    for (int i = 0; i < PAIRS; i++)
        take(&h[i], &j[i]);
    for (int k = 0; k < 15 * PAIRS; k++)
        column[k / PAIRS][k % PAIRS] = h[k % PAIRS].x[k / PAIRS / 3][k / PAIRS % 3];
    for (int f = 0; f < FUNCTIONS; f++) {
        for (size_t from = 0, l = 0; from < PAIRS; from += length[l++]) {
            const size_t end = from + length[l];
            for (int k = 0; k < 15; k++)
                x[k] = column[k] + from;
            xi[end] = eta[end] = dist[end] = region[end] = status[end] = PAIRS;
            functions[f].many(length[l], x, xi + from, eta + from, dist + from, region + from, status + from);
            assert_true(xi[end] + eta[end] + dist[end] == 3 * PAIRS && region[end] + status[end] == 2 * PAIRS);
        }
        for (int i = 0; i < PAIRS; i++) {
            const double *const y[5] = {h[i].x[0], h[i].x[1], h[i].x[2], h[i].x[3], h[i].x[4]};
            double loc[2], d, found[2] = {xi[i], eta[i]};
            expect(&functions[f], "in an array", &h[i], &j[i], status[i], found, dist[i], region[i]);
#ifdef __FMA__
            continue;
#endif
            assert_int_equal(status[i], functions[f].one(y, loc, &d, &where));
            if (status[i] >= FOOTPOINT_OK)
                assert_true(!memcmp(loc, found, sizeof loc) && d == dist[i] && where == region[i]);
        }
    }
}

/* With several faces, OK means that no point of any face is nearer. */
static void the_nearest_of_several_faces_is_proved(void **state)
{
    static struct hard_case h[PAIRS];
    (void)state;
    draw_all(PAIRS, h);
    for (int i = 0; i + SEVERAL <= PAIRS; i++) {
        const double *x[4 * SEVERAL];
        struct judged j[SEVERAL];
        for (int k = 0; k < 4 * SEVERAL; k++)
            x[k] = h[i + k / 4].x[k % 4];
        for (int k = 0; k < SEVERAL; k++) {
            struct hard_case face = h[i + k];
            memcpy(face.x[4], h[i].x[4], sizeof face.x[4]);
            take(&face, &j[k]);
        }
        for (int f = 0; f < FUNCTIONS; f++) {
            double loc[2], dist;
            int region;
            size_t which;
            if (functions[f].of_many(SEVERAL, x, h[i].x[4], loc, &dist, &region, &which) != FOOTPOINT_OK)
                continue;
            expect(&functions[f], "of several", &h[i], &j[which], FOOTPOINT_OK, loc, dist, region);
            for (int k = 0; k < SEVERAL; k++) {
                /* faces without an answer, because of their distance or area, are skipped */
                const double *const y[5] = {x[4 * k], x[4 * k + 1], x[4 * k + 2], x[4 * k + 3], h[i].x[4]};
                double at[2], d;
                int where;
                if (functions[f].one(y, at, &d, &where) < FOOTPOINT_OK)
                    continue;
                if (!j[k].known)
                    find_nearest(&j[k]);
                /* up to the effect of the promise on the chosen face's distance */
                const double least = sqrt(2 * (double)j[k].least) * j[k].unit;
                const double off =
                    1e-13 * (j[k].unit + fabs(dist)) + 2 * functions[f].promise * j[which].longest * j[which].unit;
                if (least < fabs(dist) - off)
                    fail_msg("%s, case %d: face %zu at %.17g, %d is nearer", functions[f].name, i, which, dist, k);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(closest_points_keep_the_promise),
                                       cmocka_unit_test(closest_points_of_hard_faces_keep_the_promise),
                                       cmocka_unit_test(arrays_match_single_calls),
                                       cmocka_unit_test(the_nearest_of_several_faces_is_proved)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
