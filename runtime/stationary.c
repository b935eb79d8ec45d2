/* All stationary points of the distance to a bilinear segment.  Given t = (1 + eta)/2, (7) is linear in s = (1 + xi)/2:
 * with a = (1-t) AB + t DC and e = (xS - xA) - t AD it reads s = p/Q, p = a . e, Q = a . a.  Then (8), times Q^2, is a
 * quintic in t,
 *     P = (Q AD + p c) . (Q e - p a) = 0,   c = DC - AB,
 * and each of its roots where a is not 0 gives one point, so there are five at most.  P is formed with twice the
 * precision from differences of nodes, which are exact: its coefficients are known to 1e-27 of the sizes of their
 * terms.  roots.c tells its roots apart.
 *
 * Where a has next to no length, as at a collapsed edge, P says little: so the same is done with xi and eta exchanged.
 * A stationary point is found by one of the two, or it lies in an interval of each of which nothing is known; for such
 * pairs of intervals that (7), (8) do not exclude there is one point that stands for what is there. */
#include "stationary.h"
#include "roots.h"

#define ERROR 0x1p-90  /* of coefficients and their halvings, in units of the sum of the sizes of all terms */
#define BEYOND 0x1p-37 /* points that far outside, in s and t, count as on the edge */
#define START 0x1p-18  /* width of an interval in t from which Newton's method is tried */
#define END 0x1p-80    /* ... and to which it is narrowed if that fails: next to a pinch s changes that quickly */
#define APART 1e-9     /* a point that near to one that the other family found is the same, in xi and eta ... */
#define BLURRED 2.0    /* ... along its line whatever differs, if that could not be sharpened, */
#define NARROW 1e-11   /* ... and across it less */
#define MARGIN 0x1p-40 /* for the rounding of bounds */
#define SHARP 1e-10    /* a reach below is that of one point */

/* The lines of one family, by t from -BEYOND (0) to 1 + BEYOND (1): direction and xS minus the start, linear in t. */
struct lines {
    struct twofold along[2][3], e[2][3], across[3], twist[3];
};

struct family {
    struct lines lines;
    struct roots_interval interval[ROOTS_MOST];
    int count, exchanged;
};

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
}

/* ---- the quintic ---- */

static double length(const struct twofold a[3])
{
    return sqrt(a[0].high * a[0].high + a[1].high * a[1].high + a[2].high * a[2].high);
}

/* Polynomials are sums of c[k] t^k (1-t)^(n-k).  product += u v. */
static void add_product(int m, const struct twofold u[], int n, const struct twofold v[], struct twofold product[])
{
    for (int i = 0; i <= m; i++)
        for (int j = 0; j <= n; j++)
            product[i + j] = twofold_add(product[i + j], twofold_multiply(u[i], v[j]));
}

/* The same of sizes. */
static void add_size(int m, const double u[], int n, const double v[], double product[])
{
    for (int i = 0; i <= m; i++)
        for (int j = 0; j <= n; j++)
            product[i + j] += u[i] * v[j];
}

/* The product P of (Q AD + p c) and (Q e - p a), vectors of degrees 2 and 3. */
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
    const double across = length(l->across), twist = length(l->twist);
    const double a[2] = {length(l->along[0]) + BEYOND * twist, length(l->along[1]) + BEYOND * twist};
    const double e[2] = {length(l->e[0]) + BEYOND * across, length(l->e[1]) + BEYOND * across};
    double q[3] = {0.0}, p[3] = {0.0}, u[3] = {0.0}, v[4] = {0.0};
    add_size(1, a, 1, a, q);
    add_size(1, a, 1, e, p);
    add_size(2, q, 0, &across, u);
    add_size(2, p, 0, &twist, u);
    add_size(2, q, 1, e, v);
    add_size(2, p, 1, a, v);
    add_size(2, u, 3, v, product);
}

