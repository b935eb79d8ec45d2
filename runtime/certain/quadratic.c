/* Finds the closest point of a face of degree 2; see quadratic.h.  Newton's method minimises half the square of the distance over
 * the square of (a,b).  Then subdivide.c proves the minimum or finds a nearer point, from which the search continues. */
#include "quadratic.h"
#include "ieee.h"

enum { STEPS = 40, HALVINGS = 30, STARTS = 50, TURNS = 3, MOST_NODES = 9 };

#define SETTLED 0x1p-46 /* smaller steps of a and b change no digit of the distance */
#define FLAT 0x1p-84    /* squares of areas below this: nodes may be on a line */
#define SHORT 1e-6      /* shorter steps do not compare distances, whose rounding may hide the gain */

/* ---- the face ---- */

/* Returns the middle control point of a parabola from its values. */
static double control(double low, double middle, double high)
{
    return 2.0 * middle - 0.5 * (low + high);
}

/* Scales to a unit in which the largest number is from 1/2 to 1.
 *  @return the largest number */
static double scale(double *x, int n, int *exponent)
{
    double most = 0.0;
    int e;
    for (int i = 0; i < n; i++)
        most = quadratic_larger(most, fabs(x[i]));
    (void)frexp(most, &e);
    *exponent += e;
    if (e < -1000) { /* the factor would overflow */
        for (int i = 0; i < n; i++)
            x[i] *= 0x1p1000;
        most *= 0x1p1000;
        e += 1000;
    }
    const double by = ldexp(1.0, -e);
    for (int i = 0; i < n; i++)
        x[i] *= by;
    return ldexp(most, -e);
}

static void square_of(int nodes, const double y[][3], struct quadratic *f)
{
    static const int node[3][3] = {{0, 7, 3}, {4, 8, 6}, {1, 5, 2}};
    for (int k = 0; k < 3; k++) {
        double z[3][3];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                z[i][j] = node[i][j] < nodes ? y[node[i][j]][k] : 0.0;
        if (nodes == 8)
            z[1][1] = 0.5 * (z[1][0] + z[2][1] + z[1][2] + z[0][1]) - 0.25 * (z[0][0] + z[2][0] + z[2][2] + z[0][2]);
        for (int j = 0; j < 3; j++)
            z[1][j] = control(z[0][j], z[1][j], z[2][j]);
        for (int i = 0; i < 3; i++) {
            f->net[3 * i][k] = z[i][0];
            f->net[3 * i + 1][k] = control(z[i][0], z[i][1], z[i][2]);
            f->net[3 * i + 2][k] = z[i][2];
        }
    }
}

/* Turns a triangle so that corner `first` becomes A. */
static void triangle_of(const double y[][3], int first, struct quadratic *f)
{
    const double *const A = y[first], *const B = y[(first + 1) % 3], *const C = y[(first + 2) % 3];
    for (int k = 0; k < 3; k++) {
        const double ab = control(A[k], y[3 + first][k], B[k]);
        const double bc = control(B[k], y[3 + (first + 1) % 3][k], C[k]);
        const double ca = control(C[k], y[3 + (first + 2) % 3][k], A[k]);
        const double mixed = A[k] - ab - ca + bc; /* half the factor of u v */
        f->net[0][k] = A[k];
        f->net[3][k] = ab;
        f->net[6][k] = B[k];
        f->net[1][k] = ca;
        f->net[2][k] = C[k];
        f->net[4][k] = ab + ca - A[k] + 0.5 * mixed;
        f->net[7][k] = B[k] + (ca - A[k]) + mixed;
        f->net[5][k] = C[k] + (ab - A[k]) + mixed;
        f->net[8][k] = B[k] + C[k] - A[k] + 2.0 * mixed;
    }
}

