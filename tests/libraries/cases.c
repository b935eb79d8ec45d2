/* Families of cases; see cases.h. Four-node faces are those of tests/hard; curved faces have moved edges and
 * middles. */
#include "cases.h"

#include "../hard/draw.h"
#include "../hard/hard.h"
#include "face.h"

#include <math.h>
#include <string.h>

enum { SEED = 25 };

#define ALL ((1u << LIBRARY_KINDS) - 1)
#define QUADS (ALL & ~(1u << LIBRARY_TRI6))
#define FOUR (1u << LIBRARY_QUAD4)

const struct library_family library_families[] = {
    {"on", "ordinary faces, the slave node lies on the face", NULL, ALL, 1},
    {"ordinary", "what meshes hold, foot point inside, gap to a tenth of an edge", "ordinary", ALL, 0},
    {"warp", "warp, curvature and gap up to the edge", "warp", ALL, 0},
    {"outside", "ordinary faces, slave nodes all around, most of them beside", "around", ALL, 0},
    {"far", "5 to 50 edges away", "far", ALL, 0},
    {"focal", "gap near 1/curvature, where one closest point becomes several", "focal", ALL, 0},
    {"collapsed", "an edge of no length", "collapsed", QUADS, 0},
    {"folded", "not convex, or crossing itself", "folded", FOUR, 0},
    {"plane", "plane faces, slave nodes all around", "plane", FOUR, 0},
    {"flat", "nearly plane, of any shape, folded, too", "flat", FOUR, 0},
};

const int library_family_count = sizeof library_families / sizeof *library_families;

/* Displacement of edges and middles, in edges; range of xi and eta; gap. */
struct curved {
    double moved, range, gap;
};

static struct curved curved_of(const char *name)
{
    const struct curved ordinary = {0.05, 0.99, 0.1}, on = {0.05, 0.99, 0}, warp = {0.2, 0.99, 1},
                        outside = {0.05, 3, 1}, focal = {0.15, 0.99, 0}, collapsed = {0.05, 0.99, 0.3};
    return strcmp(name, "on") == 0          ? on
           : strcmp(name, "warp") == 0      ? warp
           : strcmp(name, "outside") == 0   ? outside
           : strcmp(name, "focal") == 0     ? focal
           : strcmp(name, "collapsed") == 0 ? collapsed
                                            : ordinary;
}

/* Makes a curved face from corners A to D (a triangle omits one), mid-sides and centre. */
static void curve(uint64_t *s, int kind, const struct hard_case *h, double moved, struct library_case *c)
{
    const int corners = kind == LIBRARY_TRI6 ? 3 : 4;
    double size = 0;
    for (int k = 0; k < 3; k++)
        size += (h->x[1][k] - h->x[0][k]) * (h->x[1][k] - h->x[0][k]) / 3;
    size = sqrt(size);
    memcpy(c->x, h->x, (size_t)corners * sizeof *c->x);
    for (int i = 0; i < corners; i++) {
        const double *const a = h->x[i], *const b = h->x[(i + 1) % corners];
        const int length = memcmp(a, b, 3 * sizeof *a) != 0;
        for (int k = 0; k < 3; k++)
            c->x[corners + i][k] = 0.5 * (a[k] + b[k]) + length * size * draw_flat(s, -moved, moved);
    }
    if (kind == LIBRARY_QUAD9)
        for (int k = 0; k < 3; k++) {
            double corner = 0, middle = 0;
            for (int i = 0; i < 4; i++) {
                corner += c->x[i][k];
                middle += c->x[4 + i][k];
            }
            c->x[8][k] = 0.5 * middle - 0.25 * corner + size * draw_flat(s, -moved, moved);
        }
}

