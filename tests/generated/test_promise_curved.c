/* What functions of faces of six, eight and nine nodes promise: where they say FOOTPOINT_OK a minimum of the distance lies within
 * NAME_PROMISE of xi and eta.  Faces are ordinary, strongly curved, arcs, folded, slivers, far away, of any size, with points that
 * coincide; some of each, a million of each kind in each group with FOOTPOINT_LONG.  The judge takes Newton's steps in quadruple
 * precision, of shape functions, and shares no code with what it judges. */
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

enum { CASES = 700, CASES_LONG = 1000000, STEPS = 60, MOST_NODES = 9 };

static long cases(void)
{
    return getenv("FOOTPOINT_LONG") ? CASES_LONG : CASES;
}

static const struct kind {
    const char *name;
    int nodes, corners;
} kinds[] = {{"tri6", 6, 3}, {"quad8", 8, 4}, {"quad9", 9, 4}};
enum { KINDS = sizeof kinds / sizeof *kinds };

/* Where nodes are: corners, nodes between them, the middle. */
static const double at_tri[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
static const double at_quad[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};

struct face {
    const struct kind *kind;
    double x[MOST_NODES + 1][3]; /* the slave node behind the others */
};

static const double *place_of(const struct kind *k, int node)
{
    return k->corners == 3 ? at_tri[node] : at_quad[node];
}

/* ---- the judge ---- */

static double size_of(wide x)
{
    return fabs((double)x);
}

/* A polynomial of one coordinate: its value, first and second derivative. */
struct jet {
    wide value[3];
};

static struct jet jet(wide value, wide first, wide second)
{
    const struct jet j = {{value, first, second}};
    return j;
}

/* 1 at `node` = -1, 0 or 1, 0 at the other two. */
static struct jet parabola(double node, wide z)
{
    return node == 0 ? jet(1 - z * z, -2 * z, -2) : jet(z * (z + node) / 2, z + (wide)node / 2, 1);
}

/* (1 + node z) / 2 */
static struct jet line(double node, wide z)
{
    return jet((1 + node * z) / 2, (wide)node / 2, 0);
}

/* Adds s f(xi) g(eta): shape[0] value, [1], [2] slopes, [3], [4], [5] second derivatives. */
static void add(wide shape[6], wide s, struct jet f, struct jet g)
{
    static const int along[6] = {0, 1, 0, 2, 1, 0}, across[6] = {0, 0, 1, 0, 1, 2};
    for (int i = 0; i < 6; i++)
        shape[i] += s * f.value[along[i]] * g.value[across[i]];
}

/* The shape function of a node. */
static void shape_of(const struct kind *k, int node, const wide z[2], wide shape[6])
{
    const double *const at = place_of(k, node);
    const struct jet one = jet(1, 0, 0), x = jet(z[0], 1, 0), y = jet(z[1], 1, 0);
    const struct jet xx = jet(z[0] * z[0], 2 * z[0], 2), yy = jet(z[1] * z[1], 2 * z[1], 2);
    for (int i = 0; i < 6; i++)
        shape[i] = 0;
    if (k->nodes == 9) {
        add(shape, 1, parabola(at[0], z[0]), parabola(at[1], z[1]));
    } else if (k->nodes == 8 && node >= 4) {
        if (at[0] == 0)
            add(shape, 1, parabola(0, z[0]), line(at[1], z[1]));
        else
            add(shape, 1, line(at[0], z[0]), parabola(0, z[1]));
    } else if (k->nodes == 8) { /* bilinear less halves of the neighbours' */
        add(shape, 1, line(at[0], z[0]), line(at[1], z[1]));
        add(shape, -0.5, parabola(0, z[0]), line(at[1], z[1]));
        add(shape, -0.5, line(at[0], z[0]), parabola(0, z[1]));
    } else { /* of w = 1 - xi - eta */
        static const int c[6][6] = {{1, -3, -3, 2, 4, 2}, {0, -1, 0, 2, 0, 0}, {0, 0, -1, 0, 0, 2},
                                    {0, 4, 0, -4, -4, 0}, {0, 0, 0, 0, 4, 0},  {0, 0, 4, 0, -4, -4}};
        add(shape, c[node][0], one, one);
        add(shape, c[node][1], x, one);
        add(shape, c[node][2], one, y);
        add(shape, c[node][3], xx, one);
        add(shape, c[node][4], x, y);
        add(shape, c[node][5], one, yy);
    }
}

/* Slopes and Hessian of half the squared distance at z. */
static void slopes(const struct face *f, const wide z[2], wide g[2], wide H[3])
{
    wide r[3][6] = {{0}};
    for (int k = 0; k < f->kind->nodes; k++) {
        wide shape[6];
        shape_of(f->kind, k, z, shape);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 6; j++)
                r[i][j] += shape[j] * f->x[k][i];
    }
    g[0] = g[1] = H[0] = H[1] = H[2] = 0;
    for (int i = 0; i < 3; i++) {
        const wide d = f->x[f->kind->nodes][i] - r[i][0];
        g[0] += r[i][1] * d;
        g[1] += r[i][2] * d;
        H[0] += r[i][1] * r[i][1] - r[i][3] * d;
        H[1] += r[i][1] * r[i][2] - r[i][4] * d;
        H[2] += r[i][2] * r[i][2] - r[i][5] * d;
    }
}

