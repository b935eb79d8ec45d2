/* Truth by brute force; see truth.h.  For each of many lines eta = const the nearest point of -1 <= xi <= 1 is known in
 * closed form; where a line is nearer than its neighbours, a golden section narrows eta down; the same with xi and eta
 * exchanged.  From there a projected Newton iteration in extended precision. */
#include "truth.h"

#include <math.h>
#include <string.h>

enum { LINES = 160, SECTIONS = 45, NEWTON_STEPS = 60 };

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
    wide scale = 1;
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
    f->distance = sqrt((double)dot(f->d0, f->d0));
    return 1;
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

/* Gradient and Hessian of half the square. */
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
    wide h[3];
    expand(f, z, g, h);
}

static wide clamp(wide x)
{
    return x < -1 ? -1 : x > 1 ? 1 : x;
}

/* Newton's step in the directions that are free, downhill. */
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

int truth_stationary(const struct truth_surface *f, const double loc[2], wide z[2])
{
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

/* ---- sampling ---- */

/* c1, c2 exchanged or not, in the machine's longest quick format. */
struct lines {
    long double along[3], across[3], twist[3], d0[3];
};

static long double line_square(const struct lines *l, long double t, long double *s)
{
    long double a[3], e[3], aa = 0, ae = 0, square = 0;
    for (int k = 0; k < 3; k++) {
        a[k] = l->along[k] + t * l->twist[k];
        e[k] = l->d0[k] - t * l->across[k];
        aa += a[k] * a[k];
        ae += a[k] * e[k];
    }
    *s = aa > 0 ? ae / aa : 0;
    *s = *s < -1 ? -1 : *s > 1 ? 1 : *s;
    for (int k = 0; k < 3; k++) {
        const long double d = e[k] - *s * a[k];
        square += d * d;
    }
    return square;
}

static long double narrow(const struct lines *l, long double low, long double high)
{
    const long double golden = 0.61803398874989484820L;
    long double s, x = high - golden * (high - low), y = low + golden * (high - low);
    long double fx = line_square(l, x, &s), fy = line_square(l, y, &s);
    for (int n = 0; n < SECTIONS; n++) {
        if (fx <= fy) {
            high = y;
            y = x;
            fy = fx;
            x = high - golden * (high - low);
            fx = line_square(l, x, &s);
        } else {
            low = x;
            x = y;
            fx = fy;
            y = low + golden * (high - low);
            fy = line_square(l, y, &s);
        }
    }
    return (low + high) / 2;
}

static void add(struct truth *t, wide xi, wide eta)
{
    struct truth_point p;
    p.z[0] = clamp(xi);
    p.z[1] = clamp(eta);
    descend(&t->surface, &p);
    for (int k = 0; k < t->count; k++)
        if (size_of(t->point[k].z[0] - p.z[0]) < (wide)1e-14 && size_of(t->point[k].z[1] - p.z[1]) < (wide)1e-14)
            return;
    if (t->count == TRUTH_MOST)
        return;
    int k = t->count++;
    for (; k > 0 && t->point[k - 1].square > p.square; k--)
        t->point[k] = t->point[k - 1];
    t->point[k] = p;
}

/* Where the distance is flat in one direction, the sampling may have taken several minima for one: from points of that
 * direction, too. */
static void look_along(struct truth *t)
{
    const int count = t->count;
    for (int k = 0; k < count; k++) {
        const struct truth_point p = t->point[k];
        wide g[2], h[3];
        if (p.least > 0.01)
            continue;
        expand(&t->surface, p.z, g, h);
        const wide size = size_of(h[0]) + size_of(h[1]);
        for (wide step = (wide)0.1; step > (wide)1e-7; step /= 4)
            for (int side = -1; side <= 1; side += 2)
                add(t, p.z[0] - side * step * h[1] / size, p.z[1] + side * step * h[0] / size);
    }
}

void truth_find(const struct hard_case *h, struct truth *t)
{
    t->count = 0;
    if (!truth_surface_of(h, &t->surface))
        return;
    for (int exchanged = 0; exchanged < 2; exchanged++) {
        struct lines l;
        long double square[LINES + 1], s;
        for (int k = 0; k < 3; k++) {
            l.along[k] = (long double)(exchanged ? t->surface.c2[k] : t->surface.c1[k]);
            l.across[k] = (long double)(exchanged ? t->surface.c1[k] : t->surface.c2[k]);
            l.twist[k] = (long double)t->surface.c3[k];
            l.d0[k] = (long double)t->surface.d0[k];
        }
        for (int i = 0; i <= LINES; i++)
            square[i] = line_square(&l, 2.0L * i / LINES - 1, &s);
        for (int i = 0; i <= LINES; i++) {
            if ((i > 0 && square[i - 1] < square[i]) || (i < LINES && square[i + 1] < square[i]))
                continue;
            const long double low = i > 0 ? 2.0L * (i - 1) / LINES - 1 : -1,
                              high = i < LINES ? 2.0L * (i + 1) / LINES - 1 : 1;
            const long double line = narrow(&l, low, high);
            (void)line_square(&l, line, &s);
            add(t, exchanged ? line : s, exchanged ? s : line);
        }
    }
    look_along(t);
}
