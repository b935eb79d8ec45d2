/* Points where a line meets a face; see line_points.h.
 *
 * In the plane normal to the line the face is a map F from a square of parameters, of degree 2 in each, and the line is 0.
 * A box is dropped if all control points of F lie ahead of 0 in one of eight directions, or normal to a middle line.  Slopes of F are means of control
 * vectors, too: if all products of one in xi and one in eta have one sign, so has the Jacobian, each zero in the box counts
 * with it, and the winding number of F round the box's edge is their number. */
#include "line_points.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef long double real;
__extension__ typedef __float128 exact;

enum { DIRECTIONS = 8 };
static const real direction[DIRECTIONS][2] = {{1, 0}, {5, 2}, {1, 1}, {2, 5}, {0, 1}, {-2, 5}, {-1, 1}, {-5, 2}};
enum { BOXES = 3000 }; /* more of them do not tell */
#define FINEST 1e-9L   /* boxes in which the Jacobian may be 0 are not halved on */
#define SPLIT 0.4853L  /* where boxes are cut: no point of interest lies there */

struct box {
    real u, v, wide, high; /* parameters */
    real net[3][3][2];
};

/* ---- faces ---- */

static void shape(int nodes, exact xi, exact eta, exact n[9])
{
    static const int place[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    const exact third = 1 - xi - eta, three[6] = {third, xi, eta, 4 * third * xi, 4 * xi * eta, 4 * eta * third};
    for (int k = 0; k < nodes; k++) {
        const exact u = xi * place[k][0], v = eta * place[k][1];
        if (nodes == 3)
            n[k] = three[k];
        else if (nodes == 6)
            n[k] = k < 3 ? three[k] * (2 * three[k] - 1) : three[k];
        else if (nodes == 4)
            n[k] = (1 + u) * (1 + v) / 4;
        else if (nodes == 9)
            n[k] = (place[k][0] ? xi * (xi + place[k][0]) / 2 : 1 - xi * xi) *
                   (place[k][1] ? eta * (eta + place[k][1]) / 2 : 1 - eta * eta);
        else if (k < 4)
            n[k] = (1 + u) * (1 + v) * (u + v - 1) / 4;
        else
            n[k] = place[k][0] ? (1 + u) * (1 - eta * eta) / 2 : (1 - xi * xi) * (1 + v) / 2;
    }
}

static void weigh(int nodes, double (*x)[3], const double xs[3], const exact n[9], exact r[3])
{
    for (int i = 0; i < 3; i++) {
        r[i] = 0;
        for (int k = 0; k < nodes; k++)
            r[i] += n[k] * ((exact)x[k][i] - xs[i]);
    }
}

static void offset_at(int nodes, double (*x)[3], const double xs[3], exact xi, exact eta, exact r[3])
{
    exact n[9];
    shape(nodes, xi, eta, n);
    weigh(nodes, x, xs, n, r);
}

void line_points_offset(int nodes, double (*x)[3], const double xs[3], const double loc[2], double offset[3])
{
    exact r[3];
    offset_at(nodes, x, xs, loc[0], loc[1], r);
    for (int i = 0; i < 3; i++)
        offset[i] = (double)r[i];
}

/* Two axes normal to the direction, of length 1 to rounding. */
static void axes_of(const double along[3], exact e[2][3])
{
    exact square = 0, length = 0;
    int least = 0;
    for (int i = 0; i < 3; i++) {
        square += (exact)along[i] * along[i];
        least = fabs(along[i]) < fabs(along[least]) ? i : least;
    }
    for (int i = 0; i < 3; i++) {
        e[0][i] = (i == least) - along[i] * (exact)along[least] / square;
        length += e[0][i] * e[0][i];
    }
    for (int i = 0; i < 3; i++)
        e[0][i] /= sqrtl((real)length);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        e[1][i] = (along[j] * e[0][k] - along[k] * e[0][j]) / sqrtl((real)square);
    }
}

/* The surface in the plane of the axes, where the line is 0. */
static void plane_at(int nodes, double (*x)[3], const double xs[3], exact e[2][3], const exact loc[2], exact f[2])
{
    exact r[3];
    offset_at(nodes, x, xs, loc[0], loc[1], r);
    for (int c = 0; c < 2; c++)
        f[c] = e[c][0] * r[0] + e[c][1] * r[1] + e[c][2] * r[2];
}

