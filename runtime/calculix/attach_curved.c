/* The closest point of a quadratic face, clamped to it: sequential quadratic programming, until attach_search.c finds
 * nothing nearer.  The face is brought to
 *     r = k0 + k1 u + k2 v + k3 u^2 + k4 u v + k5 v^2 + k6 u^2 v + k7 u v^2,
 * half the squared distance f is replaced by its Taylor polynomial of second order, the least point of that over the
 * triangle or square is found exactly, and the step to it is halved until f falls.  Where the Hessian is not positive
 * definite it gives way to Gauss and Newton's, damped.  It starts from the closest point of the plane or bilinear face
 * of the corners, or from a node that is nearer. */
#include "attach_curved.h"
#include "../../generated/footpoint_quad4.h"

#include <float.h>

enum { MAX_STEPS = 200, MAX_HALVINGS = 30, MAX_STARTS = 20 };

/* The iteration is done when its next step would be below this. */
#define NEXT_STEP 1e-9

/* ... or, without a Hessian inside, when its last one was. */
#define NEARLY 1e-6

/* What edges may be bent, over the size of the face, and still be straight. */
#define STRAIGHT 1e-12

/* How near a point on an edge is to it. */
#define ON_EDGE 1e-6

static void set_triangle(struct curved *f, const double x[][3], const double xs[3])
{
    for (int i = 0; i < 3; i++) {
        const double x2 = x[1][i] - x[0][i], x3 = x[2][i] - x[0][i], x4 = x[3][i] - x[0][i], x5 = x[4][i] - x[0][i],
                     x6 = x[5][i] - x[0][i];
        f->k[0][i] = x[0][i] - xs[i];
        f->k[1][i] = 4.0 * x4 - x2;
        f->k[2][i] = 4.0 * x6 - x3;
        f->k[3][i] = 2.0 * x2 - 4.0 * x4;
        f->k[4][i] = 4.0 * (x5 - x4 - x6);
        f->k[5][i] = 2.0 * x3 - 4.0 * x6;
        f->k[6][i] = f->k[7][i] = 0.0;
    }
}

static void set_serendipity(struct curved *f, const double x[][3], const double xs[3])
{
    for (int i = 0; i < 3; i++) {
        double y[8];
        for (int n = 0; n < 8; n++)
            y[n] = x[n][i] - x[0][i];
        f->k[0][i] = 0.5 * (y[4] + y[5] + y[6] + y[7]) - 0.25 * (y[1] + y[2] + y[3]) + (x[0][i] - xs[i]);
        f->k[1][i] = 0.5 * (y[5] - y[7]);
        f->k[2][i] = 0.5 * (y[6] - y[4]);
        f->k[3][i] = 0.25 * (y[1] + y[2] + y[3]) - 0.5 * (y[4] + y[6]);
        f->k[4][i] = 0.25 * (y[2] - y[1] - y[3]);
        f->k[5][i] = 0.25 * (y[1] + y[2] + y[3]) - 0.5 * (y[5] + y[7]);
        f->k[6][i] = 0.25 * (y[2] + y[3] - y[1]) - 0.5 * (y[6] - y[4]);
        f->k[7][i] = 0.25 * (y[1] + y[2] - y[3]) - 0.5 * (y[5] - y[7]);
    }
}

/* Whether the midside nodes are the middles of straight edges, to rounding of coordinates. */
static int is_straight(const struct curved *f, int corners)
{
    double bent = 0.0, size = 0.0;
    for (int i = 0; i < 3; i++) {
        const double mixed = fabs(f->k[4][i]);
        size += fabs(f->k[1][i]) + fabs(f->k[2][i]) + (corners == 4 ? mixed : 0.0);
        bent +=
            fabs(f->k[3][i]) + fabs(f->k[5][i]) + fabs(f->k[6][i]) + fabs(f->k[7][i]) + (corners == 3 ? mixed : 0.0);
    }
    return bent <= STRAIGHT * size;
}

static int positive(const struct model *m)
{
    return m->h00 > 0.0 && m->h11 > 0.0 && m->h00 * m->h11 - m->h01 * m->h01 > 1e-9 * m->h00 * m->h11;
}

