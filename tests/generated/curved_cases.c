/* Faces of four to nine nodes for tests; see curved_cases.h. */
#include "curved_cases.h"

#include "../hard/draw.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

const struct curved_kind curved_kinds[CASE_KINDS] = {{"tri6", 6, 3}, {"quad8", 8, 4}, {"quad9", 9, 4}, {"quad4", 4, 4}};

/* Local coordinates of nodes: corners, nodes between them, the middle. */
static const double at_tri[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
static const double at_quad[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};

static const double *place_of(const struct curved_kind *k, int node)
{
    return k->corners == 3 ? at_tri[node] : at_quad[node];
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

/* Returns the parabola that is 1 at `node` = -1, 0 or 1, and 0 at the other two. */
static struct jet parabola(double node, wide z)
{
    return node == 0 ? jet(1 - z * z, -2 * z, -2) : jet(z * (z + node) / 2, z + (wide)node / 2, 1);
}

/* Returns (1 + node z) / 2. */
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

/* Computes the shape function of a node. */
static void shape_of(const struct curved_kind *k, int node, const wide z[2], wide shape[6])
{
    const double *const at = place_of(k, node);
    const struct jet one = jet(1, 0, 0), x = jet(z[0], 1, 0), y = jet(z[1], 1, 0);
    const struct jet xx = jet(z[0] * z[0], 2 * z[0], 2), yy = jet(z[1] * z[1], 2 * z[1], 2);
    for (int i = 0; i < 6; i++)
        shape[i] = 0;
    if (k->nodes == 4) {
        add(shape, 1, line(at[0], z[0]), line(at[1], z[1]));
    } else if (k->nodes == 9) {
        add(shape, 1, parabola(at[0], z[0]), parabola(at[1], z[1]));
    } else if (k->nodes == 8 && node >= 4) {
        if (at[0] == 0)
            add(shape, 1, parabola(0, z[0]), line(at[1], z[1]));
        else
            add(shape, 1, line(at[0], z[0]), parabola(0, z[1]));
    } else if (k->nodes == 8) { /* bilinear, minus half of the neighbours' */
        add(shape, 1, line(at[0], z[0]), line(at[1], z[1]));
        add(shape, -0.5, parabola(0, z[0]), line(at[1], z[1]));
        add(shape, -0.5, line(at[0], z[0]), parabola(0, z[1]));
    } else { /* in terms of w = 1 - xi - eta */
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

/* Sums nodes times shape functions, and their derivatives. */
static void sums(const struct curved_case *f, const wide z[2], wide r[3][6])
{
    memset(r, 0, 3 * sizeof *r);
    for (int k = 0; k < f->kind->nodes; k++) {
        wide shape[6];
        shape_of(f->kind, k, z, shape);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 6; j++)
                r[i][j] += shape[j] * f->x[k][i];
    }
}

/* Returns shape functions at xi and eta of -1, 0 and 1: whole numbers and halves, mostly 0. */
static const wide *shapes_on_grid(const struct curved_kind *k)
{
    static wide values[CASE_KINDS][9 * CURVED_NODES];
    static bool known[CASE_KINDS];
    wide *const value = values[k - curved_kinds];
    for (int i = 0; i < 9 && !known[k - curved_kinds]; i++)
        for (int n = 0; n < k->nodes; n++) {
            const wide z[2] = {i / 3 - 1, i % 3 - 1};
            wide shape[6];
            shape_of(k, n, z, shape);
            value[i * CURVED_NODES + n] = shape[0];
        }
    known[k - curved_kinds] = true;
    return value;
}

void curved_powers(const struct curved_case *f, struct curved_powers *p)
{
    const wide *const shape = shapes_on_grid(f->kind);
    wide at[3][3][3]; /* values at -1, 0 and 1 */
    for (int i = 0; i < 9; i++)
        for (int k = 0; k < 3; k++) {
            at[k][i / 3][i % 3] = f->x[f->kind->nodes][k];
            for (int n = 0; n < f->kind->nodes; n++)
                if (shape[i * CURVED_NODES + n] != 0)
                    at[k][i / 3][i % 3] -= shape[i * CURVED_NODES + n] * f->x[n][k];
        }
    for (int k = 0; k < 3; k++) {
        wide half[3][3]; /* powers of eta */
        for (int i = 0; i < 3; i++) {
            const wide *const y = at[k][i];
            half[i][0] = y[1];
            half[i][1] = (y[2] - y[0]) / 2;
            half[i][2] = (y[2] + y[0]) / 2 - y[1];
        }
        for (int j = 0; j < 3; j++) {
            p->d[k][0][j] = half[1][j];
            p->d[k][1][j] = (half[2][j] - half[0][j]) / 2;
            p->d[k][2][j] = (half[2][j] + half[0][j]) / 2 - half[1][j];
        }
    }
}

wide curved_half(const struct curved_powers *p, const wide z[2], wide g[2], wide H[3])
{
    wide half = 0;
    g[0] = g[1] = H[0] = H[1] = H[2] = 0;
    for (int k = 0; k < 3; k++) {
        wide v[3], vy[3], vyy[3];
        for (int i = 0; i < 3; i++) {
            const wide *const c = p->d[k][i];
            v[i] = c[0] + z[1] * (c[1] + z[1] * c[2]);
            vy[i] = c[1] + 2 * z[1] * c[2];
            vyy[i] = 2 * c[2];
        }
        const wide d = v[0] + z[0] * (v[1] + z[0] * v[2]), u = v[1] + 2 * z[0] * v[2];
        const wide w = vy[0] + z[0] * (vy[1] + z[0] * vy[2]), uv = vy[1] + 2 * z[0] * vy[2];
        const wide vv = vyy[0] + z[0] * (vyy[1] + z[0] * vyy[2]);
        half += d * d / 2;
        g[0] -= u * d;
        g[1] -= w * d;
        H[0] += u * u + 2 * v[2] * d;
        H[1] += u * w + uv * d;
        H[2] += w * w + vv * d;
    }
    return half;
}

void curved_slopes(const struct curved_case *f, const wide z[2], wide g[2], wide H[3])
{
    wide r[3][6];
    sums(f, z, r);
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

static void surface_at(const struct curved_case *f, double xi, double eta, double r[3], double n[3])
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

/* Draws the slave node over a place in or beside the face, up to `gap` of an edge away. */
static void draw_slave(uint64_t *stream, struct curved_case *f, double beside, double gap)
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

/* Draws a face with edges 2 and 2 `width` (quadrilaterals): skewed, tapered, warped, with nodes between corners moved
 * by `off`. */
static void draw_plain(uint64_t *stream, struct curved_case *f, double width, double off)
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

/* Draws part of a ring or, rolled up, of a cylinder, of up to `degrees`. */
static void draw_arc(uint64_t *stream, struct curved_case *f, double degrees)
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

/* Draws nodes between corners at quarters of their edges, or farther; or folds a corner over. */
static void draw_bad(uint64_t *stream, struct curved_case *f)
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

/* Turns, moves by `shift`, then multiplies by 2^exponent. */
static void move(uint64_t *stream, struct curved_case *f, double shift, int exponent)
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

/* Makes two nodes, or all nodes of an edge, coincide. */
static void coincide(uint64_t *stream, struct curved_case *f)
{
    const int n = f->kind->corners, edge = draw_choose(stream, n), one = draw_choose(stream, f->kind->nodes);
    const bool whole = draw_next(stream) & 1;
    memcpy(f->x[whole ? (edge + 1) % n : one], f->x[edge], sizeof f->x[0]);
    if (whole)
        memcpy(f->x[n + edge], f->x[edge], sizeof f->x[0]);
}

const char *const curved_groups[CURVED_GROUPS] = {"ordinary", "strongly curved", "sliver", "wild"};
void curved_draw(uint64_t *stream, enum curved_group group, struct curved_case *f)
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

void curved_draw_slave(uint64_t *stream, struct curved_case *f, double away)
{
    const int n = f->kind->corners;
    double longest = 0, d[3];
    for (int k = 0; k < n; k++) {
        double square = 0;
        for (int i = 0; i < 3; i++)
            square += (f->x[k][i] - f->x[(k + 1) % n][i]) * (f->x[k][i] - f->x[(k + 1) % n][i]);
        longest = fmax(longest, sqrt(square));
    }
    draw_slave(stream, f, 1, 0);
    draw_direction(stream, d);
    const double far = draw_flat(stream, 0, away) * longest;
    for (int i = 0; i < 3; i++)
        f->x[f->kind->nodes][i] += far * d[i];
}