/* Newton's steps from z until they stand; whether that is a minimum. */
static bool minimum_near(const struct face *f, wide z[2])
{
    for (int k = 0; k < STEPS; k++) {
        wide g[2], H[3];
        slopes(f, z, g, H);
        const wide det = H[0] * H[2] - H[1] * H[1];
        const wide s = (H[2] * g[0] - H[1] * g[1]) / det, t = (H[0] * g[1] - H[1] * g[0]) / det;
        if (!(size_of(s) + size_of(t) < 1e3)) /* nan, too */
            return false;
        z[0] += s;
        z[1] += t;
        if (size_of(s) + size_of(t) < 1e-17 * (1 + size_of(z[0]) + size_of(z[1]))) /* the next is its square */
            return det > 0 && H[0] > 0;
    }
    return false;
}

static bool is_within(const wide z[2], const double loc[2], double promise)
{
    const double most = promise * fmax(1, fmax(fabs(loc[0]), fabs(loc[1])));
    return size_of(z[0] - loc[0]) <= most && size_of(z[1] - loc[1]) <= most;
}

/* Whether an answer that is OK is as near to a minimum as promised: to `known`, which is one if *is_known, or to one that is found
 * now from it, or from about it. */
static bool holds(const struct face *f, const double loc[2], double promise, wide known[2], bool *is_known)
{
    if (*is_known && is_within(known, loc, promise))
        return true;
    for (int i = 0; i < 25; i++) {
        const int along = (i + 2) % 5 - 2, across = (i / 5 + 2) % 5 - 2;
        wide z[2] = {loc[0] + promise * along / 2, loc[1] + promise * across / 2};
        if (minimum_near(f, z) && is_within(z, loc, promise)) {
            known[0] = z[0];
            known[1] = z[1];
            *is_known = true;
            return true;
        }
    }
    return false;
}

/* ---- faces ---- */

static void surface_at(const struct face *f, double xi, double eta, double r[3], double n[3])
{
    const wide z[2] = {xi, eta};
    double u[3] = {0}, v[3] = {0};
    r[0] = r[1] = r[2] = 0;
    for (int k = 0; k < f->kind->nodes; k++) {
        wide shape[6];
        shape_of(f->kind, k, z, shape);
        for (int i = 0; i < 3; i++) {
            r[i] += (double)shape[0] * f->x[k][i];
            u[i] += (double)shape[1] * f->x[k][i];
            v[i] += (double)shape[2] * f->x[k][i];
        }
    }
    draw_cross(u, v, n);
}

