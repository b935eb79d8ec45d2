/* What a caller pays: functions of generated/footpoint_quad4.h bare (NAME_at), checked with gap and status (NAME) and
 * over arrays (NAME_n, NAME_checked_n), and the library's checked searches, beside Newton's iteration until it stands, written by hand,
 * bare and with the same checks; and closest points of the closed face (NAME_closest, NAME_closest_n) beside four
 * triangles about the centroid; and projection along a direction (footpoint_quad4_along, _along_n), 0.3 off the normal
 * at most, beside Newton in three unknowns; and, a search each, eight slave nodes over one segment (NAME_over_n) beside
 * one call of NAME each, and the nearest of four faces (NAME_closest_of) beside four triangles of each.  Interleaved in one run on ordinary segments, for closest points every other slave node
 * moved up to an edge beside its segment; prints lines
 *     call,ns,ratio,off,bare   ns: least a search; ratio: Newton's ns / this one's, checked beside checked, or four
 *                         triangles', one at a time or in a loop over the same arrays; off: of closest points and
 *                         along a direction, worst error of the distance over the longest edge; bare: ns over that of the same search unchecked,
 *                         of _over_n over that of one call each
 * The header and Newton are compiled with this file's flags; tests/timed/calls.sh runs it. */
#include "../../generated/footpoint_quad4.h"
#include "../../runtime/footpoint.h"
#include "../hard/draw.h"
#include "../hard/hard.h"
#include "../rivals/along_newton.h"
#include "../rivals/four_triangles.h"
#include "../rivals/rivals_converged.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* No power of 2: columns that begin at the same places of the cache would drive each other out. */
enum { CASES = 2000, ROUNDS = 400, STEPS = 50 };

static struct hard_case cases[CASES];
static double column[15][CASES], xyz[5 * CASES][3], loc[CASES][2], xi[CASES], eta[CASES], gap[CASES];
static const double *columns[15];
static double beside_column[15][CASES], beside[5 * CASES][3], dist[CASES], point[CASES][3];
static const double *beside_columns[15];
static int region[CASES];
static double direction[CASES][3], direction_column[3][CASES];
static const double *const directions[3] = {direction_column[0], direction_column[1], direction_column[2]};
static int seg[CASES][4], slave[CASES], status[CASES];

#define NODES(i) xyz[5 * (i)], xyz[5 * (i) + 1], xyz[5 * (i) + 2], xyz[5 * (i) + 3], xyz[5 * (i) + 4]

static void newton_at(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = rival_newton(NODES(i), STEPS, RIVAL_NEWTON_TOLERANCE, &xi[i], &eta[i]) == 0;
}

/* With status and gap along the normal, as a caller of NAME gets them: written by hand. */
static int newton_one(const double *const x[5], double *u, double *v, double *distance)
{
    double n[3], a[3], b[3], d[3], area = 0, finite = 0;
    for (int k = 0; k < 5; k++)
        for (int j = 0; j < 3; j++)
            finite += x[k][j] - x[k][j];
    if (!rival_newton(x[0], x[1], x[2], x[3], x[4], STEPS, RIVAL_NEWTON_TOLERANCE, u, v))
        return finite == 0 ? FOOTPOINT_ERR_NO_CONVERGENCE : FOOTPOINT_ERR_NOT_FINITE;
    for (int j = 0; j < 3; j++) {
        const double ab = x[1][j] - x[0][j], ad = x[3][j] - x[0][j], m = x[2][j] - x[3][j] - ab;
        const double s = 0.5 + 0.5 * *u, t = 0.5 + 0.5 * *v;
        a[j] = ab + t * m;
        b[j] = ad + s * m;
        d[j] = x[4][j] - x[0][j] - s * ab - t * b[j];
    }
    for (int j = 0; j < 3; j++) {
        n[j] = a[(j + 1) % 3] * b[(j + 2) % 3] - a[(j + 2) % 3] * b[(j + 1) % 3];
        area += n[j] * n[j];
    }
    *distance = (d[0] * n[0] + d[1] * n[1] + d[2] * n[2]) / sqrt(area);
    return finite != 0 ? FOOTPOINT_ERR_NOT_FINITE : area > 0 ? FOOTPOINT_OK : FOOTPOINT_ERR_DEGENERATE;
}

