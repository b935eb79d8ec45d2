/* Draws faces about [-1,1]^2, or the triangle (0,0), (2,0), (0,2), and bends them; then a slave node over, beside or on them.
 * Only sums, products and square roots of splitmix64's numbers are used, so that every machine draws the same. */
#include "draw_queries.h"

#include <math.h>
#include <string.h>

const char *const query_family_name[FAMILIES] = {"mild",      "bent",   "beside",    "on",   "needle", "taper",
                                                 "collapsed", "wild",   "curvature", "tie",  "far",    "offset",
                                                 "size",      "border", "folded",    "mixed"};

static uint64_t next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}

static double between(uint64_t *state, double low, double high)
{
    return low + (high - low) * ((double)(next(state) >> 11) / 9007199254740992.0);
}

static int below(uint64_t *state, int n)
{
    return (int)(next(state) >> 33) % n;
}

/* Returns 10^-k, with k whole in least..most, times 1 to 10. */
static double power_of_ten(uint64_t *state, int least, int most)
{
    double p = between(state, 1, 10);
    const int k = least + below(state, most - least + 1);
    for (int i = 0; i < (k < 0 ? -k : k); i++)
        p = k < 0 ? p * 10 : p / 10;
    return p;
}

/* ---- faces ---- */

static void middles(enum query_kind kind, double *x)
{
    const int corners = query_kind_corners[kind];
    if (query_kind_nodes[kind] == corners)
        return;
    for (int e = 0; e < corners; e++)
        for (int k = 0; k < 3; k++)
            x[3 * (corners + e) + k] = (x[3 * e + k] + x[3 * ((e + 1) % corners) + k]) / 2;
    for (int k = 0; k < 3 && kind == QUERY_QUAD9; k++)
        x[24 + k] = (x[k] + x[3 + k] + x[6 + k] + x[9 + k]) / 4;
}

static void reference_face(enum query_kind kind, double *x)
{
    static const double corner[2][4][2] = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {{0, 0}, {2, 0}, {0, 2}, {0, 0}}};
    const int corners = query_kind_corners[kind];
    for (int c = 0; c < corners; c++)
        for (int k = 0; k < 3; k++)
            x[3 * c + k] = k < 2 ? corner[corners == 3][c][k] : 0;
    middles(kind, x);
}

static void shake(enum query_kind kind, uint64_t *state, double in_plane, double out, double *x)
{
    for (int i = 0; i < 3 * query_kind_nodes[kind]; i++)
        x[i] += i % 3 < 2 ? between(state, -in_plane, in_plane) : between(state, -out, out);
}

/* Moves a corner towards the previous corner until only `left` of their distance remains. */
static void pull(enum query_kind kind, int corner, double left, double *x)
{
    for (int k = 0; k < 3; k++)
        x[3 * corner + k] = x[3 * (corner - 1) + k] + left * (x[3 * corner + k] - x[3 * (corner - 1) + k]);
    middles(kind, x);
}

/* Makes a face its own image: a quadrilateral turned by 180 degrees about the z axis, a triangle with x and y exchanged. */
static void repeat_half(enum query_kind kind, double *x)
{
    static const int quad[9] = {2, 3, 0, 1, 6, 7, 4, 5, 8}, triangle[6] = {0, 2, 1, 5, 4, 3};
    const int turned = query_kind_corners[kind] == 4;
    const int *const image = turned ? quad : triangle;
    for (int n = 0; n < query_kind_nodes[kind]; n++) {
        double *const a = x + 3 * n, *const b = x + 3 * image[n];
        if (a == b)
            a[1] = a[0] = turned ? 0 : a[0];
        if (image[n] < n)
            continue;
        b[0] = turned ? -a[0] : a[1];
        b[1] = turned ? -a[1] : a[0];
        b[2] = a[2];
    }
}

/* Rounds to whole multiples of 2^-10. */
static void to_grid(int n, double *x)
{
    for (int i = 0; i < n; i++)
        x[i] = floor(x[i] * 1024) / 1024;
}

static void draw_face(enum query_kind kind, int family, uint64_t *state, double *x)
{
    const int ordinary = family == MILD || family == BESIDE || family == FAR || family == OFFSET || family == SIZE;
    reference_face(kind, x);
    if (family == WILD)
        memset(x, 0, (size_t)(3 * query_kind_nodes[kind]) * sizeof *x);
    if (family == TAPER)
        pull(kind, 2, power_of_ten(state, 2, 7), x);
    if (family == WILD || family == MIXED)
        shake(kind, state, 1, 1, x);
    else if (family == FOLDED)
        shake(kind, state, query_kind_nodes[kind] > 4 ? 0.7 : 1.2, 0.2, x);
    else if (family == BORDER)
        shake(kind, state, 0.1, 0, x);
    else if (family == TAPER)
        shake(kind, state, 0, 0.1, x);
    else if (family == TIE)
        shake(kind, state, 0.15, 1, x);
    else
        shake(kind, state, ordinary ? 0.08 : 0.15, ordinary ? 0.05 : 0.4, x);
    if (family == COLLAPSED)
        pull(kind, 2, query_kind_corners[kind] == 4 ? 0 : power_of_ten(state, 4, 6), x);
    if (family == BORDER || family == TIE)
        to_grid(3 * query_kind_nodes[kind], x);
    if (family == TIE)
        repeat_half(kind, x);
}

/* ---- slave nodes ---- */