double line_points_error(int nodes, double (*x)[3], const double xs[3], const double along[3], const double loc[2])
{
    exact e[2][3], at[2] = {loc[0], loc[1]}, slope[2][2];
    double step = INFINITY;
    axes_of(along, e);
    for (int i = 0; i < 2; i++) { /* of a polynomial of degree 2 */
        const exact high[2] = {at[0] + (i == 0), at[1] + (i == 1)}, low[2] = {at[0] - (i == 0), at[1] - (i == 1)};
        exact f[2];
        plane_at(nodes, x, xs, e, high, slope[i]);
        plane_at(nodes, x, xs, e, low, f);
        for (int c = 0; c < 2; c++)
            slope[i][c] = (slope[i][c] - f[c]) / 2;
    }
    const exact turn = slope[0][0] * slope[1][1] - slope[0][1] * slope[1][0];
    const double enough = 1e-16 * fmax(1, fmax(fabs(loc[0]), fabs(loc[1])));
    for (int k = 0; k < 12 && step > enough && turn != 0; k++) {
        exact f[2], move[2];
        plane_at(nodes, x, xs, e, at, f);
        move[0] = (slope[1][0] * f[1] - slope[1][1] * f[0]) / turn;
        move[1] = (slope[0][1] * f[0] - slope[0][0] * f[1]) / turn;
        at[0] += move[0];
        at[1] += move[1];
        step = fmax(fabs((double)move[0]), fabs((double)move[1]));
    }
    return step > enough ? INFINITY : fmax(fabs((double)(at[0] - loc[0])), fabs((double)(at[1] - loc[1])));
}

double line_points_product(int nodes, double (*x)[3], const double along[3], const double loc[2], double *terms)
{
    exact high[2][3], low[2][3], product = 0;
    for (int j = 0; j < 2; j++) {
        offset_at(nodes, x, x[0], (exact)loc[0] + (j == 0), (exact)loc[1] + (j == 1), high[j]);
        offset_at(nodes, x, x[0], (exact)loc[0] - (j == 0), (exact)loc[1] - (j == 1), low[j]);
    }
    *terms = 0;
    for (int i = 0; i < 3; i++) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        const exact ab = (high[0][a] - low[0][a]) * (high[1][b] - low[1][b]) * along[i] / 4;
        const exact ba = (high[0][b] - low[0][b]) * (high[1][a] - low[1][a]) * along[i] / 4;
        product += ab - ba;
        *terms += fabs((double)ab) + fabs((double)ba);
    }
    return (double)product;
}

/* ---- the search ---- */

struct line_search {
    int nodes;
    double (*x)[3];
    const double *xs, *along;
    struct box whole;
    struct line_points *found;
    real limit; /* of u + v */
    long boxes;
};

