/* The closest point of a quadratic face, clamped to it. Let z = (s,t) be a move in (u,v) from a point p of the face,
 * and g = r - xS. Then
 *
 *     |r - xS|^2 - |g|^2 = 2 g . L z + |L z|^2 + 2 (g + L z) . y + |y|^2,   L z = r_u s + r_v t,
 *     y = r_uu s^2/2 + r_uv s t + r_vv t^2/2 + k6 s^2 t + k7 s t^2.
 *
 * The last term is not negative. Over the whole face, the others are at least h11 s^2 - e |s t| + h22 t^2 minus the
 * slopes that descend, with bounds on the factors. If that form is positive and the slopes are small, p is the closest
 * point.
 *
 * On ordinary faces that proves a local minimum, which sequential quadratic programming finds: it replaces half the
 * squared distance f by its second-order Taylor polynomial, finds the minimum of that over the triangle or square
 * exactly, and halves the step until f decreases. If the Hessian is not positive definite, a damped Gauss-Newton matrix
 * replaces it. The start is the closest point of the plane or bilinear face of the corners, or a node that is nearer.
 * On all other faces footpoint_face_robust answers. */
#include "../../generated/footpoint_quad4.h"
#include "../footpoint_face.h"
#include "attach.h"

#include <float.h>

enum { TERMS = 8, MAX_STEPS = 50, MAX_HALVINGS = 30 };

#define STRAIGHT 1e-12  /* largest deviation of straight edges, over the size of the face */
#define NEXT_STEP 1e-10 /* the iteration ends when its next step would be below this, */
#define NEARLY 1e-6     /* or, without a Hessian in the interior, when its last step was */
#define ON_EDGE 1e-6    /* largest distance of a point on an edge */
#define NEARER 1e-11    /* over the face's size: smaller gains in distance do not count */
#define ROUNDING (64.0 * DBL_EPSILON)

/* r - xS = k0 + k1 u + k2 v + k3 u^2 + k4 u v + k5 v^2 + k6 u^2 v + k7 u v^2, and the sum of squares of k3 to k7. */
struct curved {
    double k[TERMS][3], bend2;
};

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

/* Returns true if the midside nodes are the middles of straight edges, to rounding of coordinates. */
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

/* Computes r - xS at (u,v) = loc. */
static inline void away(const struct curved *f, const double loc[2], double r[3])
{
    const double u = loc[0], v = loc[1];
    for (int i = 0; i < 3; i++)
        r[i] = f->k[0][i] + u * (f->k[1][i] + u * (f->k[3][i] + v * f->k[6][i]) + v * (f->k[4][i] + v * f->k[7][i])) +
               v * (f->k[2][i] + v * f->k[5][i]);
}

/* ---- a local minimum ---- */

static int positive(const struct model *m)
{
    return m->h00 > 0.0 && m->h11 > 0.0 && m->h00 * m->h11 - m->h01 * m->h01 > 1e-9 * m->h00 * m->h11;
}

/* Returns the gradient with the Hessian, or with the Gauss-Newton matrix. */
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

/* Returns the damped matrix that replaces a Hessian that is not positive definite. Without damping, steps would zigzag
 * if r_u and r_v are nearly parallel. */
static struct model substitute(const struct curved *f, const double loc[2], const double r[3])
{
    struct model m = model_of(f, loc, r, 1);
    const double damping = 1e-2 * (m.h00 + m.h11) + DBL_MIN;
    m.h00 += damping;
    m.h11 += damping;
    return m;
}

/* Moves a point back into the domain, which rounding may have left. */
static void confine(int corners, double loc[2])
{
    const double low = corners == 3 ? 0.0 : -1.0;
    loc[0] = clamp(loc[0], low, 1.0);
    loc[1] = clamp(loc[1], low, corners == 3 ? 1.0 - loc[0] : 1.0);
}

/* Returns 1 if the next step would be short. With a Hessian, its square is bounded by the third derivatives of f times
 * the square of this move, through the inverse of the Hessian. */
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

/* If a move stays on an edge, replaces it by a Newton step along the edge, provided that the Hessian m is positive
 * there: Gauss-Newton is slow where the face curves away from a distant slave node. */
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

/* Finds the longest step from loc along `move` that decreases f enough; returns 0 if rounding hides any decrease. r and
 * *here become those of the new point. */
