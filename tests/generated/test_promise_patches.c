/* What functions of patches promise: where they return FOOTPOINT_OK a minimum of the distance lies within NAME_PROMISE of xi and
 * eta, on the patch or where its formula continues it; with FOOTPOINT_OUTSIDE a minimum on the closed patch, at the border.  Patches are
 * ordinary, strongly warped, slivers, wild (collapsed, far away, of any size), slave nodes beside and about borders; some of each, a million
 * of each kind in each group with FOOTPOINT_LONG.  The judge makes control points by their definition and takes Newton's steps, in
 * quadruple precision; it shares no code with what it judges. */
#include "../../runtime/footpoint.h"
#include "../hard/draw.h"
#include "header_functions.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

__extension__ typedef __float128 wide;

enum { CASES = 130, CASES_LONG = 1000000, STEPS = 40, VECTORS = 9 };

static long cases(void)
{
    const char *const wanted = getenv("FOOTPOINT_CASES");
    return wanted ? atol(wanted) : getenv("FOOTPOINT_LONG") ? CASES_LONG : CASES;
}

static const char *const kinds[] = {"bezier", "gregory"};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Corners A, B, C, D, normals there, slave node. */
struct patch {
    int kind;
    double x[VECTORS][3];
};

/* ---- the judge ---- */

/* Control points; inner ones that edges along xi make, and those along eta. */
struct net {
    wide p[4][4][3], twin[4][4][3];
};

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

/* n x a */
static void turned(const double n[3], const wide a[3], wide c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = n[(i + 1) % 3] * a[(i + 2) % 3] - n[(i + 2) % 3] * a[(i + 1) % 3];
}

/* The two inner points beside an edge p[0] ... p[3] from the rows beside it at its ends, by Chiyokura and Kimura. */
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

/* Inner points of all edges; p[i][j]: i along xi. */
static void all_inner(const struct patch *f, struct net *t)
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

static void make_net(const struct patch *f, struct net *t)
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

/* Bernstein's polynomials and their derivatives by xi. */
static void bernstein(wide z, wide b[2][4])
{
    const wide t = (1 + z) / 2, u = 1 - t;
    const wide all[2][4] = {{u * u * u, 3 * t * u * u, 3 * t * t * u, t * t * t},
                            {-3 * u * u / 2, 3 * u * (u - 2 * t) / 2, 3 * t * (2 * u - t) / 2, 3 * t * t / 2}};
    memcpy(b, all, sizeof all);
}

/* An inner point of a Gregory patch, and its derivatives by xi and eta. */
static void blend(const struct net *t, int i, int j, const wide z[2], wide p[3][3])
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

/* r[0] the point, r[1] and r[2] the tangents. */
static void evaluate(const struct patch *f, const struct net *t, const wide z[2], wide r[3][3])
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

/* Slopes of half the squared distance, downhill. */
static void slopes(const struct patch *f, const struct net *t, const wide z[2], wide g[2])
{
    wide r[3][3], d[3];
    evaluate(f, t, z, r);
    for (int i = 0; i < 3; i++)
        d[i] = f->x[8][i] - r[0][i];
    g[0] = dot(r[1], d);
    g[1] = dot(r[2], d);
}

/* Newton's steps from z until they stand, of coordinates that are not held; whether that is a minimum. */
static bool minimum_near(const struct patch *f, const struct net *t, const bool held[2], wide z[2])
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

/* Whether what is held lies at the border, and slopes there lead out of the patch. */
static bool is_outwards(const struct patch *f, const struct net *t, const bool held[2], const wide z[2])
{
    wide g[2];
    slopes(f, t, z, g);
    for (int i = 0; i < 2; i++)
        if (held[i] ? size_of(z[i]) != 1 || !(g[i] * z[i] > 0) : !(size_of(z[i]) <= 1 + 1e-15))
            return false;
    return true;
}

/* Whether a minimum, with `held` coordinates those of loc, lies within the promise of loc: `known`, which is one if *is_known, or one
 * that is found now. */
static bool holds(const struct patch *f, const struct net *t, const bool held[2], const double loc[2], double promise,
                  wide known[2], bool *is_known)
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

/* The same for a status: FOOTPOINT_OK, or FOOTPOINT_OUTSIDE of an edge or a corner. */
static bool is_right(const struct patch *f, const struct net *t, int status, const double loc[2], double promise,
                     wide known[2], bool *is_known)
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

/* ---- patches ---- */