static real cross2(const real a[2], const real b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

static real dot2(const real a[2], const real b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

static bool is_ahead(const struct box *b)
{
    for (int k = 0; k < DIRECTIONS + 2; k++) {
        const int i = k - DIRECTIONS;
        const real *const from = b->net[i ? 1 : 0][i ? 0 : 1], *const to = b->net[i ? 1 : 2][i ? 2 : 1];
        const real normal[2] = {from[1] - to[1], to[0] - from[0]}, *const to_side = i < 0 ? direction[k] : normal;
        int ahead = 0, behind = 0;
        for (int n = 0; n < 9; n++) {
            const real f = dot2(b->net[n / 3][n % 3], to_side);
            ahead += f > 0;
            behind += f < 0;
        }
        if (ahead == 9 || behind == 9)
            return true;
    }
    return false;
}

/* 1 or -1: the sign of the Jacobian; 0: it may change. */
static int turn_of(const struct box *b)
{
    real s[6][2], t[6][2];
    int right = 0, left = 0;
    for (int k = 0; k < 6; k++)
        for (int c = 0; c < 2; c++) {
            s[k][c] = b->net[k / 3 + 1][k % 3][c] - b->net[k / 3][k % 3][c];
            t[k][c] = b->net[k % 3][k / 3 + 1][c] - b->net[k % 3][k / 3][c];
        }
    for (int k = 0; k < 36; k++) {
        const real j = cross2(s[k / 6], t[k % 6]);
        right += j > 0;
        left += j < 0;
    }
    return right == 36 ? 1 : left == 36 ? -1 : 0;
}

/* The angle at 0 that a curve of three control points goes through; false if it comes too near 0 to tell. */
static bool angle_of(const real a[2], const real m[2], const real b[2], real length, real *angle)
{
    const real la = sqrtl(dot2(a, a)), lb = sqrtl(dot2(b, b));
    const real middle[2] = {lb * a[0] + la * b[0], lb * a[1] + la * b[1]};
    if (dot2(a, middle) > 0 && dot2(m, middle) > 0 && dot2(b, middle) > 0) {
        *angle += atan2l(cross2(a, b), dot2(a, b));
        return true;
    }
    if (length < 1e-12L)
        return false;
    real c[3][2];
    for (int i = 0; i < 2; i++) {
        c[0][i] = (a[i] + m[i]) / 2;
        c[2][i] = (m[i] + b[i]) / 2;
        c[1][i] = (c[0][i] + c[2][i]) / 2;
    }
    return angle_of(a, c[0], c[1], length / 2, angle) && angle_of(c[1], c[2], b, length / 2, angle);
}

/* How often the image of the box's edge goes round 0; -99: not told. */
static int winding_of(const struct box *b)
{
    static const int edge[4][3][2] = {
        {{0, 0}, {1, 0}, {2, 0}}, {{2, 0}, {2, 1}, {2, 2}}, {{2, 2}, {1, 2}, {0, 2}}, {{0, 2}, {0, 1}, {0, 0}}};
    real angle = 0;
    for (int k = 0; k < 4; k++) {
        const int(*const e)[2] = edge[k];
        if (!angle_of(b->net[e[0][0]][e[0][1]], b->net[e[1][0]][e[1][1]], b->net[e[2][0]][e[2][1]],
                      k % 2 ? b->high : b->wide, &angle))
            return -99;
    }
    return (int)lroundl(angle / (2 * 3.14159265358979323846L));
}

/* Value and slopes of F over the whole square, at parameters 0..1. */
static void jet_at(const struct box *w, real s, real t, real f[3][2])
{
    const real a[3] = {(1 - s) * (1 - s), 2 * s * (1 - s), s * s}, b[3] = {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
    const real da[3] = {2 * s - 2, 2 - 4 * s, 2 * s}, db[3] = {2 * t - 2, 2 - 4 * t, 2 * t};
    memset(f, 0, 3 * sizeof *f);
    for (int k = 0; k < 9; k++)
        for (int c = 0; c < 2; c++) {
            f[0][c] += a[k / 3] * b[k % 3] * w->net[k / 3][k % 3][c];
            f[1][c] += da[k / 3] * b[k % 3] * w->net[k / 3][k % 3][c];
            f[2][c] += a[k / 3] * db[k % 3] * w->net[k / 3][k % 3][c];
        }
}

static double beyond_of(int nodes, const double loc[2])
{
    return nodes == 3 || nodes == 6 ? fmax(-fmin(loc[0], loc[1]), loc[0] + loc[1] - 1)
                                    : fmax(fabs(loc[0]), fabs(loc[1])) - 1;
}

static void add_point(struct line_search *q, real s, real t, real f[3][2])
{
    struct line_points *const all = q->found;
    if (all->count == LINE_POINTS_MOST) {
        all->clear = false;
        return;
    }
    struct line_point *const p = &all->point[all->count++];
    exact r[3], ahead = 0, length = 0;
    p->loc[0] = (double)(q->whole.u + s * q->whole.wide);
    p->loc[1] = (double)(q->whole.v + t * q->whole.high);
    p->beyond = beyond_of(q->nodes, p->loc);
    offset_at(q->nodes, q->x, q->xs, q->whole.u + s * q->whole.wide, q->whole.v + t * q->whole.high, r);
    for (int i = 0; i < 3; i++) {
        ahead -= r[i] * q->along[i];
        length += (exact)q->along[i] * q->along[i];
    }
    p->dist = (double)((real)ahead / sqrtl((real)length));
    p->spread =
        (double)(q->whole.wide * (sqrtl(dot2(f[1], f[1])) + sqrtl(dot2(f[2], f[2]))) / fabsl(cross2(f[1], f[2])));
}

/* Newton's steps to the one zero in the box. */
static bool polish(struct line_search *q, const struct box *b)
{
    const struct box *const w = &q->whole;
    const real low[2] = {(b->u - w->u) / w->wide, (b->v - w->v) / w->high};
    const real high[2] = {low[0] + b->wide / w->wide, low[1] + b->high / w->high};
    real s = (low[0] + high[0]) / 2, t = (low[1] + high[1]) / 2, f[3][2], step = 1;
    for (int k = 0; k < 12; k++) {
        jet_at(w, s, t, f);
        const real over = 1 / cross2(f[1], f[2]), a = over * cross2(f[0], f[2]), c = over * cross2(f[1], f[0]);
        s -= a;
        t -= c;
        step = fabsl(a) + fabsl(c);
        if (!(s >= low[0] && s <= high[0] && t >= low[1] && t <= high[1]))
            return false;
    }
    if (step > 1e-14L)
        return false;
    add_point(q, s, t, f);
    return true;
}

static void halve(const struct box *b, struct box half[2])
{
    const bool in_u = b->wide > b->high;
    half[0] = half[1] = *b;
    *(in_u ? &half[0].wide : &half[0].high) *= SPLIT;
    *(in_u ? &half[1].wide : &half[1].high) *= 1 - SPLIT;
    *(in_u ? &half[1].u : &half[1].v) += in_u ? half[0].wide : half[0].high;
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 2; c++) {
            real p[3];
            for (int i = 0; i < 3; i++)
                p[i] = in_u ? b->net[i][k][c] : b->net[k][i][c];
            const real a = p[0] + SPLIT * (p[1] - p[0]), d = p[1] + SPLIT * (p[2] - p[1]), m = a + SPLIT * (d - a);
            const real low[3] = {p[0], a, m}, high[3] = {m, d, p[2]};
            for (int i = 0; i < 3; i++) {
                *(in_u ? &half[0].net[i][k][c] : &half[0].net[k][i][c]) = low[i];
                *(in_u ? &half[1].net[i][k][c] : &half[1].net[k][i][c]) = high[i];
            }
        }
}

static void search_box(struct line_search *q, const struct box *b)
{
    if (!q->found->clear || b->u + b->v > q->limit || is_ahead(b))
        return;
    if (turn_of(b)) {
        const int winding = winding_of(b);
        if (winding == 0 || (abs(winding) == 1 && polish(q, b)))
            return;
    }
    if (fmaxl(b->wide, b->high) < FINEST || ++q->boxes > BOXES) {
        q->found->clear = false;
        return;
    }
    struct box half[2];
    halve(b, half);
    for (int k = 0; k < 2; k++)
        search_box(q, &half[k]);
}

/* Shape functions at the corners, the middles of edges and the middle of a square; kept for the next call. */
static exact (*shapes_of(int nodes, real low, real wide))[9]
{
    static exact shapes[9][9];
    static struct {
        int nodes;
        real low;
    } last;
    for (int k = 0; k < 9 && (last.nodes != nodes || last.low != low); k++)
        shape(nodes, low + wide * (k / 3) / 2, low + wide * (k % 3) / 2, shapes[k]);
    last.nodes = nodes;
    last.low = low;
    return shapes;
}

void line_points_find(int nodes, double (*x)[3], const double xs[3], const double along[3], double over,
                      struct line_points *found)
{
    const bool triangle = nodes == 3 || nodes == 6;
    const real low = (triangle ? 0 : -1) - (real)over, wide = 1 - low + (real)over;
    struct line_search q = {
        nodes, x, xs, along, {low, low, wide, wide, {{{0}}}}, found, triangle ? 1 + (real)over : INFINITY, 0};
    real(*const net)[3][2] = q.whole.net;
    exact e[2][3], (*const shapes)[9] = shapes_of(nodes, low, wide);
    axes_of(along, e);
    for (int k = 0; k < 9; k++) {
        exact r[3];
        weigh(nodes, x, xs, shapes[k], r);
        for (int c = 0; c < 2; c++)
            net[k / 3][k % 3][c] = (real)(e[c][0] * r[0] + e[c][1] * r[1] + e[c][2] * r[2]);
    }
    for (int c = 0; c < 2; c++) { /* from values at the halves to control points */
        for (int i = 0; i < 3; i++)
            net[i][1][c] = 2 * net[i][1][c] - (net[i][0][c] + net[i][2][c]) / 2;
        for (int i = 0; i < 3; i++)
            net[1][i][c] = 2 * net[1][i][c] - (net[0][i][c] + net[2][i][c]) / 2;
    }
    *found = (struct line_points){.clear = true};
    search_box(&q, &q.whole);
}