/* Computes a face from nodes y, whose largest component is `span`. */
static void face_of(int nodes, const double y[][3], double span, int first, int exponent, struct quadratic *f)
{
    f->triangle = nodes == 6;
    f->exponent = exponent;
    if (f->triangle)
        triangle_of(y, first, f);
    else
        square_of(nodes, y, f);
    (void)scale(f->net[0], 27, &f->exponent);
    f->tolerance = QUADRATIC_TOLERANCE * ldexp(span, exponent - f->exponent);
    f->extent[0] = f->extent[1] = 0.0;
    for (int i = 0; i < 6; i++)
        for (int k = 0; k < 3; k++) {
            const double *const p = f->net[i], *const q = f->net[i + i / 2];
            f->extent[0] = quadratic_larger(f->extent[0], fabs(p[9 + k] - p[k]));
            f->extent[1] = quadratic_larger(f->extent[1], fabs(q[3 + k] - q[k]));
        }
}

/* Computes x - xS in a unit in which the largest component is about 1, and that unit. */
static int differences_of(int nodes, const double *x, double y[][3], double *span, int *exponent)
{
    const double *const xS = x + 3 * nodes;
    double sum = 0.0, most = 0.0;
    for (int i = 0; i < 3 * nodes + 3; i++) {
        sum += 0.0 * x[i];
        most = quadratic_larger(most, fabs(x[i]));
    }
    if (!(sum == 0.0))
        return FOOTPOINT_ERR_NOT_FINITE;
    const double by = most > 0x1p1000 ? 0x1p-10 : 1.0; /* differences may overflow */
    for (int i = 0; i < 3 * nodes; i++)
        y[i / 3][i % 3] = by * x[i] - by * xS[i % 3];
    *exponent = by < 1.0 ? 10 : 0;
    *span = scale(y[0], 3 * nodes, exponent);
    return FOOTPOINT_OK;
}

static int all_on_a_line(const struct quadratic *f)
{
    double along[3] = {0.0, 0.0, 0.0}, most = 0.0;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 1; i < 9; i++) {
            double way[3], n[3];
            vector_sub(f->net[i], f->net[0], way);
            vector_cross(way, along, n);
            const double square = vector_dot(way, way);
            if (pass == 0 && square > most) {
                most = square;
                vector_sub(f->net[i], f->net[0], along);
            }
            if (pass == 1 && vector_dot(n, n) > FLAT * most * most)
                return 0;
        }
    return 1;
}

/* ---- a local minimum ---- */

/* Returns a parabola's value at t. */
static inline double value_at(double low, double middle, double high, double t)
{
    const double first = middle - low, second = high - middle;
    return low + t * (first + (first + t * (second - first)));
}

/* Expands a parabola around t by differences, which are exact on slim faces. */
static inline void expand(double low, double middle, double high, double t, double c[3])
{
    const double first = middle - low, second = high - middle, slope = first + t * (second - first);
    c[0] = low + t * (first + slope);
    c[1] = 2.0 * slope;
    c[2] = second - first;
}

/* Computes mixed coefficients from the shorter differences. */
void footpoint_quadratic_taylor(const struct quadratic *f, double u, double v, struct quadratic_taylor *t)
{
    const int wide = f->extent[1] > f->extent[0], step = wide ? 1 : 3, next = 4 - step;
    const double at = wide ? v : u, other = wide ? u : v;
    for (int k = 0; k < 3; k++) {
        double row[3][3], c[3];
        for (int i = 0; i < 3; i++)
            expand(f->net[i * next][k], f->net[i * next + step][k], f->net[i * next + 2 * step][k], at, row[i]);
        for (int m = 0; m < 3; m++)
            (wide ? t->c[0][m] : t->c[m][0])[k] = value_at(row[0][m], row[1][m], row[2][m], other);
        for (int i = 0; i < 3; i++)
            expand(f->net[i * step][k], f->net[i * step + next][k], f->net[i * step + 2 * next][k], other, row[i]);
        for (int m = 1; m < 3; m++) {
            expand(row[0][m], row[1][m], row[2][m], at, c);
            for (int n = 0; n < 3; n++)
                (wide ? t->c[m][n] : t->c[n][m])[k] = c[n];
        }
    }
}