/* Computes point, tangents and second derivatives at s, t. */
static void surface(enum query_kind kind, const double *x, double s, double t, double r[6][3])
{
    const double a[3][3] = {
        {(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)}, {4 * s - 3, 4 - 8 * s, 4 * s - 1}, {4, -8, 4}};
    const double b[3][3] = {
        {(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)}, {4 * t - 3, 4 - 8 * t, 4 * t - 1}, {4, -8, 4}};
    static const int order[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    memset(r, 0, 6 * sizeof *r);
    for (int i = 0; i < 9; i++) {
        int weight[QUERY_NODES];
        polynomial_weights(kind, i / 3, i % 3, weight);
        for (int d = 0; d < 6; d++)
            for (int n = 0; n < query_kind_nodes[kind]; n++)
                for (int k = 0; k < 3; k++)
                    r[d][k] += a[order[d][0]][i / 3] * b[order[d][1]][i % 3] * weight[n] / 4 * x[3 * n + k];
    }
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void unit_normal(double r[6][3], double n[3])
{
    for (int k = 0; k < 3; k++)
        n[k] = r[1][(k + 1) % 3] * r[2][(k + 2) % 3] - r[1][(k + 2) % 3] * r[2][(k + 1) % 3];
    const double size = sqrt(dot(n, n));
    for (int k = 0; k < 3; k++)
        n[k] = size > 0 ? n[k] / size : k == 2;
}

/* Returns the lesser radius of curvature, with its sign; 0 if the face is plane there. */
static double radius(double r[6][3], const double n[3])
{
    const double e = dot(r[1], r[1]), f = dot(r[1], r[2]), g = dot(r[2], r[2]);
    const double l = dot(r[3], n), m = dot(r[4], n), p = dot(r[5], n);
    const double area = e * g - f * f, mean = (e * p - 2 * f * m + g * l) / (2 * area), gauss = (l * p - m * m) / area;
    const double root = sqrt(fmax(mean * mean - gauss, 0)), greatest = mean + (mean < 0 ? -root : root);
    return area > 0 && fabs(greatest) > 1e-6 ? 1 / greatest : 0;
}

static double draw_height(int family, uint64_t *state, double r[6][3], const double n[3])
{
    const double side = below(state, 2) ? 1 : -1, bend = radius(r, n);
    switch (family) {
    case ON:
        return 0;
    case CURVATURE:
        return bend != 0 ? bend * (1 + side * power_of_ten(state, 2, 8)) : side * power_of_ten(state, -2, 2);
    case FAR:
        return side * power_of_ten(state, -8, -1);
    case NEEDLE:
    case TAPER:
        return side * power_of_ten(state, 1, 6);
    case BENT:
    case FOLDED:
    case COLLAPSED:
        return side * between(state, 0, 1);
    default:
        return side * between(state, 0, 0.3);
    }
}

static void draw_node(enum query_kind kind, int family, uint64_t *state, double *x)
{
    double *const xs = x + 3 * query_kind_nodes[kind], r[6][3], n[3];
    const double beyond = family == BESIDE ? 0.5 : family == MILD || family == ON || family == BORDER ? 0 : 0.1;
    double s = between(state, -beyond, 1 + beyond), t = between(state, -beyond, 1 + beyond);
    if (query_kind_corners[kind] == 3 && s + t > 1 + 2 * beyond) {
        s = 1 - s;
        t = 1 - t;
    }
    if (family == BORDER) { /* over an edge, a corner among others */
        s = below(state, 3) * 0.5;
        t = 0;
    }
    surface(kind, x, s, t, r);
    unit_normal(r, n);
    const double height = draw_height(family, state, r, n);
    for (int k = 0; k < 3; k++)
        xs[k] = r[0][k] + height * n[k];
    for (int k = 0; k < 3 && (family == WILD || family == MIXED); k++)
        xs[k] = between(state, -1.5, 1.5);
    if (family == TIE) {
        xs[1] = xs[0] = query_kind_corners[kind] == 4 ? 0 : xs[0];
        xs[2] = between(state, -3, 3);
    }
    if (family == BORDER || family == TIE)
        to_grid(3, xs);
}

/* ---- places and sizes ---- */

static void transform(enum query_kind kind, int family, uint64_t *state, double *x)
{
    const int numbers = 3 * (query_kind_nodes[kind] + 1);
    double by[3] = {1, 1, 1}, to[3] = {0, 0, 0};
    const int power = below(state, 601) - 300;
    for (int k = 0; k < 3; k++) {
        if (family == MIXED)
            by[k] = power_of_ten(state, -3, 3);
        if (family == OFFSET)
            to[k] = between(state, -2e6, 2e6);
        if (family == SIZE)
            by[k] = ldexp(1, power);
    }
    if (family == NEEDLE)
        by[1] = power_of_ten(state, 2, 7);
    for (int i = 0; i < numbers; i++)
        x[i] = x[i] * by[i % 3] + to[i % 3];
}

/* Rounds to 32 bits if the family's property survives: this halves the file. */
static void shorten(int n, double *x)
{
    for (int i = 0; i < n; i++) {
        int exponent;
        const double fraction = frexp(x[i], &exponent);
        x[i] = ldexp(floor(ldexp(fraction, 32)), exponent - 32);
    }
}

void draw_query(enum query_kind kind, int family, uint64_t *state, double *x)
{
    draw_face(kind, family, state, x);
    shorten(3 * query_kind_nodes[kind], x);
    draw_node(kind, family, state, x);
    transform(kind, family, state, x);
    if (family != ON && family != CURVATURE && family != OFFSET && family != FAR)
        shorten(3 * (query_kind_nodes[kind] + 1), x);
}
