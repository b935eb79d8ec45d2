/* Whether a local minimum of the distance to a quadratic face is the least: by subdivision with bounds.
 *
 * About the minimum, with y = r - r(loc), g = r(loc) - xS and a point (s,t) further,
 *     |r - xS|^2 - |g|^2 = |y|^2 + 2 g . y,
 *     y = r_u s + r_v t + r_uu s^2/2 + r_uv s t + r_vv t^2/2 + k6 s^2 t + k7 s t^2,
 * where g . (r_u s + r_v t) >= 0 in the face.  If |s| <= S and |t| <= T, all of y beyond r_u s + r_v t is at most
 * A |s| + B |t| long, and -2 g . y is at most M s^2 + 2 N |s t| + O t^2 <= ((M + N) s^2 + (O + N) t^2).  So no point of
 * such a box is nearer if
 *     |r_u s + r_v t| >= a |s| + b |t|,   a = A + sqrt(M + N),   b = B + sqrt(O + N),
 * a question of two definite forms.  On an ordinary face that settles it for the whole of it.
 *
 * Elsewhere boxes are halved.  A box is dropped if it is settled as above, or if all of it, as far as it belongs to the
 * face, lies farther from xS than the minimum, seen along the direction of its middle. */
#include "attach_curved.h"

#include <float.h>

enum { DEPTH = 160, MOST_BOXES = 20000 };

#define NEARER 1e-10 /* over the face's size: what is nearer by less is not looked for */
#define ROUNDING (64.0 * DBL_EPSILON)

struct derivatives {
    double r[3], u[3], v[3], uu[3], uv[3], vv[3]; /* r - xS, r_u, r_v, ... */
};

struct box {
    double middle[2], half[2];
};

static void derive(const struct curved *f, const double loc[2], struct derivatives *d)
{
    const double u = loc[0], v = loc[1];
    curved_away(f, loc, d->r);
    for (int i = 0; i < 3; i++) {
        const double uu = f->k[3][i] + v * f->k[6][i], vv = f->k[5][i] + u * f->k[7][i];
        d->u[i] = f->k[1][i] + v * (f->k[4][i] + v * f->k[7][i]) + 2.0 * u * uu;
        d->v[i] = f->k[2][i] + u * (f->k[4][i] + u * f->k[6][i]) + 2.0 * v * vv;
        d->uu[i] = 2.0 * uu;
        d->uv[i] = f->k[4][i] + 2.0 * (u * f->k[6][i] + v * f->k[7][i]);
        d->vv[i] = 2.0 * vv;
    }
}

static double length(const double a[3])
{
    return sqrt(vector_dot(a, a));
}

/* What is negative of a . b, as a positive number. */
static double against(const double a[3], const double b[3])
{
    const double product = vector_dot(a, b);
    return product < 0.0 ? -product : 0.0;
}

/* What the test needs of the minimum: sizes of the second and third derivatives, and how far they lead to xS. */
struct minimum {
    double loc[2], aa, ab, bb;
    double uu, uv, vv, k6, k7;
    double to_uu, to_uv, to_vv, to_k6, to_k7;
    double distance;
};

static void describe(const struct curved *f, const double loc[2], struct minimum *m)
{
    struct derivatives d;
    derive(f, loc, &d);
    m->loc[0] = loc[0], m->loc[1] = loc[1];
    m->aa = vector_dot(d.u, d.u), m->ab = vector_dot(d.u, d.v), m->bb = vector_dot(d.v, d.v);
    m->uu = length(d.uu), m->uv = length(d.uv), m->vv = length(d.vv);
    m->k6 = length(f->k[6]), m->k7 = length(f->k[7]);
    m->to_uu = against(d.r, d.uu), m->to_vv = against(d.r, d.vv), m->to_uv = fabs(vector_dot(d.r, d.uv));
    m->to_k6 = fabs(vector_dot(d.r, f->k[6])), m->to_k7 = fabs(vector_dot(d.r, f->k[7]));
    m->distance = length(d.r);
}

static int is_settled(const struct minimum *m, double most_s, double most_t)
{
    const double mixed = 0.5 * (m->uv + m->k6 * most_s + m->k7 * most_t);
    const double bend_u = 0.5 * m->uu * most_s + mixed * most_t, bend_v = 0.5 * m->vv * most_t + mixed * most_s;
    const double n = m->to_uv;
    const double a = bend_u + sqrt(m->to_uu + 2.0 * m->to_k6 * most_t + n);
    const double b = bend_v + sqrt(m->to_vv + 2.0 * m->to_k7 * most_s + n);
    const double rounding = ROUNDING * (m->aa + m->bb);
    const double h11 = m->aa - a * a - rounding, h22 = m->bb - b * b - rounding, h12 = fabs(m->ab) + a * b + rounding;
    return h11 > 0.0 && h22 > 0.0 && h11 * h22 > h12 * h12;
}