/* The slave node over a place in and beside the face, up to `gap` of an edge away. */
static void draw_slave(uint64_t *stream, struct face *f, double beside, double gap)
{
    const bool triangle = f->kind->corners == 3;
    double z[2] = {draw_flat(stream, -beside, beside), draw_flat(stream, -beside, beside)}, r[3], n[3];
    if (triangle) { /* folded from the square */
        z[0] = (z[0] + 1) / 2;
        z[1] = (z[1] + 1) / 2;
        if (z[0] + z[1] > 1) {
            z[0] = 1 - z[0];
            z[1] = 1 - z[1];
        }
    }
    surface_at(f, z[0], z[1], r, n);
    const double length = sqrt(draw_dot(n, n)), g = draw_flat(stream, -gap, gap);
    for (int i = 0; i < 3; i++)
        f->x[f->kind->nodes][i] = r[i] + (length > 0 ? g * n[i] / length : 0);
}

/* A face of edges 2, 2 `wide` for quadrilaterals: skewed, tapered, warped, nodes between corners off their places by `off`. */
static void draw_plain(uint64_t *stream, struct face *f, double width, double off)
{
    const double skew = draw_flat(stream, -0.7, 0.7), taper = draw_flat(stream, -0.3, 0.3);
    const double warp = draw_flat(stream, -0.15, 0.15), bend = draw_flat(stream, -0.2, 0.2) * (off > 0.1 ? 2 : 0.5);
    const double sign = draw_sign(stream);
    for (int k = 0; k < f->kind->nodes; k++) {
        const double *const at = place_of(f->kind, k), off_now = k < f->kind->corners ? 0 : off;
        const double u = at[0] * (1 + taper * at[1]), v = at[1];
        double d[3];
        draw_direction(stream, d);
        f->x[k][0] = u + skew * v + off_now * d[0];
        f->x[k][1] = width * (v + off_now * d[1]);
        f->x[k][2] = fmin(1, width) * (warp * u * v + bend * (u * u + sign * v * v) + off_now * d[2]);
    }
}

/* Part of a ring or, rolled up, of a cylinder, through up to `degrees`. */
static void draw_arc(uint64_t *stream, struct face *f, double degrees)
{
    const bool rolled = draw_next(stream) & 1, triangle = f->kind->corners == 3;
    const double half = draw_flat(stream, 0, degrees) * 3.14159265358979 / 360, inner = draw_flat(stream, 0.2, 0.9);
    for (int k = 0; k < f->kind->nodes; k++) {
        const double *const at = place_of(f->kind, k);
        const double u = triangle ? at[0] : (at[0] + 1) / 2, v = triangle ? 2 * at[1] - 1 : at[1];
        const double radius = rolled ? 1 : inner + (1 - inner) * u;
        f->x[k][0] = radius * cos(half * v);
        f->x[k][1] = radius * sin(half * v);
        f->x[k][2] = rolled ? (1 - inner) * u : 0;
    }
}

/* Nodes between corners at quarters of their edges, or farther; or a corner that is folded over. */
static void draw_bad(uint64_t *stream, struct face *f)
{
    const int n = f->kind->corners, folded = draw_choose(stream, 2 * n);
    draw_plain(stream, f, 1, 0.02);
    if (folded < n)
        for (int i = 0; i < 3; i++)
            f->x[folded][i] += draw_flat(stream, 0.5, 1.2) * (f->x[(folded + 2) % n][i] - f->x[folded][i]);
    else
        for (int k = n; k < 2 * n; k++) {
            const double *const a = f->x[k - n], *const b = f->x[(k - n + 1) % n], t = draw_flat(stream, 0.1, 0.9);
            for (int i = 0; i < 3; i++)
                f->x[k][i] = a[i] + t * (b[i] - a[i]);
        }
}