static void newton(void)
{
    for (int i = 0; i < CASES; i++) {
        const double *const nodes[5] = {NODES(i)};
        double u, v, g;
        status[i] = newton_one(nodes, &u, &v, &g);
        if (status[i] == FOOTPOINT_OK) {
            loc[i][0] = u;
            loc[i][1] = v;
            gap[i] = g;
        }
    }
}

#define TIER(name)                                                                                                     \
    static void name##_at(void)                                                                                        \
    {                                                                                                                  \
        for (int i = 0; i < CASES; i++)                                                                                \
            footpoint_quad4_##name##_at(NODES(i), &xi[i], &eta[i]);                                                    \
    }                                                                                                                  \
    static void name(void)                                                                                             \
    {                                                                                                                  \
        for (int i = 0; i < CASES; i++)                                                                                \
            status[i] = footpoint_quad4_##name(NODES(i), loc[i], &gap[i]);                                             \
    }                                                                                                                  \
    static void name##_n(void)                                                                                         \
    {                                                                                                                  \
        footpoint_quad4_##name##_n(CASES, columns, xi, eta);                                                           \
    }                                                                                                                  \
    static void name##_checked_n(void)                                                                                 \
    {                                                                                                                  \
        footpoint_quad4_##name##_checked_n(CASES, columns, xi, eta, gap, status);                                      \
    }
TIER(fast)
TIER(coarse)
TIER(gauss2)
TIER(medium)
TIER(balanced)
TIER(fine)
TIER(precise)
TIER(accurate)
TIER(full)

/* Closest points. */
#define BESIDE(i) beside[5 * (i)], beside[5 * (i) + 1], beside[5 * (i) + 2], beside[5 * (i) + 3], beside[5 * (i) + 4]

static void four_triangles(void)
{
    for (int i = 0; i < CASES; i++) {
        const double *const x[5] = {BESIDE(i)};
        dist[i] = sqrt(rival_four_triangles(x, x[4], point[i]));
    }
}

static void four_triangles_n(void)
{
    for (int i = 0; i < CASES; i++) {
        double p[5][3];
        const double *const x[4] = {p[0], p[1], p[2], p[3]};
        for (int k = 0; k < 15; k++)
            p[k / 3][k % 3] = beside_columns[k][i];
        dist[i] = sqrt(rival_four_triangles(x, p[4], point[i]));
    }
}

static void robust_closest(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = footpoint_robust(BESIDE(i), loc[i], &dist[i]);
}

#define CLOSEST(name)                                                                                                  \
    static void name##_closest(void)                                                                                   \
    {                                                                                                                  \
        for (int i = 0; i < CASES; i++)                                                                                \
            status[i] = footpoint_quad4_##name##_closest(BESIDE(i), loc[i], &dist[i], &region[i]);                     \
    }                                                                                                                  \
    static void name##_closest_n(void)                                                                                 \
    {                                                                                                                  \
        footpoint_quad4_##name##_closest_n(CASES, beside_columns, xi, eta, dist, region, status);                      \
    }
CLOSEST(fast)
CLOSEST(coarse)
CLOSEST(gauss2)
CLOSEST(medium)
CLOSEST(balanced)
CLOSEST(fine)
CLOSEST(precise)
CLOSEST(accurate)
CLOSEST(full)

