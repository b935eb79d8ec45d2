// Times the adapters of runtime/replace/ beside our equivalents of the searches that they replace. These are written
// from the published codes, with their starts, steps and tolerances, without the surrounding finite element objects,
// lists and messages. Four-node segments are drawn as ordinary ones by tests/hard/draw.h, with gaps up to 0.2 of the
// shortest edge; calls are single and interleaved in one run. Prints lines
//     code,theirs,ours,ratio,off_theirs,off_ours    ns a call; theirs over ours; worst error of xi, eta over the cases
// The adapters in Fortran are measured by their library calls. tests/timed/replace_times.sh runs this program.
#include "../../runtime/footpoint.h"
#include "../rivals/four_triangles.h"
extern "C" {
#include "../hard/draw.h"
#include "../hard/hard.h"
}

#include <cmath>
#include <cstdio>
#include <ctime>

namespace tribol
{
using RealT = double;
}
#define SLIC_ERROR_IF(what, text)                                                                                      \
    if (what)                                                                                                          \
        return;
#include "../../runtime/replace/arborx.hpp"
#include "../../runtime/replace/nimblesm.hpp"
#include "../../runtime/replace/tribol.hpp"

enum { CASES = 2000, ROUNDS = 100 };

static hard_case cases[CASES];
static double nodes[CASES][5][3], tribols[CASES][3][4], exact[CASES][2], at[CASES][2], gap[CASES];
static int faces[CASES][4], slaves[CASES];

// ---- their searches ----

struct newton {
    int least_squares;   // steps without second derivatives, from the middle
    double until;        // these steps end at an update of this length
    int most;            // most steps
    double tolerance;    // of an update
    bool sum, shortened; // the update is |du| + |dv|; steps that lead farther away are shortened
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Computes the vector from r(u, v) to the slave node, and the tangents there, from shape functions.
static void place(const double x[5][3], double u, double v, double way[3], double tu[3], double tv[3])
{
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int k = 0; k < 3; k++) {
        way[k] = x[4][k];
        tu[k] = tv[k] = 0;
    }
    for (int i = 0; i < 4; i++) {
        const double a = 1 + corner[i][0] * u, b = 1 + corner[i][1] * v;
        for (int k = 0; k < 3; k++) {
            way[k] -= 0.25 * a * b * x[i][k];
            tu[k] += 0.25 * corner[i][0] * b * x[i][k];
            tv[k] += 0.25 * a * corner[i][1] * x[i][k];
        }
    }
}

static bool search(const newton &n, const double x[5][3], double loc[2], double tu[3], double tv[3], double way[3])
{
    double u = 0, v = 0, twist[3], size = 1;
    for (int k = 0; k < 3; k++)
        twist[k] = 0.25 * (x[0][k] - x[1][k] + x[2][k] - x[3][k]);
    bool plain = n.least_squares > 0, good = false;
    for (int step = 0; step < n.most && !good; step++) {
        place(x, u, v, way, tu, tv);
        plain = plain && step < n.least_squares && size > n.until;
        const double e = plain ? 0 : dot(twist, way), a = dot(tu, tu), b = dot(tu, tv) - e, c = dot(tv, tv),
                     f = dot(way, tu), g = dot(way, tv), determinant = a * c - b * b;
        if (determinant == 0)
            return false;
        const double du = (c * f - b * g) / determinant, dv = (a * g - b * f) / determinant;
        double factor = 1;
        if (n.shortened) {
            const double before = dot(way, way);
            for (int k = 0; k < 10; k++, factor *= 0.7) {
                double there[3], s[3], t[3];
                place(x, u + factor * du, v + factor * dv, there, s, t);
                if (dot(there, there) <= before)
                    break;
            }
        }
        u += factor * du;
        v += factor * dv;
        size = n.sum ? std::fabs(du) + std::fabs(dv) : std::sqrt(du * du + dv * dv);
        good = size <= n.tolerance && !plain;
    }
    loc[0] = u;
    loc[1] = v;
    return good;
}

static constexpr newton openradioss = {0, 0, 10, 1e-10, true, false}, frontistr = {0, 0, 100, 1e-4, false, true},
                        code_aster = {0, 0, 200, 1e-6, false, false}, tribols_own = {3, 0, 15, 1e-12, true, false},
                        moose = {3, 1e-3, 15, 1e-12, false, false};

static void normal_and_gap(const double tu[3], const double tv[3], const double way[3], double *distance)
{
    double n[3];
    for (int k = 0; k < 3; k++)
        n[k] = tu[(k + 1) % 3] * tv[(k + 2) % 3] - tu[(k + 2) % 3] * tv[(k + 1) % 3];
    *distance = dot(way, n) / std::sqrt(dot(n, n));
}

template <const newton &N, bool full> static void theirs()
{
    for (int i = 0; i < CASES; i++) {
        double tu[3], tv[3], way[3];
        if (search(N, nodes[i], at[i], tu, tv, way) && full) {
            place(nodes[i], at[i][0], at[i][1], way, tu, tv);
            normal_and_gap(tu, tv, way, &gap[i]);
        }
    }
}

static void triangles()
{
    for (int i = 0; i < CASES; i++) {
        const double *const corner[4] = {nodes[i][0], nodes[i][1], nodes[i][2], nodes[i][3]};
        double r[3];
        gap[i] = rival_four_triangles(corner, nodes[i][4], at[i], r);
    }
}