/* Computes position, tangents and unit normal in double; returns 0 if there is no normal. */
static int frame_at(const struct face *f, const double loc[2], double r[3], double u[3], double v[3], double n[3])
{
    const wide z[2] = {loc[0], loc[1]};
    wide p[3], a[3], b[3];
    face_jet(f, z, p, a, b);
    for (int k = 0; k < 3; k++) {
        r[k] = (double)p[k];
        u[k] = (double)a[k];
        v[k] = (double)b[k];
    }
    draw_cross(u, v, n);
    const double area = sqrt(draw_dot(n, n));
    for (int k = 0; k < 3; k++)
        n[k] /= area;
    return area > 0;
}

/* Returns a gap at which the Hessian of the distance is nearly singular: 1 / curvature along a random direction. */
static double focal_gap(uint64_t *s, const struct face *f, const double loc[2])
{
    const double h = 1e-4, t = draw_flat(s, 0, 3.141592653589793), d[2] = {cos(t), sin(t)};
    double r[3][3], u[3], v[3], n[3], bend = 0, length = 0;
    for (int i = 0; i < 3; i++) {
        const double at[2] = {loc[0] + (i - 1) * h * d[0], loc[1] + (i - 1) * h * d[1]};
        double unused[3];
        (void)frame_at(f, at, r[i], u, v, i == 1 ? n : unused);
    }
    for (int k = 0; k < 3; k++) {
        bend += n[k] * (r[0][k] - 2 * r[1][k] + r[2][k]);
        length += (r[2][k] - r[0][k]) * (r[2][k] - r[0][k]) / 4;
    }
    const double gap = length / bend;
    return fabs(gap) < 100 * f->edge ? gap * (1 + draw_sign(s) * draw_power(s, -6, -1)) : f->edge;
}

static void place(uint64_t *s, int kind, const char *family, struct curved how, struct library_case *c)
{
    struct face f;
    double loc[2], r[3], u[3], v[3], n[3], d[3];
    face_of(kind, c->x[0], &f);
    if (strcmp(family, "far") == 0) {
        draw_direction(s, d);
        for (int k = 0; k < 3; k++)
            c->xs[k] = c->x[0][k] + draw_flat(s, 5, 50) * f.edge * d[k];
        return;
    }
    do {
        if (kind == LIBRARY_TRI6) {
            const double out = (how.range - 0.99) / 2;
            loc[0] = draw_flat(s, -out, 0.99 + out);
            loc[1] = draw_flat(s, -out, 0.99 + out);
            if (loc[0] + loc[1] > 0.99 + out)
                continue;
        } else {
            loc[0] = draw_flat(s, -how.range, how.range);
            loc[1] = draw_flat(s, -how.range, how.range);
        }
        if (frame_at(&f, loc, r, u, v, n))
            break;
    } while (1);
    const double gap = strcmp(family, "focal") == 0 ? focal_gap(s, &f, loc) : f.edge * draw_flat(s, -how.gap, how.gap);
    for (int k = 0; k < 3; k++)
        c->xs[k] = r[k] + gap * n[k];
}

static int hard_family_of(const char *name)
{
    for (int i = 0; i < hard_family_count; i++)
        if (strcmp(hard_families[i].name, name) == 0)
            return i;
    return 0;
}

void library_draw(int family, int kind, unsigned long index, struct library_case *c)
{
    const struct library_family *const f = &library_families[family];
    struct hard_case h;
    hard_draw(hard_family_of(f->hard ? f->hard : "ordinary"), SEED, index, &h);
    if (kind == LIBRARY_QUAD4 && f->hard) {
        memcpy(c->x, h.x, 4 * sizeof *h.x);
        memcpy(c->xs, h.x[4], sizeof c->xs);
        return;
    }
    uint64_t stream = 1000 * index + 10 * (unsigned long)family + (unsigned long)kind;
    if (kind == LIBRARY_QUAD4)
        memcpy(c->x, h.x, 4 * sizeof *h.x);
    else
        curve(&stream, kind, &h, curved_of(f->name).moved, c);
    place(&stream, kind, f->name, curved_of(f->name), c);
}
