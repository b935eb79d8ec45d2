/* The promise of closest points of faces of six, eight and nine nodes. FOOTPOINT_OK means that the closest point of the
 * closed face, including edges and corners, lies within NAME_PROMISE of xi and eta, in the returned region.
 * FOOTPOINT_NOT_UNIQUE means that no point is nearer by more than 1e-10 of the longest edge, and another is as near.
 * The judge bounds distances over parts of the face (tests/support/curved_face.h), then takes Newton's steps in
 * quadruple precision, and shares no code with the judged functions. Some of each kind and group; a million with
 * FOOTPOINT_LONG, which prints how many are proved. A file that defines CLOSEST_FUNCTIONS may include this for other
 * headers. */
#ifndef CLOSEST_FUNCTIONS
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri6.h"
#endif
#include "../hard/draw.h"
#include "../support/curved_face.h"
#include "../support/long_cases.h"
#include "curved_cases.h"

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

enum { CASES = 120, STEPS = 80, PAIRS = 100, SEVERAL = 3, ANSWERS = 6 };
#define NOT_HERE 7.0 /* initial value of outputs */

/* ---- functions ---- */

typedef int one(const double *const *x, const double *s, double loc[2], double *dist, int *region);
typedef void many(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region, int *status);
typedef int of_many(size_t n, const double *const *x, const double *xs, double loc[2], double *dist, int *region,
                    size_t *which);

#define X6 x[0], x[1], x[2], x[3], x[4], x[5]
#define X8 X6, x[6], x[7]
#define X9 X8, x[8]
#ifdef CLOSEST_FUNCTIONS
#include CLOSEST_FUNCTIONS
#else
enum { CASES_LONG = 1000000, FUNCTIONS = 9 };
#define BORDER 1e-9     /* of xi and eta: nearer than this to the border of a region, either is right */
#define TIE 1.001e-10   /* distances this much apart, over the longest edge, are equal */
#define ROUNDING 1e-12  /* of distances */
#define ON_EDGE 2.3e-16 /* of xi and eta */
#define OVER 0          /* what the sum of xi and eta may exceed 1 by */
#define ROUND(f) (void)(f)
/* % that must be proved, by group, of promises above COARSE */
#define COARSE 1e-8
#define PROVED_LEAST                                                                                                   \
    {                                                                                                                  \
        99, 85, 50, 0, 0, 90, 0, 90                                                                                    \
    }
#define ALL(F)                                                                                                         \
    F(6, tri6, coarse, TRI6_COARSE)                                                                                    \
    F(6, tri6, precise, TRI6_PRECISE)                                                                                  \
    F(6, tri6, accurate, TRI6_ACCURATE)                                                                                \
    F(8, quad8, coarse, QUAD8_COARSE)                                                                                  \
    F(8, quad8, fine, QUAD8_FINE)                                                                                      \
    F(8, quad8, full, QUAD8_FULL)                                                                                      \
    F(9, quad9, coarse, QUAD9_COARSE)                                                                                  \
    F(9, quad9, fine, QUAD9_FINE)                                                                                      \
    F(9, quad9, full, QUAD9_FULL)
#define WRAP(nodes, kind, tier, capitals)                                                                              \
    static int one_##kind##_##tier(const double *const *x, const double *s, double loc[2], double *dist, int *region)  \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_closest(X##nodes, s, loc, dist, region);                                    \
    }
