/* What a caller pays on faces of six, eight and nine nodes, one search at a time: bare (NAME_at), checked (NAME), closest
 * points (NAME_closest) beside the library's iteration that CalculiX calls (attach_2d), which is certain, and along a direction
 * (PREFIX_along) beside Newton in three unknowns until it stands; checked over arrays (NAME_checked_n) beside NAME.
 * Interleaved in one run; prints lines
 *     call,ns,ratio     ns: least a search; ratio: that of the rival / this one's; of NAME, over NAME_at
 * The headers are compiled with this file's flags; tests/timed/calls.sh runs it. */
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri6.h"
#include "../../runtime/geometry/footpoint-quad8-geometry.h"
#include "../../runtime/geometry/footpoint-quad9-geometry.h"
#include "../../runtime/geometry/footpoint-tri6-geometry.h"
#include "../hard/draw.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

void attach_2d_(const double pneigh[9][3], double pnode[3], const int *nterms, double ratio[9], double *dist,
                double *xil, double *etl);

enum { CASES = 1000, ROUNDS = 200, STEPS = 50 };

static double x[CASES][10][3], beside[CASES][3], direction[CASES][3], loc[CASES][2], dist[CASES];
static double column[30][CASES], xi[CASES], eta[CASES];
static const double *columns[30];
static int region[CASES], status[CASES];

/* Nodes 0 to 8 of a square and a triangle's six. */
static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};

/* Faces a little bent; slave nodes over them, every other one beside. */
static void draw_faces(int nodes)
{
    uint64_t stream = (uint64_t)nodes;
    for (int i = 0; i < CASES; i++) {
        for (int k = 0; k < nodes; k++)
            for (int j = 0; j < 3; j++)
                x[i][k][j] = (j == 2       ? 0
                              : nodes == 6 ? triangle[k][j]
                                           : square[k][j]) +
                             draw_flat(&stream, -0.05, 0.05);
        for (int j = 0; j < 3; j++) {
            const double at = j == 2 ? draw_flat(&stream, -0.2, 0.2) : draw_flat(&stream, -0.9, 0.9);
            x[i][nodes][j] = nodes == 6 && j < 2 ? 0.3 + 0.25 * at : at;
            beside[i][j] = x[i][nodes][j] + (i % 2 && j < 2 ? draw_flat(&stream, -1, 1) : 0);
            direction[i][j] = (j == 2) + draw_flat(&stream, -0.3, 0.3);
        }
        for (int c = 0; c <= 3 * nodes + 2; c++) {
            column[c][i] = x[i][c / 3][c % 3];
            columns[c] = column[c];
        }
    }
}

/* Newton in xi, eta and the distance. */
static int newton_along(int nodes, void shape(double, double, double *), double (*node)[3], const double *p,
                        double at[3])
{
    double step = HUGE_VAL, phi[54], length = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    at[0] = at[1] = nodes == 6 ? 1.0 / 3 : 0;
    at[2] = 0;
    for (int n = 0; n < STEPS && step > 1e-10; n++) {
        double u[3] = {0}, v[3] = {0}, f[3], m[3], k[3], g[3];
        shape(at[0], at[1], phi);
        for (int i = 0; i < 3; i++) {
            f[i] = node[nodes][i] - at[2] * p[i] / length;
            for (int a = 0; a < nodes; a++) {
                f[i] -= phi[a] * node[a][i];
                u[i] += phi[nodes + a] * node[a][i];
                v[i] += phi[2 * nodes + a] * node[a][i];
            }
        }
        for (int i = 0; i < 3; i++) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            m[i] = v[a] * p[b] - v[b] * p[a];
            k[i] = p[a] * u[b] - p[b] * u[a];
            g[i] = u[a] * v[b] - u[b] * v[a];
        }
        const double over = 1 / (u[0] * m[0] + u[1] * m[1] + u[2] * m[2]);
        const double du = over * (f[0] * m[0] + f[1] * m[1] + f[2] * m[2]);
        const double dv = over * (f[0] * k[0] + f[1] * k[1] + f[2] * k[2]);
        at[0] += du;
        at[1] += dv;
        at[2] += over * length * (f[0] * g[0] + f[1] * g[1] + f[2] * g[2]);
        step = fabs(du) + fabs(dv);
    }
    return step <= 1e-10 ? FOOTPOINT_OK : FOOTPOINT_ERR_NO_CONVERGENCE;
}