static void isolate(const double *const x[5], int exponent, int exchanged, struct family *family)
{
    static const double binomial[ROOTS_DEGREE + 1] = {1.0, 5.0, 10.0, 10.0, 5.0, 1.0};
    struct roots_polynomial p = {{{0.0, 0.0}}, {0.0}};
    lines_of(x, exponent, exchanged, &family->lines);
    product_of(&family->lines, p.c);
    size_of(&family->lines, p.error);
    for (int k = 0; k <= ROOTS_DEGREE; k++) {
        p.c[k] = twofold_divide(p.c[k], twofold_of(binomial[k]));
        p.error[k] = p.error[k] / binomial[k] * ERROR + 0x1p-900; /* the latter for underflow */
    }
    family->count = footpoint_roots_isolate(&p, family->interval);
    family->exchanged = exchanged;
}

/* ---- from roots to points ---- */

static void at_line(const struct twofold ends[2][3], struct twofold t, struct twofold at[3])
{
    for (int i = 0; i < 3; i++)
        at[i] = twofold_add(ends[0][i], twofold_multiply(t, twofold_subtract(ends[1][i], ends[0][i])));
}

static double clamp_near(double z)
{
    return fabs(z) <= 1.0 + 2.0 * BEYOND ? bilinear_clamp(z) : z;
}

/* xi and eta of the point of line t that is nearest to xS; xi or eta, on its line, may be anything. */
static void point_of_line(const struct family *family, struct twofold t, double z[2])
{
    struct twofold a[3], e[3];
    at_line(family->lines.along, t, a);
    at_line(family->lines.e, t, e);
    const double across = t.high * (1.0 + 2.0 * BEYOND) - BEYOND;
    const struct twofold square = twofold_dot(a, a), s = twofold_divide(twofold_dot(a, e), square);
    z[family->exchanged] = square.high > 0.0 ? clamp_near(2.0 * s.high - 1.0) : 0.0;
    z[!family->exchanged] = bilinear_clamp(2.0 * across - 1.0);
}

/* The t at a part, from 0 to 1, of an interval. */
static struct twofold line_in(const struct roots_interval *interval, double part)
{
    return twofold_add(interval->low, twofold_of(part * interval->width));
}

/* The t of a point. */
static double line_of(const struct family *family, const double z[2])
{
    return (0.5 * (1.0 + z[!family->exchanged]) + BEYOND) / (1.0 + 2.0 * BEYOND);
}

/* Whether p - Q > 0 or p < 0, that is s > 1 or s < 0, all over an interval of t. */
static int is_outside(const struct lines *l, const struct roots_interval *interval)
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
    const double size = length(l->along[0]) + length(l->along[1]);
    const double margin = (MARGIN + BEYOND) * size * (size + length(l->e[0]) + length(l->e[1]));
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

static double between(const double *const x[5], const struct bilinear *f, const double z[2], const double y[2])
{
    struct bilinear_wide p, q;
    double most = 0.0;
    footpoint_bilinear_wide_at(x, f->exponent, z, &p);
    footpoint_bilinear_wide_at(x, f->exponent, y, &q);
    for (int i = 0; i < 3; i++)
        most = bilinear_larger(most, fabs(p.d[i].high - q.d[i].high));
    return most / f->m;
}

static int is_inside(const double z[2])
{
    return fabs(z[0]) <= 1.0 && fabs(z[1]) <= 1.0;
}

/* Newton's method from z; 1 if it leads to the root of a single interval. */
static int settle(const double *const x[5], const struct bilinear *f, const struct family *family,
                  const struct roots_interval *interval, double z[2])
{
    double to[2] = {z[0], z[1]}, radius;
    if (!is_inside(z) || !footpoint_bilinear_refine(x, f, to, &radius))
        return 0;
    const double t = line_of(family, to) - interval->low.high;
    if (t < -DBL_EPSILON || t > interval->width + DBL_EPSILON)
        return 0;
    z[0] = clamp_near(to[0]);
    z[1] = clamp_near(to[1]);
    return 1;
}

