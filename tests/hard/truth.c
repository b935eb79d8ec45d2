/* Finds the truth by subdivision; see truth.h and subdivision.h.  A closest point is a stationary point or lies on an edge, on which it
 * is known in closed form.  All points nearly as near as the best are polished by a projected Newton iteration in extended
 * precision.  If the list of stationary points has gaps, subdivision with bounds on the distance decides how near the segment
 * comes; any other case can be tested so, too. */
#include "truth.h"

#include "subdivision.h"

#include <math.h>

enum { NEWTON_STEPS = 60, LEAVES = 12 };

#define NEARLY 2e-10L /* points up to this height above the least are polished */
#define SAME 1e-8     /* permitted error of a root, in xi and eta or in space */
#define ENOUGH 2e-12L /* accuracy of the least height */

static wide dot(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static wide size_of(wide x)
{
    return x < 0 ? -x : x;
}

int truth_surface_of(const struct hard_case *h, struct truth_surface *f)
{
    wide most = 0, edge[4][3];
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            edge[i][k] = (wide)h->x[(i + 1) % 4][k] - (wide)h->x[i][k];
            most = size_of(edge[i][k]) > most ? size_of(edge[i][k]) : most;
        }
    if (!(most > 0))
        return 0;
    int exponent;
    (void)frexpl((long double)most, &exponent);
    wide scale = exponent < 0 ? 1 / (wide)ldexpl(1, exponent - 1) : (wide)ldexpl(1, 1 - exponent);
    while (most * scale < (wide)0.5)
        scale *= 2;
    while (most * scale > 1)
        scale /= 2;
    for (int k = 0; k < 3; k++) {
        const wide a = (wide)h->x[0][k] * scale, b = (wide)h->x[1][k] * scale, c = (wide)h->x[2][k] * scale,
                   d = (wide)h->x[3][k] * scale;
        f->c1[k] = (b - a + c - d) / 4;
        f->c2[k] = (d - a + c - b) / 4;
        f->c3[k] = (a - b + c - d) / 4;
        f->d0[k] = (wide)h->x[4][k] * scale - (a + b + c + d) / 4;
    }
    f->scale = (double)(1 / scale);
    f->edge = 0;
    for (int i = 0; i < 4; i++)
        f->edge = fmax(f->edge, sqrt((double)(dot(edge[i], edge[i]) * scale * scale)));
    f->distance = sqrt((double)dot(f->d0, f->d0));
    return 1;
}

/* Returns 1 if the corners are clearly not in a line, far beyond rounding in long double. */
static int has_clear_area(const struct hard_case *h)
{
    long double most = 0, area = 0, e[4][3];
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            e[i][k] = (long double)h->x[(i + 1) % 4][k] - h->x[i][k];
            most = fmaxl(most, e[i][k] * e[i][k]);
        }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < i; j++)
            for (int k = 0; k < 3; k++) {
                const long double n = e[i][(k + 1) % 3] * e[j][(k + 2) % 3] - e[i][(k + 2) % 3] * e[j][(k + 1) % 3];
                area = fmaxl(area, n * n);
            }
    return area > 1e-24L * most * most;
}

int truth_has_area(const struct hard_case *h)
{
    if (has_clear_area(h))
        return 1;
    wide most = 0, area = 0;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            wide a[3], b[3];
            for (int k = 0; k < 3; k++) {
                a[k] = (wide)h->x[(i + 1) % 4][k] - h->x[i][k];
                b[k] = (wide)h->x[(j + 1) % 4][k] - h->x[j][k];
            }
            for (int k = 0; k < 3; k++) {
                const wide n = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
                area = n * n > area ? n * n : area;
                most = a[k] * a[k] > most ? a[k] * a[k] : most;
            }
        }
    return area > (wide)1e-28 * most * most;
}

void truth_offset(const struct truth_surface *f, const wide z[2], wide d[3])
{
    for (int k = 0; k < 3; k++)
        d[k] = f->d0[k] - z[0] * f->c1[k] - z[1] * (f->c2[k] + z[0] * f->c3[k]);
}

wide truth_square(const struct truth_surface *f, const wide z[2])
{
    wide d[3];
    truth_offset(f, z, d);
    return dot(d, d);
}