ALL(WRAP)
#define ROW(nodes, kind, tier, capitals)                                                                               \
    {#kind "_" #tier,                                                                                                  \
     nodes,                                                                                                            \
     FOOTPOINT_##capitals##_PROMISE,                                                                                   \
     one_##kind##_##tier,                                                                                              \
     footpoint_##kind##_##tier##_closest_n,                                                                            \
     footpoint_##kind##_##tier##_closest_of},
#endif
static const struct function {
    const char *name;
    int nodes;
    double promise;
    one *one;
    many *many;
    of_many *of_many;
} functions[FUNCTIONS] = {ALL(ROW)};

/* ---- the judge ---- */

/* A face in a unit of length in which it is about 1 long, and its nearest point. */
struct judged {
    struct curved_case face;
    struct curved_powers powers[3]; /* for triangles, numbered from each corner */
    double longest, unit;
    bool known;
    wide at[2], least; /* half the squared distance */
};

/* Renumbers a triangle from another corner, so that xi and eta are 0 there. */
static struct curved_case turned(const struct curved_case *f, int turn)
{
    struct curved_case g = *f;
    for (int k = 0; k < 6; k++)
        memcpy(g.x[k], f->x[k / 3 * 3 + (k + turn) % 3], sizeof g.x[k]);
    return g;
}

static void take(const struct curved_case *f, struct judged *j)
{
    double most = 0;
    int exponent;
    const int n = f->kind->nodes;
    j->face.kind = f->kind;
    j->longest = 0;
    j->known = false;
    for (int k = 0; k < n; k++)
        for (int i = 0; i < 3; i++)
            most = fmax(most, fabs(f->x[k][i] / 2 - f->x[0][i] / 2));
    (void)frexp(most, &exponent);
    j->unit = ldexp(1, exponent);
    for (int k = 0; k <= n; k++)
        for (int i = 0; i < 3; i++)
            j->face.x[k][i] = ldexp(ldexp(f->x[k][i], -exponent / 2), exponent / 2 - exponent);
    for (int k = 0; k < f->kind->corners; k++) {
        const double *const a = j->face.x[k], *const b = j->face.x[(k + 1) % f->kind->corners];
        j->longest = fmax(j->longest, sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                                           (a[2] - b[2]) * (a[2] - b[2])));
    }
    for (int turn = 0; turn < (f->kind->corners == 3 ? 3 : 1); turn++) {
        const struct curved_case g = turn ? turned(&j->face, turn) : j->face;
        curved_powers(&g, &j->powers[turn]);
    }
}

/* Converts xi and eta to the numbering in which corner number `turn` is the first. */
static void turn_place(int turn, wide z[2])
{
    const wide l[3] = {1 - z[0] - z[1], z[0], z[1]};
    z[0] = l[(turn + 1) % 3];
    z[1] = l[(turn + 2) % 3];
}

/* Takes downhill Newton's steps from z, with xi and eta from `low` to 1 on the closed face, until they converge;
 * returns half the squared distance. */
static wide settle_in(const struct curved_powers *f, double low, wide z[2])
{
    wide g[2], H[3], half = curved_half(f, z, g, H);
    for (int k = 0; k < STEPS; k++) {
        const bool held[2] = {(z[0] >= 1 && g[0] >= 0) || (z[0] <= low && g[0] <= 0),
                              (z[1] >= 1 && g[1] >= 0) || (z[1] <= low && g[1] <= 0)};
        const wide det = H[0] * H[2] - H[1] * H[1];
        wide s[2] = {g[0], g[1]}, to[2], G[2], K[3], less;
        double moved;
        if (!held[0] && !held[1] && det > 0 && H[0] > 0) {
            s[0] = (H[2] * g[0] - H[1] * g[1]) / det;
            s[1] = (H[0] * g[1] - H[1] * g[0]) / det;
        } else if (held[0] || held[1])
            for (int i = 0; i < 2; i++)
                s[i] = held[i] || !(H[2 * i] > 0) ? 0 : g[i] / H[2 * i];
        do {
            for (int i = 0; i < 2; i++)
                to[i] = z[i] + s[i] < low ? low : z[i] + s[i] > 1 ? 1 : z[i] + s[i];
            less = curved_half(f, to, G, K);
            moved = size_of(to[0] - z[0]) + size_of(to[1] - z[1]);
            s[0] /= 4;
            s[1] /= 4;
        } while (less > half && moved > 1e-15);
        if (less > half)
            return half;
        memcpy(z, to, sizeof to);
        memcpy(g, G, sizeof g);
        memcpy(H, K, sizeof H);
        half = less;
        if (moved < 1e-17) /* the next is its square */
            return half;
    }
    return half;
}

/* Moves a place beyond the edges of a triangle onto it; returns true if it was beyond. */
static bool bring_back(wide z[2])
{
    wide l[3] = {1 - z[0] - z[1], z[0], z[1]}, sum = 0;
    bool beyond = false;
    for (int i = 0; i < 3; i++) {
        beyond = beyond || l[i] < -1e-25;
        l[i] = l[i] < 0 ? 0 : l[i];
        sum += l[i];
    }
    z[0] = l[1] / sum;
    z[1] = l[2] / sum;
    return beyond;
}

/* Takes steps on the closed face. On triangles they start from the nearest corner, whose opposite edge does not stop
 * them; once they have crossed it, they continue from another corner. */
