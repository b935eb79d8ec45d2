/* The promise of closest points of patches: FOOTPOINT_OK means that the closest point of the closed patch, edges and
 * corners included, lies within NAME_PROMISE of xi and eta, in the returned region; FOOTPOINT_NOT_UNIQUE that no point is
 * nearer by more than 1e-10 of the longest edge, and another is as near. The judge (patch_nearest.h) shares no code with
 * the functions that it judges. Some of each kind and group; with FOOTPOINT_LONG a million altogether, and shares of
 * proved points. */
#include "../../generated/footpoint_bezier.h"
#include "../../generated/footpoint_gregory.h"
#include "../../generated/footpoint_paper_gregory.h"
#include "../hard/draw.h"
#include "../support/long_cases.h"
#include "drawn_patches.h"
#include "patch_nearest.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum {
    CASES = 20,
    CASES_LONG = 72000,
    PAIRS = 60,
    SEVERAL = 3,
    ANSWERS = 6,
    FUNCTIONS = 6,
    KINDS = 2,
    VECTORS = PATCH_VECTORS
};
typedef patch_wide wide;

#define BORDER 1e-9  /* of xi and eta: nearer than this to the border of a region, either is right */
#define NOT_HERE 7.0 /* what outputs are set to beforehand */

/* ---- functions ---- */

typedef void many(size_t n, const double *const *x, double *xi, double *eta, double *dist, int *region, int *status);
typedef int one(const double *const *x, double loc[2], double *dist, int *region);
typedef int of_many(size_t n, const double *const *x, const double *xs, double loc[2], double *dist, int *region,
                    size_t *which);

#define ALL(F)                                                                                                         \
    F(0, bezier, facet, BEZIER_FACET)                                                                                  \
    F(0, bezier, precise, BEZIER_PRECISE)                                                                              \
    F(0, bezier, full, BEZIER_FULL)                                                                                    \
    F(1, gregory, smooth, GREGORY_SMOOTH)                                                                              \
    F(1, gregory, full, GREGORY_FULL)                                                                                  \
    F(1, paper_gregory, precise, PAPER_GREGORY_PRECISE)
#define WRAP(kind, header, tier, capitals)                                                                             \
    static int one_##header##_##tier(const double *const *x, double loc[2], double *dist, int *region)                 \
    {                                                                                                                  \
        return footpoint_##header##_##tier##_closest(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8], loc, dist,  \
                                                     region);                                                          \
    }
ALL(WRAP)
#define ROW(kind, header, tier, capitals)                                                                              \
    {#header "_" #tier,                                                                                                \
     kind,                                                                                                             \
     FOOTPOINT_##capitals##_PROMISE,                                                                                   \
     one_##header##_##tier,                                                                                            \
     footpoint_##header##_##tier##_closest_n,                                                                          \
     footpoint_##header##_##tier##_closest_of},
static const struct function {
    const char *name;
    int kind;
    double promise;
    one *one;
    many *many;
    of_many *of_many;
} functions[FUNCTIONS] = {ALL(ROW)};

/* ---- the judge ---- */

static double size_of(wide x)
{
    return fabs((double)x);
}

/* A patch in a unit of length in which it is about 1 long, and the nearest point. */
struct judged {
    struct patch_case patch;
    struct patch_net net;
    double longest, unit;
    bool known;
    wide at[2], least; /* half the square of the distance */
};

static void take(const struct patch_case *f, struct judged *j)
{
    double most = 0;
    int exponent;
    j->patch = *f;
    j->longest = 0;
    j->known = false;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            most = fmax(most, fabs(f->x[k][i] / 2 - f->x[0][i] / 2));
    (void)frexp(most, &exponent);
    j->unit = ldexp(1, exponent);
    for (int k = 0; k < VECTORS; k++)
        for (int i = 0; i < 3 && (k < 4 || k == 8); i++)
            j->patch.x[k][i] = ldexp(ldexp(f->x[k][i], -exponent / 2), exponent / 2 - exponent);
    for (int k = 0; k < 4; k++) {
        const double *const a = j->patch.x[k], *const b = j->patch.x[(k + 1) % 4];
        j->longest = fmax(j->longest, sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                                           (a[2] - b[2]) * (a[2] - b[2])));
    }
    patch_net_make(&j->patch, &j->net);
}

