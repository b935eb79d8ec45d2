/* Stationary points solve F = (r_u . r, r_v . r) = 0, where r is the vector from the slave node. A box of (u,v) is
 * bisected until one of these is proved for each piece:
 *
 *   it contains no zero, since F at its centre exceeds the change that F' allows over the box, or since Newton's step
 *   from the centre, widened by the variation of F' (Krawczyk's operator), leaves the box;
 *   it contains exactly one zero, since the widened step ends inside: Newton's iteration in long double finds it.
 *
 * If the smallest box is still undecided, the answer is uncertain.
 *
 * Bounds of second derivatives over a box: for the Bezier net, from its third derivatives, which third differences of
 * the net bound; for the blends q = 9 s^2 t^2 u v w, s = 1 - u, t = 1 - v, w = v/(u + v) (see
 * runtime/geometry/gregory.c), in closed form, from factors that are monotonic and not negative. First derivatives and
 * points follow by integration from the centre. Bounds are computed in double; signs count only beyond a margin for
 * rounding. */
#include "foot_patch_local.h"

#include <math.h>
#include <string.h>

#define MARGIN 1e-13  /* for rounding, in units of the sum of magnitudes */
#define SMALLEST 1e-9 /* half-width of a box that is not bisected again */

enum { FEW_BOXES = 200, MOST_BOXES = 5000, MOST_DEPTH = 128 /* boxes waiting; each bisection leaves one */ };

/* Vectors m[k] - rad[k] .. m[k] + rad[k]. */
struct bounds {
    double m[3], rad[3];
};

/* Computes the range of q_uu, q_uv, q_vv over a box, relative to the blend's corner: low and high ends. */
static void blend_range(const double u[2], const double v[2], double low[3], double high[3])
{
    const double s[2] = {1 - u[1], 1 - u[0]}, t[2] = {1 - v[1], 1 - v[0]};
    const double w[2] = {v[0] > 0 ? v[0] / (u[1] + v[0]) : 0, u[0] > 0 ? v[1] / (u[0] + v[1]) : 1};
    double *end[2] = {low, high};
    for (int i = 0; i < 2; i++) { /* a: bound for added terms; b: for subtracted terms */
        const int a = i, b = 1 - i;
        const double f = u[a] * v[a] * w[a], z = 1 - w[b];
        const double s2 = s[a] * s[a], t2 = t[a] * t[a], s2b = s[b] * s[b], t2b = t[b] * t[b];
        end[i][0] = 18 * (t2 * f - 2 * s[b] * t2b * v[b] * w[b] * w[b] - s2b * t2b * w[b] * w[b] * w[b]);
        end[i][1] = 36 * s[a] * t[a] * f - 18 * s[b] * t2b * u[b] * w[b] * (2 - w[b]) -
                    18 * s2b * t[b] * v[b] * w[b] * w[b] + 9 * s2 * t2 * w[a] * w[a] * (3 - 2 * w[a]);
        end[i][2] = 18 * (s2 * f - 2 * s2b * t[b] * u[b] * w[b] * (2 - w[b]) + s2 * t2 * z * z * z);
    }
}

static void short_dot(const struct bounds *a, const struct bounds *b, double *m, double *rad)
{
    for (int k = 0; k < 3; k++) {
        *m += a->m[k] * b->m[k];
        *rad += fabs(a->m[k]) * b->rad[k] + fabs(b->m[k]) * a->rad[k] + a->rad[k] * b->rad[k];
    }
}

/* The system on a box: half the squared distance and F at its centre, and the midpoint and radius of the derivative of F: 11, 12,
 * 22. */
struct system {
    double d, f[2], h[3], rad[3], noise;
};

static void add_blends(const struct patch_local *l, const struct patch_box *box, struct bounds second[3])
{
    for (int k = 0; k < 4; k++) {
        const int i = k / 2, j = k % 2;
        const double u[2] = {i ? 1 - box->u[1] : box->u[0], i ? 1 - box->u[0] : box->u[1]};
        const double v[2] = {j ? 1 - box->v[1] : box->v[0], j ? 1 - box->v[0] : box->v[1]};
        double low[3], high[3];
        blend_range(u, v, low, high);
        for (int d = 0; d < 3; d++) {
            const double sign = d == 1 && i != j ? -1 : 1;
            for (int c = 0; c < 3; c++) {
                second[d].m[c] += sign * l->e[i][j][c] * (high[d] + low[d]) / 2;
                second[d].rad[c] += fabs(l->e[i][j][c]) * (high[d] - low[d]) / 2;
            }
        }
    }
}