static void taylor_at(const struct quadratic *f, const double at[2], struct quadratic_taylor *t)
{
    footpoint_quadratic_taylor(f, quadratic_u(f, at), at[1], t);
}

/* Gradient and Hessian of half the square of the distance, by a and b, and by y and b, with a = y + skew b + bow b^2 from here, or
 * y and a likewise, so that r_b and r_bb have no part along r_y.  On slim faces, only the latter show the minimum. */
struct slopes {
    double g[2], h11, h12, h22, gauss[2]; /* gauss: replaces h11 and h22 if they are not positive */
    double skew, bow, g_skew, h_along, h_mixed, h_skew, det;
    int along; /* 0: a begins with y, 1: b begins with y */
};

/* r_a, r_b, r_aa, r_ab, r_bb */
struct curve {
    double a[3], b[3], aa[3], ab[3], bb[3];
};

static void curve_of(const struct quadratic *f, const double at[2], const struct quadratic_taylor *t, struct curve *c)
{
    const double by = f->triangle ? 1.0 - at[1] : 1.0, to = f->triangle ? at[0] : 0.0; /* u_a, -u_b */
    for (int k = 0; k < 3; k++) {
        const double u = t->c[1][0][k], v = t->c[0][1][k], uu = 2.0 * t->c[2][0][k], uv = t->c[1][1][k],
                     vv = 2.0 * t->c[0][2][k];
        c->a[k] = by * u;
        c->b[k] = v - to * u;
        c->aa[k] = by * by * uu;
        c->ab[k] = by * (uv - to * uu) - (f->triangle ? u : 0.0);
        c->bb[k] = vv - to * (2.0 * uv - to * uu);
    }
}

static void slopes_of(const struct quadratic *f, const double at[2], const struct quadratic_taylor *t, struct slopes *m)
{
    struct curve c;
    curve_of(f, at, t, &c);
    const double *const r = t->c[0][0], aa = vector_dot(c.a, c.a), bb = vector_dot(c.b, c.b), ab = vector_dot(c.a, c.b);
    m->g[0] = vector_dot(r, c.a);
    m->g[1] = vector_dot(r, c.b);
    m->h11 = aa + vector_dot(r, c.aa);
    m->h12 = ab + vector_dot(r, c.ab);
    m->h22 = bb + vector_dot(r, c.bb);
    m->gauss[0] = aa;
    m->gauss[1] = bb;
    m->along = bb > aa;
    m->skew = aa + bb > 0.0 ? -ab / quadratic_larger(aa, bb) : 0.0;
    const double *const way = m->along ? c.b : c.a, *const other = m->along ? c.a : c.b;
    const double *const bend = m->along ? c.bb : c.aa, *const bend_other = m->along ? c.aa : c.bb;
    double across[3], mixed[3], bend_across[3];
    for (int k = 0; k < 3; k++) {
        across[k] = other[k] + m->skew * way[k];
        mixed[k] = c.ab[k] + m->skew * bend[k];
        bend_across[k] = bend_other[k] + m->skew * (c.ab[k] + mixed[k]);
    }
    m->g_skew = vector_dot(r, across);
    m->h_along = m->along ? m->h22 : m->h11;
    m->h_mixed = vector_dot(way, across) + vector_dot(r, mixed);
    m->bow = aa + bb > 0.0 ? -0.5 * vector_dot(way, bend_across) / quadratic_larger(aa, bb) : 0.0;
    m->h_skew = vector_dot(across, across) + vector_dot(r, bend_across) + 2.0 * m->bow * m->g[m->along];
    m->det = m->h_along * m->h_skew - m->h_mixed * m->h_mixed;
    if (m->h_along > 0.0 && m->det > 0x1p-40 * m->h_along * m->h_skew)
        return;
    m->h_along = m->gauss[m->along]; /* the Gauss-Newton value, whose mixed part is 0 */
    m->h_skew = vector_dot(across, across);
    m->h_mixed = 0.0;
    m->det = m->h_along * m->h_skew;
}