static wide settle(const struct judged *j, wide z[2])
{
    wide half, g[2], H[3];
    if (j->face.kind->corners == 4)
        return settle_in(&j->powers[0], -1, z);
    for (int tries = 0; tries < 4; tries++) {
        const int turn = z[0] > 0.5 ? 1 : z[1] > 0.5 ? 2 : 0;
        turn_place(turn, z);
        half = settle_in(&j->powers[turn], 0, z);
        turn_place((3 - turn) % 3, z);
        if (!bring_back(z))
            return half;
    }
    return curved_half(&j->powers[0], z, g, H);
}

static void find_nearest(struct judged *j)
{
    struct curved_face f;
    double loc[2];
    curved_face_of(&f, j->face.kind->nodes, j->face.x, j->face.x[j->face.kind->nodes]);
    (void)curved_face_closest(&f, loc);
    j->at[0] = loc[0];
    j->at[1] = loc[1];
    j->least = settle(j, j->at);
    j->known = true;
}

static wide clamp(wide x, double low)
{
    return x < low ? low : x > 1 ? 1 : x;
}

/* Returns the region of a place; within `border` counts as on an edge. */
static int region_of(const struct curved_kind *k, const wide z[2], double border)
{
    static const int square[3][3] = {{5, 1, 6}, {4, 0, 2}, {8, 3, 7}}, on[8] = {0, 1, 2, 5, 3, 4, 6, 0};
    if (k->corners == 4)
        return square[z[1] >= 1 - border ? 2 : z[1] > border - 1][z[0] >= 1 - border ? 2 : z[0] > border - 1];
    return on[(z[1] <= border) + 2 * (1 - z[0] - z[1] <= border) + 4 * (z[0] <= border)];
}

/* Returns true if z, the closest point, lies in the region or beside its border. */
static bool in_region(const struct curved_kind *k, const wide z[2], int region)
{
    const double low = k->corners == 4 ? -1 : 0;
    for (int i = -2; i <= 2; i++)
        for (int n = -2; n <= 2; n++) {
            const wide to[2] = {clamp(z[0] + i * BORDER / 2, low), clamp(z[1] + n * BORDER / 2, low)};
            if (region_of(k, to, k->corners == 4 ? 0 : 1e-15) == region)
                return true;
        }
    return region_of(k, z, BORDER) == region;
}

static void point_at(const struct curved_powers *p, const wide z[2], wide d[3])
{
    for (int k = 0; k < 3; k++) {
        d[k] = 0;
        for (int i = 2; i >= 0; i--)
            d[k] = d[k] * z[0] + p->d[k][i][0] + z[1] * (p->d[k][i][1] + z[1] * p->d[k][i][2]);
    }
}

/* Returns the squared distance between two points of the face. */
static double apart(const struct judged *j, const wide a[2], const wide b[2])
{
    wide r[3], s[3], sum = 0;
    point_at(&j->powers[0], a, r);
    point_at(&j->powers[0], b, s);
    for (int i = 0; i < 3; i++)
        sum += (r[i] - s[i]) * (r[i] - s[i]);
    return size_of(sum);
}

/* Returns the violated part of the status's promise; NULL: none. */
static const char *fault(struct judged *j, double promise, int status, const double loc[2], double dist, int region)
{
    const struct curved_kind *const k = j->face.kind;
    const double low = k->corners == 4 ? -1 : 0;
    wide g[2], H[3], z[2] = {loc[0], loc[1]};
    if (!(loc[0] >= low && loc[1] >= low && loc[0] <= 1 && loc[1] <= 1 && dist < HUGE_VAL && dist > -HUGE_VAL) ||
        (k->corners == 3 && loc[0] + loc[1] > 1 + OVER))
        return "no point of the face";
    if (region != region_of(k, z, k->corners == 4 ? 0 : ON_EDGE))
        return "another region than xi and eta";
    const double here = sqrt(2 * (double)curved_half(&j->powers[0], z, g, H)), scale = j->longest + here;
    if (fabs(fabs(dist) / j->unit - here) > ROUNDING * scale)
        return "the distance is another";
    if (status == FOOTPOINT_UNPROVED)
        return NULL;
    if (!j->known)
        find_nearest(j);
    if (status == FOOTPOINT_OK && size_of(j->at[0] - loc[0]) <= promise && size_of(j->at[1] - loc[1]) <= promise &&
        in_region(k, j->at, region))
        return NULL;
    const wide near = settle(j, z); /* a place at least as far as the judge's */
    if (status == FOOTPOINT_NOT_UNIQUE)
        return here <= sqrt(2 * (double)j->least) + TIE * j->longest ? NULL : "a tie, and another point is nearer";
    if (size_of(near - j->least) > 1e-28 * scale * scale && j->least < near && apart(j, z, j->at) > 1e-40)
        memcpy(z, j->at, sizeof z); /* another valley */
    if (size_of(z[0] - loc[0]) > promise || size_of(z[1] - loc[1]) > promise)
        return "beyond the promise";
    return in_region(k, z, region) ? NULL : "another region";
}

