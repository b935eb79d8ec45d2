/* The replacement of CalculiX's attach_2d: random and hard faces of every kind against a dense search in long double,
 * and conditions that the closest point of a closed face must meet. Derivatives are differences of positions, which are
 * exact for polynomials of the second degree in either coordinate. */
#include "../../evolve/common/stream.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

typedef long double real;

enum { FACES = 1500, FEW_FACES = 400, GRID = 32, ZOOMS = 200 };

/* Error of local coordinates; error of distances relative to the longest edge and the distance. */
#define LOCAL_ERROR 1e-8
#define DISTANCE_ERROR 2e-9

void attach_2d_(double (*pneigh)[3], double *pnode, const int *nterms, double *ratio, double *dist, double *xil,
                double *etl);

struct face {
    const char *family;
    int nodes;
    double x[9][3], xs[3];
};

struct answer {
    double at[3], ratio[9], dist, loc[2];
};

static struct answer answer_of(const struct face *f)
{
    struct face copy = *f;
    struct answer a;
    memcpy(a.at, f->xs, sizeof a.at);
    attach_2d_(copy.x, a.at, &copy.nodes, a.ratio, &a.dist, &a.loc[0], &a.loc[1]);
    assert_memory_equal(copy.x, f->x, sizeof f->x);
    return a;
}

static int is_triangle(const struct face *f)
{
    return f->nodes == 3 || f->nodes == 6;
}

static void shape_functions(const struct face *f, real u, real v, real phi[8])
{
    static const int xi[8] = {-1, 1, 1, -1, 0, 1, 0, -1}, eta[8] = {-1, -1, 1, 1, -1, 0, 1, 0};
    const real l[3] = {1 - u - v, u, v};
    for (int n = 0; n < f->nodes; n++) {
        const int k = n % 3;
        const real a = 1 + u * xi[n], b = 1 + v * eta[n];
        switch (f->nodes) {
        case 3:
            phi[n] = l[n];
            break;
        case 6:
            phi[n] = n < 3 ? l[k] * (2 * l[k] - 1) : 4 * l[k] * l[(k + 1) % 3];
            break;
        case 4:
            phi[n] = a * b / 4;
            break;
        default:
            phi[n] = n < 4   ? a * b * (u * xi[n] + v * eta[n] - 1) / 4
                     : xi[n] ? a * (1 - v * v) / 2
                             : (1 - u * u) * b / 2;
        }
    }
}

static void position(const struct face *f, real u, real v, real r[3])
{
    real phi[8];
    shape_functions(f, u, v, phi);
    for (int i = 0; i < 3; i++) {
        r[i] = 0;
        for (int n = 0; n < f->nodes; n++)
            r[i] += phi[n] * f->x[n][i];
    }
}

static real dot(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static real distance(const struct face *f, real u, real v)
{
    real r[3];
    position(f, u, v, r);
    for (int i = 0; i < 3; i++)
        r[i] -= f->xs[i];
    return sqrtl(dot(r, r));
}

static int inside(const struct face *f, real u, real v)
{
    return is_triangle(f) ? u >= 0 && v >= 0 && u + v <= 1 + DBL_EPSILON : fabsl(u) <= 1 && fabsl(v) <= 1;
}

/* Returns the least distance: on a grid, then by ever smaller steps from its best point. */
static real dense_distance(const struct face *f)
{
    const real low = is_triangle(f) ? 0 : -1, width = 1 - low;
    real best = HUGE_VALL, at[2] = {low, low}, step = width / GRID;
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= GRID; j++) {
            const real u = low + width * i / GRID, v = low + width * j / GRID;
            const real d = inside(f, u, v) ? distance(f, u, v) : HUGE_VALL;
            if (d < best) {
                best = d;
                at[0] = u;
                at[1] = v;
            }
        }
    for (int n = 0; n < ZOOMS && step > 1e-9L; n++) {
        const real u = at[0], v = at[1];
        int better = 0;
        for (int k = 0; k < 9; k++) {
            const real p = u + step * (k % 3 - 1), q = v + step * (k / 3 - 1);
            const real d = inside(f, p, q) ? distance(f, p, q) : HUGE_VALL;
            if (d < best) {
                better = 1;
                best = d;
                at[0] = p;
                at[1] = q;
            }
        }
        step = better ? step : step / 3;
    }
    return best;
}