static double clamp(double x)
{
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}

/* Returns the step s to the minimum of slope s + bend s^2/2 with at + s from 0 to 1. */
static double least_of(double at, double slope, double bend, double gauss)
{
    const double by = bend > 0.0 ? bend : gauss;
    return by > 0.0 ? clamp(at - slope / by) : at;
}

/* Returns the x nearest to 0 at which skew x + bow x^2 = to, or 0 if there is no such x. */
static double where_bent(double skew, double bow, double to)
{
    const double square = skew * skew + 4.0 * bow * to;
    const double below = square > 0.0 ? skew + copysign(sqrt(square), skew) : 0.0;
    return below != 0.0 ? 2.0 * to / below : 0.0;
}

/* Computes the end `to` of a step; a coordinate that is not moved keeps its value in `at`.  The first part of the step follows the
 * parabola at + s (to - at - bow) + s^2 bow, s from 0 to 1. */
static void step_from(const struct slopes *m, const double at[2], double to[2], double bow[2])
{
    const double *const g = m->g;
    const int held[2] = {(at[0] <= 0.0 && g[0] >= 0.0) || (at[0] >= 1.0 && g[0] <= 0.0),
                         (at[1] <= 0.0 && g[1] >= 0.0) || (at[1] >= 1.0 && g[1] <= 0.0)};
    to[0] = held[0] ? at[0] : least_of(at[0], g[0], m->h11, m->gauss[0]);
    to[1] = held[1] ? at[1] : least_of(at[1], g[1], m->h22, m->gauss[1]);
    bow[0] = bow[1] = 0.0;
    const int way = m->along, other = !way;
    if (held[0] || held[1])
        return;
    if (!(m->det > 0.0)) {
        to[other] = at[other];
        return;
    }
    to[other] = clamp(at[other] + (m->h_mixed * g[way] - m->h_along * m->g_skew) / m->det);
    double across = to[other] - at[other];
    const double y = -(g[way] + m->h_mixed * across) / m->h_along;
    const double along = at[way] + y + (m->skew + m->bow * across) * across;
    to[way] = clamp(along);
    if (to[way] != along) {
        const double bent = where_bent(m->skew, m->bow, to[way] - at[way] - y);
        const double part = across != 0.0 ? bent / across : 0.0;
        if (!(part > 0.0 && part < 1.0)) {
            to[other] =
                least_of(at[other], g[other] + m->h12 * (to[way] - at[way]), way ? m->h11 : m->h22, m->gauss[other]);
            return;
        }
        across *= part;
        to[other] = at[other] + across;
    }
    bow[way] = m->bow * across * across;
}

/* Moves `at` to a local minimum, to rounding; t is the expansion there. */
static void descend(const struct quadratic *f, double at[2], struct quadratic_taylor *t)
{
    double last = 1.0;
    taylor_at(f, at, t);
    for (int n = 0; n < STEPS; n++) {
        struct slopes m;
        struct quadratic_taylor there;
        double to[2], bow[2];
        slopes_of(f, at, t, &m);
        step_from(&m, at, to, bow);
        const double move = quadratic_larger(fabs(to[0] - at[0]), fabs(to[1] - at[1]));
        if (move < SETTLED || (move < SHORT && move > 0.5 * last))
            return;
        last = move;
        taylor_at(f, to, &there);
        const double here = vector_dot(t->c[0][0], t->c[0][0]);
        for (int k = 0; move > SHORT && !(vector_dot(there.c[0][0], there.c[0][0]) < here); k++) {
            if (k == HALVINGS)
                return;
            for (int i = 0; i < 2; i++) {
                bow[i] *= 0.25;
                to[i] = clamp(0.5 * (at[i] + to[i]) - bow[i]);
            }
            taylor_at(f, to, &there);
        }
        at[0] = to[0];
        at[1] = to[1];
        *t = there;
    }
}

/* ---- the closest point ---- */