/* ---- tests ---- */

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

static void expect(const struct function *f, const char *group, const struct curved_case *h, struct judged *j,
                   int status, const double loc[2], double dist, int region)
{
    const char *const wrong = status < FOOTPOINT_OK ? NULL : fault(j, f->promise, status, loc, dist, region);
    if (wrong) {
        for (int k = 0; k <= f->nodes; k++)
            print_error("{%a, %a, %a},\n", h->x[k][0], h->x[k][1], h->x[k][2]);
        if (j->known)
            print_error("nearest (%.17g, %.17g), %.17g\n", (double)j->at[0], (double)j->at[1],
                        sqrt(2 * (double)j->least) * j->unit);
        fail_msg("%s, %s: status %d at (%.17g, %.17g), distance %.17g, region %d: %s", f->name, group, status, loc[0],
                 loc[1], dist, region, wrong);
    }
}

/* Draws slave nodes of flat faces equally near to two points, to rounding, and over edges and corners. */
static void draw_tie(uint64_t *stream, struct curved_case *f)
{
    const int n = f->kind->corners, edge = draw_choose(stream, n);
    curved_draw(stream, ORDINARY, f);
    for (int k = 0; k < f->kind->nodes; k++) {
        static const double place[9][2] = {{-1, -1}, {1, -1}, {1, 1},  {-1, 1}, {0, -1},
                                           {1, 0},   {0, 1},  {-1, 0}, {0, 0}};
        static const double other[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
        const double *const at = n == 3 ? other[k] : place[k];
        f->x[k][0] = at[0];
        f->x[k][1] = at[1];
        f->x[k][2] = 0;
    }
    const double bend = draw_choose(stream, 2) ? draw_flat(stream, 0.3, 1) : 0;
    for (int k = n; k < f->kind->nodes; k++) /* a ridge, symmetric in xi */
        f->x[k][2] = n == 4 && f->x[k][0] == 0 ? bend : 0;
    const double *const a = f->x[edge], *const b = f->x[(edge + 1) % n], t = draw_choose(stream, 3) / 2.;
    for (int i = 0; i < 3; i++)
        f->x[f->kind->nodes][i] = a[i] + t * (b[i] - a[i]);
    f->x[f->kind->nodes][2] = draw_flat(stream, -1, 1);
    if (bend > 0)
        f->x[f->kind->nodes][0] = 0;
}

enum { TIES = CURVED_GROUPS, OFFSET, FAR, BESIDE, KINDS_OF_CASES };
static const char *const names[KINDS_OF_CASES] = {"ordinary", "strongly curved", "sliver", "wild",
                                                  "ties",     "offset",          "far",    "beside border"};
/* percentage that must be proved to 1e-7 or more coarsely */
static const double proved_least[KINDS_OF_CASES] = PROVED_LEAST;

/* Moves the slave node over a corner or a point of an edge, and up to 1e-8 of the tangents beside it. */
static void draw_over_border(uint64_t *stream, struct curved_case *f)
{
    static const double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, triangle[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    const double(*const corner)[2] = f->kind->corners == 4 ? square : triangle;
    const int edge = draw_choose(stream, f->kind->corners);
    const double *const a = corner[edge], *const b = corner[(edge + 1) % f->kind->corners];
    const double way = draw_choose(stream, 3) ? 0 : draw_flat(stream, 0, 1);
    const wide p = a[0] + way * (b[0] - a[0]), q = a[1] + way * (b[1] - a[1]);
    const double far = draw_flat(stream, -0.1, 0.1);
    double *const slave = f->x[f->kind->nodes], u[3], v[3], normal[3];
    struct curved_powers powers;
    curved_powers(f, &powers);
    for (int i = 0; i < 3; i++) {
        const wide(*const c)[3] = (const wide(*)[3])powers.d[i];
        wide d[3] = {0, 0, 0};
        for (int k = 2; k >= 0; k--) {
            const wide along = c[k][0] + q * (c[k][1] + q * c[k][2]);
            d[1] = d[1] * p + d[0];
            d[0] = d[0] * p + along;
            d[2] = d[2] * p + c[k][1] + 2 * q * c[k][2];
        }
        slave[i] -= (double)d[0];
        u[i] = -(double)d[1];
        v[i] = -(double)d[2];
    }
    draw_cross(u, v, normal);
    const double length = sqrt(sqrt(draw_dot(normal, normal)));
    const double s = (draw_choose(stream, 2) ? 1 : -1) * draw_power(stream, -13, -8);
    const double t = (draw_choose(stream, 2) ? 1 : -1) * draw_power(stream, -13, -8);
    for (int i = 0; i < 3; i++)
        slave[i] += (length > 0 ? far * normal[i] / length : 0) + s * u[i] + t * v[i];
}

static void draw(uint64_t *stream, int group, struct curved_case *f)
{
    if (group == TIES) {
        draw_tie(stream, f);
        ROUND(f);
        return;
    }
    curved_draw(stream, group > TIES ? ORDINARY : (enum curved_group)group, f);
    if (group != WILD)
        curved_draw_slave(stream, f, group == FAR ? draw_power(stream, 0, 2) : 1);
    if (group == BESIDE)
        draw_over_border(stream, f);
    for (int k = 0; group == OFFSET && k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            f->x[k][i] += 1e6 * (i + 1);
    ROUND(f);
}

/* Judges the answers of all functions of a kind to one case; counts statuses, indexed by function. */
static void judge(const char *group, const struct curved_case *h, long count[FUNCTIONS][ANSWERS])
{
    const double *x[CURVED_NODES];
    struct judged j;
    for (int k = 0; k < h->kind->nodes; k++)
        x[k] = h->x[k];
    take(h, &j);
    for (int i = 0; i < FUNCTIONS; i++) {
        double loc[2] = {NOT_HERE, NOT_HERE}, dist = NOT_HERE;
        int region = 7;
        if (functions[i].nodes != h->kind->nodes)
            continue;
        const int status = functions[i].one(x, h->x[h->kind->nodes], loc, &dist, &region);
        if (status < FOOTPOINT_OK)
            assert_true(loc[0] == NOT_HERE && loc[1] == NOT_HERE && dist == NOT_HERE && region == 7);
        expect(&functions[i], group, h, &j, status, loc, dist, region);
        count[i][status < FOOTPOINT_OK ? ANSWERS - 1 : status]++;
    }
}

static void closest_points_keep_the_promise(void **state)
{
    (void)state;
    for (int group = 0; group < KINDS_OF_CASES; group++) {
        long count[FUNCTIONS][ANSWERS] = {{0}};
        for (int k = 0; k < CURVED_KINDS; k++) {
            uint64_t stream = 6262 + (uint64_t)(10 * group + k);
            for (long i = 0; i < cases() / (group < WILD ? 1 : 4); i++) {
                struct curved_case f = {.kind = &curved_kinds[k]};
                draw(&stream, group, &f);
                judge(names[group], &f, count);
            }
        }
        for (int i = 0; i < FUNCTIONS; i++) {
            const long *c = count[i], answers = c[FOOTPOINT_OK] + c[FOOTPOINT_NOT_UNIQUE] + c[FOOTPOINT_UNPROVED];
            const double proved = 100 * (double)c[FOOTPOINT_OK] / (double)(answers ? answers : 1);
            if (getenv("FOOTPOINT_LONG"))
                print_message("%-14s %-15s OK %8.4f %% of %ld, ties %ld, unproved %ld, errors %ld\n", functions[i].name,
                              names[group], proved, answers, c[FOOTPOINT_NOT_UNIQUE], c[FOOTPOINT_UNPROVED],
                              c[ANSWERS - 1]);
            else if (functions[i].promise > COARSE && proved < proved_least[group])
                fail_msg("%s, %s: %ld of %ld proved", functions[i].name, names[group], c[0], answers);
        }
    }
}

/* Draws n cases of a kind, of all groups in turn. */
static void draw_all(const struct curved_kind *k, int n, struct curved_case *f)
{
    uint64_t stream = 62;
    for (int i = 0; i < n; i++) {
        f[i].kind = k;
        draw(&stream, i % KINDS_OF_CASES, &f[i]);
    }
}

/* Arrays return the answers of calls, to the bit, or to rounding if compilers fuse operations. */
static void arrays_match_single_calls(void **state)
{
    static struct curved_case h[PAIRS];
    static double column[3 * CURVED_NODES + 3][PAIRS], xi[PAIRS], eta[PAIRS], dist[PAIRS];
    static int region[PAIRS], status[PAIRS];
    (void)state;
    for (int f = 0; f < FUNCTIONS; f++) {
        const int nodes = functions[f].nodes;
        const double *x[3 * CURVED_NODES + 3];
        draw_all(&curved_kinds[nodes == 6 ? 0 : nodes - 7], PAIRS, h);
        for (int k = 0; k < 3 * nodes + 3; k++) {
            x[k] = column[k];
            for (int i = 0; i < PAIRS; i++)
                column[k][i] = h[i].x[k / 3][k % 3];
        }
        functions[f].many(PAIRS, x, xi, eta, dist, region, status);
        for (int i = 0; i < PAIRS; i++) {
            const double *y[CURVED_NODES], found[2] = {xi[i], eta[i]};
            double loc[2], d;
            int where;
            struct judged j;
            for (int k = 0; k < nodes; k++)
                y[k] = h[i].x[k];
            take(&h[i], &j);
            expect(&functions[f], "in an array", &h[i], &j, status[i], found, dist[i], region[i]);
#ifndef __FMA__
            assert_int_equal(status[i], functions[f].one(y, h[i].x[nodes], loc, &d, &where));
            if (status[i] >= FOOTPOINT_OK)
                assert_true(loc[0] == xi[i] && loc[1] == eta[i] && d == dist[i] && where == region[i]);
#else
            (void)y, (void)loc, (void)d, (void)where;
#endif
        }
    }
}

/* With several faces, OK means that no point of any face is nearer. */
static void the_nearest_of_several_faces_is_proved(void **state)
{
    static struct curved_case h[PAIRS];
    (void)state;
    for (int f = 0; f < FUNCTIONS; f++) {
        const int nodes = functions[f].nodes;
        draw_all(&curved_kinds[nodes == 6 ? 0 : nodes - 7], PAIRS, h);
        for (int i = 0; i + SEVERAL <= PAIRS; i++) {
            const double *x[CURVED_NODES * SEVERAL], *const xs = h[i].x[nodes];
            struct judged j[SEVERAL];
            double loc[2], dist;
            int region;
            size_t which;
            for (int k = 0; k < nodes * SEVERAL; k++)
                x[k] = h[i + k / nodes].x[k % nodes];
            for (int k = 0; k < SEVERAL; k++) {
                struct curved_case face = h[i + k];
                memcpy(face.x[nodes], xs, sizeof face.x[nodes]);
                take(&face, &j[k]);
            }
            if (functions[f].of_many(SEVERAL, x, xs, loc, &dist, &region, &which) != FOOTPOINT_OK)
                continue;
            expect(&functions[f], "of several", &h[i], &j[which], FOOTPOINT_OK, loc, dist, region);
            for (size_t k = 0; k < SEVERAL; k++) { /* faces without an answer are skipped */
                double at[2], d;
                int where;
                if (functions[f].one(x + (size_t)nodes * k, xs, at, &d, &where) < FOOTPOINT_OK)
                    continue;
                if (!j[k].known)
                    find_nearest(&j[k]);
                /* up to the effect of the promise on the chosen face's distance */
                const double least = sqrt(2 * (double)j[k].least) * j[k].unit;
                const double off = 0.1 * ROUNDING * (j[k].unit + fabs(dist)) +
                                   8 * functions[f].promise * j[which].longest * j[which].unit;
                if (least < fabs(dist) - off)
                    fail_msg("%s, case %d: face %zu at %.17g, %zu is nearer", functions[f].name, i, which, dist, k);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_points_keep_the_promise),
        cmocka_unit_test(arrays_match_single_calls),
        cmocka_unit_test(the_nearest_of_several_faces_is_proved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