static real longest_edge(const struct face *f)
{
    const int corners = f->nodes > 4 ? f->nodes / 2 : f->nodes;
    double most = 0;
    for (int i = 0; i < corners; i++) {
        const double *const a = f->x[i], *const b = f->x[(i + 1) % corners];
        most = fmax(most, hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]));
    }
    return most;
}

/* Computes r - xS and the derivatives of r: by u, v, uu, uv, vv. */
static void derivatives(const struct face *f, real u, real v, real d[6][3])
{
    const real h = 0.25L;
    real r[3][3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            position(f, u + h * (i - 1), v + h * (j - 1), r[i][j]);
    for (int i = 0; i < 3; i++) {
        d[0][i] = r[1][1][i] - f->xs[i];
        d[1][i] = (r[2][1][i] - r[0][1][i]) / (2 * h);
        d[2][i] = (r[1][2][i] - r[1][0][i]) / (2 * h);
        d[3][i] = (r[2][1][i] - 2 * r[1][1][i] + r[0][1][i]) / (h * h);
        d[4][i] = (r[2][2][i] - r[2][0][i] - r[0][2][i] + r[0][0][i]) / (4 * h * h);
        d[5][i] = (r[1][2][i] - 2 * r[1][1][i] + r[1][0][i]) / (h * h);
    }
}

static void fail_on(const struct face *f, const struct answer *a, const char *what, real value)
{
    for (int n = 0; n < f->nodes; n++)
        print_error("  %d %a %a %a\n", n + 1, f->x[n][0], f->x[n][1], f->x[n][2]);
    print_error("  S %a %a %a\n", f->xs[0], f->xs[1], f->xs[2]);
    fail_msg("%s: %s: %Lg at xi %.17g eta %.17g", f->family, what, value, a->loc[0], a->loc[1]);
}

/* Checks that shape functions, point and distance belong to the local coordinates, and these to the face. */
static void check_consistent(const struct face *f, const struct answer *a)
{
    real phi[8], r[3], most = 0;
    if (!inside(f, a->loc[0], a->loc[1]))
        fail_on(f, a, "outside", 0);
    shape_functions(f, a->loc[0], a->loc[1], phi);
    position(f, a->loc[0], a->loc[1], r);
    for (int n = 0; n < f->nodes; n++) {
        for (int i = 0; i < 3; i++)
            most = fmaxl(most, fabsl(f->x[n][i]));
        if (fabsl(phi[n] - a->ratio[n]) > 4 * DBL_EPSILON)
            fail_on(f, a, "shape function", phi[n] - a->ratio[n]);
    }
    for (int i = 0; i < 3; i++)
        if (fabsl(r[i] - a->at[i]) > 16 * DBL_EPSILON * most)
            fail_on(f, a, "point", r[i] - a->at[i]);
    if (fabsl(a->dist - distance(f, a->loc[0], a->loc[1])) > 16 * DBL_EPSILON * (most + a->dist))
        fail_on(f, a, "distance", a->dist);
}

/* Checks that no direction along an edge or into the face decreases the distance; and that inside, where its curvature
 * is large, Newton's next step is short. */
static void check_stationary(const struct face *f, const struct answer *a)
{
    static const int along[4][2] = {{1, 0}, {0, 1}, {-1, 1}, {1, 1}};
    const real u = a->loc[0], v = a->loc[1], h = longest_edge(f);
    real d[6][3];
    derivatives(f, u, v, d);
    const real size = h + sqrtl(dot(d[0], d[0]));
    const real g[2] = {dot(d[0], d[1]), dot(d[0], d[2])};
    for (int k = 0; k < 3; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const real s = sign * along[k][0], t = sign * along[k][1];
            const real slope = s * g[0] + t * g[1];
            if (inside(f, u + 1e-7L * s, v + 1e-7L * t) && slope < -(LOCAL_ERROR * h + DBL_EPSILON * size) * size)
                fail_on(f, a, "leads down", slope);
        }
    const real h00 = dot(d[1], d[1]) + dot(d[0], d[3]), h11 = dot(d[2], d[2]) + dot(d[0], d[5]);
    const real h01 = dot(d[1], d[2]) + dot(d[0], d[4]), det = h00 * h11 - h01 * h01;
    const int interior = inside(f, u + 1e-6L, v + 1e-6L) && inside(f, u - 1e-6L, v - 1e-6L);
    if (interior && h00 > 1e-3L * h * size && h11 > 1e-3L * h * size && det > 0.05L * h00 * h11) {
        const real p = (h11 * g[0] - h01 * g[1]) / det, q = (h00 * g[1] - h01 * g[0]) / det;
        if (fabsl(p) > LOCAL_ERROR || fabsl(q) > LOCAL_ERROR)
            fail_on(f, a, "Newton's step", fmaxl(fabsl(p), fabsl(q)));
    }
}

/* The demands on the answers of a family. On slim faces, points with very different local coordinates are equally
 * near. */
enum demand { CLOSEST, STATIONARY_ALONE, DISTANCE_ALONE };

static void check_answer(const struct face *f, enum demand demand)
{
    const struct answer a = answer_of(f);
    check_consistent(f, &a);
    if (demand != DISTANCE_ALONE)
        check_stationary(f, &a);
    if (demand == STATIONARY_ALONE)
        return;
    const real farther = distance(f, a.loc[0], a.loc[1]) - dense_distance(f);
    if (farther > DISTANCE_ERROR * (longest_edge(f) + a.dist))
        fail_on(f, &a, "farther than need be", farther);
}

/* ---- faces ------------------------------------------------------------------------------------------------------ */

static double uniform(gsl_rng *r, double low, double high)
{
    return low + (high - low) * gsl_rng_uniform(r);
}

/* A family of faces: aspect up to 10^aspect; corners moved by up to `corner` in the plane and `warp` out of it, midside
 * nodes by up to `curve`; the slave node `gap` away in any direction from a point with local coordinates up to `reach`
 * times the face's; all moved by `offset`. Lengths are in shortest edges. `spoil`, if set, then changes the face. */
struct family {
    const char *name;
    int nodes;
    double aspect, corner, warp, curve, gap, reach, offset;
    void (*spoil)(struct face *f, int index);
    enum demand demand;
};

static void coincide(struct face *f, int index)
{
    const int corners = f->nodes > 4 ? f->nodes / 2 : f->nodes;
    memcpy(f->x[index % corners], f->x[(index + 1) % corners], sizeof *f->x);
}

static void flatten_to_line(struct face *f, int index)
{
    for (int n = 0; n < f->nodes; n++)
        f->x[n][1 + index % 2] = f->x[n][2 - index % 2] = 0;
}

static void shrink_to_point(struct face *f, int index)
{
    for (int n = 1; n < f->nodes; n++)
        memcpy(f->x[n], f->x[0], sizeof *f->x);
    (void)index;
}

static void cross(struct face *f, int index)
{
    double t[3];
    memcpy(t, f->x[index % 2], sizeof t);
    memcpy(f->x[index % 2], f->x[index % 2 + 1], sizeof t);
    memcpy(f->x[index % 2 + 1], t, sizeof t);
}

/* Moves midside nodes along their edges, by up to a third of the length. */
static void slide(struct face *f, int index)
{
    const double length = (double)longest_edge(f);
    for (int n = f->nodes / 2; n < f->nodes; n++)
        f->x[n][0] += 0.3 * length * sin(7.0 * index + n);
}

/* Moves the slave node onto a node, or into the middle between two. */
static void hit_node(struct face *f, int index)
{
    for (int i = 0; i < 3; i++)
        f->xs[i] =
            index % 3 ? f->x[index % f->nodes][i] : 0.5 * (f->x[index % f->nodes][i] + f->x[(index + 1) % f->nodes][i]);
}

static const struct family families[] = {
    {"ordinary triangles", 3, 0.5, 0.15, 0, 0, 0.1, 1.3, 0, NULL, CLOSEST},
    {"needles", 3, 3, 0.3, 0, 0, 1, 2, 0, NULL, CLOSEST},
    {"triangles, a line", 3, 0, 0.1, 0, 0, 1, 2, 0, flatten_to_line, CLOSEST},
    {"triangles, corners alike", 3, 0, 0.1, 0, 0, 1, 2, 0, coincide, CLOSEST},
    {"triangles, a point", 3, 0, 0.1, 0, 0, 1, 2, 0, shrink_to_point, CLOSEST},
    {"triangles, nodes hit", 3, 0.5, 0.1, 0, 0, 0, 1, 0, hit_node, CLOSEST},
    {"ordinary quadrilaterals", 4, 0.5, 0.15, 0.03, 0, 0.1, 1.2, 0, NULL, CLOSEST},
    {"plane, gap as large", 4, 0.5, 0.15, 0, 0, 1, 2, 0, NULL, CLOSEST},
    {"warped", 4, 0.5, 0.3, 0.5, 0, 0.5, 1.5, 0, NULL, CLOSEST},
    {"near the centre of curvature", 4, 0.3, 0.3, 0.6, 0, 3, 1, 0, NULL, CLOSEST},
    {"far", 4, 0.5, 0.2, 0.1, 0, 50, 1, 0, NULL, CLOSEST},
    {"nearly triangular", 4, 0.3, 0.5, 0.05, 0, 0.3, 1.2, 0, NULL, CLOSEST},
    {"long", 4, 3, 0.2, 0.05, 0, 0.3, 1.2, 0, NULL, CLOSEST},
    {"far from the origin", 4, 0.5, 0.2, 0.05, 0, 0.1, 1.2, 1e6, NULL, CLOSEST},
    {"quadrilaterals, corners alike", 4, 0.3, 0.2, 0.2, 0, 0.5, 1.3, 0, coincide, CLOSEST},
    {"quadrilaterals, a line", 4, 0.3, 0.2, 0, 0, 0.5, 1.3, 0, flatten_to_line, CLOSEST},
    {"quadrilaterals, a point", 4, 0.3, 0.2, 0, 0, 0.5, 1.3, 0, shrink_to_point, CLOSEST},
    {"crossed", 4, 0.3, 0.3, 0.3, 0, 0.5, 1.3, 0, cross, CLOSEST},
    {"quadrilaterals, nodes hit", 4, 0.5, 0.2, 0.2, 0, 0, 1, 0, hit_node, CLOSEST},
    {"quadratic triangles", 6, 0.3, 0.1, 0, 0.05, 0.1, 1.3, 0, NULL, CLOSEST},
    {"bulging triangles", 6, 0.3, 0.2, 0, 0.3, 0.5, 1.5, 0, NULL, CLOSEST},
    {"quadratic triangles, nodes hit", 6, 0.3, 0.1, 0, 0.05, 0, 1.3, 0, hit_node, CLOSEST},
    {"quadratic triangles, corners alike", 6, 0.3, 0.1, 0, 0.05, 0.5, 1.3, 0, coincide, STATIONARY_ALONE},
    {"slim quadratic triangles", 6, 6, 0.2, 0.2, 0.1, 1, 1.2, 0, slide, DISTANCE_ALONE},
    {"serendipity", 8, 0.3, 0.1, 0.03, 0.05, 0.1, 1.2, 0, NULL, CLOSEST},
    {"bulging serendipity", 8, 0.3, 0.2, 0.2, 0.3, 0.5, 1.5, 0, NULL, STATIONARY_ALONE},
    {"slim serendipity", 8, 6, 0.2, 0.2, 0.1, 1, 1.2, 0, slide, DISTANCE_ALONE},
    {"serendipity, nodes hit", 8, 0.3, 0.1, 0.03, 0.05, 0, 1.2, 0, hit_node, CLOSEST},
    {"serendipity, a line", 8, 0.3, 0.1, 0.03, 0.05, 0.5, 1.2, 0, flatten_to_line, STATIONARY_ALONE},
    {"serendipity, a point", 8, 0.3, 0.1, 0.03, 0.05, 0.5, 1.2, 0, shrink_to_point, CLOSEST},
};
enum { FAMILIES = sizeof families / sizeof *families };

/* Turns by the angles about the z and the x axis, then shifts. */
static void place(double x[3], double a, double b, double offset)
{
    const double p = cos(a) * x[0] - sin(a) * x[1], q = sin(a) * x[0] + cos(a) * x[1], z = x[2];
    x[0] = p + offset;
    x[1] = cos(b) * q - sin(b) * z + offset;
    x[2] = sin(b) * q + cos(b) * z - offset;
}

static struct face draw(const struct family *k, gsl_rng *r, int index)
{
    static const double square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, triangle[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    struct face f = {.family = k->name, .nodes = k->nodes};
    const int corners = k->nodes > 4 ? k->nodes / 2 : k->nodes;
    const double length = pow(10, uniform(r, 0, k->aspect)), a = uniform(r, 0, 7), b = uniform(r, 0, 7);
    real at[3];
    for (int n = 0; n < corners; n++) {
        const double *const c = corners == 4 ? square[n] : triangle[n];
        f.x[n][0] = length * c[0] + uniform(r, -k->corner, k->corner);
        f.x[n][1] = c[1] + uniform(r, -k->corner, k->corner);
        f.x[n][2] = uniform(r, -k->warp, k->warp);
    }
    for (int n = corners; n < k->nodes; n++)
        for (int i = 0; i < 3; i++)
            f.x[n][i] = 0.5 * (f.x[n - corners][i] + f.x[(n + 1) % corners][i]) + uniform(r, -k->curve, k->curve);
    const double u = uniform(r, -k->reach, k->reach), v = uniform(r, -k->reach, k->reach);
    if (k->spoil && k->spoil != hit_node)
        k->spoil(&f, index);
    position(&f, u, v, at);
    for (int i = 0; i < 3; i++)
        f.xs[i] = (double)at[i] + uniform(r, -k->gap, k->gap);
    for (int n = 0; n < k->nodes; n++)
        place(f.x[n], a, b, k->offset);
    place(f.xs, a, b, k->offset);
    if (k->spoil == hit_node)
        hit_node(&f, index);
    return f;
}

static void closest_points(void **state)
{
    (void)state;
    gsl_rng *const r = stream_new();
    const int faces = getenv("FOOTPOINT_LONG") ? FACES : FEW_FACES;
    for (uint64_t k = 0; k < FAMILIES; k++)
        for (int i = 0; i < faces; i++) {
            stream_key(r, 9, k, (uint64_t)i, 0);
            const struct face f = draw(&families[k], r, i);
            check_answer(&f, families[k].demand);
        }
    gsl_rng_free(r);
}

/* A quadratic face whose midside nodes halve its edges equals the linear face. */
static void halved_edges_match_linear_faces(void **state)
{
    (void)state;
    gsl_rng *const r = stream_new();
    for (uint64_t k = 0; k < FAMILIES; k++)
        for (int i = 0; i < FACES / 10; i++) {
            if (families[k].nodes > 4 || families[k].spoil || families[k].corner + families[k].warp > 0.3)
                break;
            stream_key(r, 10, k, (uint64_t)i, 0);
            const struct face f = draw(&families[k], r, i);
            struct face g = f;
            g.nodes = 2 * f.nodes;
            for (int n = 0; n < f.nodes; n++)
                for (int c = 0; c < 3; c++)
                    g.x[f.nodes + n][c] = 0.5 * (f.x[n][c] + f.x[(n + 1) % f.nodes][c]);
            const struct answer a = answer_of(&f), b = answer_of(&g);
            if (fabs(a.dist - b.dist) > 1e-9 * (families[k].offset + a.dist + 1))
                fail_on(&g, &b, "not the linear face's distance", a.dist);
        }
    gsl_rng_free(r);
}

/* Answers hold in any unit of length that attach.h allows. */
static void any_unit_has_the_same_answer(void **state)
{
    (void)state;
    gsl_rng *const r = stream_new();
    for (uint64_t k = 0; k < FAMILIES; k++) {
        if (families[k].spoil)
            continue;
        stream_key(r, 12, k, 0, 0);
        const struct face f = draw(&families[k], r, 0);
        const struct answer a = answer_of(&f);
        for (int power = -100; power <= 100; power += 25) {
            struct face g = f;
            for (int c = 0; c < 27; c++)
                g.x[c / 3][c % 3] = ldexp(f.x[c / 3][c % 3], power);
            for (int c = 0; c < 3; c++)
                g.xs[c] = ldexp(f.xs[c], power);
            const double dist = ldexp(answer_of(&g).dist, -power);
            if (!(fabs(dist - a.dist) <= 1e-9 * (families[k].offset + a.dist + 1)))
                fail_on(&g, &a, "another distance in another unit of length", dist);
        }
    }
    gsl_rng_free(r);
}

/* Faces found by `make rivals`: another edge is nearer than the minimum to which the iteration converges. */
static void the_nearer_edge_is_found(void **state)
{
    const struct face f = {.nodes = 6,
                           .x = {{0x1.6ae751943b61dp+0, 0x1.3e14c4d85b6bfp+1, -0x1.52b0ffc00945p-5},
                                 {0x1.1493000fe585p+0, 0x1.0e5a0fdacedc8p-3, 0x1.1348f4972f0fdp-1},
                                 {0x1.0951e23269f85p+1, 0x1.f6aeb1f56c148p-3, 0x1.419f5282b9db2p-1},
                                 {0x1.2cfc5bcd155ffp+0, 0x1.1e660ac8b1cccp+0, -0x1.4f18466d2174p-8},
                                 {0x1.994afe6c44644p+0, 0x1.7ba4386baafp-2, 0x1.1e77642a92d39p-1},
                                 {0x1.8d406341b8c8cp+0, 0x1.19397c800c72cp+0, 0x1.817daccdadbbcp-5}},
                           .xs = {0x1.081e7d26aa8eep+0, 0x1.d0ddcd460cf7fp+0, 0x1.04271564daa79p+1}};
    (void)state;
    check_answer(&f, CLOSEST);
}

static void hostile_input(void **state)
{
    (void)state;
    const int kinds[] = {3, 4, 6, 8, 0, 5, 9};
    const double bad[] = {NAN, HUGE_VAL, -HUGE_VAL, DBL_MAX, 1e200};
    gsl_rng *const r = stream_new();
    stream_key(r, 11, 0, 0, 0);
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (size_t b = 0; b < sizeof bad / sizeof *bad; b++)
            for (int n = 0; n <= kinds[k]; n++) {
                struct face f = {.nodes = kinds[k]};
                for (int i = 0; i < 9; i++)
                    for (int c = 0; c < 3; c++)
                        f.x[i][c] = uniform(r, 0, 1);
                *(n < f.nodes ? &f.x[n][n % 3] : &f.xs[n % 3]) = bad[b];
                const double dist = answer_of(&f).dist;
                assert_false(isfinite(dist) && (k > 3 || !isfinite(bad[b])));
            }
    gsl_rng_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_points),
        cmocka_unit_test(halved_edges_match_linear_faces),
        cmocka_unit_test(any_unit_has_the_same_answer),
        cmocka_unit_test(the_nearer_edge_is_found),
        cmocka_unit_test(hostile_input),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