/* Computes gradient and Hessian of half the square. */
static void expand(const struct truth_surface *f, const wide z[2], wide g[2], wide h[3])
{
    wide a[3], b[3], d[3];
    truth_offset(f, z, d);
    for (int k = 0; k < 3; k++) {
        a[k] = f->c1[k] + z[1] * f->c3[k];
        b[k] = f->c2[k] + z[0] * f->c3[k];
    }
    g[0] = -dot(a, d);
    g[1] = -dot(b, d);
    h[0] = dot(a, a);
    h[1] = dot(a, b) - dot(f->c3, d);
    h[2] = dot(b, b);
}

void truth_gradient(const struct truth_surface *f, const wide z[2], wide g[2])
{
    wide d[3];
    g[0] = g[1] = 0;
    truth_offset(f, z, d);
    for (int k = 0; k < 3; k++) {
        g[0] -= (f->c1[k] + z[1] * f->c3[k]) * d[k];
        g[1] -= (f->c2[k] + z[0] * f->c3[k]) * d[k];
    }
}

static wide clamp(wide x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* Computes Newton's step in the free directions, downhill. */
static void propose(const wide g[2], const wide h[3], const int held[2], wide step[2])
{
    const wide determinant = h[0] * h[2] - h[1] * h[1];
    step[0] = held[0] || !(h[0] > 0) ? 0 : -g[0] / h[0];
    step[1] = held[1] || !(h[2] > 0) ? 0 : -g[1] / h[2];
    if (held[0] || held[1])
        return;
    if (determinant > 0) {
        step[0] = (h[1] * g[1] - h[2] * g[0]) / determinant;
        step[1] = (h[1] * g[0] - h[0] * g[1]) / determinant;
    }
}

static double least_eigenvalue(const wide h[3], const int held[2])
{
    const double h0 = (double)h[0], h1 = (double)h[1], h2 = (double)h[2];
    if (held[0] && held[1])
        return 1;
    if (held[0] || held[1] || !(h0 > 0 && h2 > 0))
        return 1;
    return 1 - fabs(h1) / sqrt(h0 * h2);
}

static void descend(const struct truth_surface *f, struct truth_point *p)
{
    wide g[2], h[3];
    int held[2] = {0, 0};
    p->square = truth_square(f, p->z);
    for (int n = 0; n < NEWTON_STEPS; n++) {
        wide step[2], moved[2], most = 0, square;
        expand(f, p->z, g, h);
        for (int k = 0; k < 2; k++)
            held[k] = (p->z[k] <= -1 && g[k] > 0) || (p->z[k] >= 1 && g[k] < 0);
        propose(g, h, held, step);
        wide part = 1;
        int tries = 0;
        do {
            for (int k = 0; k < 2; k++)
                moved[k] = clamp(p->z[k] + part * step[k]);
            square = truth_square(f, moved);
            part /= 4;
        } while (square > p->square && ++tries < 30);
        if (square > p->square)
            break;
        for (int k = 0; k < 2; k++) {
            most = size_of(moved[k] - p->z[k]) > most ? size_of(moved[k] - p->z[k]) : most;
            p->z[k] = moved[k];
        }
        p->square = square;
        if (most < (wide)1e-22)
            break;
    }
    expand(f, p->z, g, h);
    for (int k = 0; k < 2; k++)
        held[k] = size_of(p->z[k]) >= 1 && size_of(g[k]) > (wide)1e-15;
    p->least = least_eigenvalue(h, held);
    p->on_edge = size_of(p->z[0]) >= 1 || size_of(p->z[1]) >= 1;
}

void truth_descend(const struct truth_surface *f, const double loc[2], struct truth_point *p)
{
    p->z[0] = clamp(loc[0]);
    p->z[1] = clamp(loc[1]);
    descend(f, p);
}

static void segment_of(const struct truth_surface *f, struct boxes_segment *s)
{
    for (int k = 0; k < 3; k++) {
        s->c1[k] = (long double)f->c1[k];
        s->c2[k] = (long double)f->c2[k];
        s->c3[k] = (long double)f->c3[k];
        s->d0[k] = (long double)f->d0[k];
    }
}

/* Iterates Newton's method in long double, which takes a twentieth of the time: *z to about its rounding, and the inverse of the
 * Hessian there (1/11, 1/12, 1/22).  Returns 0 if it does not converge. */
static int approach(const struct truth_surface *f, const double loc[2], wide z[2], wide inverse[3])
{
    struct boxes_segment s;
    long double at[2] = {loc[0], loc[1]}, step[2] = {0, 0};
    segment_of(f, &s);
    for (int n = 0; n < NEWTON_STEPS; n++) {
        long double g[2] = {0, 0}, h[3] = {0, 0, 0};
        for (int k = 0; k < 3; k++) {
            const long double a = s.c1[k] + at[1] * s.c3[k], b = s.c2[k] + at[0] * s.c3[k];
            const long double d = s.d0[k] - at[0] * s.c1[k] - at[1] * b;
            g[0] -= a * d;
            g[1] -= b * d;
            h[0] += a * a;
            h[1] += a * b - s.c3[k] * d;
            h[2] += b * b;
        }
        const long double determinant = h[0] * h[2] - h[1] * h[1];
        inverse[0] = h[2] / determinant;
        inverse[1] = -h[1] / determinant;
        inverse[2] = h[0] / determinant;
        step[0] = -(long double)inverse[0] * g[0] - (long double)inverse[1] * g[1];
        step[1] = -(long double)inverse[1] * g[0] - (long double)inverse[2] * g[1];
        at[0] += step[0];
        at[1] += step[1];
        if (!(fabsl(at[0]) < 1e12L && fabsl(at[1]) < 1e12L))
            return 0;
        if (fabsl(step[0]) < 1e-9L && fabsl(step[1]) < 1e-9L)
            break;
    }
    z[0] = at[0];
    z[1] = at[1];
    return fabsl(step[0]) < 1e-9L && fabsl(step[1]) < 1e-9L;
}

/* Continues in extended precision, with the same Hessian: each step leaves so small a part of the error that
 * two or three suffice.  Returns 0 if they do not. */
static int settle(const struct truth_surface *f, const wide inverse[3], wide z[2])
{
    for (int n = 0; n < 4; n++) {
        wide g[2];
        truth_gradient(f, z, g);
        const wide u = -inverse[0] * g[0] - inverse[1] * g[1], v = -inverse[1] * g[0] - inverse[2] * g[1];
        z[0] += u;
        z[1] += v;
        if (size_of(u) < (wide)1e-20 && size_of(v) < (wide)1e-20)
            return 1;
    }
    return 0;
}

int truth_stationary(const struct truth_surface *f, const double loc[2], wide z[2])
{
    wide inverse[3];
    if (approach(f, loc, z, inverse) && settle(f, inverse, z))
        return 1;
    z[0] = loc[0];
    z[1] = loc[1];
    for (int n = 0; n < NEWTON_STEPS; n++) {
        wide g[2], h[3];
        expand(f, z, g, h);
        const wide determinant = h[0] * h[2] - h[1] * h[1];
        if (determinant == 0)
            return 0;
        const wide u = (h[1] * g[1] - h[2] * g[0]) / determinant, v = (h[1] * g[0] - h[0] * g[1]) / determinant;
        z[0] += u;
        z[1] += v;
        if (!(size_of(z[0]) < (wide)1e12 && size_of(z[1]) < (wide)1e12))
            return 0;
        if (size_of(u) < (wide)1e-20 && size_of(v) < (wide)1e-20)
            return 1;
    }
    return 0;
}

/* ---- the truth ---- */

double truth_between(const struct truth_surface *f, const wide p[2], const wide q[2])
{
    wide d[3], e[3], most = 0;
    truth_offset(f, p, d);
    truth_offset(f, q, e);
    for (int k = 0; k < 3; k++)
        most = size_of(d[k] - e[k]) > most ? size_of(d[k] - e[k]) : most;
    return (double)most;
}

/* Returns 1 if q is p, within the error of a root in long double. */
static int is_near(const struct truth_surface *f, const wide p[2], const wide q[2])
{
    return (size_of(p[0] - q[0]) <= (wide)SAME && size_of(p[1] - q[1]) <= (wide)SAME) || truth_between(f, p, q) <= SAME;
}

static void insert(struct truth *t, const struct truth_point *p)
{
    int k = t->count;
    if (k == TRUTH_MOST)
        return;
    for (t->count++; k > 0 && t->point[k - 1].square > p->square; k--)
        t->point[k] = t->point[k - 1];
    t->point[k] = *p;
}

void truth_add(struct truth *t, const double loc[2])
{
    struct truth_point p;
    truth_descend(&t->surface, loc, &p);
    for (int k = 0; k < t->count; k++)
        if (truth_between(&t->surface, t->point[k].z, p.z) < 1e-14)
            return;
    insert(t, &p);
}

/* Computes xi and eta of the nearest point of edge k. */
static void nearest_of_edge(const struct boxes_segment *f, int k, long double z[2])
{
    const long double side = k & 1 ? 1 : -1, *const along = k < 2 ? f->c1 : f->c2,
                      *const across = k < 2 ? f->c2 : f->c1;
    long double product = 0, square = 0;
    for (int i = 0; i < 3; i++) {
        const long double e = along[i] + side * f->c3[i];
        product += e * (f->d0[i] - side * across[i]);
        square += e * e;
    }
    const long double at = square > 0 ? product / square : 0;
    z[k >= 2] = at < -1 ? -1 : at > 1 ? 1 : at;
    z[k < 2] = side;
}

/* Computes all roots again in extended precision, because long double leaves little if the equations are nearly singular.  Returns 0
 * if a root was not confirmed. */
static int sharpen(const struct truth_surface *f, struct boxes_list *list)
{
    for (int k = 0; k < list->roots; k++) {
        long double *const root = list->root[k];
        const double loc[2] = {(double)root[0], (double)root[1]};
        const wide from[2] = {root[0], root[1]};
        wide z[2];
        if (!truth_stationary(f, loc, z) || !is_near(f, from, z))
            return 0;
        root[0] = (long double)z[0];
        root[1] = (long double)z[1];
    }
    return 1;
}

struct candidate {
    long double z[2], height;
};

static struct candidate candidate_of(const struct boxes_segment *f, long double xi, long double eta)
{
    const struct candidate c = {{(long double)clamp(xi), (long double)clamp(eta)},
                                boxes_height(f, (long double)clamp(xi), (long double)clamp(eta))};
    return c;
}

void truth_find(const struct hard_case *h, enum truth_kind kind, struct truth *t)
{
    struct boxes_list *const list = &t->list;
    struct candidate c[4 + BOXES_ROOTS + BOXES_LEAVES + 1];
    int count = 0, known;
    t->count = 0;
    t->decided = 1;
    t->contradicted = 0;
    t->all = 1;
    t->list.roots = t->list.leaves = 0;
    t->list.complete = 1;
    t->surface.distance = 0;
    if (!truth_surface_of(h, &t->surface))
        return;
    segment_of(&t->surface, &t->segment);
    const int has_area = truth_has_area(h);
    if (has_area)
        boxes_find(&t->segment, list);
    list->complete = has_area && list->complete && sharpen(&t->surface, list);
    for (; count < 4; count++) {
        long double z[2];
        nearest_of_edge(&t->segment, count, z);
        c[count] = candidate_of(&t->segment, z[0], z[1]);
    }
    for (int k = 0; k < list->roots; k++)
        c[count++] = candidate_of(&t->segment, list->root[k][0], list->root[k][1]);
    known = count;
    for (int k = 0; k < list->leaves; k++)
        c[count++] = candidate_of(&t->segment, list->leaf[k][0], list->leaf[k][1]);
    struct candidate least = c[0];
    for (int k = 1; k < count; k++)
        least = c[k].height < least.height ? c[k] : least;
    if (has_area && (!list->complete || kind == TRUTH_CHECKED)) { /* without, all points lie on the edges */
        const long double before = least.height;
        t->decided = boxes_lower(&t->segment, ENOUGH, least.z, &least.height);
        t->contradicted = list->complete && least.height < before - 2 * ENOUGH;
        c[count++] = least;
    }
    if (kind == TRUTH_NEAREST) {
        t->count = 1;
        t->point[0].z[0] = least.z[0];
        t->point[0].z[1] = least.z[1];
        t->point[0].square = truth_square(&t->surface, t->point[0].z);
        return;
    }
    const int each = 1 + list->leaves / LEAVES;
    t->all = list->complete && each == 1;
    for (int k = 0; k < count; k++)
        if (c[k].height <= least.height + NEARLY && (k < known || (k - known) % each == 0 || k == count - 1)) {
            const double loc[2] = {(double)c[k].z[0], (double)c[k].z[1]};
            truth_add(t, loc);
        }
}