/* Computes r_u x r_v an eighth of the way to the middle, where collapsed corners have a normal, too. */
static void normal_beside(const struct quadratic *f, const double at[2], double n[3])
{
    const double middle = f->triangle ? 1.0 / 3.0 : 0.5, u = quadratic_u(f, at), v = at[1];
    struct quadratic_taylor t;
    footpoint_quadratic_taylor(f, u + 0.125 * (middle - u), v + 0.125 * (middle - v), &t);
    vector_cross(t.c[1][0], t.c[0][1], n);
}

/* Computes (xi,eta) from a place of the face that begins at a corner `first`. */
static void write_place(const struct quadratic *f, int first, const double at[2], double loc[2])
{
    const double part[3] = {(1.0 - at[0]) * (1.0 - at[1]), at[0] * (1.0 - at[1]), at[1]};
    loc[0] = f->triangle ? part[(4 - first) % 3] : 2.0 * at[0] - 1.0;
    loc[1] = f->triangle ? part[(5 - first) % 3] : 2.0 * at[1] - 1.0;
}

/* Clamps to [0,1], and to an end of it if rounding may have led away from that end. */
static double end_or_inside(double x)
{
    return x < SETTLED ? 0.0 : x > 1.0 - SETTLED ? 1.0 : x;
}

/* Computes (a,b) of a place of the face.  Returns the corner at which they begin. */
static int place_of(int triangle, const double loc[2], double at[2])
{
    if (!triangle) {
        at[0] = end_or_inside(0.5 * (1.0 + loc[0]));
        at[1] = end_or_inside(0.5 * (1.0 + loc[1]));
        return 0;
    }
    const double part[3] = {1.0 - loc[0] - loc[1], loc[0], loc[1]};
    const int first = part[1] > part[0] ? 1 + (part[2] > part[1]) : 2 * (part[2] > part[0]);
    at[1] = end_or_inside(part[(first + 2) % 3]);
    at[0] = at[1] < 1.0 ? end_or_inside(part[(first + 1) % 3] / (1.0 - at[1])) : 0.0;
    return first;
}

int footpoint_quadratic_closest(int nodes, const double *x, const double start[2], double loc[2], double *distance,
                                int *boxes)
{
    struct quadratic f;
    struct quadratic_taylor t;
    double y[MOST_NODES][3], span, at[2], place[2] = {start[0], start[1]};
    int exponent, status = FOOTPOINT_UNPROVED;
    const int triangle = nodes == 6, wrong = differences_of(nodes, x, y, &span, &exponent);
    if (wrong)
        return wrong;
    for (int starts = 0, turns = 0;; turns++) {
        double nearer[2];
        const int first = place_of(triangle, place, at);
        face_of(nodes, (const double(*)[3])y, span, first, exponent, &f);
        descend(&f, at, &t);
        write_place(&f, first, at, place);
        if (triangle && turns < TURNS && (1.0 - at[0]) * (1.0 - at[1]) < 0.25)
            continue;
        const enum quadratic_proof proof = footpoint_quadratic_prove(&f, at, &t, boxes, nearer);
        if (proof == QUADRATIC_NEARER && starts++ < STARTS) {
            write_place(&f, first, nearer, place);
            turns = -1;
            continue;
        }
        if (proof == QUADRATIC_PROVED)
            status = FOOTPOINT_OK;
        else if (proof == QUADRATIC_TIED)
            status = FOOTPOINT_NOT_UNIQUE;
        break;
    }
    const double *const r = t.c[0][0], length = ldexp(sqrt(vector_dot(r, r)), f.exponent);
    if (!isfinite(length))
        return FOOTPOINT_ERR_DOMAIN;
    double n[3];
    normal_beside(&f, at, n);
    const int on_a_line = !(vector_dot(n, n) > FLAT) && all_on_a_line(&f);
    loc[0] = place[0];
    loc[1] = place[1];
    *distance = length;
    return on_a_line && status != FOOTPOINT_UNPROVED ? FOOTPOINT_NO_AREA : status;
}
