/* Finds the closest point of any plane triangle.
 *
 * Let e be the longest edge, f the vector from its start to the third node, t = e.f/e.e and h = f - t e the height over e.
 * As e and h are at right angles, the foot point of xS, d away from the start of e, is p e + q h with p = e.d/e.e and
 * q = h.d/h.h, so that its barycentric coordinates are 1 - p - q (1 - t), p - q t and q.  If all are positive, it is the
 * closest point.  Otherwise the nearest point of the three edges is.
 *
 * Only h cancels.  Differences of nodes are exact and h carries twice the precision, so that its relative error is 2^-99
 * times the ratio of e to h: even triangles that are flat to rounding keep half of their digits. */
#include "triangle.h"
#include "bilinear.h"

#define FLAT (32.0 * DBL_EPSILON) /* the ratio of h to e at which rounding of coordinates puts nodes on a line */

/* Powers of two: edges within 2^+-ORDINARY are not scaled, and xS counts as at most 2^FARTHEST edges away, so that no product
 * overflows. */
enum { ORDINARY = 200, FARTHEST = 200 };

/* Lengths are in 2^exponent mesh lengths, `from` is in 2^(exponent + far). */
struct triangle {
    struct twofold way[3][3], from[3][3]; /* AB, BC, CA; from A, B, C to xS */
    int exponent, far;
};

/* Returns the exponent of the largest difference of n points from another point; -1074 if all are 0. */
static int exponent_of(const double *x, int n, const double from[3])
{
    double most = 0.0;
    int exponent = 0;
    for (int i = 0; i < 3 * n; i++)
        most = bilinear_larger(most, fabs(0.25 * x[i] - 0.25 * from[i % 3]));
    (void)frexp(most, &exponent);
    return most > 0.0 ? exponent + 2 : -1074;
}

static int triangle_of(const double x[12], struct triangle *f)
{
    double sum = 0.0;
    for (int i = 0; i < 12; i++)
        sum += 0.0 * x[i];
    if (!(sum == 0.0))
        return FOOTPOINT_ERR_NOT_FINITE;
    const int edges = exponent_of(x, 3, x), away = exponent_of(x + 9, 1, x);
    f->exponent = -ORDINARY <= edges && edges <= ORDINARY ? 0 : edges;
    f->far = away > edges + FARTHEST ? away - edges - FARTHEST : 0;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            f->way[k][i] = bilinear_difference(x[3 * ((k + 1) % 3) + i], x[3 * k + i], f->exponent);
            f->from[k][i] = bilinear_difference(x[9 + i], x[3 * k + i], f->exponent + f->far);
        }
    return FOOTPOINT_OK;
}

static void highs(const struct twofold a[3], double b[3])
{
    for (int i = 0; i < 3; i++)
        b[i] = a[i].high;
}

/* Computes c = a - by b. */
static void take(const struct twofold a[3], struct twofold by, const struct twofold b[3], struct twofold c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = twofold_subtract(a[i], twofold_multiply(by, b[i]));
}

static int longest_of(const struct triangle *f)
{
    double square[3], way[3];
    for (int k = 0; k < 3; k++) {
        highs(f->way[k], way);
        square[k] = vector_dot(way, way);
    }
    return square[1] > square[0] ? 1 + (square[2] > square[1]) : 2 * (square[2] > square[0]);
}

/* Finds the foot point, d away from xS.
 *  @return 1 if it is inside, 0 if it is not, -1 if the triangle has no area */
static int find_foot(struct triangle *f, double loc[2], double d[3])
{
    const int k = longest_of(f);
    const struct twofold *const e = f->way[k], *const back = f->way[(k + 2) % 3], *const from = f->from[k];
    const struct twofold ee = twofold_dot(e, e);
    struct twofold h[3], rest[3], part[3];
    if (!(ee.high > 0.0))
        return -1;
    const struct twofold t = twofold_divide(twofold_dot(e, back), ee); /* from C to A, with the sign changed */
    take(back, t, e, h);
    const struct twofold hh = twofold_dot(h, h);
    if (!(hh.high > FLAT * FLAT * ee.high))
        return -1;
    const struct twofold p = twofold_divide(twofold_dot(e, from), ee), q = twofold_divide(twofold_dot(h, from), hh);
    part[(k + 2) % 3] = twofold_scale(-1.0, q);
    part[(k + 1) % 3] = twofold_subtract(p, twofold_multiply(q, t));
    part[k] = twofold_subtract(twofold_subtract(twofold_of(1.0), part[(k + 1) % 3]), part[(k + 2) % 3]);
    if (!(part[0].high > 0.0 && part[1].high > 0.0 && part[2].high > 0.0))
        return 0;
    loc[0] = part[1].high;
    loc[1] = part[2].high;
    take(from, p, e, rest);
    take(rest, q, h, rest);
    highs(rest, d);
    return 1;
}

/* Finds the nearest point of the edges, d away from xS. */
static void find_edge(const struct triangle *f, double loc[2], double d[3])
{
    double best = 0.0;
    for (int k = 0; k < 3; k++) {
        double along[3], away[3];
        highs(f->way[k], along);
        highs(f->from[k], away);
        const double square = vector_dot(along, along), product = vector_dot(along, away);
        const double t = product <= 0.0 || !(square > 0.0) ? 0.0 : product >= square ? 1.0 : product / square;
        for (int i = 0; i < 3; i++)
            away[i] -= t * along[i];
        if (k == 0 || vector_dot(away, away) < best) {
            best = vector_dot(away, away);
            memcpy(d, away, sizeof away);
            loc[0] = k == 0 ? t : k == 1 ? 1.0 - t : 0.0;
            loc[1] = k == 0 ? 0.0 : k == 1 ? t : 1.0 - t;
        }
    }
}

int footpoint_triangle_closest(const double x[12], double loc[2], double *distance)
{
    struct triangle f;
    double at[2], d[3];
    const int wrong = triangle_of(x, &f);
    if (wrong)
        return wrong;
    const int found = find_foot(&f, at, d);
    if (found <= 0)
        find_edge(&f, at, d);
    double length = sqrt(vector_dot(d, d));
    if (f.exponent + f.far != 0)
        length = ldexp(length, f.exponent + f.far);
    if (!isfinite(length))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = at[0];
    loc[1] = at[1];
    *distance = length;
    return found < 0 ? FOOTPOINT_NO_AREA : FOOTPOINT_OK;
}
