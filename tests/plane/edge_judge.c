/* Edges and their judge; see edge_judge.h. */
#include "edge_judge.h"

#include "../../generated/footpoint_edge3.h"
#include "../hard/draw.h"

#include <math.h>
#include <string.h>

wide judge_value(const wide f[4], wide t)
{
    return ((f[3] * t + f[2]) * t + f[1]) * t + f[0];
}

void judge_point(const struct judged *j, wide t, wide r[2])
{
    for (int i = 0; i < 2; i++)
        r[i] = j->x[0][i] * t * (t - 1) / 2 + j->x[1][i] * t * (t + 1) / 2 + j->x[2][i] * (1 - t * t);
}

static wide square(const struct judged *j, wide t)
{
    wide r[2];
    judge_point(j, t, r);
    return (r[0] - j->x[3][0]) * (r[0] - j->x[3][0]) + (r[1] - j->x[3][1]) * (r[1] - j->x[3][1]);
}

/* Expands r = C + t u + t^2 v. */
void judge_expand(struct judged *j)
{
    memset(j->f, 0, sizeof j->f);
    for (int i = 0; i < 2; i++) {
        const wide u = (j->x[1][i] - j->x[0][i]) / 2, v = (j->x[0][i] + j->x[1][i]) / 2 - j->x[2][i];
        const wide s = j->x[3][i] - j->x[2][i];
        j->f[0] -= u * s;
        j->f[1] += u * u - 2 * v * s;
        j->f[2] += 3 * u * v;
        j->f[3] += 2 * v * v;
    }
}

wide judge_root(wide a)
{
    wide root = (wide)sqrt((double)a);
    for (int i = 0; i < 3 && root > 0; i++)
        root = (root + a / root) / 2;
    return root;
}

/* Returns the zero between low and high, where the cubic has opposite signs. */
static wide zero(const wide f[4], wide low, wide high)
{
    const bool rises = judge_value(f, low) < 0;
    wide t = (low + high) / 2;
    for (int i = 0; i < 130; i++) {
        const wide here = judge_value(f, t), slope = (3 * f[3] * t + 2 * f[2]) * t + f[1];
        if ((here < 0) == rises)
            low = t;
        else
            high = t;
        wide next = t - here / slope;
        if (!(next > low && next < high))
            next = (low + high) / 2;
        if (next - t < 1e-30 && t - next < 1e-30)
            break;
        t = next;
    }
    return t;
}

static void add_place(struct judged *j, wide t)
{
    const wide s = square(j, t);
    int k = j->places++;
    for (; k > 0 && j->square[k - 1] > s; k--) {
        j->place[k] = j->place[k - 1];
        j->square[k] = j->square[k - 1];
    }
    j->place[k] = t;
    j->square[k] = s;
}

/* Finds all zeros of the cubic on the edge, which lie between its extremes and the ends. */
void judge_find(struct judged *j)
{
    wide knot[4] = {-1, -1, -1, 1};
    const wide *const f = j->f, under = f[2] * f[2] - 3 * f[3] * f[1];
    if (under > 0) {
        const wide root = judge_root(under), q = f[2] > 0 ? -(f[2] + root) : root - f[2];
        const wide one = q != 0 ? f[1] / q : 0, other = f[3] > 0 ? q / (3 * f[3]) : one;
        knot[1] = one < other ? one : other;
        knot[2] = one < other ? other : one;
    }
    for (int i = 1; i < 3; i++)
        knot[i] = knot[i] < -1 ? -1 : knot[i] > 1 ? 1 : knot[i];
    j->places = 0;
    add_place(j, -1);
    add_place(j, 1);
    for (int i = 0; i < 3; i++)
        if (judge_value(f, knot[i]) < 0 && judge_value(f, knot[i + 1]) > 0)
            add_place(j, zero(f, knot[i], knot[i + 1]));
    j->least = j->square[0];
}

void judge_edge(struct judged *j, int nodes, double x[4][2])
{
    for (int i = 0; i < 2; i++) {
        j->x[0][i] = x[0][i];
        j->x[1][i] = x[1][i];
        j->x[2][i] = nodes == 3 ? (wide)x[2][i] : ((wide)x[0][i] + x[1][i]) / 2;
        j->x[3][i] = x[nodes][i];
    }
    j->unit = 1e-16;
    j->promise = 1e-12;
    j->tie = 1e-10;
    j->apart = 1e-7;
    judge_expand(j);
}

void judge_single(struct judged *j)
{
    j->unit = 6e-8;
    j->promise = 1e-5;
    j->tie = 3e-5;
    j->apart = 1e-4;
}

static double length_of(const struct judged *j)
{
    wide most = 0;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++) {
            const wide d = j->x[k][i] - j->x[(k + 1) % 3][i];
            most = d > most ? d : -d > most ? -d : most;
        }
    return (double)most;
}

/* A minimum within the promise: the cubic rises through 0. */
bool judge_holds(const struct judged *j, double xi)
{
    const double within = j->promise * fmax(1, fabs(xi));
    return judge_value(j->f, (wide)xi - within) < 0 && judge_value(j->f, (wide)xi + within) > 0;
}