/* Along a direction. */
static void newton_along(void)
{
    for (int i = 0; i < CASES; i++) {
        const double *const x[5] = {NODES(i)};
        double at[3];
        status[i] = rival_along_newton(x, direction[i], STEPS, RIVAL_NEWTON_TOLERANCE, at)
                        ? FOOTPOINT_OK
                        : FOOTPOINT_ERR_NO_CONVERGENCE;
        loc[i][0] = at[0];
        loc[i][1] = at[1];
        dist[i] = at[2];
    }
}

static void newton_along_n(void)
{
    for (int i = 0; i < CASES; i++) {
        double p[5][3], at[3];
        const double *const x[5] = {p[0], p[1], p[2], p[3], p[4]};
        for (int k = 0; k < 15; k++)
            p[k / 3][k % 3] = column[k][i];
        status[i] = rival_along_newton(x, direction[i], STEPS, RIVAL_NEWTON_TOLERANCE, at)
                        ? FOOTPOINT_OK
                        : FOOTPOINT_ERR_NO_CONVERGENCE;
        xi[i] = at[0];
        eta[i] = at[1];
        dist[i] = at[2];
    }
}

static void along(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = footpoint_quad4_along(NODES(i), direction[i], loc[i], &dist[i]);
}

static void along_n(void)
{
    footpoint_quad4_along_n(CASES, columns, directions, xi, eta, dist, status);
}

/* Eight slave nodes over one segment, and four faces for one slave node. */
enum { AROUND = 8, FACES = 4 };
static double around[CASES][3], around_column[CASES / AROUND][3][AROUND];
static size_t which[CASES];

#define CORNERS(i) xyz[5 * (i)], xyz[5 * (i) + 1], xyz[5 * (i) + 2], xyz[5 * (i) + 3]
#define AROUND_ONE(name)                                                                                               \
    static void name##_each(void)                                                                                      \
    {                                                                                                                  \
        for (int i = 0; i < CASES; i++)                                                                                \
            status[i] = footpoint_quad4_##name(CORNERS(i / AROUND), around[i], loc[i], &gap[i]);                       \
    }                                                                                                                  \
    static void name##_over_n(void)                                                                                    \
    {                                                                                                                  \
        for (int i = 0; i < CASES / AROUND; i++) {                                                                     \
            const double *const nodes[4] = {CORNERS(i)};                                                               \
            const double *const x[3] = {around_column[i][0], around_column[i][1], around_column[i][2]};                \
            const int k = i * AROUND;                                                                                  \
            footpoint_quad4_##name##_over_n(nodes, AROUND, x, xi + k, eta + k, gap + k, status + k);                   \
        }                                                                                                              \
    }
AROUND_ONE(balanced)
AROUND_ONE(accurate)

#define CLOSEST_OF(name)                                                                                               \
    static void name##_closest_of(void)                                                                                \
    {                                                                                                                  \
        for (int i = 0; i < CASES / FACES; i++) {                                                                      \
            const double *x[4 * FACES];                                                                                \
            for (int k = 0; k < 4 * FACES; k++)                                                                        \
                x[k] = xyz[5 * (FACES * i + k / 4) + k % 4];                                                           \
            status[i] = footpoint_quad4_##name##_closest_of(FACES, x, xyz[5 * FACES * i + 4], loc[i], &dist[i],        \
                                                            &region[i], &which[i]);                                    \
        }                                                                                                              \
    }
CLOSEST_OF(coarse)
CLOSEST_OF(accurate)

/* Slave nodes about those of the segments. */
static void draw_around(void)
{
    uint64_t stream = 3;
    for (int i = 0; i < CASES; i++) {
        const int segment = 5 * (i / AROUND);
        const double u = draw_flat(&stream, -0.3, 0.3), v = draw_flat(&stream, -0.3, 0.3);
        for (int j = 0; j < 3; j++)
            around_column[i / AROUND][j][i % AROUND] = around[i][j] = xyz[segment + 4][j] +
                                                                      u * (xyz[segment + 1][j] - xyz[segment][j]) +
                                                                      v * (xyz[segment + 3][j] - xyz[segment][j]);
    }
}