/* Gradient and Hessian, or Gauss and Newton's. */
static inline struct model model_of(const struct curved *f, const double loc[2], const double r[3], int gauss)
{
    const double u = loc[0], v = loc[1];
    double g0 = 0.0, g1 = 0.0, h00 = 0.0, h01 = 0.0, h11 = 0.0;
    double r_uu = 0.0, r_uv = 0.0, r_vv = 0.0;
    for (int i = 0; i < 3; i++) {
        const double uu = f->k[3][i] + v * f->k[6][i], vv = f->k[5][i] + u * f->k[7][i];
        const double r_u = f->k[1][i] + v * (f->k[4][i] + v * f->k[7][i]) + 2.0 * u * uu;
        const double r_v = f->k[2][i] + u * (f->k[4][i] + u * f->k[6][i]) + 2.0 * v * vv;
        g0 += r_u * r[i];
        g1 += r_v * r[i];
        h00 += r_u * r_u;
        h01 += r_u * r_v;
        h11 += r_v * r_v;
        r_uu += 2.0 * uu * r[i];
        r_uv += (f->k[4][i] + 2.0 * (u * f->k[6][i] + v * f->k[7][i])) * r[i];
        r_vv += 2.0 * vv * r[i];
    }
    if (gauss)
        r_uu = r_uv = r_vv = 0.0;
    return (struct model){{g0, g1}, h00 + r_uu, h01 + r_uv, h11 + r_vv};
}

/* The one that takes the Hessian's place where that is not positive definite, damped: where r_u and r_v are nearly
 * parallel, steps would else zigzag. */
static struct model substitute(const struct curved *f, const double loc[2], const double r[3])
{
    struct model m = model_of(f, loc, r, 1);
    const double damping = 1e-2 * (m.h00 + m.h11) + DBL_MIN;
    m.h00 += damping;
    m.h11 += damping;
    return m;
}

/* Into the domain: rounding may have led a little out of it. */
static void confine(int corners, double loc[2])
{
    const double low = corners == 3 ? 0.0 : -1.0;
    loc[0] = clamp(loc[0], low, 1.0);
    loc[1] = clamp(loc[1], low, corners == 3 ? 1.0 - loc[0] : 1.0);
}

/* 1 if the next step would be short.  With a Hessian its square is bounded by the third derivatives of f times the
 * square of this move, through the inverse of the Hessian. */
static int settled(const struct curved *f, const struct model *m, int newton, double square_distance,
                   const double move[2])
{
    const double moved2 = move[0] * move[0] + move[1] * move[1];
    if (!newton)
        return moved2 <= NEARLY * NEARLY;
    const double trace = m->h00 + m->h11;
    const double det = m->h00 * m->h11 - m->h01 * m->h01, third2 = 64.0 * f->bend2 * (trace + square_distance);
    return third2 * (moved2 * moved2) * (trace * trace) <= NEXT_STEP * NEXT_STEP * (det * det);
}

/* Where a move keeps to an edge, Newton's method along that edge instead, if the Hessian m is positive there: Gauss and
 * Newton's is slow where the face curves away from a distant slave node. */
static void prefer_edge(const struct model *m, int corners, const double loc[2], double move[2])
{
    for (int i = 0; i < corners; i++) {
        const double *const c = corners == 4 ? square[i] : triangle[i];
        const double *const next = corners == 4 ? square[(i + 1) % 4] : triangle[(i + 1) % 3];
        const double s = next[0] - c[0], t = next[1] - c[1], a = loc[0] - c[0], b = loc[1] - c[1];
        const double off = s * b - t * a, curvature = m->h00 * s * s + 2.0 * m->h01 * s * t + m->h11 * t * t;
        if (off > ON_EDGE || fabs(off + s * move[1] - t * move[0]) > 4.0 * DBL_EPSILON || !(curvature > 0.0))
            continue;
        const double length2 = s * s + t * t, at = (s * a + t * b) / length2;
        const double p = off * t / length2, q = -off * s / length2; /* onto the edge */
        const double slope = s * (m->g[0] + m->h00 * p + m->h01 * q) + t * (m->g[1] + m->h01 * p + m->h11 * q);
        const double along = clamp(-slope / curvature, -at, 1.0 - at);
        move[0] = p + along * s;
        move[1] = q + along * t;
        return;
    }
}

