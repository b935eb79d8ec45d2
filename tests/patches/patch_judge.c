/* Computes control points by their definition; see patch_judge.h. */
#include "patch_judge.h"

#include "../../runtime/footpoint.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

typedef patch_wide wide;

enum { STEPS = 40 };

static double size_of(wide x)
{
    return fabs((double)x);
}

static wide dot(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void less(const wide a[3], const wide b[3], wide c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[i] - b[i];
}

/* Computes n x a. */
static void turned(const double n[3], const wide a[3], wide c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = n[(i + 1) % 3] * a[(i + 2) % 3] - n[(i + 2) % 3] * a[(i + 1) % 3];
}

/* Computes the two inner points beside an edge p[0] ... p[3] from the rows beside it at its ends, by Chiyokura and
 * Kimura. */
static void inner(wide *const p[4], wide *const beside[2], const double *const n[2], wide *const q[2])
{
    wide c[3][3], a[2][3], g[2][3], k[2], h[2];
    for (int i = 0; i < 3; i++)
        less(p[i + 1], p[i], c[i]);
    for (int i = 0; i < 2; i++) {
        wide *const edge = c[2 * i];
        less(beside[i], p[3 * i], a[i]);
        turned(n[i], edge, g[i]);
        k[i] = dot(a[i], g[i]) / dot(edge, edge);
        h[i] = dot(a[i], edge) / dot(edge, edge);
    }
    for (int i = 0; i < 3; i++) {
        q[0][i] = p[1][i] + ((k[0] + k[1]) * g[0][i] + k[0] * g[1][i] + 2 * h[0] * c[1][i] + h[1] * c[0][i]) / 3;
        q[1][i] = p[2][i] + (k[1] * g[0][i] + (k[0] + k[1]) * g[1][i] + h[0] * c[2][i] + 2 * h[1] * c[1][i]) / 3;
    }
}

/* Computes inner points of all edges; p[i][j]: i along xi. */
static void all_inner(const struct patch_case *f, struct patch_net *t)
{
    static const int normal[2][2] = {{4, 7}, {5, 6}}; /* by xi, eta */
    for (int side = 0; side < 2; side++) {
        const int j = 3 * side, k = 1 + side;
        wide *const along[4] = {t->p[0][j], t->p[1][j], t->p[2][j], t->p[3][j]};
        wide *const up[2] = {t->p[0][k], t->p[3][k]}, *const made[2] = {t->p[1][k], t->p[2][k]};
        const double *const n[2] = {f->x[normal[0][side]], f->x[normal[1][side]]};
        inner(along, up, n, made);
    }
    for (int side = 0; side < 2; side++) {
        const int i = 3 * side, k = 1 + side;
        wide *const along[4] = {t->p[i][0], t->p[i][1], t->p[i][2], t->p[i][3]};
        wide *const right[2] = {t->p[k][0], t->p[k][3]}, *const made[2] = {t->twin[k][1], t->twin[k][2]};
        const double *const n[2] = {f->x[normal[side][0]], f->x[normal[side][1]]};
        inner(along, right, n, made);
    }
}

void patch_net_make(const struct patch_case *f, struct patch_net *t)
{
    static const int at[4][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}}, next[4] = {1, 0, 3, 2};
    memset(t, 0, sizeof *t);
    for (int c = 0; c < 4; c++) {
        const int i = at[c][0], j = at[c][1], k = i ? 2 : 1, l = j ? 2 : 1;
        const double *const n = f->x[4 + c];
        for (int m = 0; m < 2; m++) {
            const double *const to = f->x[m ? 3 - c : next[c]];
            wide *const handle = m ? t->p[i][l] : t->p[k][j], along = 0;
            for (int o = 0; o < 3; o++)
                along += ((wide)to[o] - f->x[c][o]) * n[o];
            for (int o = 0; o < 3; o++)
                handle[o] = f->x[c][o] + ((wide)to[o] - f->x[c][o] - along * n[o]) / 3;
        }
        for (int o = 0; o < 3; o++) {
            t->p[i][j][o] = f->x[c][o];
            t->p[k][l][o] = t->p[k][j][o] + t->p[i][l][o] - f->x[c][o];
        }
    }
    if (f->kind == 1)
        all_inner(f, t);
}

/* Computes Bernstein polynomials and their derivatives by xi. */
static void bernstein(wide z, wide b[2][4])
{
    const wide t = (1 + z) / 2, u = 1 - t;
    const wide all[2][4] = {{u * u * u, 3 * t * u * u, 3 * t * t * u, t * t * t},
                            {-3 * u * u / 2, 3 * u * (u - 2 * t) / 2, 3 * t * (2 * u - t) / 2, 3 * t * t / 2}};
    memcpy(b, all, sizeof all);
}

/* Computes an inner point of a Gregory patch, and its derivatives by xi and eta. */
static void blend(const struct patch_net *t, int i, int j, const wide z[2], wide p[3][3])
{
    const wide x = (i == 1 ? 1 + z[0] : 1 - z[0]) / 2, y = (j == 1 ? 1 + z[1] : 1 - z[1]) / 2, sum = x + y;
    const wide w = sum == 0 ? 0.5 : x / sum, per = sum == 0 ? 0 : 1 / (2 * sum * sum);
    for (int o = 0; o < 3; o++) {
        const wide more = t->p[i][j][o] - t->twin[i][j][o];
        p[0][o] = t->twin[i][j][o] + w * more;
        p[1][o] = (i == 1 ? y : -y) * per * more;
        p[2][o] = (j == 1 ? -x : x) * per * more;
    }
}