/* The slave node over a place in and beside the patch. */
static void draw_slave(struct patch *f, double xi, double eta, double gap)
{
    struct net t;
    wide r[3][3];
    const double beyond = 1e-6; /* where Gregory patches are continued */
    const wide z[2] = {fmax(-1 - beyond, fmin(1 + beyond, xi)), fmax(-1 - beyond, fmin(1 + beyond, eta))};
    double u[3], v[3], n[3];
    make_net(f, &t);
    evaluate(f, &t, z, r);
    for (int i = 0; i < 3; i++) {
        u[i] = (double)r[1][i];
        v[i] = (double)r[2][i];
    }
    draw_cross(u, v, n);
    const double length = sqrt(draw_dot(n, n));
    for (int i = 0; i < 3; i++)
        f->x[8][i] =
            (double)(r[0][i] + (xi - z[0]) * u[i] + (eta - z[1]) * v[i]) + (length > 0 ? gap * n[i] / length : 0);
}

/* Corners of a quadrilateral of edges 2 and 2 `width`, skewed, tapered and warped, and normals of a body of curvature `bend`, tilted by
 * `tilt`. */
static void draw_corners(uint64_t *stream, struct patch *f, double width, double bend, double tilt)
{
    static const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double skew = draw_flat(stream, -0.5, 0.5), taper = draw_flat(stream, -0.3, 0.3);
    const double k = draw_flat(stream, -bend, bend), l = draw_flat(stream, -bend, bend) / width;
    for (int c = 0; c < 4; c++) {
        const double x = at[c][0] * (1 + taper * at[c][1]) + skew * at[c][1], y = width * at[c][1];
        double *const n = f->x[4 + c], d[3];
        draw_direction(stream, d);
        f->x[c][0] = x;
        f->x[c][1] = y;
        f->x[c][2] = (k * x * x + l * y * y) / 2;
        n[0] = -k * x + tilt * d[0];
        n[1] = -l * y + tilt * d[1];
        n[2] = 1 + tilt * d[2];
        const double length = sqrt(draw_dot(n, n));
        for (int i = 0; i < 3; i++)
            n[i] /= length;
    }
}

/* Turned and moved by `shift`; then times 2^exponent. */
static void move(uint64_t *stream, struct patch *f, double shift, int exponent)
{
    double axis[3][3], to[3];
    draw_direction(stream, axis[0]);
    do
        draw_direction(stream, axis[1]);
    while (fabs(draw_dot(axis[0], axis[1])) > 0.9);
    draw_cross(axis[0], axis[1], axis[2]);
    const double length = sqrt(draw_dot(axis[2], axis[2]));
    for (int i = 0; i < 3; i++)
        axis[2][i] /= length;
    draw_cross(axis[2], axis[0], axis[1]);
    draw_direction(stream, to);
    for (int v = 0; v < VECTORS; v++) {
        const bool normal = v >= 4 && v < 8;
        double y[3] = {0, 0, 0};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                y[i] += axis[j][i] * f->x[v][j];
        for (int i = 0; i < 3; i++)
            f->x[v][i] = normal ? y[i] : ldexp(y[i] + shift * to[i], exponent);
    }
}

enum group { ORDINARY, STRONG, SLIVER, BORDER, WILD, GROUPS };
static const char *const group_names[] = {"ordinary", "strongly warped", "sliver", "border", "wild"};
/* % that must be proved of promises from 1e-7 on. */
static const int proved_least[GROUPS][KINDS] = {{99, 97}, {80, 60}, {70, 40}, {90, 70}, {30, 25}};

/* One of -1, 1, or near them, or between. */
static double draw_near_border(uint64_t *stream)
{
    const double sign = draw_sign(stream);
    switch (draw_choose(stream, 4)) {
    case 0:
        return sign;
    case 1:
        return sign * (1 + draw_sign(stream) * draw_power(stream, -14, -1));
    default:
        return draw_flat(stream, -1.3, 1.3);
    }
}

