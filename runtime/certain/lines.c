/* Computes lines of a bilinear segment and their roots; see lines.h. */
#include "lines.h"

#define ERROR 0x1p-90 /* error of coefficients and their halvings, in units of the sum of the sizes of all terms */
#define BEYOND LINES_BEYOND
#define MARGIN 0x1p-40   /* for the rounding of bounds */
#define SMALL 0x1p-50    /* rounding of s */
#define CANCELED 0x1p-96 /* error of p over the lengths of a and e */

static void extend(struct twofold from[3], double by, const struct twofold d[3])
{
    for (int i = 0; i < 3; i++)
        from[i] = twofold_add(from[i], twofold_scale(by, d[i]));
}

static void lines_of(const double *const x[5], int exponent, int exchanged, struct lines *l)
{
    const int next = exchanged ? 3 : 1, side = exchanged ? 1 : 3;
    for (int i = 0; i < 3; i++) {
        l->along[0][i] = bilinear_difference(x[next][i], x[0][i], exponent);
        l->along[1][i] = bilinear_difference(x[2][i], x[side][i], exponent);
        l->across[i] = bilinear_difference(x[side][i], x[0][i], exponent);
        l->e[0][i] = bilinear_difference(x[4][i], x[0][i], exponent);
        l->e[1][i] = bilinear_difference(x[4][i], x[side][i], exponent);
        l->twist[i] = twofold_subtract(l->along[1][i], l->along[0][i]);
    }
    extend(l->along[0], -BEYOND, l->twist);
    extend(l->along[1], BEYOND, l->twist);
    extend(l->e[0], BEYOND, l->across);
    extend(l->e[1], -BEYOND, l->across);
    l->exchanged = exchanged;
}

/* ---- the quintic ---- */

/* Adds the product of u and v; polynomials are sums of c[k] t^k (1-t)^(n-k). */
static void add_product(int m, const struct twofold u[], int n, const struct twofold v[], struct twofold product[])
{
    for (int i = 0; i <= m; i++)
        for (int j = 0; j <= n; j++)
            product[i + j] = twofold_add(product[i + j], twofold_multiply(u[i], v[j]));
}

/* Adds the product of sizes. */
static void add_size(int m, const double u[], int n, const double v[], double product[])
{
    for (int i = 0; i <= m; i++)
        for (int j = 0; j <= n; j++)
            product[i + j] += u[i] * v[j];
}

/* Computes the product P of (Q AD + p c) and (Q e - p a), vectors of degrees 2 and 3. */
static void product_of(const struct lines *l, struct twofold product[])
{
    struct twofold q[3] = {{0.0, 0.0}}, p[3] = {{0.0, 0.0}};
    for (int i = 0; i < 3; i++) {
        const struct twofold a[2] = {l->along[0][i], l->along[1][i]}, e[2] = {l->e[0][i], l->e[1][i]};
        add_product(1, a, 1, a, q);
        add_product(1, a, 1, e, p);
    }
    for (int i = 0; i < 3; i++) {
        const struct twofold minus_a[2] = {twofold_scale(-1.0, l->along[0][i]), twofold_scale(-1.0, l->along[1][i])};
        const struct twofold e[2] = {l->e[0][i], l->e[1][i]};
        struct twofold u[3] = {{0.0, 0.0}}, v[4] = {{0.0, 0.0}};
        add_product(2, q, 0, &l->across[i], u);
        add_product(2, p, 0, &l->twist[i], u);
        add_product(2, q, 1, e, v);
        add_product(2, p, 1, minus_a, v);
        add_product(2, u, 3, v, product);
    }
}

static void size_of(const struct lines *l, double product[])
{
    const double across = lines_length(l->across), twist = lines_length(l->twist);
    const double a[2] = {lines_length(l->along[0]) + BEYOND * twist, lines_length(l->along[1]) + BEYOND * twist};
    const double e[2] = {lines_length(l->e[0]) + BEYOND * across, lines_length(l->e[1]) + BEYOND * across};
    double q[3] = {0.0}, p[3] = {0.0}, u[3] = {0.0}, v[4] = {0.0};
    add_size(1, a, 1, a, q);
    add_size(1, a, 1, e, p);
    add_size(2, q, 0, &across, u);
    add_size(2, p, 0, &twist, u);
    add_size(2, q, 1, e, v);
    add_size(2, p, 1, a, v);
    add_size(2, u, 3, v, product);
}