static void find_nearest(struct judged *j)
{
    j->least = patch_nearest(&j->patch, &j->net, j->at);
    j->known = true;
}

/* Which region a place is in, `border` being as good as on an edge. */
static int region_of(const wide z[2], double border)
{
    static const int square[3][3] = {{5, 1, 6}, {4, 0, 2}, {8, 3, 7}};
    return square[z[1] >= 1 - border ? 2 : z[1] > border - 1][z[0] >= 1 - border ? 2 : z[0] > border - 1];
}

static wide clamp(wide x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* Whether z, the closest point, lies in the region, or beside its border. */
static bool in_region(const wide z[2], int region)
{
    for (int i = -1; i < 2; i++)
        for (int n = -1; n < 2; n++) {
            const wide to[2] = {clamp(z[0] + i * BORDER), clamp(z[1] + n * BORDER)};
            if (region_of(to, 0) == region)
                return true;
        }
    return region_of(z, BORDER) == region;
}

static wide half_at(const struct judged *j, const wide z[2], wide r[3])
{
    wide all[3][3], half = 0;
    patch_net_at(&j->patch, &j->net, z, all);
    for (int i = 0; i < 3; i++) {
        r[i] = all[0][i];
        half += (r[i] - j->patch.x[8][i]) * (r[i] - j->patch.x[8][i]) / 2;
    }
    return half;
}

/* The square of the distance between two points of the patch. */
static double apart(const struct judged *j, const wide a[2], const wide b[2])
{
    wide r[3], s[3], sum = 0;
    (void)half_at(j, a, r);
    (void)half_at(j, b, s);
    for (int i = 0; i < 3; i++)
        sum += (r[i] - s[i]) * (r[i] - s[i]);
    return size_of(sum);
}

/* What an answer lacks of what its status promises; NULL: nothing. */
static const char *fault(struct judged *j, double promise, int status, const double loc[2], double dist, int region)
{
    wide z[2] = {loc[0], loc[1]}, r[3];
    if (!(fabs(loc[0]) <= 1 && fabs(loc[1]) <= 1 && fabs(dist) < HUGE_VAL))
        return "no point of the patch";
    if (region != region_of(z, 0))
        return "another region than xi and eta";
    const double here = sqrt(2 * (double)half_at(j, z, r)), scale = j->longest + here;
    if (fabs(fabs(dist) / j->unit - here) > 1e-11 * scale)
        return "the distance is another";
    if (status == FOOTPOINT_UNPROVED)
        return NULL;
    if (!j->known)
        find_nearest(j);
    if (status == FOOTPOINT_OK && size_of(j->at[0] - loc[0]) <= promise && size_of(j->at[1] - loc[1]) <= promise &&
        in_region(j->at, region))
        return NULL;
    if (status == FOOTPOINT_NOT_UNIQUE)
        return here <= sqrt(2 * (double)j->least) + 1.001e-10 * j->longest ? NULL
                                                                           : "a tie, and another point is nearer";
    const wide near = patch_settle(&j->patch, &j->net, z); /* a place as near as the judge's, or further */
    if (size_of(near - j->least) > 1e-28 * scale * scale && j->least < near && apart(j, z, j->at) > 1e-40)
        memcpy(z, j->at, sizeof z); /* another valley's */
    if (size_of(z[0] - loc[0]) > promise || size_of(z[1] - loc[1]) > promise)
        return "beyond the promise";
    return in_region(z, region) ? NULL : "another region";
}

/* ---- cases ---- */

enum { AROUND = PATCH_GROUPS, TIES, OFFSET, FAR, BESIDE, GROUPS };
static const char *const names[GROUPS] = {"ordinary", "strongly warped", "sliver", "border",       "wild", "around",
                                          "ties",     "offset",          "far",    "beside border"};

/* The slave node up to `away` of half an edge from a corner or between corners. */
static void draw_around(uint64_t *stream, struct patch_case *f, double away)
{
    const double s = draw_flat(stream, 0, 1), t = draw_flat(stream, 0, 1), far = draw_flat(stream, 0, away);
    double d[3];
    draw_direction(stream, d);
    for (int i = 0; i < 3; i++)
        f->x[8][i] = (1 - s) * ((1 - t) * f->x[0][i] + t * f->x[3][i]) + s * ((1 - t) * f->x[1][i] + t * f->x[2][i]) +
                     far * d[i];
}

/* A long arch, symmetric in xi, or a dome, also in eta, and a slave node in the plane between, above or below. */
static void draw_tie(uint64_t *stream, struct patch_case *f)
{
    static const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double k = draw_flat(stream, 0, 2), l = draw_choose(stream, 2) * k / 3;
    for (int c = 0; c < 4; c++) {
        const double n[3] = {k * at[c][0], l * at[c][1], 1}, length = sqrt(draw_dot(n, n));
        for (int i = 0; i < 3; i++) {
            f->x[c][i] = i < 2 ? at[c][i] * (1 + 2 * i) : 0;
            f->x[4 + c][i] = n[i] / length;
        }
    }
    f->x[8][0] = 0;
    f->x[8][1] = draw_choose(stream, 2) ? 0 : draw_flat(stream, -3, 3);
    f->x[8][2] = draw_flat(stream, -5, 1);
}

/* Moves the slave node over a corner or a point of an edge, and up to 1e-8 of the tangents beside it. */
static void draw_over_border(uint64_t *stream, struct patch_case *f)
{
    const double side[2] = {2 * draw_choose(stream, 2) - 1, 2 * draw_choose(stream, 2) - 1};
    const int inner = draw_choose(stream, 6); /* the coordinate that is not on the border; above 1: none */
    const wide z[2] = {inner == 0 ? draw_flat(stream, -1, 1) : side[0],
                       inner == 1 ? draw_flat(stream, -1, 1) : side[1]};
    const double far = draw_flat(stream, -0.1, 0.1);
    struct patch_net net;
    wide r[3][3];
    double u[3], v[3], normal[3];
    patch_net_make(f, &net);
    patch_net_at(f, &net, z, r);
    for (int i = 0; i < 3; i++) {
        u[i] = (double)r[1][i];
        v[i] = (double)r[2][i];
        f->x[8][i] = (double)r[0][i];
    }
    draw_cross(u, v, normal);
    const double length = sqrt(sqrt(draw_dot(normal, normal)));
    const double s = (draw_choose(stream, 2) ? 1 : -1) * draw_power(stream, -13, -8);
    const double t = (draw_choose(stream, 2) ? 1 : -1) * draw_power(stream, -13, -8);
    for (int i = 0; i < 3; i++)
        f->x[8][i] += (length > 0 ? far * normal[i] / length : 0) + s * u[i] + t * v[i];
}

static void draw(uint64_t *stream, int group, struct patch_case *f)
{
    if (group == TIES) {
        draw_tie(stream, f);
        return;
    }
    patch_draw(stream, group < PATCH_GROUPS ? (enum patch_group)group : PATCH_ORDINARY, f);
    if (group == AROUND || group == FAR)
        draw_around(stream, f, group == AROUND ? 1 : draw_power(stream, 0, 2));
    if (group == BESIDE)
        draw_over_border(stream, f);
    for (int v = 0; group == OFFSET && v < VECTORS; v++)
        for (int i = 0; i < 3 && (v < 4 || v == 8); i++)
            f->x[v][i] += 1e6 * (i + 1);
}

/* ---- tests ---- */

static long cases(int group)
{
    const bool is_dear = group == PATCH_SLIVER || group == PATCH_WILD; /* for the judge */
    return long_cases(CASES, is_dear ? CASES_LONG / 10 : CASES_LONG);
}

static void expect(const struct function *f, const char *group, const struct patch_case *p, struct judged *j,
                   int status, const double loc[2], double dist, int region)
{
    const char *const wrong = status < FOOTPOINT_OK ? NULL : fault(j, f->promise, status, loc, dist, region);
    if (wrong) {
        for (int v = 0; v < VECTORS; v++)
            print_error("{%a, %a, %a},\n", p->x[v][0], p->x[v][1], p->x[v][2]);
        if (j->known)
            print_error("nearest (%.17g, %.17g), %.17g\n", (double)j->at[0], (double)j->at[1],
                        sqrt(2 * (double)j->least) * j->unit);
        fail_msg("%s, %s: status %d at (%.17g, %.17g), distance %.17g, region %d: %s", f->name, group, status, loc[0],
                 loc[1], dist, region, wrong);
    }
}

static int call(const struct function *f, const struct patch_case *p, double loc[2], double *dist, int *region)
{
    const double *x[VECTORS];
    for (int v = 0; v < VECTORS; v++)
        x[v] = p->x[v];
    return f->one(x, loc, dist, region);
}

/* What all functions of its kind answer to one case; adds up statuses, indexed by function. */
static void judge(const char *group, const struct patch_case *p, long count[FUNCTIONS][ANSWERS])
{
    struct judged j;
    take(p, &j);
    for (int i = 0; i < FUNCTIONS; i++) {
        double loc[2] = {NOT_HERE, NOT_HERE}, dist = NOT_HERE;
        int region = 7;
        if (functions[i].kind != p->kind)
            continue;
        const int status = call(&functions[i], p, loc, &dist, &region);
        if (status < FOOTPOINT_OK)
            assert_true(loc[0] == NOT_HERE && loc[1] == NOT_HERE && dist == NOT_HERE && region == 7);
        expect(&functions[i], group, p, &j, status, loc, dist, region);
        count[i][status < FOOTPOINT_OK ? ANSWERS - 1 : status]++;
    }
}

/* % that must be proved to 1e-7 or less finely */
static const double proved_least[GROUPS] = {99, 50, 30, 90, 0, 90, 0, 90, 0, 90};

static void closest_points_keep_the_promise(void **state)
{
    (void)state;
    for (int group = 0; group < GROUPS; group++) {
        long count[FUNCTIONS][ANSWERS] = {{0}};
        for (int k = 0; k < KINDS; k++) {
            uint64_t stream = 6464 + (uint64_t)(10 * group + k);
            for (long i = 0; i < cases(group); i++) {
                struct patch_case f = {.kind = k};
                draw(&stream, group, &f);
                judge(names[group], &f, count);
            }
        }
        for (int i = 0; i < FUNCTIONS; i++) {
            const long *c = count[i], answers = c[FOOTPOINT_OK] + c[FOOTPOINT_NOT_UNIQUE] + c[FOOTPOINT_UNPROVED];
            const double proved = 100 * (double)c[FOOTPOINT_OK] / (double)(answers ? answers : 1);
            if (cases(group) != CASES)
                print_message("%-22s %-15s OK %8.4f %% of %ld, ties %ld, unproved %ld, errors %ld\n", functions[i].name,
                              names[group], proved, answers, c[FOOTPOINT_NOT_UNIQUE], c[FOOTPOINT_UNPROVED],
                              c[ANSWERS - 1]);
            else if (functions[i].promise > 1e-8 && proved < proved_least[group])
                fail_msg("%s, %s: %ld of %ld proved", functions[i].name, names[group], c[0], answers);
        }
    }
}

/* A closest point 1e-11 from a corner, on an edge. */
static void corners_are_no_answer_beside_them(void **state)
{
    (void)state;
    static const struct patch_case beside = {
        .kind = 1,
        .x = {{0x1.c460c6d711ceep-1, -0x1.1e6e3cc1e3d17p+3, -0x1.034b7f07cb398p-1},
              {-0x1.6bd0dac2c0535p-1, -0x1.12101697c37b4p+3, -0x1.1d6f03fb394ffp+1},
              {0x1.af967f14e533fp-1, -0x1.4f9d571c75ac2p+3, -0x1.b6d347a87113ap+1},
              {0x1.ef09e22a570c4p+0, -0x1.57d8002bd4e35p+3, -0x1.20f78d0f199eep+1},
              {-0x1.3ffea85b08ddp-1, -0x1.3a451049aa9b4p-1, 0x1.ede3de9164ae2p-2},
              {-0x1.5972a3470e888p-1, -0x1.315af3631dbc4p-1, 0x1.bd46fd959afeap-2},
              {-0x1.292df5b9a33f9p-1, -0x1.823077274306p-1, 0x1.3a3c882d0c10ep-2},
              {-0x1.d7d0ec877fc48p-2, -0x1.a5b5d4ab9d302p-1, 0x1.52897bbe8002cp-2},
              {0x1.93ab848f0f513p-1, -0x1.51e1d0d43459ap+3, -0x1.b322a1aec6636p+1}}};
    long count[FUNCTIONS][ANSWERS] = {{0}};
    judge("beside a corner", &beside, count);
}

/* Draws n cases of a kind, of all groups by turns. */
static void draw_all(int kind, int n, struct patch_case *f)
{
    uint64_t stream = 64;
    for (int i = 0; i < n; i++) {
        f[i].kind = kind;
        draw(&stream, i % GROUPS, &f[i]);
    }
}

/* In arrays the same answers as alone, to the bit, but for rounding where compilers fuse operations. */
static void arrays_match_single_calls(void **state)
{
    static struct patch_case p[PAIRS];
    static double column[3 * VECTORS][PAIRS], xi[PAIRS], eta[PAIRS], dist[PAIRS];
    static int region[PAIRS], status[PAIRS];
    (void)state;
    for (int f = 0; f < FUNCTIONS; f++) {
        const double *x[3 * VECTORS];
        draw_all(functions[f].kind, PAIRS, p);
        for (int k = 0; k < 3 * VECTORS; k++) {
            x[k] = column[k];
            for (int i = 0; i < PAIRS; i++)
                column[k][i] = p[i].x[k / 3][k % 3];
        }
        functions[f].many(PAIRS, x, xi, eta, dist, region, status);
        for (int i = 0; i < PAIRS; i++) {
            double loc[2], d;
            int where;
            const int alone = call(&functions[f], &p[i], loc, &d, &where);
#ifndef __FMA__
            assert_int_equal(status[i], alone);
            if (alone >= FOOTPOINT_OK)
                assert_true(loc[0] == xi[i] && loc[1] == eta[i] && d == dist[i] && where == region[i]);
#else
            const double found[2] = {xi[i], eta[i]};
            struct judged j;
            take(&p[i], &j);
            expect(&functions[f], "in an array", &p[i], &j, status[i], found, dist[i], region[i]);
            (void)alone;
#endif
        }
    }
}

/* Of several patches: OK only if no point of any is nearer. */
static void the_nearest_of_several_patches_is_proved(void **state)
{
    static struct patch_case p[PAIRS];
    (void)state;
    for (int f = 0; f < FUNCTIONS; f++) {
        draw_all(functions[f].kind, PAIRS, p);
        for (int i = 0; i + SEVERAL <= PAIRS; i += 2) {
            const double *x[(VECTORS - 1) * SEVERAL], *const xs = p[i].x[8];
            struct judged j[SEVERAL];
            double loc[2], dist;
            int region;
            size_t which;
            for (int k = 0; k < (VECTORS - 1) * SEVERAL; k++)
                x[k] = p[i + k / (VECTORS - 1)].x[k % (VECTORS - 1)];
            if (functions[f].of_many(SEVERAL, x, xs, loc, &dist, &region, &which) != FOOTPOINT_OK)
                continue;
            for (int k = 0; k < SEVERAL; k++) {
                struct patch_case face = p[i + k];
                memcpy(face.x[8], xs, sizeof face.x[8]);
                take(&face, &j[k]);
            }
            expect(&functions[f], "of several", &p[i], &j[which], FOOTPOINT_OK, loc, dist, region);
            for (size_t k = 0; k < SEVERAL; k++) { /* a patch that has no answer is passed over */
                double at[2], d;
                int where;
                if (call(&functions[f], &j[k].patch, at, &d, &where) < FOOTPOINT_OK)
                    continue;
                if (!j[k].known)
                    find_nearest(&j[k]);
                /* by as much as the promise may make of the distance of the patch that is chosen */
                const double least = sqrt(2 * (double)j[k].least) * j[k].unit;
                const double off =
                    1e-13 * (j[k].unit + fabs(dist)) + 8 * functions[f].promise * j[which].longest * j[which].unit;
                if (least < fabs(dist) - off)
                    fail_msg("%s, case %d: patch %zu at %.17g, %zu is nearer", functions[f].name, i, which, dist, k);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_points_keep_the_promise),
        cmocka_unit_test(corners_are_no_answer_beside_them),
        cmocka_unit_test(arrays_match_single_calls),
        cmocka_unit_test(the_nearest_of_several_patches_is_proved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