/* The longest step from loc along `move` that takes f down enough; 0 if there is none to be told from rounding.  r and
 * *here are those of the point that it reaches. */
static int step_down(const struct curved *f, int corners, double slope, const double move[2], double loc[2],
                     double r[3], double *here)
{
    double length = 1.0;
    for (int k = 0; k <= MAX_HALVINGS; k++, length *= 0.5) {
        double next[2] = {loc[0] + length * move[0], loc[1] + length * move[1]};
        confine(corners, next);
        curved_away(f, next, r);
        const double there = vector_dot(r, r);
        if (there <= *here + length * slope) {
            *here = there;
            loc[0] = next[0];
            loc[1] = next[1];
            return 1;
        }
    }
    return 0;
}

/* From loc, where r is r - xS. */
static void descend(struct curved *f, int corners, double loc[2], double r[3])
{
    double here = vector_dot(r, r), move[2];
    f->bend2 = 0.0;
    for (int k = 3; k < CURVED_TERMS; k++)
        f->bend2 += vector_dot(f->k[k], f->k[k]);
    for (int n = 0; n < MAX_STEPS; n++) {
        const struct model full = model_of(f, loc, r, 0);
        const int newton = positive(&full);
        const struct model m = newton ? full : substitute(f, loc, r);
        if (corners == 3)
            least_in_triangle(&m, loc, move);
        else
            least_in_square(&m, loc, move);
        if (!newton)
            prefer_edge(&full, corners, loc, move);
        if (settled(f, &m, newton, here, move)) {
            loc[0] += move[0];
            loc[1] += move[1];
            break;
        }
        if (!step_down(f, corners, 2e-4 * (m.g[0] * move[0] + m.g[1] * move[1]), move, loc, r, &here))
            break;
    }
    confine(corners, loc);
}

/* To the closest point, from loc: a local minimum, and from whatever is nearer than that, the next. */
static inline void find_closest(struct curved *f, int corners, double loc[2], double r[3])
{
    double start[2];
    descend(f, corners, loc, r);
    for (int n = 0; n < MAX_STARTS && footpoint_attach_nearer(f, corners, loc, start); n++) {
        loc[0] = start[0];
        loc[1] = start[1];
        curved_away(f, loc, r);
        descend(f, corners, loc, r);
    }
}

/* To the nearest of n nodes, at local coordinates `at`, if that is nearer than loc; and r - xS there. */
static inline void prefer_node(const struct curved *f, int n, const double x[][3], const double at[][2],
                               const double xs[3], double loc[2], double r[3])
{
    curved_away(f, loc, r);
    double d[3], best = vector_dot(r, r);
    for (int i = 0; i < n; i++) {
        vector_sub(x[i], xs, d);
        const double square_distance = vector_dot(d, d);
        if (square_distance < best) {
            best = square_distance;
            loc[0] = at[i][0];
            loc[1] = at[i][1];
            r[0] = d[0];
            r[1] = d[1];
            r[2] = d[2];
        }
    }
}

void footpoint_attach_tri6(const double x[6][3], const double xs[3], double loc[2])
{
    static const double at[6][2] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}};
    struct curved f;
    double r[3];
    set_triangle(&f, x, xs);
    footpoint_attach_tri3(x, xs, loc);
    if (is_straight(&f, 3))
        return;
    prefer_node(&f, 6, x, at, xs, loc, r);
    find_closest(&f, 3, loc, r);
}

void footpoint_attach_quad8(const double x[8][3], const double xs[3], double loc[2])
{
    static const double at[8][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0},
                                    {0.0, -1.0},  {1.0, 0.0},  {0.0, 1.0}, {-1.0, 0.0}};
    struct curved f;
    double r[3];
    set_serendipity(&f, x, xs);
    if (is_straight(&f, 4)) {
        footpoint_attach_quad4(x, xs, loc);
        return;
    }
    footpoint_quad4_coarse_at(x[0], x[1], x[2], x[3], xs, &loc[0], &loc[1]);
    if (!(fabs(loc[0]) + fabs(loc[1]) < HUGE_VAL))
        loc[0] = loc[1] = 0.0;
    confine(4, loc);
    prefer_node(&f, 8, x, at, xs, loc, r);
    find_closest(&f, 4, loc, r);
}