/* Evaluates Bernstein polynomials in double, for boxes. */
static void short_bernstein(double t, double b[3][4])
{
    const double s = 1 - t;
    const double value[3][4] = {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
                                {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t},
                                {6 * s, 6 * (t - 2 * s), 6 * (s - 2 * t), 6 * t}};
    memcpy(b, value, sizeof value);
}

/* Computes q, q_u, q_v relative to the blend's corner. */
static void blend_at(double u, double v, double q[3])
{
    const double s = 1 - u, t = 1 - v, w = u + v > 0 ? v / (u + v) : 0.5, f = 9 * s * t * w;
    q[0] = f * s * t * u * v;
    q[1] = f * t * v * (s * w - 2 * u);
    q[2] = f * s * u * (t * (2 - w) - 2 * v);
}

/* Computes point and derivatives by u and v at the centre; second derivatives of the net only. */
static void centre(const struct patch_local *l, double u, double v, double r[3], struct bounds first[2],
                   struct bounds second[3])
{
    double a[3][4], b[3][4], along[3][4];
    short_bernstein(u, a);
    short_bernstein(v, b);
    for (int c = 0; c < 3; c++) {
        for (int d = 0; d < 3; d++)
            for (int i = 0; i < 4; i++)
                along[d][i] = b[d][0] * l->p[i][0][c] + b[d][1] * l->p[i][1][c] + b[d][2] * l->p[i][2][c] +
                              b[d][3] * l->p[i][3][c];
        double value[6];
        static const int by[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
        for (int k = 0; k < 6; k++) {
            const double *x = a[by[k][0]], *y = along[by[k][1]];
            value[k] = x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3];
        }
        r[c] = value[0];
        first[0].m[c] = value[1];
        first[1].m[c] = value[2];
        for (int d = 0; d < 3; d++)
            second[d].m[c] = value[3 + d];
    }
    for (int k = 0; k < 4; k++) {
        const int i = k / 2, j = k % 2;
        double q[3];
        blend_at(i ? 1 - u : u, j ? 1 - v : v, q);
        for (int c = 0; c < 3; c++) {
            r[c] += q[0] * l->e[i][j][c];
            first[0].m[c] += (i ? -1 : 1) * q[1] * l->e[i][j][c];
            first[1].m[c] += (j ? -1 : 1) * q[2] * l->e[i][j][c];
        }
    }
}

static struct system system_of(const struct patch_local *l, const struct patch_box *box)
{
    const double u = (box->u[0] + box->u[1]) / 2, v = (box->v[0] + box->v[1]) / 2;
    const double hu = (box->u[1] - box->u[0]) / 2, hv = (box->v[1] - box->v[0]) / 2;
    struct bounds point = {0}, first[2], second[3];
    struct system f = {0};
    centre(l, u, v, point.m, first, second);
    double reach = 0, slope = 0;
    for (int c = 0; c < 3; c++) {
        f.f[0] += first[0].m[c] * point.m[c];
        f.f[1] += first[1].m[c] * point.m[c];
        f.d += point.m[c] * point.m[c] / 2;
        reach += fabs(point.m[c]);
        slope += fabs(first[0].m[c]) + fabs(first[1].m[c]);
        for (int d = 0; d < 3; d++)
            second[d].rad[c] = l->third[d][c] * hu + l->third[d + 1][c] * hv;
    }
    f.noise = MARGIN * (1 + reach) * (1 + slope);
    add_blends(l, box, second);
    for (int c = 0; c < 3; c++) {
        const double uu = fabs(second[0].m[c]) + second[0].rad[c], vv = fabs(second[2].m[c]) + second[2].rad[c];
        const double uv = fabs(second[1].m[c]) + second[1].rad[c];
        first[0].rad[c] = uu * hu + uv * hv;
        first[1].rad[c] = uv * hu + vv * hv;
        point.rad[c] = (fabs(first[0].m[c]) + first[0].rad[c]) * hu + (fabs(first[1].m[c]) + first[1].rad[c]) * hv;
    }
    static const int pair[3][2] = {{0, 0}, {0, 1}, {1, 1}};
    for (int d = 0; d < 3; d++) {
        short_dot(&first[pair[d][0]], &first[pair[d][1]], &f.h[d], &f.rad[d]);
        short_dot(&second[d], &point, &f.h[d], &f.rad[d]);
    }
    return f;
}