// ---- the adapters ----

static int unclamped(int i)
{
    double(*const x)[3] = nodes[i];
    const int status = footpoint_locate(x[0], x[1], x[2], x[3], x[4], at[i], &gap[i]);
    return status >= FOOTPOINT_OK ? status : footpoint_robust(x[0], x[1], x[2], x[3], x[4], at[i], &gap[i]);
}

static void located()
{
    for (int i = 0; i < CASES; i++)
        unclamped(i);
}

static void differentiated()
{
    footpoint_derivatives d;
    for (int i = 0; i < CASES; i++)
        if (unclamped(i) == FOOTPOINT_OK && footpoint_differentiate(nodes[i][0], nodes[i][1], nodes[i][2], nodes[i][3],
                                                                    nodes[i][4], at[i], &d) == FOOTPOINT_OK)
            gap[i] = d.gap;
}

static void robust()
{
    for (int i = 0; i < CASES; i++)
        footpoint_robust(nodes[i][0], nodes[i][1], nodes[i][2], nodes[i][3], nodes[i][4], at[i], &gap[i]);
}

static void tribols_new()
{
    for (int i = 0; i < CASES; i++)
        tribol::InvIso(nodes[i][4], tribols[i][0], tribols[i][1], tribols[i][2], 4, at[i]);
}

struct entity {
    double coord_1_x_, coord_1_y_, coord_1_z_, coord_2_x_, coord_2_y_, coord_2_z_, coord_3_x_, coord_3_y_, coord_3_z_,
        coord_4_x_, coord_4_y_, coord_4_z_;
};
static entity face[CASES], node[CASES];

static void nimblesm()
{
    for (int i = 0; i < CASES; i++) {
        bool in;
        double n[3], weights[4] = {0, 0, 0, 0};
        nimble::Projection(node[i], face[i], in, gap[i], n, weights);
        at[i][0] = weights[0];
    }
}

struct query {
    int slave;
};
static int getData(const query &q)
{
    return q.slave;
}

static double distance[CASES];
static int nearest[CASES];

static void arborx()
{
    const footpoint_nearest_face f = {&nodes[0][0], faces, slaves, distance, nearest, at, nullptr};
    for (int i = 0; i < CASES; i++) {
        distance[i] = 1e300;
        f(query{i}, i);
    }
}

// ---- the run ----

static const struct row {
    const char *code;
    void (*theirs)(), (*ours)();
    bool coordinates; // they leave xi, eta
} rows[] = {{"OpenRadioss sts_project", theirs<openradioss, false>, located, true},
            {"FrontISTR project_Point2Element", theirs<frontistr, true>, differentiated, true},
            {"Code_Aster mmnewt", theirs<code_aster, true>, differentiated, true},
            {"Tribol InvIso", theirs<tribols_own, false>, tribols_new, true},
            {"MOOSE findContactPoint", theirs<moose, true>, robust, true},
            {"NimbleSM Projection", triangles, nimblesm, false},
            {"ArborX callback", triangles, arborx, false}};
enum { ROWS = sizeof rows / sizeof *rows };

static double seconds()
{
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

static double worst()
{
    double off = 0;
    for (int i = 0; i < CASES; i++)
        off = std::fmax(off, std::fmax(std::fabs(at[i][0] - exact[i][0]), std::fabs(at[i][1] - exact[i][1])));
    return off;
}

int main()
{
    double least[ROWS][2];
    for (int i = 0; i < CASES; i++) {
        hard_draw(0, 1, uint64_t(i), &cases[i]);
        for (int n = 0; n < 5; n++)
            for (int k = 0; k < 3; k++)
                nodes[i][n][k] = cases[i].x[n][k];
        for (int n = 0; n < 4; n++) {
            for (int k = 0; k < 3; k++) {
                tribols[i][k][(n + 2) % 4] = nodes[i][n][k];
                (&face[i].coord_1_x_)[3 * n + k] = nodes[i][n][k];
            }
            faces[i][n] = 5 * i + n;
        }
        for (int k = 0; k < 3; k++)
            (&node[i].coord_1_x_)[k] = nodes[i][4][k];
        slaves[i] = 5 * i + 4;
        double distance_there;
        footpoint_robust(nodes[i][0], nodes[i][1], nodes[i][2], nodes[i][3], nodes[i][4], exact[i], &distance_there);
    }
    for (auto &r : least)
        r[0] = r[1] = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++)
        for (int r = 0; r < ROWS; r++)
            for (int side = 0; side < 2; side++) {
                const double begun = seconds();
                (side ? rows[r].ours : rows[r].theirs)();
                least[r][side] = std::fmin(least[r][side], seconds() - begun);
            }
    std::puts("code,theirs,ours,ratio,off_theirs,off_ours");
    for (int r = 0; r < ROWS; r++) {
        char off[2][32] = {"-", "-"};
        for (int side = 0; side < 2 && rows[r].coordinates; side++) {
            (side ? rows[r].ours : rows[r].theirs)();
            std::snprintf(off[side], sizeof off[side], "%.1e", worst());
        }
        std::printf("%s,%.1f,%.1f,%.2f,%s,%s\n", rows[r].code, 1e9 * least[r][0] / CASES, 1e9 * least[r][1] / CASES,
                    least[r][0] / least[r][1], off[0], off[1]);
    }
    return 0;
}