static void call_locate(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = footpoint_locate(NODES(i), loc[i], &gap[i]);
}

static void call_locate_pairs(void)
{
    (void)footpoint_locate_pairs(CASES, xyz[0], (size_t)5 * CASES, seg[0], slave, loc[0], gap, status);
}

static void call_robust(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = footpoint_robust(NODES(i), loc[i], &gap[i]);
}

/* clang-format off */
#define ROW(name, against) {#name, name, against, 0}
#define CHECKED(name, before) {#name, name, 1, before}
#define ROWS(name) ROW(name##_at, 0), CHECKED(name, 1), ROW(name##_n, 0), CHECKED(name##_checked_n, 1)
#define ROWS_AROUND(name) {#name "_each", name##_each, 1, 0}, {#name "_over_n", name##_over_n, 1, 1}
#define ROWS_CLOSEST(name) ROW(name##_closest, FOUR), ROW(name##_closest_n, FOUR + 1)
/* clang-format on */
enum { FOUR = 2, ALONG = 4 };
static const struct call {
    const char *name;
    void (*run)(void);
    int against; /* row that it is compared with */
    int bare;    /* the bare search is so many rows before this one; 0: there is none */
} calls[] = {
    ROW(newton_at, 0),
    ROW(newton, 1),
    ROW(four_triangles, FOUR),
    ROW(four_triangles_n, FOUR + 1),
    ROW(newton_along, ALONG),
    ROW(newton_along_n, ALONG + 1),
    ROW(along, ALONG),
    ROW(along_n, ALONG + 1),
    ROWS(fast),
    ROWS(coarse),
    ROWS(gauss2),
    ROWS(medium),
    ROWS(balanced),
    ROWS(fine),
    ROWS(precise),
    ROWS(accurate),
    ROWS(full),
    {"footpoint_locate", call_locate, 1, 0},
    {"footpoint_locate_pairs", call_locate_pairs, 1, 0},
    {"footpoint_robust", call_robust, 1, 0},
    ROWS_CLOSEST(fast),
    ROWS_CLOSEST(coarse),
    ROWS_CLOSEST(gauss2),
    ROWS_CLOSEST(medium),
    ROWS_CLOSEST(balanced),
    ROWS_CLOSEST(fine),
    ROWS_CLOSEST(precise),
    ROWS_CLOSEST(accurate),
    ROWS_CLOSEST(full),
    ROW(robust_closest, FOUR),
    ROWS_AROUND(balanced),
    ROWS_AROUND(accurate),
    {"coarse_closest_of", coarse_closest_of, FOUR, 0},
    {"accurate_closest_of", accurate_closest_of, FOUR, 0},
};
enum { CALLS = sizeof calls / sizeof *calls };

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Every other slave node up to an edge beside its segment. */
static void move_beside(void)
{
    uint64_t stream = 1;
    memcpy(beside, xyz, sizeof beside);
    for (int i = 0; i < CASES; i++) {
        const double u = draw_flat(&stream, -1, 1), v = draw_flat(&stream, -1, 1);
        for (int j = 0; i % 2 && j < 3; j++)
            beside[5 * i + 4][j] += u * (xyz[5 * i + 1][j] - xyz[5 * i][j]) + v * (xyz[5 * i + 3][j] - xyz[5 * i][j]);
        for (int k = 0; k < 15; k++)
            beside_column[k][i] = beside[5 * i + k / 3][k % 3];
    }
}

