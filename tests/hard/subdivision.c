/* Subdivides a bilinear segment; see subdivision.h.  A box of (xi,eta), mapped to -1 <= u, v <= 1, is a bilinear segment
 * itself: d = xS - r is
 *     d(u,v) = d - u a - v b - u v t,
 * with d, a, b of its middle, so that with a(v) = a + v t and b(u) = b + u t, exactly,
 *     F1 = a(v) . d(u,v) = a.d - u a.a - v (a.b - t.d) - 2 u v a.t - v^2 b.t - u v^2 t.t,
 *     F2 = b(u) . d(u,v) = b.d - v b.b - u (a.b - t.d) - 2 u v b.t - u^2 a.t - u^2 v t.t.
 * The box contains no stationary point if F1 or F2 stays away from 0, or a third product in the valley of the box, along which F1 is
 * 0.  It contains at most one if that product rises or falls all along; Newton's method then leads to it.  Distances: the
 * box lies in the hull of its four corners, so for any unit vector n no point of it is nearer than the least n . d of
 * a corner.  n is taken from the nearest point of the parallelogram t = 0, so that the bound falls short by at most |t|,
 * of second order in the width of the box. */
#include "subdivision.h"

#include <math.h>
#include <string.h>

enum { STACK = 200, MOST_BOXES = 20000, STEPS = 40 };

#define ROUNDING 0x1p-59L /* of products, over the sizes of their terms */
#define SETTLED 1e-5L     /* the last step of Newton's method, over the width of the box */
#define FAR 100           /* beyond this distance, heights are not computed as differences of distances */
#define SMALL 1e-13L      /* boxes of this size in space count as points */

typedef long double real;

struct box {
    real x, y, hx, hy;
};