static void draw_wild(uint64_t *stream, struct patch *f)
{
    const int variant = draw_choose(stream, 8), corner = draw_choose(stream, 4);
    draw_corners(stream, f, draw_power(stream, -1, 0), 0.5, variant & 1 ? 0.1 : 1);
    draw_slave(f, draw_flat(stream, -1.5, 1.5), draw_flat(stream, -1.5, 1.5),
               draw_power(stream, -3, variant & 2 ? 3 : 0) * draw_sign(stream));
    if (variant == 4)
        for (int v = 0; v < 2; v++)
            memcpy(f->x[4 * v + corner], f->x[4 * v + (corner + 1) % 4], sizeof f->x[0]);
    else if (variant == 5)
        memcpy(f->x[corner], f->x[(corner + 1) % 4], sizeof f->x[0]);
    else if (variant == 6)
        draw_direction(stream, f->x[4 + corner]);
    else if (variant == 7)
        for (int i = 0; i < 3; i++)
            f->x[corner][i] += draw_flat(stream, 0.5, 1.2) * (f->x[(corner + 2) % 4][i] - f->x[corner][i]);
    move(stream, f, draw_power(stream, 0, variant & 1 ? 6 : 0), draw_choose(stream, 3) * 330 - 330);
}

static void draw_patch(uint64_t *stream, enum group group, struct patch *f)
{
    const double width = draw_power(stream, -3, 0);
    switch (group) {
    case ORDINARY:
        draw_corners(stream, f, draw_power(stream, -0.3, 0.3), 0.15, 0.03);
        draw_slave(f, draw_flat(stream, -1, 1), draw_flat(stream, -1, 1), draw_flat(stream, -0.2, 0.2));
        break;
    case STRONG:
        draw_corners(stream, f, draw_power(stream, -0.3, 0.3), 0.5, draw_flat(stream, 0, 0.6));
        draw_slave(f, draw_flat(stream, -1.1, 1.1), draw_flat(stream, -1.1, 1.1), draw_flat(stream, -0.3, 0.3));
        break;
    case SLIVER:
        draw_corners(stream, f, width, 0.15 * width, 0.02);
        draw_slave(f, draw_flat(stream, -1.1, 1.1), draw_flat(stream, -1.1, 1.1), width * draw_flat(stream, -0.5, 0.5));
        break;
    case BORDER:
        draw_corners(stream, f, draw_power(stream, -0.3, 0.3), 0.2, 0.05);
        draw_slave(f, draw_near_border(stream), draw_near_border(stream), draw_flat(stream, -0.2, 0.2));
        break;
    default:
        draw_wild(stream, f);
        return;
    }
    move(stream, f, 10, 0);
}

/* ---- tests ---- */

static const struct header_function *judged(size_t i, int kind)
{
    const struct header_function *const f = &header_functions[i];
    return f->promise > 0 && strcmp(f->kind, kinds[kind]) == 0 ? f : NULL;
}

static void fail_on(const struct patch *f, const char *name, const char *group, int status, const double loc[2])
{
    for (int v = 0; v < VECTORS; v++)
        print_error("{%a, %a, %a},\n", f->x[v][0], f->x[v][1], f->x[v][2]);
    fail_msg("%s, %s: status %d at (%.17g, %.17g)", name, group, status, loc[0], loc[1]);
}

/* In another unit of length, so that quadruple precision suffices. */
static struct patch unit_patch(const struct patch *f)
{
    struct patch g = *f;
    int exponent;
    double most = 0;
    for (int v = 0; v < VECTORS; v++)
        for (int i = 0; i < 3 && (v < 4 || v == 8); i++)
            most = fmax(most, fabs(f->x[v][i]));
    (void)frexp(most, &exponent);
    for (int v = 0; v < VECTORS; v++)
        for (int i = 0; i < 3 && (v < 4 || v == 8); i++)
            g.x[v][i] = ldexp(f->x[v][i], -exponent);
    return g;
}

static void judge(const struct patch *f, enum group group, long proved[HEADER_FUNCTIONS][2])
{
    const struct patch scaled = unit_patch(f);
    const double *x[VECTORS];
    struct net t;
    wide known[2] = {0, 0};
    bool is_known = false;
    make_net(&scaled, &t);
    for (int v = 0; v < VECTORS; v++)
        x[v] = f->x[v];
    for (size_t i = HEADER_FUNCTIONS; i-- > 0;) {
        const struct header_function *const function = judged(i, f->kind);
        double loc[2], gap;
        const int status = function ? function->locate(x, f->x[8], loc, &gap) : FOOTPOINT_UNPROVED;
        if (status != FOOTPOINT_OK && status != FOOTPOINT_OUTSIDE)
            continue;
        if (!is_right(&scaled, &t, status, loc, function->promise, known, &is_known))
            fail_on(f, function->name, group_names[group], status, loc);
        proved[i][status == FOOTPOINT_OUTSIDE]++;
    }
}