/* Unit vectors near the normals of the segments. */
static void draw_directions(void)
{
    uint64_t stream = 2;
    for (int i = 0; i < CASES; i++) {
        double n[3], length = 0, turned = 0;
        for (int j = 0; j < 3; j++) {
            const int a = (j + 1) % 3, b = (j + 2) % 3;
            n[j] = (xyz[5 * i + 2][a] - xyz[5 * i][a]) * (xyz[5 * i + 3][b] - xyz[5 * i + 1][b]) -
                   (xyz[5 * i + 2][b] - xyz[5 * i][b]) * (xyz[5 * i + 3][a] - xyz[5 * i + 1][a]);
            length += n[j] * n[j];
        }
        for (int j = 0; j < 3; j++) {
            direction[i][j] = n[j] / sqrt(length) + 0.3 * draw_flat(&stream, -1, 1);
            turned += direction[i][j] * direction[i][j];
        }
        for (int j = 0; j < 3; j++)
            direction_column[j][i] = direction[i][j] /= sqrt(turned);
    }
}

/* Distances along a direction against those of Newton, where that has ended at the same point; over the longest edge. */
static double worst_along(const struct call *call)
{
    double worst = 0;
    call->run();
    for (int i = 0; i < CASES; i++) {
        const double *const x[5] = {NODES(i)};
        double at[3], longest = 0;
        const int known = rival_along_newton(x, direction[i], STEPS, 1e-14, at);
        for (int j = 0; j < 3; j++)
            longest = fmax(longest, fabs(xyz[5 * i + 2][j] - xyz[5 * i][j]));
        if (known && status[i] >= FOOTPOINT_OK)
            worst = fmax(worst, fabs(dist[i] - at[2]) / longest);
    }
    return worst;
}

/* Worst error of the distances that a call has left, over the longest edge, where the call has an answer. */
static double worst_distance(const struct call *call)
{
    double worst = 0;
    memset(status, 0, sizeof status);
    call->run();
    for (int i = 0; i < CASES; i++) {
        double certain, at[2], longest = 0;
        const int known = footpoint_robust(BESIDE(i), at, &certain);
        for (int k = 0; k < 4; k++) {
            double square = 0;
            for (int j = 0; j < 3; j++)
                square += pow(beside[5 * i + (k + 1) % 4][j] - beside[5 * i + k][j], 2);
            longest = fmax(longest, sqrt(square));
        }
        if ((status[i] == FOOTPOINT_OK || status[i] == FOOTPOINT_OUTSIDE) &&
            (known == FOOTPOINT_OK || known == FOOTPOINT_OUTSIDE))
            worst = fmax(worst, fabs(fabs(dist[i]) - fabs(certain)) / longest);
    }
    return worst;
}

int main(void)
{
    double least[CALLS];
    for (int i = 0; i < CASES; i++) {
        hard_draw(0, 1, (uint64_t)i, &cases[i]);
        for (int k = 0; k < 5; k++)
            for (int j = 0; j < 3; j++)
                xyz[5 * i + k][j] = column[3 * k + j][i] = cases[i].x[k][j];
        for (int k = 0; k < 4; k++)
            seg[i][k] = 5 * i + k;
        slave[i] = 5 * i + 4;
    }
    move_beside();
    draw_directions();
    draw_around();
    for (int k = 0; k < 15; k++) {
        columns[k] = column[k];
        beside_columns[k] = beside_column[k];
    }
    for (int c = 0; c < CALLS; c++)
        least[c] = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++)
        for (int c = 0; c < CALLS; c++) {
            const double start = seconds();
            calls[c].run();
            least[c] = fmin(least[c], seconds() - start);
        }
    printf("call,ns,ratio,off,bare\n");
    for (int c = 0; c < CALLS; c++) {
        printf("%s,%.1f,%.1f,", calls[c].name, 1e9 * least[c] / CASES, least[calls[c].against] / least[c]);
        if (calls[c].against >= FOUR && !strstr(calls[c].name, "_of"))
            printf("%.1e", calls[c].against >= ALONG ? worst_along(&calls[c]) : worst_distance(&calls[c]));
        if (calls[c].bare)
            printf(",%.2f\n", least[c] / least[c - calls[c].bare]);
        else
            printf(",\n");
    }
    return 0;
}