static real dot(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const real a[3], const real b[3], real c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static real larger(real a, real b)
{
    return a > b ? a : b;
}

/* Halves a box; *q keeps the first half. */
static void halve(struct box *q, int along_x, struct box *other)
{
    if (along_x)
        q->hx /= 2;
    else
        q->hy /= 2;
    *other = *q;
    if (along_x)
        q->x -= q->hx, other->x += q->hx;
    else
        q->y -= q->hy, other->y += q->hy;
}

/* ---- distances ---- */

static void offset(const struct boxes_segment *f, real xi, real eta, real away[3])
{
    for (int k = 0; k < 3; k++)
        away[k] = -xi * f->c1[k] - eta * (f->c2[k] + xi * f->c3[k]);
}

/* Returns |d0 + away| - |d0|. */
static real height_of(const struct boxes_segment *f, real far, const real away[3])
{
    real d[3];
    for (int k = 0; k < 3; k++)
        d[k] = f->d0[k] + away[k];
    const real size = sqrtl(dot(d, d));
    return far < FAR ? size - far : (2 * dot(away, f->d0) + dot(away, away)) / (size + far);
}

real boxes_height(const struct boxes_segment *f, real xi, real eta)
{
    real away[3];
    offset(f, xi, eta, away);
    return height_of(f, sqrtl(dot(f->d0, f->d0)), away);
}

static real clamp(real x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* Computes u, v of the nearest point of the parallelogram d - u a - v b, |u|, |v| <= 1. */
static void nearest(const real a[3], const real b[3], const real d[3], real w[2])
{
    const real aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ad = dot(a, d), bd = dot(b, d);
    const real det = aa * bb - ab * ab;
    real best = 0;
    w[0] = (bb * ad - ab * bd) / det;
    w[1] = (aa * bd - ab * ad) / det;
    if (det > 1e-17L * aa * bb && fabsl(w[0]) <= 1 && fabsl(w[1]) <= 1)
        return;
    for (int k = 0; k < 4; k++) {
        const real side = k & 1 ? 1 : -1;
        const real u = k < 2 ? side : aa > 0 ? clamp((ad - side * ab) / aa) : 0;
        const real v = k >= 2 ? side : bb > 0 ? clamp((bd - side * ab) / bb) : 0;
        const real square = u * u * aa + v * v * bb + 2 * (u * v * ab - u * ad - v * bd);
        if (k == 0 || square < best) {
            best = square;
            w[0] = u;
            w[1] = v;
        }
    }
}

/* Returns a lower bound on the heights in a box, and the height of its point (u,v) of the parallelogram. */
static real bound(const struct boxes_segment *f, real far, const struct box *q, real z[2], real *height, real *size)
{
    real a[3], b[3], d[3], away[3], n[3], w[2], na = 0, nb = 0, nt = 0, nd = 0, tilt = 0, length = 0;
    offset(f, q->x, q->y, away);
    for (int k = 0; k < 3; k++) {
        a[k] = q->hx * (f->c1[k] + q->y * f->c3[k]);
        b[k] = q->hy * (f->c2[k] + q->x * f->c3[k]);
        d[k] = f->d0[k] + away[k];
    }
    *size = sqrtl(dot(a, a)) + sqrtl(dot(b, b)) + q->hx * q->hy * sqrtl(dot(f->c3, f->c3));
    nearest(a, b, d, w);
    z[0] = q->x + w[0] * q->hx;
    z[1] = q->y + w[1] * q->hy;
    *height = boxes_height(f, z[0], z[1]);
    for (int k = 0; k < 3; k++) {
        n[k] = d[k] - w[0] * a[k] - w[1] * b[k];
        length += n[k] * n[k];
    }
    length = sqrtl(length);
    if (!(length > 0))
        return -far;
    for (int k = 0; k < 3; k++) {
        n[k] /= length;
        na += n[k] * a[k];
        nb += n[k] * b[k];
        nt += n[k] * f->c3[k] * q->hx * q->hy;
    }
    if (far < FAR) {
        nd = dot(n, d) - far;
    } else { /* n . d - |d0| = n . away - |d0| |n - d0/|d0||^2/2 */
        real from[3], rise;
        for (int k = 0; k < 3; k++)
            from[k] = away[k] - w[0] * a[k] - w[1] * b[k];
        rise = (2 * dot(from, f->d0) + dot(from, from)) / (length + far);
        for (int k = 0; k < 3; k++) {
            const real change = (from[k] - f->d0[k] / far * rise) / length;
            tilt += change * change;
        }
        nd = dot(n, away) - far * tilt / 2;
    }
    real least = nd - na - nb - nt;
    for (int k = 1; k < 4; k++) {
        const real u = k & 1 ? 1 : -1, v = k & 2 ? 1 : -1, there = nd + u * na + v * nb - u * v * nt;
        least = there < least ? there : least;
    }
    return least;
}

int boxes_lower(const struct boxes_segment *f, real enough, real z[2], real *height)
{
    const real far = sqrtl(dot(f->d0, f->d0));
    struct box stack[STACK];
    int top = 1, boxes = 0;
    stack[0] = (struct box){0, 0, 1, 1};
    while (top > 0) {
        struct box q = stack[--top];
        real at[2], here, size;
        const real least = bound(f, far, &q, at, &here, &size);
        if (here < *height) {
            *height = here;
            z[0] = at[0];
            z[1] = at[1];
        }
        if (least >= *height - enough || size < SMALL)
            continue;
        if (++boxes > MOST_BOXES || top + 2 > STACK)
            return 0;
        real a = 0, b = 0;
        for (int k = 0; k < 3; k++) {
            a += fabsl(f->c1[k] + q.y * f->c3[k]);
            b += fabsl(f->c2[k] + q.x * f->c3[k]);
        }
        halve(&q, a * q.hx >= b * q.hy, &stack[top + 1]);
        stack[top] = q;
        top += 2;
    }
    return 1;
}

/* ---- stationary points ---- */

struct local {
    real a[3], b[3], t[3], d[3];                   /* of the middle, in u and v */
    real f1, f2, h11, h12, h22, at, bt, tt;        /* F1, F2, H, a.t, b.t, t.t */
    real size_a, size_b, size_t, size_d, noise[2]; /* upper bounds on lengths; rounding errors of F1, F2 */
};

static void expand(const struct boxes_segment *f, const struct box *q, struct local *l)
{
    const real across = q->hx * q->hy;
    for (int k = 0; k < 3; k++) {
        l->a[k] = q->hx * (f->c1[k] + q->y * f->c3[k]);
        l->b[k] = q->hy * (f->c2[k] + q->x * f->c3[k]);
        l->t[k] = across * f->c3[k];
        l->d[k] = f->d0[k] - q->x * f->c1[k] - q->y * (f->c2[k] + q->x * f->c3[k]);
    }
    l->f1 = dot(l->a, l->d);
    l->f2 = dot(l->b, l->d);
    l->h11 = dot(l->a, l->a);
    l->h22 = dot(l->b, l->b);
    l->h12 = dot(l->a, l->b) - dot(l->t, l->d);
    l->at = dot(l->a, l->t);
    l->bt = dot(l->b, l->t);
    l->tt = dot(l->t, l->t);
    l->size_d = fabsl(l->d[0]) + fabsl(l->d[1]) + fabsl(l->d[2]) + 4;
    l->size_a = sqrtl(l->h11) + 0.05L * q->hx;
    l->size_b = sqrtl(l->h22) + 0.05L * q->hy;
    l->size_t = sqrtl(l->tt) + 0.05L * across;
    l->noise[0] = ROUNDING * l->size_d * l->size_a;
    l->noise[1] = ROUNDING * l->size_d * l->size_b;
}

enum verdict { NONE, ONE_AT_MOST, UNKNOWN };

/* Returns 1 if F1 or F2 in the middle exceeds the sum of all other terms. */
static int is_empty(const struct local *l)
{
    const real at = fabsl(l->at), bt = fabsl(l->bt), h12 = fabsl(l->h12);
    return fabsl(l->f1) > l->noise[0] + l->h11 + h12 + 2 * at + bt + l->tt ||
           fabsl(l->f2) > l->noise[1] + l->h22 + h12 + 2 * bt + at + l->tt;
}

/* Judges a box by its valley.  F1 = 0 is a valley across the box: u = u0 - k v + w, k = h12/h11, u0 = F1/h11, with |w| at most the
 * terms of second order.  With s = a.t and the like, the remaining combination of (7), (8), (a.a) F2 - (a.b) F1 = (a x b) . (a x d)
 * of a(v), b(u), d(u,v), a x b = n + u p + v q,  n = a x b, p = a x t, q = t x b,  a x d = m0 + v m1 + v^2 m2, m0 = a x d,
 * m1 = t x d - n, m2 = -q, is a cubic in v there, with a rest in w.  It may stay away from 0, or rise or fall all along. */
static enum verdict judge_valley(const struct local *l)
{
    real n[3], p[3], q[3], m0[3], m1[3];
    const real u0 = l->f1 / l->h11, k = l->h12 / l->h11, at = fabsl(l->at), bt = fabsl(l->bt);
    const real w = (2 * at + bt + l->tt + l->noise[0]) / l->h11, slope = l->h11 - 2 * at - l->tt;
    if (!(w < 1))
        return UNKNOWN;
    cross(l->a, l->b, n);
    cross(l->a, l->t, p);
    cross(l->t, l->b, q);
    cross(l->a, l->d, m0);
    cross(l->t, l->d, m1);
    for (int i = 0; i < 3; i++)
        m1[i] -= n[i];
    const real pm0 = dot(p, m0), pm1 = dot(p, m1), pm2 = -dot(p, q);
    const real g0 = dot(n, m0) + u0 * pm0, g1 = dot(q, m0) + dot(n, m1) - k * pm0 + u0 * pm1;
    const real g2 = dot(q, m1) - dot(n, q) - k * pm1 + u0 * pm2, g3 = -dot(q, q) - k * pm2;
    const real small = sqrtl(dot(n, n)) + sqrtl(dot(p, p)) + sqrtl(dot(q, q)), sizes = l->size_b + l->size_t;
    const real large = sqrtl(dot(m0, m0)) + sqrtl(dot(m1, m1)) + small;
    const real noise =
        ROUNDING * (l->size_a + l->size_t) * (sizes * large + small * l->size_d) * (1 + fabsl(u0) + fabsl(k));
    if (fabsl(g0) > fabsl(g1) + fabsl(g2) + fabsl(g3) + w * (fabsl(pm0) + fabsl(pm1) + fabsl(pm2)) + noise)
        return NONE;
    if (!(slope > 0))
        return UNKNOWN;
    const real bend = (2 * (at + bt + l->tt) + fabsl(k) * (2 * at + l->tt)) / slope;
    const real rest = bend * (fabsl(pm0) + fabsl(pm1) + fabsl(pm2)) + w * (fabsl(pm1) + 2 * fabsl(pm2));
    return fabsl(g1) > 2 * fabsl(g2) + 3 * fabsl(g3) + rest + 4 * noise ? ONE_AT_MOST : UNKNOWN;
}

/* Exchanges xi and eta. */
static void exchange(struct local *l)
{
    const struct local o = *l;
    memcpy(l->a, o.b, sizeof l->a);
    memcpy(l->b, o.a, sizeof l->b);
    l->f1 = o.f2;
    l->f2 = o.f1;
    l->h11 = o.h22;
    l->h22 = o.h11;
    l->at = o.bt;
    l->bt = o.at;
    l->size_a = o.size_b;
    l->size_b = o.size_a;
    l->noise[0] = o.noise[1];
    l->noise[1] = o.noise[0];
}

static enum verdict judge(struct local *l)
{
    if (is_empty(l))
        return NONE;
    if (l->h11 < l->h22)
        exchange(l);
    return judge_valley(l);
}

/* Computes Newton's step, in u and v, with cancelling terms from cross products. */
static void newton(const struct local *l, real *u, real *v)
{
    real n[3], ad[3], bd[3];
    const real td = dot(l->t, l->d);
    cross(l->a, l->b, n);
    cross(l->a, l->d, ad);
    cross(l->b, l->d, bd);
    const real det = dot(n, n) + td * (2 * dot(l->a, l->b) - td);
    *u = (td * l->f2 - dot(n, bd)) / det;
    *v = (td * l->f1 + dot(n, ad)) / det;
}

/* Iterates Newton's method from the middle.  Returns 1 if it converges in the box. */
static int settle(const struct boxes_segment *f, const struct box *q, real z[2])
{
    struct box at = {q->x, q->y, q->hx, q->hy};
    real before = 9;
    for (int n = 0; n < STEPS; n++) {
        struct local l;
        real u, v;
        expand(f, &at, &l);
        newton(&l, &u, &v);
        const real step = larger(fabsl(u), fabsl(v));
        at.x += u * q->hx;
        at.y += v * q->hy;
        if (!(fabsl(at.x - q->x) <= 2 * q->hx && fabsl(at.y - q->y) <= 2 * q->hy))
            return 0;
        if (step >= before && step < SETTLED)
            break;
        before = step;
    }
    z[0] = at.x;
    z[1] = at.y;
    return before < SETTLED && fabsl(z[0] - q->x) <= q->hx * (1 + 1e-9L) && fabsl(z[1] - q->y) <= q->hy * (1 + 1e-9L);
}

static void add_root(const real z[2], struct boxes_list *list)
{
    for (int k = 0; k < list->roots; k++)
        if (fabsl(list->root[k][0] - z[0]) < 1e-14L && fabsl(list->root[k][1] - z[1]) < 1e-14L)
            return;
    if (list->roots == BOXES_ROOTS) {
        list->complete = 0;
        return;
    }
    list->root[list->roots][0] = z[0];
    list->root[list->roots++][1] = z[1];
}

static void add_leaf(const struct boxes_segment *f, const struct box *q, struct boxes_list *list)
{
    real height, size;
    if (list->leaves == BOXES_LEAVES) {
        list->complete = 0;
        return;
    }
    (void)bound(f, sqrtl(dot(f->d0, f->d0)), q, list->leaf[list->leaves++], &height, &size);
}

void boxes_find(const struct boxes_segment *f, struct boxes_list *list)
{
    struct box stack[STACK];
    int top = 1, boxes = 0;
    list->roots = list->leaves = 0;
    list->complete = 1;
    stack[0] = (struct box){0, 0, 1 + BOXES_BEYOND, 1 + BOXES_BEYOND};
    while (top > 0 && list->complete) {
        struct box q = stack[--top];
        struct local l;
        real z[2];
        if (++boxes > MOST_BOXES)
            list->complete = 0;
        expand(f, &q, &l);
        const enum verdict verdict = judge(&l);
        if (verdict == NONE)
            continue;
        if (verdict == ONE_AT_MOST && settle(f, &q, z)) {
            add_root(z, list);
            continue;
        }
        if (larger(q.hx, q.hy) <= BOXES_LEAF) {
            add_leaf(f, &q, list);
            continue;
        }
        halve(&q, q.hx >= q.hy, &stack[top + 1]);
        stack[top] = q;
        top += 2;
    }
}

double boxes_regularity(const struct boxes_segment *f, const real z[2])
{
    const struct box q = {z[0], z[1], 1, 1};
    struct local l;
    real n[3];
    expand(f, &q, &l);
    cross(l.a, l.b, n);
    const real ab = dot(l.a, l.b), td = dot(l.t, l.d), terms = l.h11 * l.h22 + ab * ab + td * td;
    return terms > 0 ? (double)(fabsl(dot(n, n) + td * (2 * ab - td)) / terms) : 0;
}