int footpoint_lines_isolate(const double *const x[5], int exponent, int exchanged, struct lines *l,
                            struct roots_interval interval[ROOTS_MOST])
{
    static const double binomial[ROOTS_DEGREE + 1] = {1.0, 5.0, 10.0, 10.0, 5.0, 1.0};
    struct roots_polynomial p = {{{0.0, 0.0}}, {0.0}};
    lines_of(x, exponent, exchanged, l);
    product_of(l, p.c);
    size_of(l, p.error);
    for (int k = 0; k <= ROOTS_DEGREE; k++) {
        p.c[k] = twofold_divide(p.c[k], twofold_of(binomial[k]));
        p.error[k] = p.error[k] / binomial[k] * ERROR + 0x1p-900; /* the last term is for underflow */
    }
    return footpoint_roots_isolate(&p, interval);
}

/* ---- places ---- */

static void interpolate(const struct twofold ends[2][3], struct twofold t, struct twofold at[3])
{
    for (int i = 0; i < 3; i++)
        at[i] = twofold_add(ends[0][i], twofold_multiply(t, twofold_subtract(ends[1][i], ends[0][i])));
}

void footpoint_lines_at(const struct lines *l, struct twofold t, struct twofold a[3], struct twofold e[3])
{
    interpolate(l->along, t, a);
    interpolate(l->e, t, e);
}

void footpoint_lines_point(const struct lines *l, struct twofold t, double z[2])
{
    struct twofold a[3], e[3];
    footpoint_lines_at(l, t, a, e);
    const double across = t.high * (1.0 + 2.0 * BEYOND) - BEYOND;
    const struct twofold square = twofold_dot(a, a), s = twofold_divide(twofold_dot(a, e), square);
    z[l->exchanged] = square.high > 0.0 ? lines_clamp(2.0 * s.high - 1.0) : 0.0;
    z[!l->exchanged] = bilinear_clamp(2.0 * across - 1.0);
}

/* Bounds a ratio of quadratics in Bernstein form: it is a mean of the ratios of their coefficients, if the coefficients of Q are positive. */
double footpoint_lines_bound(const struct lines *l, const struct roots_interval *interval, double s[2])
{
    struct twofold a[2][3], e[2][3];
    for (int k = 0; k < 2; k++)
        footpoint_lines_at(l, lines_part(interval, k), a[k], e[k]);
    const double size = bilinear_larger(lines_length(e[0]), lines_length(e[1]));
    const struct twofold q[3] = {twofold_dot(a[0], a[0]), twofold_dot(a[0], a[1]), twofold_dot(a[1], a[1])};
    const struct twofold p[3] = {twofold_dot(a[0], e[0]),
                                 twofold_scale(0.5, twofold_add(twofold_dot(a[0], e[1]), twofold_dot(a[1], e[0]))),
                                 twofold_dot(a[1], e[1])};
    double least = q[0].high;
    s[0] = INFINITY;
    s[1] = -INFINITY;
    for (int k = 0; k < 3; k++) {
        const double place = twofold_divide(p[k], q[k]).high;
        const double error = SMALL * (1.0 + fabs(place)) + CANCELED * size / sqrt(q[k].high);
        least = bilinear_smaller(least, q[k].high);
        s[0] = bilinear_smaller(s[0], place - error);
        s[1] = bilinear_larger(s[1], place + error);
    }
    if (least > 0.0 && q[1].high > MARGIN * MARGIN * sqrt(q[0].high * q[2].high) && isfinite(s[0]) && isfinite(s[1]))
        return least;
    s[0] = 0.0;
    s[1] = 1.0;
    return 0.0;
}

/* Tests p - Q > 0 or p < 0. */
int footpoint_lines_outside(const struct lines *l, const struct roots_interval *interval)
{
    const double low = interval->low.high, high = low + interval->width;
    double a[2][3], e[2][3], p[3], q[3];
    for (int i = 0; i < 3; i++) {
        const double da = l->along[1][i].high - l->along[0][i].high, de = l->e[1][i].high - l->e[0][i].high;
        a[0][i] = l->along[0][i].high + low * da;
        a[1][i] = l->along[0][i].high + high * da;
        e[0][i] = l->e[0][i].high + low * de;
        e[1][i] = l->e[0][i].high + high * de;
    }
    const double size = lines_length(l->along[0]) + lines_length(l->along[1]);
    const double margin = (MARGIN + BEYOND) * size * (size + lines_length(l->e[0]) + lines_length(l->e[1]));
    int above = 1, below = 1;
    p[0] = vector_dot(a[0], e[0]), p[1] = 0.5 * (vector_dot(a[0], e[1]) + vector_dot(a[1], e[0]));
    p[2] = vector_dot(a[1], e[1]);
    q[0] = vector_dot(a[0], a[0]), q[1] = vector_dot(a[0], a[1]), q[2] = vector_dot(a[1], a[1]);
    for (int k = 0; k < 3; k++) {
        above &= p[k] - q[k] > margin;
        below &= p[k] < -margin;
    }
    return above || below;
}