/* The least of a p + b q where |p| <= most[0], |q| <= most[1] and p + q <= room: at a corner of the box, or at an end of
 * the line that cuts it off. */
static double least_linear(double a, double b, const double most[2], double room)
{
    const double p = a > 0.0 ? -most[0] : most[0], q = b > 0.0 ? -most[1] : most[1];
    if (p + q <= room)
        return a * p + b * q;
    const double low = fmax(-most[0], room - most[1]), high = fmin(most[0], room + most[1]);
    return b * room + (a - b) * (a > b ? low : high);
}

/* No point of the box, as far as it belongs to the face, is nearer to xS than that. */
static double least_distance(const struct curved *f, int corners, const struct box *box, const struct derivatives *d)
{
    const double p = box->half[0], q = box->half[1], size = length(d->r);
    const double room = corners == 3 ? 1.0 - box->middle[0] - box->middle[1] : HUGE_VAL;
    double n[3];
    if (!(size > 0.0))
        return 0.0;
    for (int i = 0; i < 3; i++)
        n[i] = d->r[i] / size;
    return size + least_linear(vector_dot(n, d->u), vector_dot(n, d->v), box->half, room) -
           0.5 * p * p * against(n, d->uu) - p * q * fabs(vector_dot(n, d->uv)) - 0.5 * q * q * against(n, d->vv) -
           p * q * (p * fabs(vector_dot(n, f->k[6])) + q * fabs(vector_dot(n, f->k[7])));
}

/* Halves the side that is longer in space; the other half is the return value. */
static struct box halve(struct box *box, const struct derivatives *d)
{
    const double p = box->half[0], q = box->half[1];
    const int k = p * (length(d->u) + p * length(d->uu)) < q * (length(d->v) + q * length(d->vv));
    struct box other = *box;
    other.half[k] = box->half[k] *= 0.5;
    other.middle[k] += other.half[k];
    box->middle[k] -= box->half[k];
    return other;
}

/* Whether the middle of a box, or the point of a triangle beside it, is nearer than that. */
static int is_start(const struct curved *f, int corners, const double at[2], double distance, double start[2])
{
    const double beyond = corners == 3 && at[0] + at[1] > 1.0 ? 0.5 * (at[0] + at[1] - 1.0) : 0.0;
    const double loc[2] = {at[0] - beyond, at[1] - beyond};
    double r[3];
    curved_away(f, loc, r);
    if (!(length(r) < distance))
        return 0;
    start[0] = loc[0];
    start[1] = loc[1];
    return 1;
}

int footpoint_attach_nearer(const struct curved *f, int corners, const double loc[2], double start[2])
{
    struct box stack[DEPTH + 1] = {{{0.0, 0.0}, {1.0, 1.0}}};
    struct minimum m;
    double size = 0.0;
    describe(f, loc, &m);
    if (corners == 3 ? is_settled(&m, loc[0] > 0.5 ? loc[0] : 1.0 - loc[0], loc[1] > 0.5 ? loc[1] : 1.0 - loc[1])
                     : is_settled(&m, 1.0 + fabs(loc[0]), 1.0 + fabs(loc[1])))
        return 0;
    for (int k = 1; k < CURVED_TERMS; k++)
        size += length(f->k[k]);
    if (corners == 3)
        stack[0] = (struct box){{0.5, 0.5}, {0.5, 0.5}};
    for (int top = 0, boxes = 0; top >= 0 && boxes < MOST_BOXES; boxes++) {
        struct box *const box = &stack[top--];
        struct derivatives d;
        const double *const at = box->middle, *const half = box->half;
        if (corners == 3 && at[0] - half[0] + at[1] - half[1] > 1.0)
            continue;
        derive(f, at, &d);
        if (is_start(f, corners, at, m.distance - NEARER * size, start))
            return 1;
        const double far = least_distance(f, corners, box, &d);
        if (!(far < m.distance - NEARER * size) ||
            is_settled(&m, fabs(at[0] - loc[0]) + half[0], fabs(at[1] - loc[1]) + half[1]) || top + 2 > DEPTH)
            continue;
        stack[top + 2] = halve(box, &d);
        top += 2;
    }
    return 0;
}
