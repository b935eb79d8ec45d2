/* Finds certain closest points of patches; see patch_nearest.h. */
#include "patch_nearest.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef patch_wide wide;

enum { STEPS = 100, LEAVES = 4096 };
#define SMALLEST (1. / 128) /* part of the patch */
#define APART 0.02          /* parts nearer than this to one that was settled, or to its minimum, lead to that */

static double size_of(wide x)
{
    return fabs((double)x);
}

/* ---- minima ---- */

static wide half_square(const struct patch_case *f, const struct patch_net *t, const wide z[2], wide g[2])
{
    wide r[3][3], half = 0;
    patch_net_at(f, t, z, r);
    g[0] = g[1] = 0;
    for (int i = 0; i < 3; i++) {
        const wide d = f->x[8][i] - r[0][i];
        half += d * d / 2;
        g[0] += r[1][i] * d;
        g[1] += r[2][i] * d;
    }
    return half;
}

/* Computes half the square, slopes downhill, and, by differences into the patch, the Hessian. */
static wide derive(const struct patch_case *f, const struct patch_net *t, const wide z[2], wide g[2], wide H[3])
{
    const wide h = z[0] > 0 ? -(wide)1e-12 : (wide)1e-12, k = z[1] > 0 ? -(wide)1e-12 : (wide)1e-12;
    const wide right[2] = {z[0] + h, z[1]}, above[2] = {z[0], z[1] + k};
    wide a[2], b[2];
    const wide half = half_square(f, t, z, g);
    (void)half_square(f, t, right, a);
    (void)half_square(f, t, above, b);
    H[0] = (g[0] - a[0]) / h;
    H[1] = (g[1] - a[1]) / h;
    H[2] = (g[1] - b[1]) / k;
    return half;
}

/* Writes Newton's step, or one downhill, of the coordinates that no edge holds. */
static void step_from(const wide z[2], const wide g[2], const wide H[3], wide s[2])
{
    const bool held[2] = {(z[0] >= 1 && g[0] >= 0) || (z[0] <= -1 && g[0] <= 0),
                          (z[1] >= 1 && g[1] >= 0) || (z[1] <= -1 && g[1] <= 0)};
    const wide det = H[0] * H[2] - H[1] * H[1];
    if (!held[0] && !held[1] && det > 0 && H[0] > 0) {
        s[0] = (H[2] * g[0] - H[1] * g[1]) / det;
        s[1] = (H[0] * g[1] - H[1] * g[0]) / det;
        return;
    }
    for (int i = 0; i < 2; i++) {
        const wide h = H[2 * i] > 0 ? H[2 * i] : -H[2 * i];
        s[i] = held[i] || h == 0 ? 0 : g[i] / h;
    }
}

wide patch_settle(const struct patch_case *f, const struct patch_net *t, wide z[2])
{
    wide g[2], H[3], half = derive(f, t, z, g, H);
    for (int k = 0; k < STEPS; k++) {
        wide s[2], to[2], G[2], less;
        double moved;
        step_from(z, g, H, s);
        do {
            for (int i = 0; i < 2; i++)
                to[i] = z[i] + s[i] < -1 ? -1 : z[i] + s[i] > 1 ? 1 : z[i] + s[i];
            less = half_square(f, t, to, G);
            moved = size_of(to[0] - z[0]) + size_of(to[1] - z[1]);
            s[0] /= 4;
            s[1] /= 4;
        } while (less > half && moved > 1e-16);
        if (less > half || !(moved > 0))
            return half;
        memcpy(z, to, sizeof to);
        half = less;
        if (moved < 1e-17)
            return half;
        (void)derive(f, t, z, g, H);
    }
    return half;
}

/* ---- parts ---- */

/* A part of the patch, x[0] to x[1] and y[0] to y[1] of it. */
struct part {
    double x[2], y[2];
    double middle[3], centre; /* the middle less the slave node, its distance */
};

/* The patch less the slave node in double precision, the least distance that is known, and parts that are left. */
struct search {
    double p[4][4][3], twin[4][4][3], least;
    bool twins;
    struct part leaf[LEAVES];
    int leaves;
};

static double weight(double x, double y)
{
    return x + y > 0 ? x / (x + y) : 0.5;
}

/* The largest value of 3 x (1 - x)^2 from a to b. */
static double bulge(double a, double b)
{
    const double left = 3 * a * (1 - a) * (1 - a), right = 3 * b * (1 - b) * (1 - b);
    return a < 1. / 3 && b > 1. / 3 ? 4. / 9 : fmax(left, right);
}

/* Moves inner point (i,j) to where it is in the middle of the part. Returns how far the patch is from there in it, at most. */
static double blend(const struct search *s, const struct part *c, int i, int j, double p[3])
{
    const double x[2] = {i == 1 ? c->x[0] : 1 - c->x[1], i == 1 ? c->x[1] : 1 - c->x[0]};
    const double y[2] = {j == 1 ? c->y[0] : 1 - c->y[1], j == 1 ? c->y[1] : 1 - c->y[0]};
    const double low = weight(x[0], y[1]), high = x[0] + y[0] > 0 ? weight(x[1], y[0]) : 1;
    const double middle = (low + high) / 2;
    double size = 0;
    for (int k = 0; k < 3; k++) {
        const double more = s->p[i][j][k] - s->twin[i][j][k];
        p[k] = s->twin[i][j][k] + middle * more;
        size += more * more;
    }
    return sqrt(size) * (high - low) / 2 * bulge(x[0], x[1]) * bulge(y[0], y[1]);
}