static void test_group(enum group group)
{
    for (int k = 0; k < KINDS; k++) {
        long proved[HEADER_FUNCTIONS][2] = {{0}};
        uint64_t stream = 640 + (uint64_t)group;
        for (long i = 0; i < cases(); i++) {
            struct patch f = {.kind = k};
            draw_patch(&stream, group, &f);
            judge(&f, group, proved);
        }
        for (size_t i = 0; i < HEADER_FUNCTIONS; i++) {
            const struct header_function *const f = judged(i, k);
            if (!f)
                continue;
            const double share = 100. * (double)(proved[i][0] + proved[i][1]) / (double)cases();
            if (cases() != CASES)
                print_message("%s, %s: %.2f %% proved, %.2f %% outside\n", f->name, group_names[group], share,
                              100. * (double)proved[i][1] / (double)cases());
            if (f->promise > 1e-8 && share < proved_least[group][k])
                fail_msg("%s, %s: %.2f %% proved", f->name, group_names[group], share);
        }
    }
}

static void test_ordinary(void **state)
{
    (void)state;
    test_group(ORDINARY);
}

static void test_strong(void **state)
{
    (void)state;
    test_group(STRONG);
}

static void test_sliver(void **state)
{
    (void)state;
    test_group(SLIVER);
}

static void test_border(void **state)
{
    (void)state;
    test_group(BORDER);
}

static void test_wild(void **state)
{
    (void)state;
    test_group(WILD);
}

/* The answer in an array is as good as the answer alone: proved if that is, within both promises of that on ordinary
 * patches, where the gap differs by the square of what xi and eta do, by the third power of a step, and by rounding to single precision; statuses below 0 are the same. */
static void compare(const struct header_function *f, const struct patch *p, int status, const double found[2],
                    double gap, bool ordinary)
{
    const double *y[VECTORS];
    double loc[2] = {0, 0}, g = 0, size = 0;
    for (int v = 0; v < VECTORS; v++)
        y[v] = p->x[v];
    const int alone = f->locate(y, p->x[8], loc, &g);
    if (status != alone && !(status == FOOTPOINT_OK && alone > FOOTPOINT_OK))
        fail_msg("%s: status %d in an array, %d alone", f->name, status, alone);
    if (!ordinary || alone != FOOTPOINT_OK)
        return;
    for (int i = 0; i < 3; i++)
        size += fabs(p->x[1][i] - p->x[0][i]) + fabs(p->x[2][i] - p->x[1][i]);
    const double away = fmax(fabs(loc[0] - found[0]), fabs(loc[1] - found[1]));
    const double off = (away * away + (f->promise < 9e-4 ? 1e-14 + 1e-6 * f->promise : 1e-6)) * size;
    if (!(away <= 2 * f->promise && fabs(gap - g) <= off))
        fail_msg("%s: %g away from the answer alone, gaps by %g", f->name, away, fabs(gap - g));
}

static void test_arrays(void **state)
{
    enum { PAIRS = 75, ROWS = 3 * VECTORS };
    static double column[ROWS][PAIRS], xi[PAIRS], eta[PAIRS], gap[PAIRS];
    static struct patch patch[PAIRS];
    static int status[PAIRS];
    const double *x[ROWS];
    uint64_t stream = 650;
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        for (int i = 0; i < PAIRS; i++) {
            patch[i].kind = k;
            draw_patch(&stream, (enum group)(i % GROUPS), &patch[i]);
            for (int row = 0; row < ROWS; row++) {
                column[row][i] = patch[i].x[row / 3][row % 3];
                x[row] = column[row];
            }
        }
        for (size_t j = 0; j < HEADER_FUNCTIONS; j++) {
            const struct header_function *const f = judged(j, k);
            if (!f)
                continue;
            f->checked_n(PAIRS, x, xi, eta, gap, status);
            for (int i = 0; i < PAIRS; i++) {
                const struct patch scaled = unit_patch(&patch[i]);
                const double found[2] = {xi[i], eta[i]};
                struct net t;
                wide known[2] = {0, 0};
                bool is_known = false;
                make_net(&scaled, &t);
                if ((status[i] == FOOTPOINT_OK || status[i] == FOOTPOINT_OUTSIDE) &&
                    !is_right(&scaled, &t, status[i], found, f->promise, known, &is_known))
                    fail_on(&patch[i], f->name, "arrays", status[i], found);
                compare(f, &patch[i], status[i], found, gap[i], i % GROUPS == ORDINARY);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ordinary), cmocka_unit_test(test_strong), cmocka_unit_test(test_sliver),
        cmocka_unit_test(test_border),   cmocka_unit_test(test_wild),   cmocka_unit_test(test_arrays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