enum verdict { EMPTY, ONE, NARROWED, WIDE };

/* Intersects the range of v with middle - radius .. middle + radius; returns false if it becomes empty. */
static bool cut(double v[2], double middle, double radius)
{
    v[0] = fmax(v[0], middle - radius);
    v[1] = fmin(v[1], middle + radius);
    return v[0] <= v[1];
}

/* Applies Krawczyk's operator; narrows the box. */
static enum verdict judge(const struct patch_local *l, struct patch_box *box)
{
    const double hu = (box->u[1] - box->u[0]) / 2, hv = (box->v[1] - box->v[0]) / 2;
    const double u = (box->u[0] + box->u[1]) / 2, v = (box->v[0] + box->v[1]) / 2;
    const struct system f = system_of(l, box);
    const double h11 = fabs(f.h[0]) + f.rad[0], h12 = fabs(f.h[1]) + f.rad[1], h22 = fabs(f.h[2]) + f.rad[2];
    if (fabs(f.f[0]) > h11 * hu + h12 * hv + f.noise || fabs(f.f[1]) > h12 * hu + h22 * hv + f.noise)
        return EMPTY;
    const double det = f.h[0] * f.h[2] - f.h[1] * f.h[1];
    if (!(fabs(det) > 1e-10 * (f.h[0] * f.h[0] + f.h[2] * f.h[2])))
        return WIDE;
    const double y11 = f.h[2] / det, y12 = -f.h[1] / det, y22 = f.h[0] / det;
    const double noise = 2 * f.noise * (fabs(y11) + fabs(y12) + fabs(y22)) + MARGIN;
    const double v11 = f.rad[0] * hu + f.rad[1] * hv, v22 = f.rad[1] * hu + f.rad[2] * hv;
    const double ru = fabs(y11) * v11 + fabs(y12) * v22 + noise, rv = fabs(y12) * v11 + fabs(y22) * v22 + noise;
    const double mu = u - y11 * f.f[0] - y12 * f.f[1], mv = v - y12 * f.f[0] - y22 * f.f[1];
    const struct patch_box before = *box;
    if (!cut(box->u, mu, ru) || !cut(box->v, mv, rv))
        return EMPTY;
    if (box->u[0] > before.u[0] && box->u[1] < before.u[1] && box->v[0] > before.v[0] && box->v[1] < before.v[1])
        return ONE;
    const double area = (box->u[1] - box->u[0]) * (box->v[1] - box->v[0]);
    if (ru < hu && rv < hv && fmax(box->u[1] - box->u[0], box->v[1] - box->v[0]) < 2 * SMALLEST)
        return ONE; /* at most one, on the bound of the box */
    return area < 0.5 * 4 * hu * hv ? NARROWED : WIDE;
}

/* Finds the only zero of a box from its middle. Returns false if the iteration does not find it. */
static bool find_one(const struct patch_local *l, const struct patch_box *box, struct stationary *s)
{
    long double u = (box->u[0] + box->u[1]) / 2, v = (box->v[0] + box->v[1]) / 2;
    const double slack = 10 * SMALLEST;
    bool minimum;
    if (!patch_polish(l, &u, &v, &minimum) || u < box->u[0] - slack || u > box->u[1] + slack || v < box->v[0] - slack ||
        v > box->v[1] + slack)
        return false;
    *s = patch_point_at(l, u, v, minimum);
    return true;
}