/* Four control points, `stride` numbers apart, from [0,1] to [a,b]. */
static void restrict_to(double *p, int stride, double a, double b)
{
    for (int k = 0; k < 3; k++) {
        double *const c[4] = {p + k, p + k + stride, p + k + 2 * stride, p + k + 3 * stride}, q[4];
        for (int i = 0; i < 4; i++) { /* blossoms of 3 - i times a and i times b */
            double w[4] = {*c[0], *c[1], *c[2], *c[3]};
            for (int n = 0; n < 3; n++) {
                const double at = n < i ? b : a;
                for (int m = 0; m < 3 - n; m++)
                    w[m] += at * (w[m + 1] - w[m]);
            }
            q[i] = w[0];
        }
        for (int i = 0; i < 4; i++)
            *c[i] = q[i];
    }
}

/* Computes control points over a part. Returns how far the patch is from theirs, at most. */
static double cut(const struct search *s, const struct part *c, double p[4][4][3])
{
    double off = 0;
    memcpy(p, s->p, sizeof s->p);
    for (int i = 1; i < 3 && s->twins; i++)
        for (int j = 1; j < 3; j++)
            off += blend(s, c, i, j, p[i][j]);
    for (int j = 0; j < 4; j++)
        restrict_to(p[0][j], 12, c->x[0], c->x[1]);
    for (int i = 0; i < 4; i++)
        restrict_to(p[i][0], 3, c->y[0], c->y[1]);
    return off;
}

/* Computes the middle of the part less the slave node, and its distance. */
static void measure(struct search *s, struct part *c)
{
    const double x = (c->x[0] + c->x[1]) / 2, y = (c->y[0] + c->y[1]) / 2;
    const struct part point = {.x = {x, x}, .y = {y, y}};
    double p[4][4][3];
    (void)cut(s, &point, p);
    memcpy(c->middle, p[0][0], sizeof p[0][0]);
    c->centre = sqrt(p[0][0][0] * p[0][0][0] + p[0][0][1] * p[0][0][1] + p[0][0][2] * p[0][0][2]);
    s->least = fmin(s->least, c->centre * (1 + 1e-13));
}

static double length(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

/* Whether to halve a part across xi: there it is longer in space. */
static bool is_wide(const struct part *c, double p[4][4][3])
{
    const double along = length(p[0][0], p[3][0]) + length(p[0][3], p[3][3]);
    const double across = length(p[0][0], p[0][3]) + length(p[3][0], p[3][3]);
    return c->y[1] - c->y[0] <= SMALLEST || (c->x[1] - c->x[0] > SMALLEST && along > across);
}

static void look_at(struct search *s, const struct part *c)
{
    double p[4][4][3], lower = INFINITY, size = 0;
    const double off = cut(s, c, p), *const r = c->middle;
    for (int k = 0; k < 16; k++) {
        const double *const q = p[k / 4][k % 4];
        lower = fmin(lower, c->centre > 0 ? (q[0] * r[0] + q[1] * r[1] + q[2] * r[2]) / c->centre : 0);
        size = fmax(size, fabs(q[0]) + fabs(q[1]) + fabs(q[2]));
    }
    if (lower - off > s->least + 1e-13 * size)
        return;
    if (fmax(c->x[1] - c->x[0], c->y[1] - c->y[0]) <= SMALLEST) {
        if (s->leaves < LEAVES)
            s->leaf[s->leaves++] = *c;
        return;
    }
    struct part half[2] = {*c, *c};
    for (int i = 0; i < 2; i++) {
        double *const cut = is_wide(c, p) ? half[i].x : half[i].y;
        cut[!i] = (cut[0] + cut[1]) / 2;
        measure(s, &half[i]);
    }
    const int first = half[1].centre < half[0].centre;
    look_at(s, &half[first]);
    look_at(s, &half[!first]);
}

static int nearer(const void *a, const void *b)
{
    const struct part *const p = a, *const q = b;
    return (p->centre > q->centre) - (p->centre < q->centre);
}

wide patch_nearest(const struct patch_case *f, const struct patch_net *t, wide z[2])
{
    static struct search s;
    double known[2 * LEAVES][2];
    int count = 0;
    wide best = 0;
    s.twins = f->kind == 1;
    s.least = INFINITY;
    s.leaves = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            for (int k = 0; k < 3; k++) {
                s.p[i][j][k] = (double)(t->p[i][j][k] - f->x[8][k]);
                s.twin[i][j][k] = (double)(t->twin[i][j][k] - f->x[8][k]);
            }
    struct part whole = {.x = {0, 1}, .y = {0, 1}};
    measure(&s, &whole);
    wide start[2] = {0, 0};
    s.least = fmin(s.least, sqrt(2 * (double)patch_settle(f, t, start)) * (1 + 1e-13));
    look_at(&s, &whole);
    qsort(s.leaf, (size_t)s.leaves, sizeof *s.leaf, nearer);
    for (int n = 0; n < s.leaves; n++) {
        const double x = s.leaf[n].x[0] + s.leaf[n].x[1] - 1, y = s.leaf[n].y[0] + s.leaf[n].y[1] - 1;
        bool seen = false;
        for (int k = 0; k < count && !seen; k++)
            seen = fabs(known[k][0] - x) < APART && fabs(known[k][1] - y) < APART;
        if (seen)
            continue;
        wide at[2] = {x, y};
        const wide half = patch_settle(f, t, at);
        known[count][0] = x;
        known[count++][1] = y;
        known[count][0] = (double)at[0];
        known[count++][1] = (double)at[1];
        if (count == 2 || half < best) {
            best = half;
            memcpy(z, at, sizeof at);
        }
    }
    return best;
}
