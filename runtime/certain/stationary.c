/* Finds all stationary points of the distance to a bilinear segment, from the roots of the quintics of both families of lines
 * (lines.h).  Each root of a family at which a is not 0 gives a point, so there are at most five.  At a collapsed edge a has almost
 * no length and P decides little, so both families are used, lines along xi and lines along eta.
 *
 * Every stationary point lies in an interval of either family.  Either a family finds it; or the list contains it by bounds on its
 * place, for the remaining rounding; or it lies in undecided intervals of both.  For each pair of such intervals that (7), (8) do
 * not exclude, the list contains a point that stands for all points there. */
#include "stationary.h"
#include "lines.h"

#include <string.h>

#define START 0x1p-18  /* width of an interval in t from which Newton's method is tried */
#define END 0x1p-80    /* ... and to which it is narrowed if that fails: next to a pinch s changes so quickly */
#define APART 1e-9     /* a point this near to a point of the other family, in xi and eta, is the same */
#define MARGIN 0x1p-40 /* for the rounding of bounds */
#define SMALL 0x1p-50  /* ... of s and t */
#define SLICE 0.125    /* part of an interval that is cut off at its end if nothing is there */
#define SHARP 1e-10    /* a smaller reach belongs to a single point */

enum { CUTS = 400, PARTS = 64 };

struct family {
    struct lines lines;
    struct roots_interval interval[ROOTS_MOST];
    int settled[ROOTS_MOST];      /* 1 if the root of the interval is outside, or listed and sharp */
    double box[ROOTS_MOST][2][2]; /* ... bounds on (1 + z)/2 for the others */
    int count;
};

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

/* Iterates Newton's method from z.  Returns 1 if it leads to the root of a single interval: to a stationary point that is proved to
 * be the only one there, and either lies in the interval beyond doubt or, if the interval has almost no width, at the place of its
 * line. */
static int settle(const double *const x[5], const struct bilinear *f, const struct family *family,
                  const struct roots_interval *interval, double z[2])
{
    const int along = family->lines.exchanged, across = !along;
    double to[2] = {z[0], z[1]}, place[2], radius;
    if (!is_inside(z) || !footpoint_bilinear_refine(x, f, to, &radius))
        return 0;
    const double m[2] = {f->m1, f->m2}, t = lines_through(&family->lines, to) - interval->low.high;
    const double slack = radius / m[across] + DBL_EPSILON;
    if (!(slack < t && t < interval->width - slack)) {
        const double s = 0.5 * (1.0 + to[along]), loose = radius / m[along] + DBL_EPSILON;
        if (!(footpoint_lines_bound(&family->lines, interval, place) > 0.0 && -slack <= t &&
              t <= interval->width + slack && place[1] - place[0] <= APART && place[0] - loose <= s &&
              s <= place[1] + loose))
            return 0;
    }
    z[0] = lines_clamp(to[0]);
    z[1] = lines_clamp(to[1]);
    return 1;
}

/* Returns 1 if the root of a single interval belongs to a point of the list. */
static int is_known(const struct family *family, const struct roots_interval *interval,
                    const struct stationary_point point[], int count)
{
    for (int k = 0; k < count; k++) {
        const double t = lines_through(&family->lines, point[k].z) - interval->low.high;
        if (point[k].reach <= 0.0 && APART < t && t < interval->width - APART)
            return 1;
    }
    return 0;
}

/* Bounds how much distances differ from a point's, over m, for points within `reach` of it and within u and v of its xi and eta.
 *     |d - e|^2 = |d|^2 - 2 (u a . d + v b . d + u v c3 . d) + |e|^2 */
static double vary(const struct bilinear *f, const struct bilinear_wide *w, double u, double v, double reach)
{
    const double square = twofold_dot(w->d, w->d).high, length = sqrt(square), noise = MARGIN * MARGIN * f->m * length;
    const double slope = u * (fabs(twofold_dot(w->a, w->d).high) + noise) +
                         v * (fabs(twofold_dot(w->b, w->d).high) + noise) +
                         u * v * (fabs(twofold_dot(w->c, w->d).high) + noise);
    return length > 0.0 ? (slope / f->m + 0.5 * reach * reach * f->m) / length : INFINITY;
}

/* Bounds the same for all stationary points on the lines of an interval, beside a distance of `there`, if Q is at least `square`.
 * Along the points of the lines that are nearest to xS the square of the distance changes by -2 P/Q^2 a unit of t. */