/* Bisects a box across its longer side. */
static void bisect(struct patch_box box, struct patch_box half[2])
{
    const bool along_u = box.u[1] - box.u[0] > box.v[1] - box.v[0];
    const double *side = along_u ? box.u : box.v, middle = (side[0] + side[1]) / 2;
    half[0] = half[1] = box;
    (along_u ? half[0].u : half[0].v)[1] = middle;
    (along_u ? half[1].u : half[1].v)[0] = middle;
}

int patch_boxes_search(const struct patch_local *l, const struct patch_box *whole,
                       struct stationary found[PATCH_STATIONARY_MAX])
{
    struct patch_box waiting[MOST_DEPTH] = {*whole};
    int n = 0, depth = 1;
    for (int boxes = 0; depth > 0; boxes++) {
        struct patch_box box = waiting[--depth];
        struct stationary s;
        if (boxes == MOST_BOXES)
            return PATCH_UNCERTAIN;
        switch (judge(l, &box)) {
        case EMPTY:
            continue;
        case ONE:
            if (n == PATCH_STATIONARY_MAX || !find_one(l, &box, &s))
                return PATCH_UNCERTAIN;
            n = stationary_insert(found, n, PATCH_STATIONARY_MAX, &s);
            continue;
        case NARROWED:
            waiting[depth++] = box;
            continue;
        case WIDE:
            break;
        }
        if (fmax(box.u[1] - box.u[0], box.v[1] - box.v[0]) < 2 * SMALLEST || depth + 2 > MOST_DEPTH)
            return PATCH_UNCERTAIN;
        bisect(box, &waiting[depth]);
        depth += 2;
    }
    return n;
}

/* ---- from a known minimum ---- */

static bool is_convex(const struct patch_local *l, const struct patch_box *box)
{
    const struct system f = system_of(l, box);
    const double h11 = f.h[0] - f.rad[0] - f.noise, h22 = f.h[2] - f.rad[2] - f.noise;
    const double h12 = fabs(f.h[1]) + f.rad[1] + f.noise;
    return h11 > 0 && h22 > 0 && h11 * h22 * (1 - MARGIN) > h12 * h12;
}

/* Returns a bound for half the squared distance on a box, from below: second-order about its centre. */
static double bound(const struct patch_local *l, const struct patch_box *box)
{
    const double hu = (box->u[1] - box->u[0]) / 2, hv = (box->v[1] - box->v[0]) / 2;
    const struct system f = system_of(l, box);
    const double bend = fmin(0, f.h[0] - f.rad[0]) * hu * hu + fmin(0, f.h[2] - f.rad[2]) * hv * hv -
                        2 * (fabs(f.h[1]) + f.rad[1]) * hu * hv;
    return f.d - fabs(f.f[0]) * hu - fabs(f.f[1]) * hv + bend / 2 - f.noise - MARGIN * f.d;
}

static bool contains(const struct patch_box *outer, const struct patch_box *inner)
{
    return inner->u[0] >= outer->u[0] && inner->u[1] <= outer->u[1] && inner->v[0] >= outer->v[0] &&
           inner->v[1] <= outer->v[1];
}

/* Finds a convex part of a box around (u,v); returns false if it would be small. */
static bool find_convex(const struct patch_local *l, const struct patch_box *whole, double u, double v,
                        struct patch_box *part)
{
    for (double half = 1; half > 0.01; half /= 2) {
        *part = *whole;
        if (cut(part->u, u, half) && cut(part->v, v, half) && is_convex(l, part))
            return true;
    }
    return false;
}

bool patch_boxes_none_nearer(const struct patch_local *l, const struct patch_box *whole, double u, double v)
{
    struct patch_box waiting[MOST_DEPTH] = {*whole}, convex, at = {{u, u}, {v, v}};
    int depth = 1;
    if (!contains(whole, &at) || !find_convex(l, whole, u, v, &convex))
        return false;
    const struct system f = system_of(l, &at);
    for (int boxes = 0; depth > 0; boxes++) {
        const struct patch_box box = waiting[--depth];
        if (contains(&convex, &box) || bound(l, &box) > f.d * (1 + MARGIN) + f.noise)
            continue;
        if (boxes == FEW_BOXES || depth + 2 > MOST_DEPTH)
            return false;
        bisect(box, &waiting[depth]);
        depth += 2;
    }
    return true;
}