/* Whether the root of a single interval is that of one of the points. */
static int is_known(const struct family *family, const struct roots_interval *interval,
                    const struct stationary_point point[], int count)
{
    for (int k = 0; k < count; k++) {
        const double t = line_of(family, point[k].z) - interval->low.high;
        if (point[k].reach <= 0.0 && APART < t && t < interval->width - APART)
            return 1;
    }
    return 0;
}

/* The root of a single interval.  0 if its point is outside. */
static int find(const double *const x[5], const struct bilinear *f, const struct family *family,
                struct roots_interval *interval, struct stationary_point *point)
{
    static const double width[] = {0x1p-2, 0x1p-6, START};
    double low[2], high[2];
    for (int k = 0; k < 3; k++) {
        footpoint_roots_narrow(interval, width[k]);
        if (is_outside(&family->lines, interval))
            return 0;
    }
    point->reach = point->variation = 0.0;
    for (int exactly = 0; exactly < 2; exactly++) {
        point_of_line(family, line_in(interval, 0.5), point->z);
        point->blur[0] = point->blur[1] = APART;
        if (settle(x, f, family, interval, point->z))
            return is_inside(point->z);
        footpoint_roots_narrow(interval, END);
    }
    point_of_line(family, footpoint_roots_middle(interval), point->z);
    point_of_line(family, line_in(interval, 0.0), low);
    point_of_line(family, line_in(interval, 1.0), high);
    point->reach = between(x, f, low, high);
    point->blur[family->exchanged] = BLURRED;
    point->blur[!family->exchanged] = NARROW;
    return is_inside(point->z);
}

/* ---- where nothing is known ---- */

/* 1 if (7) or (8) is not 0 anywhere in the box of middle z and half-widths w: the rates at which a . d and b . d change
 * are -a.a, c3.d - a.b and -b.b. */
static int is_excluded(const struct bilinear *f, const double z[2], const double w[2])
{
    struct bilinear_point p;
    bilinear_at(f, z[0], z[1], &p);
    const double c = sqrt(vector_dot(f->c3, f->c3));
    const double a = sqrt(vector_dot(p.a, p.a)) + c * w[1], b = sqrt(vector_dot(p.b, p.b)) + c * w[0];
    const double d = sqrt(vector_dot(p.d, p.d)) + a * w[0] + b * w[1];
    const double change1 = w[0] * a * a + w[1] * (c * d + a * b), change2 = w[1] * b * b + w[0] * (c * d + a * b);
    const double error = 2.0 * p.error * f->m;
    return fabs(p.f1) > 2.0 * (change1 / f->m1 + error) || fabs(p.f2) > 2.0 * (change2 / f->m2 + error);
}

static double distance(const double *const x[5], const struct bilinear *f, const double z[2])
{
    struct bilinear_wide p;
    footpoint_bilinear_wide_at(x, f->exponent, z, &p);
    return sqrt(twofold_dot(p.d, p.d).high);
}

/* The points nearest to xS of some lines of an interval, by the first of them: if P is 0 all over the interval, so is
 * the slope of their distance. */
static void represent(const double *const x[5], const struct bilinear *f, const struct family *family,
                      const struct roots_interval *interval, struct stationary_point *point)
{
    static const double at[] = {0.5, 0.0, 0.25, 0.75, 1.0};
    double first = 0.0;
    point->reach = point->variation = 0.0;
    point->blur[0] = point->blur[1] = APART;
    for (int k = 0; k < 5; k++) {
        double z[2];
        point_of_line(family, line_in(interval, at[k]), z);
        z[0] = bilinear_clamp(z[0]);
        z[1] = bilinear_clamp(z[1]);
        const double there = distance(x, f, z);
        if (k == 0) {
            point->z[0] = z[0];
            point->z[1] = z[1];
            first = there;
        }
        point->reach = bilinear_larger(point->reach, between(x, f, z, point->z));
        point->variation = bilinear_larger(point->variation, fabs(there - first) / f->m);
    }
}