static double vary_along(const struct bilinear *f, const struct lines *l, const struct roots_interval *interval,
                         double square, double there)
{
    struct twofold a[3], e[3];
    footpoint_lines_at(l, lines_part(interval, 0.5), a, e);
    const struct twofold p = twofold_dot(a, e), q = twofold_dot(a, a);
    const double height = twofold_subtract(twofold_dot(e, e), twofold_divide(twofold_multiply(p, p), q)).high;
    const double change = 2.0 * (1.0 + 2.0 * LINES_BEYOND) * interval->most * interval->width / (square * square);
    const double least = sqrt(bilinear_larger(height - change, 0.0));
    const double most = sqrt(bilinear_larger(height + change, 0.0));
    return bilinear_larger(fabs(most - there), fabs(there - least)) / f->m;
}

/* Adds a point that stands for an undecided interval: for all stationary points on its lines, and `within` along them unless that
 * is NULL.  The point's z lies on one of these lines.  Returns 0 if there are no stationary points. */
static int represent(const double *const x[5], const struct bilinear *f, const struct family *family,
                     const struct roots_interval *interval, const double within[2], struct stationary_point *point)
{
    const struct lines *const l = &family->lines;
    const int along = l->exchanged, across = !along;
    struct twofold a[2][3], e[2][3], opposite[3];
    struct bilinear_wide w;
    double s[2], extent[2];
    const double square = footpoint_lines_bound(l, interval, s);
    s[0] = bilinear_larger(s[0], within ? bilinear_larger(within[0], 0.0) : 0.0) - LINES_BEYOND;
    s[1] = bilinear_smaller(s[1], within ? bilinear_smaller(within[1], 1.0) : 1.0) + LINES_BEYOND;
    if (s[0] > s[1])
        return 0;
    for (int k = 0; k < 2; k++) {
        point->z[k] = bilinear_clamp(point->z[k]);
        footpoint_lines_at(l, lines_part(interval, k), a[k], e[k]);
    }
    for (int i = 0; i < 3; i++)
        opposite[i] = twofold_add(l->across[i], l->twist[i]);
    const double at = 0.5 * (1.0 + point->z[along]);
    extent[along] = bilinear_larger(s[1] - at, at - s[0]);
    extent[across] = interval->width;
    point->reach = (bilinear_larger(lines_length(a[0]), lines_length(a[1])) * extent[along] +
                    bilinear_larger(lines_length(l->across), lines_length(opposite)) * extent[across]) /
                   f->m;
    point->box[along][0] = s[0];
    point->box[along][1] = s[1];
    lines_place(interval, point->box[across]);
    footpoint_bilinear_wide_at(x, f->exponent, point->z, &w);
    point->variation = bilinear_smaller(
        point->reach, square > 0.0 ? vary_along(f, l, interval, square, sqrt(twofold_dot(w.d, w.d).high))
                                   : vary(f, &w, 2.0 * extent[0], 2.0 * extent[1], point->reach));
    return 1;
}

/* Finds the root of a single interval.  Returns 0 if its point is outside. */
static int find(const double *const x[5], const struct bilinear *f, const struct family *family,
                struct roots_interval *interval, struct stationary_point *point)
{
    static const double width[] = {0x1p-2, 0x1p-6, START};
    double place[2];
    for (int k = 0; k < 3; k++) {
        footpoint_roots_narrow(interval, width[k]);
        if (footpoint_lines_outside(&family->lines, interval))
            return 0;
    }
    point->reach = point->variation = 0.0;
    point->across = !family->lines.exchanged;
    point->several = 0;
    lines_place(interval, place);
    point->alone[0] = 2.0 * place[0] - 1.0 + APART;
    point->alone[1] = 2.0 * place[1] - 1.0 - APART;
    for (int exactly = 0; exactly < 2; exactly++) {
        footpoint_lines_point(&family->lines, lines_part(interval, 0.5), point->z);
        if (settle(x, f, family, interval, point->z))
            return is_inside(point->z);
        footpoint_roots_narrow(interval, END);
    }
    footpoint_lines_point(&family->lines, footpoint_roots_middle(interval), point->z);
    return represent(x, f, family, interval, NULL, point);
}

/* ---- undecided intervals ---- */