static int step_down(const struct curved *f, int corners, double slope, const double move[2], double loc[2],
                     double r[3], double *here)
{
    double length = 1.0;
    for (int k = 0; k <= MAX_HALVINGS; k++, length *= 0.5) {
        double next[2] = {loc[0] + length * move[0], loc[1] + length * move[1]};
        confine(corners, next);
        away(f, next, r);
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

/* Descends from loc, where r = r - xS. */
static void descend(struct curved *f, int corners, double loc[2], double r[3])
{
    double here = vector_dot(r, r), move[2];
    f->bend2 = 0.0;
    for (int k = 3; k < TERMS; k++)
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

/* Moves to the nearest of n nodes, at local coordinates `at`, if it is nearer than loc; r becomes r - xS there. */
static inline void prefer_node(const struct curved *f, int n, const double x[][3], const double at[][2],
                               const double xs[3], double loc[2], double r[3])
{
    away(f, loc, r);
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

/* ---- the closest point ---- */

struct derivatives {
    double r[3], u[3], v[3], uu[3], uv[3], vv[3]; /* r - xS, r_u, r_v, ... */
};

static inline void derive(const struct curved *f, const double loc[2], struct derivatives *d)
{
    const double u = loc[0], v = loc[1];
    away(f, loc, d->r);
    for (int i = 0; i < 3; i++) {
        const double uu = f->k[3][i] + v * f->k[6][i], vv = f->k[5][i] + u * f->k[7][i];
        d->u[i] = f->k[1][i] + v * (f->k[4][i] + v * f->k[7][i]) + 2.0 * u * uu;
        d->v[i] = f->k[2][i] + u * (f->k[4][i] + u * f->k[6][i]) + 2.0 * v * vv;
        d->uu[i] = 2.0 * uu;
        d->uv[i] = f->k[4][i] + 2.0 * (u * f->k[6][i] + v * f->k[7][i]);
        d->vv[i] = 2.0 * vv;
    }
}

/* Returns how steeply a slope ascends (1) or descends (-1) if a coordinate may only grow (1), only fall (-1), or do
 * both (0). */
static inline double part_of(double slope, int into, int sign)
{
    const double up = into ? into * slope : -fabs(slope);
    return sign * up > 0.0 ? sign * up : 0.0;
}

/* Returns the minimum of factor x over a range. */
static inline double least(double factor, const double range[2])
{
    return factor * (factor > 0.0 ? range[0] : range[1]);
}

static inline double twice(const double a[3], const double b[3])
{
    return 2.0 * vector_dot(a, b);
}

/* Returns true if h11 s^2 - e |s t| + h22 t^2 is positive, and subtracting 2 (p |s| + q |t|) lowers it little. */
static inline int is_positive(double h11, double e, double h22, double p, double q, double room)
{
    const double det = h11 * h22 - 0.25 * e * e;
    return h11 > 0.0 && h22 > 0.0 && det > 0.0 && h22 * p * p + e * p * q + h11 * q * q <= room * det;
}

/* Returns true if no point of the face is nearer than loc by more than NEARER. On the edge u + v = 1 of a triangle, the
 * part of both slopes in the outward direction is blocked. */
static int is_closest(const struct curved *f, int corners, const double loc[2])
{
    const double low = corners == 3 ? 0.0 : -1.0, *const k6 = f->k[6], *const k7 = f->k[7];
    const double s[2] = {low - loc[0], 1.0 - loc[0]}, t[2] = {low - loc[1], 1.0 - loc[1]};
    const double S = fmax(-s[0], s[1]), T = fmax(-t[0], t[1]);
    const int into[2] = {s[0] >= 0.0                   ? 1
                         : corners == 4 && s[1] <= 0.0 ? -1
                                                       : 0,
                         t[0] >= 0.0                   ? 1
                         : corners == 4 && t[1] <= 0.0 ? -1
                                                       : 0};
    struct derivatives d;
    derive(f, loc, &d);
    const double aa = vector_dot(d.u, d.u), bb = vector_dot(d.v, d.v), g[2] = {twice(d.r, d.u), twice(d.r, d.v)};
    const double size = aa + bb, rounding = ROUNDING * (size + sqrt(size * vector_dot(d.r, d.r)));
    const double hold = corners == 3 && loc[0] + loc[1] >= 1.0 ? fmax(0.0, -fmax(g[0], g[1])) : 0.0;
    const double p = 0.5 * part_of(g[0] + hold, into[0], -1) + rounding,
                 q = 0.5 * part_of(g[1] + hold, into[1], -1) + rounding, room = NEARER * NEARER * size;
    const double h11 =
        aa + vector_dot(d.r, d.uu) + least(vector_dot(d.u, d.uu), s) + part_of(g[0] + hold, into[0], 1) / S - rounding;
    const double h22 =
        bb + vector_dot(d.r, d.vv) + least(vector_dot(d.v, d.vv), t) + part_of(g[1] + hold, into[1], 1) / T - rounding;
    const double e = fabs(twice(d.u, d.v) + twice(d.r, d.uv)) + S * S * fabs(twice(d.u, k6)) +
                     S * T * fabs(twice(d.u, k7) + twice(d.v, k6)) + T * T * fabs(twice(d.v, k7)) + rounding;
    const double sst = twice(d.u, d.uv) + vector_dot(d.v, d.uu) + twice(d.r, k6);
    const double stt = twice(d.v, d.uv) + vector_dot(d.u, d.vv) + twice(d.r, k7);
    return is_positive(h11 + least(sst, t), e, h22 + least(stt, s), p, q, room) ||
           is_positive(h11 + least(sst, t), e + T * fabs(stt), h22, p, q, room) ||
           is_positive(h11, e + S * fabs(sst), h22 + least(stt, s), p, q, room);
}

static double size_of(const struct curved *f)
{
    double sum = 0.0;
    for (int k = 1; k < TERMS; k++)
        sum += vector_dot(f->k[k], f->k[k]);
    return sqrt(sum);
}

/* Moves from loc to the closest point: a local minimum, unless another point is nearer. */
static void find_closest(struct curved *f, enum footpoint_face face, const double x[][3], const double xs[3],
                         double loc[2], double r[3])
{
    const int corners = face == FOOTPOINT_TRI6 ? 3 : 4, nodes = 2 * corners;
    double all[9][3], at[2], distance;
    int region;
    descend(f, corners, loc, r);
    if (is_closest(f, corners, loc))
        return;
    memcpy(all, x, (size_t)nodes * sizeof *all);
    memcpy(all[nodes], xs, sizeof *all);
    away(f, loc, r);
    if (footpoint_face_robust(face, all[0], at, &distance, &region) < FOOTPOINT_OK)
        loc[0] = loc[1] = NAN;
    else if (!(sqrt(vector_dot(r, r)) - fabs(distance) <= NEARER * size_of(f)))
        memcpy(loc, at, sizeof at);
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
    find_closest(&f, FOOTPOINT_TRI6, x, xs, loc, r);
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
    find_closest(&f, FOOTPOINT_QUAD8, x, xs, loc, r);
}