/* The gap must be right to the promise and rounding. */
bool judge_gap_holds(const struct judged *j, double xi, double gap)
{
    wide r[2], t[2], d[2];
    judge_point(j, xi, r);
    for (int i = 0; i < 2; i++) {
        t[i] = j->x[0][i] * ((wide)xi - 0.5) + j->x[1][i] * ((wide)xi + 0.5) - 2 * j->x[2][i] * xi;
        d[i] = j->x[3][i] - r[i];
    }
    const double size = length_of(j), normal = (double)judge_root((t[0] * t[0] + t[1] * t[1]) / size / size);
    const double off = (double)(((d[0] * t[1] - d[1] * t[0]) / size / normal - gap) / size);
    return fabs(off) <= 1e3 * j->unit * (1 + xi * xi + fabs(gap) / size) / fmin(1, normal * normal);
}

bool judge_closest_holds(const struct judged *j, int status, double xi, double dist, int region)
{
    const double size = length_of(j), off = (double)(j->place[0] - xi);
    const double least = size * (double)judge_root(j->least / size / size);
    const bool inside = fabs(xi) <= 1 && (region == 0 || xi == (region == 1 ? -1 : 1));
    if (fabs(fabs(dist) - least) >
            100 * j->unit * (size + least) + (status == FOOTPOINT_OK ? 4 * j->promise : 2 * j->tie) * size ||
        !inside)
        return false;
    if (status == FOOTPOINT_OK)
        return fabs(off) <= j->promise;
    wide other[2], here[2];
    const wide across =
        (j->x[1][0] - j->x[0][0]) * (j->x[1][0] - j->x[0][0]) + (j->x[1][1] - j->x[0][1]) * (j->x[1][1] - j->x[0][1]);
    const double tie = j->tie * size * (double)judge_root(across / size / size);
    bool found = false;
    judge_point(j, xi, here);
    for (int k = 0; k < j->places; k++) {
        judge_point(j, j->place[k], other);
        const double away = fabs((double)(other[0] - here[0])) + fabs((double)(other[1] - here[1]));
        found = found ||
                (away > j->apart * size && size * (double)judge_root(j->square[k] / size / size) <= fabs(dist) + tie);
    }
    return found && fabs(dist) <= least + tie;
}

const char *const edge_families[FAMILIES] = {"ordinary", "curved", "quarter", "line",   "wild", "coincident",
                                             "far",      "offset", "size",    "scales", "end",  "tie"};

/* Draws the middle node, with the edge from (-1, 0) to (1, 0). */
static void draw_middle(enum family family, uint64_t *stream, double c[2])
{
    const bool wild = family == WILD || family == COINCIDENT;
    const double bend = wild ? 2 : family == CURVED || family == TIE ? 1 : family == LINE ? 0 : 0.2;
    c[0] = family == TIE ? 0 : wild ? draw_flat(stream, -2, 2) : draw_flat(stream, -0.1, 0.1);
    c[1] = draw_flat(stream, -bend, bend);
    if (family == QUARTER)
        c[0] = 0.5 * draw_sign(stream);
    if (family == LINE)
        c[0] = draw_flat(stream, -1, 1);
}

/* Draws the slave node over a place of the curve. */
static void draw_slave(enum family family, uint64_t *stream, double x[4][2])
{
    const double t = family == END ? draw_sign(stream) : draw_flat(stream, -1.3, 1.3);
    const double away = family == FAR ? draw_power(stream, -1, 3) : family == CURVED ? 2 : 0.4;
    const double gap = away * draw_flat(stream, -1, 1);
    double u[2], r[2];
    for (int i = 0; i < 2; i++) {
        r[i] = x[0][i] * t * (t - 1) / 2 + x[1][i] * t * (t + 1) / 2 + x[2][i] * (1 - t * t);
        u[i] = x[0][i] * (t - 0.5) + x[1][i] * (t + 0.5) - 2 * x[2][i] * t;
    }
    const double per = gap / fmax(1e-3, hypot(u[0], u[1]));
    x[3][0] = family == TIE ? 0 : r[0] + per * u[1];
    x[3][1] = family == TIE ? draw_flat(stream, -4, 4) : r[1] - per * u[0];
}

void draw_edge(enum family family, uint64_t *stream, int nodes, double x[4][2])
{
    double y[4][2] = {{-1, 0}, {1, 0}, {0, 0}, {0, 0}};
    const double turn = family == TIE ? 0 : draw_flat(stream, 0, 6.3), c = cos(turn), s = sin(turn);
    const double size = family == SIZE ? draw_power(stream, -300, 300) : 1;
    const double shift = family == OFFSET ? draw_power(stream, 0, 9) : 0;
    if (nodes == 3)
        draw_middle(family, stream, y[2]);
    draw_slave(family, stream, y);
    if (family == COINCIDENT)
        memcpy(y[draw_choose(stream, 3)], y[draw_choose(stream, 4)], sizeof y[0]);
    if (nodes == 2)
        memcpy(y[2], y[3], sizeof y[2]);
    for (int k = 0; k <= nodes; k++) {
        const double unit = family == SCALES ? draw_power(stream, -8, 8) : size;
        x[k][0] = unit * (c * y[k][0] - s * y[k][1] + shift);
        x[k][1] = unit * (s * y[k][0] + c * y[k][1] + shift);
    }
}