void patch_net_at(const struct patch_case *f, const struct patch_net *t, const wide z[2], wide r[3][3])
{
    wide b[2][4], c[2][4];
    bernstein(z[0], b);
    bernstein(z[1], c);
    memset(r, 0, 3 * sizeof *r);
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            wide p[3][3] = {{t->p[i][j][0], t->p[i][j][1], t->p[i][j][2]}};
            const bool blended = f->kind == 1 && i % 3 && j % 3;
            if (blended)
                blend(t, i, j, z, p);
            for (int o = 0; o < 3; o++) {
                r[0][o] += b[0][i] * c[0][j] * p[0][o];
                r[1][o] += b[1][i] * c[0][j] * p[0][o] + (blended ? b[0][i] * c[0][j] * p[1][o] : 0);
                r[2][o] += b[0][i] * c[1][j] * p[0][o] + (blended ? b[0][i] * c[0][j] * p[2][o] : 0);
            }
        }
}

/* Computes the slopes of half the squared distance, downhill. */
static void slopes(const struct patch_case *f, const struct patch_net *t, const wide z[2], wide g[2])
{
    wide r[3][3], d[3];
    patch_net_at(f, t, z, r);
    for (int i = 0; i < 3; i++)
        d[i] = f->x[8][i] - r[0][i];
    g[0] = dot(r[1], d);
    g[1] = dot(r[2], d);
}

/* Takes Newton steps from z until they stop, in coordinates that are not held. Returns true if that is a minimum. */
static bool minimum_near(const struct patch_case *f, const struct patch_net *t, const bool held[2], wide z[2])
{
    const wide h = 1e-10;
    for (int k = 0; k < STEPS; k++) {
        wide g[2], right[2], above[2], to[2] = {z[0] + h, z[1]}, up[2] = {z[0], z[1] + h};
        slopes(f, t, z, g);
        slopes(f, t, to, right);
        slopes(f, t, up, above);
        const wide h11 = held[0] ? 1 : (g[0] - right[0]) / h, h22 = held[1] ? 1 : (g[1] - above[1]) / h;
        const wide h12 = held[0] || held[1] ? 0 : (g[0] - above[0] + g[1] - right[1]) / (2 * h);
        const wide det = h11 * h22 - h12 * h12, a = held[0] ? 0 : g[0], b = held[1] ? 0 : g[1];
        const wide s = (h22 * a - h12 * b) / det, q = (h11 * b - h12 * a) / det;
        if (!(size_of(s) + size_of(q) < 1e3)) /* nan, too */
            return false;
        z[0] += s;
        z[1] += q;
        if (size_of(s) + size_of(q) < 1e-16) /* the next is less than a millionth of it */
            return det > 0 && h11 > 0;
    }
    return false;
}

static bool is_within(const wide z[2], const double loc[2], double promise)
{
    return size_of(z[0] - loc[0]) <= promise && size_of(z[1] - loc[1]) <= promise;
}

/* Returns true if held coordinates lie at the border and slopes there lead out of the patch. */
static bool is_outwards(const struct patch_case *f, const struct patch_net *t, const bool held[2], const wide z[2])
{
    wide g[2];
    slopes(f, t, z, g);
    for (int i = 0; i < 2; i++)
        if (held[i] ? size_of(z[i]) != 1 || !(g[i] * z[i] > 0) : !(size_of(z[i]) <= 1 + 1e-15))
            return false;
    return true;
}

/* Returns true if a minimum that shares the `held` coordinates of loc lies within the promise of loc. That is `known`
 * if *is_known, otherwise a minimum that is searched here. */
static bool holds(const struct patch_case *f, const struct patch_net *t, const bool held[2], const double loc[2],
                  double promise, wide known[2], bool *is_known)
{
    const bool border = held[0] || held[1];
    if (*is_known && is_within(known, loc, promise) && !border)
        return true;
    for (int i = 0; i < 25; i++) {
        const int along = (i + 2) % 5 - 2, across = (i / 5 + 2) % 5 - 2;
        wide z[2] = {loc[0] + (held[0] ? 0 : promise * along / 2), loc[1] + (held[1] ? 0 : promise * across / 2)};
        if (((held[0] && held[1]) || minimum_near(f, t, held, z)) && is_within(z, loc, promise) &&
            (!border || is_outwards(f, t, held, z))) {
            known[0] = z[0];
            known[1] = z[1];
            *is_known = !border;
            return true;
        }
    }
    return false;
}

bool patch_answer_holds(const struct patch_case *f, const struct patch_net *t, int status, const double loc[2],
                        double promise, wide known[2], bool *is_known)
{
    static const bool held[4][2] = {{true, true}, {true, false}, {false, true}, {false, false}};
    if (!(fabs(loc[0]) <= 1 && fabs(loc[1]) <= 1))
        return false;
    if (status == FOOTPOINT_OK)
        return holds(f, t, held[3], loc, promise, known, is_known);
    for (int i = 0; i < 3; i++)
        if ((!held[i][0] || fabs(loc[0]) == 1) && (!held[i][1] || fabs(loc[1]) == 1) &&
            holds(f, t, held[i], loc, promise, known, is_known))
            return true;
    return false;
}

struct patch_case patch_unit(const struct patch_case *f)
{
    struct patch_case g = *f;
    int exponent;
    double most = 0;
    for (int v = 0; v < PATCH_VECTORS; v++)
        for (int i = 0; i < 3 && (v < 4 || v == 8); i++)
            most = fmax(most, fabs(f->x[v][i]));
    (void)frexp(most, &exponent);
    for (int v = 0; v < PATCH_VECTORS; v++)
        for (int i = 0; i < 3 && (v < 4 || v == 8); i++)
            g.x[v][i] = ldexp(f->x[v][i], -exponent);
    return g;
}