/* Returns 1 if (7) or (8) is not 0 anywhere in the box of middle z and half-widths w: a . d and b . d change at the rates
 * -a.a, c3.d - a.b and -b.b. */
static int is_excluded(const struct bilinear *f, const double z[2], const double w[2])
{
    struct bilinear_point p;
    bilinear_at(f, z[0], z[1], &p);
    const double c = sqrt(vector_dot(f->c3, f->c3));
    const double a = sqrt(vector_dot(p.a, p.a)) + c * w[1], b = sqrt(vector_dot(p.b, p.b)) + c * w[0];
    const double cd = fabs(vector_dot(f->c3, p.d)) + c * (a * w[0] + b * w[1]);
    const double change1 = w[0] * a * a + w[1] * (cd + a * b), change2 = w[1] * b * b + w[0] * (cd + a * b);
    const double error = 2.0 * p.error * f->m;
    return fabs(p.f1) > 2.0 * (change1 / f->m1 + error) || fabs(p.f2) > 2.0 * (change2 / f->m2 + error);
}

/* Proves this part by part, after cutting interval `cut` of a pair. */
static int is_pair_excluded(const struct bilinear *f, const struct roots_interval pair[2], int cut, int parts)
{
    double z[2], w[2], place[2];
    for (int k = 0; k < 2; k++) {
        lines_place(&pair[k], place);
        z[!k] = place[0] + place[1] - 1.0;
        w[!k] = place[1] - place[0] + 2.0 * LINES_BEYOND;
    }
    const double first = z[!cut] - w[!cut], width = 2.0 * w[!cut] / parts;
    w[!cut] = 0.5 * width + 2.0 * LINES_BEYOND;
    for (int i = 0; i < parts; i++) {
        const double at = first + width * (i + 0.5), y[2] = {cut ? at : z[0], cut ? z[1] : at};
        if (!is_excluded(f, y, w))
            return 0;
    }
    return 1;
}

/* Cuts off excluded ends of both intervals.  Returns 0 if nothing is left. */
static int trim(const struct bilinear *f, struct roots_interval pair[2])
{
    int cuts = 0, before = -1;
    if (is_pair_excluded(f, pair, 0, 1))
        return 0;
    while (cuts > before && cuts < CUTS) {
        before = cuts;
        for (int k = 0; k < 4; k++) {
            struct roots_interval part[2] = {pair[0], pair[1]}, *const at = &part[k / 2];
            const double width = at->width * SLICE;
            at->low = k % 2 ? twofold_add(at->low, twofold_of(at->width - width)) : at->low;
            at->width = width;
            if (!is_pair_excluded(f, part, k < 2, PARTS))
                continue;
            pair[k / 2].low = k % 2 ? pair[k / 2].low : twofold_add(pair[k / 2].low, twofold_of(width));
            pair[k / 2].width -= width;
            cuts++;
        }
    }
    return 1;
}

/* Represents a pair by the family whose lines decide more. */
static int find_pair(const double *const x[5], const struct bilinear *f, const struct family family[2], int i, int j,
                     struct stationary_point *point)
{
    struct roots_interval pair[2] = {family[0].interval[i], family[1].interval[j]};
    struct stationary_point by[2] = {{{0.0, 0.0}, 0.0, 0.0, {0.0, 0.0}, {{0.0, 0.0}, {0.0, 0.0}}, 0, 1}};
    if (!trim(f, pair))
        return 0;
    for (int k = 0; k < 2; k++) {
        double within[2];
        by[k] = by[0];
        lines_place(&pair[!k], within);
        footpoint_lines_point(&family[k].lines, lines_part(&pair[k], 0.5), by[k].z);
        if (!represent(x, f, &family[k], &pair[k], within, &by[k]))
            return 0;
    }
    *point = by[by[1].variation < by[0].variation];
    return 1;
}

static int is_alone_at(const struct stationary_point *p, const struct stationary_point *q)
{
    const double z = q->z[p->across];
    return q->reach <= 0.0 && p->alone[0] < z && z < p->alone[1];
}