/* By the family whose lines are longer there. */
static int find_pair(const double *const x[5], const struct bilinear *f, const struct family family[2],
                     const struct roots_interval *i, const struct roots_interval *j, struct stationary_point *point)
{
    const double s = line_in(j, 0.5).high, t = line_in(i, 0.5).high;
    const double z[2] = {bilinear_clamp(2.0 * s - 1.0), bilinear_clamp(2.0 * t - 1.0)};
    const double w[2] = {j->width + 4.0 * BEYOND, i->width + 4.0 * BEYOND};
    struct bilinear_point p;
    if (is_excluded(f, z, w))
        return 0;
    bilinear_at(f, z[0], z[1], &p);
    const int second = vector_dot(p.b, p.b) / (f->m2 * f->m2) > vector_dot(p.a, p.a) / (f->m1 * f->m1);
    represent(x, f, &family[second], second ? j : i, point);
    return 1;
}

/* Keeps the last of count + 1 points unless it is one of the first `known`, of which the sharper stays. */
static int keep(struct stationary_point point[], int known, int count)
{
    const struct stationary_point new = point[count];
    for (int k = 0; k < known; k++) {
        struct stationary_point *const old = &point[k];
        const struct stationary_point *const loose = old->blur[0] + old->blur[1] > 2.0 * APART ? old : &new;
        if (fabs(old->z[0] - new.z[0]) <= loose->blur[0] && fabs(old->z[1] - new.z[1]) <= loose->blur[1]) {
            if (loose == old)
                *old = new;
            return count;
        }
    }
    return count + 1;
}

int footpoint_bilinear_stationary(const double *const x[5], const struct bilinear *f, struct stationary_point point[])
{
    struct family family[2];
    int count = 0, first = 0;
    for (int k = 0; k < 2; k++) {
        isolate(x, f->exponent, k, &family[k]);
        for (int i = 0; i < family[k].count; i++)
            if (family[k].interval[i].single && !is_known(&family[k], &family[k].interval[i], point, first) &&
                find(x, f, &family[k], &family[k].interval[i], &point[count]))
                count = k == 0 ? count + 1 : keep(point, first, count);
        first = k == 0 ? count : first;
    }
    for (int i = 0; i < family[0].count; i++)
        for (int j = 0; j < family[1].count; j++)
            if (!family[0].interval[i].single && !family[1].interval[j].single && count < STATIONARY_MOST &&
                find_pair(x, f, family, &family[0].interval[i], &family[1].interval[j], &point[count]))
                count = keep(point, count, count);
    return count;
}

int footpoint_stationary(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                         const double xS[3], double loc[FOOTPOINT_STATIONARY_MOST][2], int *count)
{
    const double *const x[5] = {xA, xB, xC, xD, xS};
    struct bilinear f;
    struct stationary_point point[STATIONARY_MOST];
    const int status = footpoint_bilinear_of(xA, xB, xC, xD, xS, &f);
    if (status != FOOTPOINT_OK)
        return status;
    if (!footpoint_bilinear_has_area(&f))
        return FOOTPOINT_ERR_DEGENERATE;
    const int all = footpoint_bilinear_stationary(x, &f, point);
    int sharp = 1;
    *count = all < FOOTPOINT_STATIONARY_MOST ? all : FOOTPOINT_STATIONARY_MOST;
    for (int k = 0; k < *count; k++) {
        sharp &= !(point[k].reach > SHARP);
        loc[k][0] = point[k].z[0];
        loc[k][1] = point[k].z[1];
    }
    return sharp && all == *count ? FOOTPOINT_OK : FOOTPOINT_NOT_UNIQUE;
}