/* Turned and moved by `shift`; then times 2^exponent. */
static void move(uint64_t *stream, struct face *f, double shift, int exponent)
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
    for (int k = 0; k <= f->kind->nodes; k++) {
        double y[3] = {0, 0, 0};
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                y[i] += axis[j][i] * f->x[k][j];
        for (int i = 0; i < 3; i++)
            f->x[k][i] = ldexp(y[i] + shift * to[i], exponent);
    }
}

/* Two nodes in one place, or all nodes of an edge. */
static void coincide(uint64_t *stream, struct face *f)
{
    const int n = f->kind->corners, edge = draw_choose(stream, n), one = draw_choose(stream, f->kind->nodes);
    const bool whole = draw_next(stream) & 1;
    memcpy(f->x[whole ? (edge + 1) % n : one], f->x[edge], sizeof f->x[0]);
    if (whole)
        memcpy(f->x[n + edge], f->x[edge], sizeof f->x[0]);
}

enum group { ORDINARY, STRONG, SLIVER, WILD, GROUPS };
static const char *const group_names[] = {"ordinary", "strongly curved", "sliver", "wild"};
/* % that must be proved of promises from 1e-7 to 1e-2. */
static const int proved_least[] = {99, 80, 80, 40};

static void draw_face(uint64_t *stream, enum group group, struct face *f)
{
    const int variant = draw_choose(stream, 6);
    switch (group) {
    case ORDINARY:
        draw_plain(stream, f, draw_power(stream, -0.5, 0.5), 0.03);
        draw_slave(stream, f, 1.1, 0.2);
        move(stream, f, 10, 0);
        break;
    case STRONG:
        if (variant < 2)
            draw_plain(stream, f, draw_power(stream, -0.3, 0.3), draw_flat(stream, 0.3, 0.5));
        else if (variant < 4)
            draw_arc(stream, f, 200);
        else
            draw_bad(stream, f);
        draw_slave(stream, f, 1.1, 0.2);
        move(stream, f, 10, 0);
        break;
    case SLIVER: {
        const double width = draw_power(stream, -3, 0);
        draw_plain(stream, f, width, draw_flat(stream, 0, 0.15));
        draw_slave(stream, f, 1.1, width * draw_flat(stream, 0, 1));
        move(stream, f, 10, 0);
        break;
    }
    default:
        if (variant < 3)
            draw_plain(stream, f, draw_power(stream, -1, 0), draw_flat(stream, 0, 0.3));
        else
            draw_bad(stream, f);
        draw_slave(stream, f, variant & 1 ? 1.1 : 5, draw_power(stream, -3, variant & 2 ? 3 : 0));
        if (draw_choose(stream, 4) == 0)
            coincide(stream, f);
        move(stream, f, draw_power(stream, 0, draw_next(stream) & 1 ? 9 : 0), draw_choose(stream, 3) * 990 - 990);
    }
}

/* ---- tests ---- */

static const struct header_function *judged(size_t i, const struct kind *k)
{
    const struct header_function *const f = &header_functions[i];
    return f->promise > 0 && strcmp(f->kind, k->name) == 0 ? f : NULL;
}

static void fail_on(const struct face *f, const char *name, const char *group, const double loc[2])
{
    for (int k = 0; k <= f->kind->nodes; k++)
        print_error("{%a, %a, %a},\n", f->x[k][0], f->x[k][1], f->x[k][2]);
    fail_msg("%s, %s: OK at (%.17g, %.17g)", name, group, loc[0], loc[1]);
}

/* In another unit of length, so that quadruple precision suffices. */
static struct face unit_face(const struct face *f)
{
    struct face g = *f;
    int exponent;
    double most = 0;
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            most = fmax(most, fabs(f->x[k][i]));
    (void)frexp(most, &exponent);
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            g.x[k][i] = ldexp(ldexp(f->x[k][i], -exponent / 2), exponent / 2 - exponent);
    return g;
}