/* Keeps the last of count + 1 points unless it is one of the first `known`, of which the sharper stays. */
static int keep(const double *const x[5], const struct bilinear *f, struct stationary_point point[], int known,
                int count)
{
    const struct stationary_point new = point[count];
    for (int k = 0; k < known; k++) {
        struct stationary_point *const old = &point[k];
        const struct stationary_point sharper = new.reach < old->reach ? new : *old;
        const double both = new.reach + old->reach;
        if (is_alone_at(old, &new) || is_alone_at(&new, old) ||
            (fabs(old->z[0] - new.z[0]) <= APART && fabs(old->z[1] - new.z[1]) <= APART)) {
            *old = sharper;
            return count;
        }
        if (0.0 < both && both <= SHARP && between(x, f, old->z, new.z) <= both) { /* the same, or almost */
            *old = sharper;
            old->reach += both;
            old->variation += new.variation + both;
            return count;
        }
    }
    return count + 1;
}

/* Adds a pair.  If there are too many, the last point stands for all that do not fit. */
static int add_pair(const double *const x[5], const struct bilinear *f, const struct family family[2], int i, int j,
                    struct stationary_point point[], int count)
{
    struct stationary_point pair;
    if (!find_pair(x, f, family, i, j, &pair))
        return count;
    if (count == STATIONARY_MOST) {
        point[count - 1].reach = point[count - 1].variation = INFINITY;
        return count;
    }
    point[count] = pair;
    return keep(x, f, point, count, count);
}

static int is_apart(const double p[2][2], const double q[2][2])
{
    return p[0][1] + SMALL < q[0][0] || q[0][1] + SMALL < p[0][0] || p[1][1] + SMALL < q[1][0] ||
           q[1][1] + SMALL < p[1][0];
}

/* Returns 1 if a point that is not sharp may be the root of an interval of a family: of `single` intervals that are not settled, or
 * of others. */
static int is_met(const struct family *family, const struct stationary_point *point, int single)
{
    for (int i = 0; i < family->count; i++)
        if (!family->settled[i] && (single || !family->interval[i].single) && !is_apart(family->box[i], point->box))
            return 1;
    return 0;
}

/* Lists the roots of single intervals.  A point of the second family that is not sharp is new only if the first is undecided. */
static int list_single(const double *const x[5], const struct bilinear *f, struct family family[2], int k,
                       struct stationary_point point[], int count)
{
    const int first = count;
    for (int i = 0; i < family[k].count; i++) {
        struct roots_interval *const interval = &family[k].interval[i];
        struct stationary_point *const new = &point[count];
        family[k].settled[i] = interval->single && is_known(&family[k], interval, point, k == 0 ? 0 : first);
        family[k].box[i][k][0] = 0.0;
        family[k].box[i][k][1] = 1.0;
        lines_place(interval, family[k].box[i][!k]);
        if (!interval->single || family[k].settled[i])
            continue;
        const int found = find(x, f, &family[k], interval, new), sharp = found && new->reach <= 0.0;
        family[k].settled[i] = sharp || !found;
        if (found && !sharp)
            memcpy(family[k].box[i], new->box, sizeof new->box);
        if (found && (k == 0 || sharp || is_met(&family[0], new, 0)))
            count = k == 0 ? count + 1 : keep(x, f, point, first, count);
    }
    return count;
}

/* Drops points of the first family that are not sharp if all intervals of the second that they may meet are settled: a stationary
 * point lies in an interval of either family, so such a point does not exist or is listed by the second. */
static int drop_settled(const struct family *second, struct stationary_point point[], int count)
{
    int left = 0;
    for (int k = 0; k < count; k++)
        if (point[k].reach <= 0.0 || point[k].across == 0 || is_met(second, &point[k], 1))
            point[left++] = point[k];
    return left;
}

int footpoint_bilinear_stationary(const double *const x[5], const struct bilinear *f, struct stationary_point point[])
{
    struct family family[2];
    int count = 0;
    for (int k = 0; k < 2; k++) {
        family[k].count = footpoint_lines_isolate(x, f->exponent, k, &family[k].lines, family[k].interval);
        count = list_single(x, f, family, k, point, count);
    }
    count = drop_settled(&family[1], point, count);
    for (int i = 0; i < family[0].count; i++)
        for (int j = 0; j < family[1].count; j++)
            if (!family[0].interval[i].single && !family[1].interval[j].single)
                count = add_pair(x, f, family, i, j, point, count);
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
        sharp &= !point[k].several && !(point[k].reach > SHARP);
        loc[k][0] = point[k].z[0];
        loc[k][1] = point[k].z[1];
    }
    return sharp && all == *count ? FOOTPOINT_OK : FOOTPOINT_NOT_UNIQUE;
}