#define NODES6(i) x[i][0], x[i][1], x[i][2], x[i][3], x[i][4], x[i][5]
#define NODES8(i) NODES6(i), x[i][6], x[i][7]
#define NODES9(i) NODES8(i), x[i][8]
#define EACH(...)                                                                                                      \
    for (int i = 0; i < CASES; i++)                                                                                    \
    __VA_ARGS__
#define CALLS(nodes, kind, name)                                                                                       \
    static void kind##_at(void)                                                                                        \
    {                                                                                                                  \
        EACH(footpoint_##kind##_##name##_at(NODES##nodes(i), x[i][nodes], &loc[i][0], &loc[i][1]);)                    \
    }                                                                                                                  \
    static void kind(void)                                                                                             \
    {                                                                                                                  \
        EACH(status[i] = footpoint_##kind##_##name(NODES##nodes(i), x[i][nodes], loc[i], &dist[i]);)                   \
    }                                                                                                                  \
    static void kind##_closest(void)                                                                                   \
    {                                                                                                                  \
        EACH(status[i] =                                                                                               \
                 footpoint_##kind##_##name##_closest(NODES##nodes(i), beside[i], loc[i], &dist[i], &region[i]);)       \
    }                                                                                                                  \
    static void kind##_attach(void)                                                                                    \
    {                                                                                                                  \
        const int count = nodes;                                                                                       \
        EACH({                                                                                                         \
            double node[3] = {beside[i][0], beside[i][1], beside[i][2]}, ratio[9];                                     \
            attach_2d_((const double(*)[3])x[i], node, &count, ratio, &dist[i], &loc[i][0], &loc[i][1]);               \
        })                                                                                                             \
    }                                                                                                                  \
    static void kind##_along(void)                                                                                     \
    {                                                                                                                  \
        EACH(status[i] = footpoint_##kind##_along(NODES##nodes(i), x[i][nodes], direction[i], loc[i], &dist[i]);)      \
    }                                                                                                                  \
    static void kind##_newton(void)                                                                                    \
    {                                                                                                                  \
        EACH({                                                                                                         \
            double at[3];                                                                                              \
            status[i] = newton_along(nodes, footpoint_##kind##_shape, x[i], direction[i], at);                         \
            dist[i] = at[2];                                                                                           \
        })                                                                                                             \
    }                                                                                                                  \
    static void kind##_checked_n(void)                                                                                 \
    {                                                                                                                  \
        footpoint_##kind##_##name##_checked_n(CASES, columns, xi, eta, dist, status);                                  \
    }
CALLS(6, tri6, accurate)
CALLS(8, quad8, sharp)
CALLS(9, quad9, sharp)

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

#define ROWS(nodes, kind)                                                                                              \
    {                                                                                                                  \
        nodes, {#kind "_at",           #kind,          #kind "_attach_2d", #kind "_closest",                           \
                #kind "_newton_along", #kind "_along", #kind "_checked_n"},                                            \
        {                                                                                                              \
            kind##_at, kind, kind##_attach, kind##_closest, kind##_newton, kind##_along, kind##_checked_n              \
        }                                                                                                              \
    }
enum { CALL_COUNT = 7 };
static const struct rows {
    int nodes;
    const char *name[CALL_COUNT];
    void (*run[CALL_COUNT])(void);
} kinds[] = {ROWS(6, tri6), ROWS(8, quad8), ROWS(9, quad9)};

int main(void)
{
    puts("call,ns,ratio");
    for (int k = 0; k < 3; k++) {
        double least[CALL_COUNT];
        draw_faces(kinds[k].nodes);
        for (int c = 0; c < CALL_COUNT; c++)
            least[c] = HUGE_VAL;
        for (int round = 0; round < ROUNDS; round++)
            for (int c = 0; c < CALL_COUNT; c++) {
                const double start = seconds();
                if (kinds[k].nodes != 9 || c != 2) /* attach_2d knows no faces of nine nodes */
                    kinds[k].run[c]();
                least[c] = fmin(least[c], seconds() - start);
            }
        for (int c = 0; c < CALL_COUNT; c++)
            if (kinds[k].nodes != 9 || c != 2) {
                const double before = least[c == 6 ? 1
                                            : c    ? c - 1
                                                   : 0],
                             ratio = c == 1 ? least[c] / before : before / least[c];
                printf("%s,%.1f,", kinds[k].name[c], 1e9 * least[c] / CASES);
                if ((c % 2 || c == 6) && (c != 3 || kinds[k].nodes != 9))
                    printf("%.2f", ratio);
                puts("");
            }
    }
    return 0;
}
