/* Gregory patches for the reference search; see foot_patch_local.h. */
#include "foot_patch_local.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const struct {
    int i, j; /* orders of derivatives by u and v */
    double factor;
} third_order[4] = {{3, 0, 6}, {2, 1, 18}, {1, 2, 18}, {0, 3, 6}};

/* Returns the i-th difference of four numbers with respect to the index, starting at the k-th. */
static double difference(const double a[4], int i, int k)
{
    switch (i) {
    case 0:
        return a[k];
    case 1:
        return a[k + 1] - a[k];
    case 2:
        return a[k + 2] - 2 * a[k + 1] + a[k];
    default:
        return a[3] - 3 * a[2] + 3 * a[1] - a[0];
    }
}

static double largest_difference(double p[4][4][3], int c, int i, int j)
{
    double most = 0;
    for (int l = 0; l + j < 4; l++) {
        double column[4];
        for (int k = 0; k < 4; k++) {
            const double row[4] = {p[k][0][c], p[k][1][c], p[k][2][c], p[k][3][c]};
            column[k] = difference(row, j, l);
        }
        for (int k = 0; k + i < 4; k++)
            most = fmax(most, fabs(difference(column, i, k)));
    }
    return most;
}

bool patch_localise(const struct footpoint_gregory *patch, const double xs[3], struct patch_local *l)
{
    l->size = 0;
    for (int k = 0; k < 48; k++)
        l->size = fmax(l->size, fabs(patch->net.p[k / 12][k / 3 % 4][k % 3]));
    if (!isfinite(l->size) || !(l->size > 0) || !isfinite(xs[0] + xs[1] + xs[2]))
        return false;
    for (int c = 0; c < 3; c++) {
        const double d = xs[c] - patch->net.origin[c];
        for (int k = 0; k < 16; k++)
            l->p[k / 4][k % 4][c] = (patch->net.p[k / 4][k % 4][c] - d) / l->size;
        for (int k = 0; k < 4; k++)
            l->e[k / 2][k % 2][c] = (patch->twin[k / 2][k % 2][c] - patch->net.p[1 + k / 2][1 + k % 2][c]) / l->size;
        for (int k = 0; k < 4; k++)
            l->third[k][c] = third_order[k].factor * largest_difference(l->p, c, third_order[k].i, third_order[k].j);
    }
    return true;
}

static void bernstein(long double t, long double b[3][4])
{
    const long double s = 1 - t;
    const long double value[3][4] = {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
                                     {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t},
                                     {6 * s, 6 * (t - 2 * s), 6 * (s - 2 * t), 6 * t}};
    memcpy(b, value, sizeof value);
}

/* Computes the part y/(x + y) that the twin has in an inner point (47)-(50), and its derivatives by x and y: value, x, y, xx,
 * xy, yy. */
static void twin_part(long double x, long double y, long double p[6])
{
    const long double sum = x + y;
    memset(p, 0, 6 * sizeof *p);
    p[0] = 0.5L;
    if (sum == 0)
        return;
    p[0] = y / sum;
    p[1] = -p[0] / sum;
    p[2] = (1 - p[0]) / sum;
    p[3] = -2 * p[1] / sum;
    p[4] = -(p[1] + p[2]) / sum;
    p[5] = -2 * p[2] / sum;
}

/* Adds weight[] times a vector to r, u, v, uu, uv, vv. */
static void add_weighted(const long double weight[6], const double x[3], struct patch_jet *jet)
{
    for (int c = 0; c < 3; c++) {
        jet->r[c] += weight[0] * x[c];
        jet->u[c] += weight[1] * x[c];
        jet->v[c] += weight[2] * x[c];
        jet->uu[c] += weight[3] * x[c];
        jet->uv[c] += weight[4] * x[c];
        jet->vv[c] += weight[5] * x[c];
    }
}

void patch_evaluate(const struct patch_local *l, long double u, long double v, struct patch_jet *jet)
{
    long double a[3][4], b[3][4];
    bernstein(u, a);
    bernstein(v, b);
    memset(jet, 0, sizeof *jet);
    for (int k = 0; k < 16; k++) {
        const int i = k / 4, j = k % 4;
        const long double w[6] = {a[0][i] * b[0][j], a[1][i] * b[0][j], a[0][i] * b[1][j],
                                  a[2][i] * b[0][j], a[1][i] * b[1][j], a[0][i] * b[2][j]};
        add_weighted(w, l->p[i][j], jet);
        if (i % 3 == 0 || j % 3 == 0)
            continue;
        const long double su = i == 1 ? 1 : -1, sv = j == 1 ? 1 : -1;
        long double p[6];
        twin_part(i == 1 ? u : 1 - u, j == 1 ? v : 1 - v, p);
        p[1] *= su;
        p[2] *= sv;
        p[4] *= su * sv;
        const long double twin[6] = {w[0] * p[0],
                                     w[1] * p[0] + w[0] * p[1],
                                     w[2] * p[0] + w[0] * p[2],
                                     w[3] * p[0] + 2 * w[1] * p[1] + w[0] * p[3],
                                     w[4] * p[0] + w[1] * p[2] + w[2] * p[1] + w[0] * p[4],
                                     w[5] * p[0] + 2 * w[2] * p[2] + w[0] * p[5]};
        add_weighted(twin, l->e[i - 1][j - 1], jet);
    }
}

/* Iterates Newton's method from (u,v) until steps are at the level of rounding: tiny, or small and no longer
 * shrinking. */
bool patch_polish(const struct patch_local *l, long double *u, long double *v, bool *minimum)
{
    long double last = INFINITY;
    for (int i = 0; i < 50; i++) {
        struct patch_jet jet;
        patch_evaluate(l, *u, *v, &jet);
        const long double f1 = long_dot(jet.u, jet.r), f2 = long_dot(jet.v, jet.r);
        const long double h11 = long_dot(jet.u, jet.u) + long_dot(jet.uu, jet.r),
                          h22 = long_dot(jet.v, jet.v) + long_dot(jet.vv, jet.r);
        const long double h12 = long_dot(jet.u, jet.v) + long_dot(jet.uv, jet.r), det = h11 * h22 - h12 * h12;
        *minimum = det > 0 && h11 > 0;
        const long double du = (h12 * f2 - h22 * f1) / det, dv = (h12 * f1 - h11 * f2) / det;
        const long double step = fabsl(du) + fabsl(dv);
        if (!isfinite(step))
            return false;
        *u += du;
        *v += dv;
        if (step <= 4 * LDBL_EPSILON || (step < 1e-12L && step >= last))
            return true;
        last = step;
    }
    return false;
}

struct stationary patch_point_at(const struct patch_local *l, long double u, long double v, bool minimum)
{
    struct patch_jet jet;
    patch_evaluate(l, u, v, &jet);
    return (struct stationary){.xi = (double)(2 * u - 1),
                               .eta = (double)(2 * v - 1),
                               .distance = (double)(l->size * sqrtl(long_dot(jet.r, jet.r))),
                               .minimum = minimum};
}