static void judge(const struct face *f, enum group group, long proved[HEADER_FUNCTIONS])
{
    const struct face scaled = unit_face(f);
    const double *x[MOST_NODES];
    wide known[2] = {0, 0};
    bool is_known = false;
    for (int k = 0; k < f->kind->nodes; k++)
        x[k] = f->x[k];
    for (size_t i = HEADER_FUNCTIONS; i-- > 0;) {
        const struct header_function *const function = judged(i, f->kind);
        double loc[2], gap;
        if (!function || function->locate(x, f->x[f->kind->nodes], loc, &gap) != FOOTPOINT_OK)
            continue;
        if (!holds(&scaled, loc, function->promise, known, &is_known))
            fail_on(f, function->name, group_names[group], loc);
        proved[i]++;
    }
}

static void test_group(enum group group)
{
    for (int k = 0; k < KINDS; k++) {
        long proved[HEADER_FUNCTIONS] = {0};
        uint64_t stream = 620 + (uint64_t)group;
        for (long i = 0; i < cases(); i++) {
            struct face f = {.kind = &kinds[k]};
            draw_face(&stream, group, &f);
            judge(&f, group, proved);
        }
        for (size_t i = 0; i < HEADER_FUNCTIONS; i++) {
            const struct header_function *const f = judged(i, &kinds[k]);
            if (f && getenv("FOOTPOINT_LONG"))
                print_message("%s, %s: %.2f %% proved\n", f->name, group_names[group],
                              100. * (double)proved[i] / (double)cases());
            if (f && f->promise > 1e-8 && 100 * proved[i] < proved_least[group] * cases())
                fail_msg("%s, %s: %ld of %ld proved", f->name, group_names[group], proved[i], cases());
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

static void test_wild(void **state)
{
    (void)state;
    test_group(WILD);
}

/* In arrays the same answers as alone, but for rounding where compilers fuse operations. */
static void test_arrays(void **state)
{
    enum { PAIRS = 400, ROWS = 3 * (MOST_NODES + 1) };
    static double column[ROWS][PAIRS], xi[PAIRS], eta[PAIRS], gap[PAIRS];
    static struct face face[PAIRS];
    static int status[PAIRS];
    const double *x[ROWS];
    uint64_t stream = 630;
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        for (int i = 0; i < PAIRS; i++) {
            face[i].kind = &kinds[k];
            draw_face(&stream, (enum group)(i % GROUPS), &face[i]);
            for (int row = 0; row < 3 * (kinds[k].nodes + 1); row++) {
                column[row][i] = face[i].x[row / 3][row % 3];
                x[row] = column[row];
            }
        }
        for (size_t j = 0; j < HEADER_FUNCTIONS; j++) {
            const struct header_function *const f = judged(j, &kinds[k]);
            if (!f)
                continue;
            f->checked_n(PAIRS, x, xi, eta, gap, status);
            for (int i = 0; i < PAIRS; i++) {
                const struct face scaled = unit_face(&face[i]);
                const double *y[MOST_NODES], found[2] = {xi[i], eta[i]};
                double loc[2] = {0, 0}, g = 0;
                wide known[2] = {0, 0};
                bool is_known = false;
                for (int node = 0; node < kinds[k].nodes; node++)
                    y[node] = face[i].x[node];
                if (status[i] == FOOTPOINT_OK && !holds(&scaled, found, f->promise, known, &is_known))
                    fail_on(&face[i], f->name, "arrays", found);
#ifndef __FMA__
                assert_int_equal(status[i], f->locate(y, face[i].x[kinds[k].nodes], loc, &g));
                if (status[i] >= FOOTPOINT_OK)
                    assert_true(loc[0] == xi[i] && loc[1] == eta[i] && g == gap[i]);
#else
                (void)y, (void)loc, (void)g;
#endif
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ordinary), cmocka_unit_test(test_strong), cmocka_unit_test(test_sliver),
        cmocka_unit_test(test_wild),     cmocka_unit_test(test_arrays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
