/* The closest point of a face of degree 2; see quadratic.h: Newton's method for half the square of the distance over the
 * square of (a,b), then the proof of subdivide.c, which may know of a point that is nearer, and so on from there. */
#include "quadratic.h"
#include "ieee.h"

enum { STEPS = 40, HALVINGS = 30, STARTS = 50, TURNS = 3, MOST_BOXES = 20000, MOST_NODES = 9 };

#define SETTLED 0x1p-46 /* of a and b: steps below change no digit of the distance */
#define FLAT 0x1p-84    /* squares of areas below: nodes may be on a line */
#define SHORT 1e-6      /* steps that need no look at the distance, which may hide what they gain */

/* ---- the face ---- */

/* The middle control point of a parabola out of its values. */
static double control(double low, double middle, double high)
{
    return 2.0 * middle - 0.5 * (low + high);
}

/* To a unit in which the largest is from 1/2 to 1. */
static void scale(double *x, int n, int *exponent)
{
    double most = 0.0;
    int e;
    for (int i = 0; i < n; i++)
        most = quadratic_larger(most, fabs(x[i]));
    (void)frexp(most, &e);
    *exponent += e;
    if (e < -1000) { /* the factor would be too large */
        for (int i = 0; i < n; i++)
            x[i] *= 0x1p1000;
        e += 1000;
    }
    const double by = ldexp(1.0, -e);
    for (int i = 0; i < n; i++)
        x[i] *= by;
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

/* Corner `first` becomes A.  A triangle of three nodes has its others halfway. */
static void triangle_of(int nodes, const double y[][3], int first, struct quadratic *f)
{
    const double *const A = y[first], *const B = y[(first + 1) % 3], *const C = y[(first + 2) % 3];
    for (int k = 0; k < 3; k++) {
        double ab = 0.5 * (A[k] + B[k]), bc = 0.5 * (B[k] + C[k]), ca = 0.5 * (C[k] + A[k]);
        if (nodes == 6) {
            ab = control(A[k], y[3 + first][k], B[k]);
            bc = control(B[k], y[3 + (first + 1) % 3][k], C[k]);
            ca = control(C[k], y[3 + (first + 2) % 3][k], A[k]);
        }
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

static void face_of(int nodes, const double y[][3], int first, int exponent, struct quadratic *f)
{
    f->triangle = nodes == 3 || nodes == 6;
    f->exponent = exponent;
    if (f->triangle)
        triangle_of(nodes, y, first, f);
    else
        square_of(nodes, y, f);
    scale(f->net[0], 27, &f->exponent);
}

/* x - xS in a unit in which the largest is about 1, and what a distance of 1 is. */
static int differences_of(int nodes, const double *x, double y[][3], int *exponent)
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
    scale(y[0], 3 * nodes, exponent);
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

/* A parabola's coefficients around t. */
static inline void expand(double low, double middle, double high, double t, double c[3])
{
    const double first = low + t * (middle - low), second = middle + t * (high - middle);
    c[0] = first + t * (second - first);
    c[1] = 2.0 * (second - first);
    c[2] = (high - middle) - (middle - low);
}

void footpoint_quadratic_taylor(const struct quadratic *f, double u, double v, struct quadratic_taylor *t)
{
    for (int k = 0; k < 3; k++) {
        double along[3][3];
        for (int j = 0; j < 3; j++)
            expand(f->net[j][k], f->net[3 + j][k], f->net[6 + j][k], u, along[j]);
        for (int i = 0; i < 3; i++) {
            double c[3];
            expand(along[0][i], along[1][i], along[2][i], v, c);
            for (int j = 0; j < 3; j++)
                t->c[i][j][k] = c[j];
        }
    }
}

static void taylor_at(const struct quadratic *f, const double at[2], struct quadratic_taylor *t)
{
    footpoint_quadratic_taylor(f, quadratic_u(f, at), at[1], t);
}

/* Gradient and Hessian of half the square of the distance by a and b. */
struct slopes {
    double g[2], h11, h12, h22, gauss[2]; /* gauss: what takes the place of h11 and h22 where they are not positive */
};

static void slopes_of(const struct quadratic *f, const double at[2], const struct quadratic_taylor *t, struct slopes *m)
{
    const double *const r = t->c[0][0], *const r_u = t->c[1][0], *const r_v = t->c[0][1];
    const double g = vector_dot(r, r_u), uu = vector_dot(r_u, r_u), uv = vector_dot(r_u, r_v),
                 vv = vector_dot(r_v, r_v);
    const double h11 = uu + 2.0 * vector_dot(r, t->c[2][0]), h12 = uv + vector_dot(r, t->c[1][1]);
    const double by = f->triangle ? 1.0 - at[1] : 1.0, to = f->triangle ? at[0] : 0.0; /* u_a, -u_b */
    m->g[0] = by * g;
    m->g[1] = vector_dot(r, r_v) - to * g;
    m->h11 = by * by * h11;
    m->h12 = by * (h12 - to * h11) - (f->triangle ? g : 0.0);
    m->h22 = vv + 2.0 * vector_dot(r, t->c[0][2]) - to * (2.0 * h12 - to * h11);
    m->gauss[0] = by * by * uu;
    m->gauss[1] = vv - to * (2.0 * uv - to * uu);
}

static double clamp(double x)
{
    return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x;
}

/* To the least of slope s + bend s^2/2 for at + s from 0 to 1. */
static double least_of(double at, double slope, double bend, double gauss)
{
    const double by = bend > 0.0 ? bend : gauss;
    return by > 0.0 ? clamp(at - slope / by) : at;
}

/* Where a step leads; what it leaves as it is holds in `at`. */
static void step_from(const struct slopes *m, const double at[2], double to[2])
{
    const double *const g = m->g, det = m->h11 * m->h22 - m->h12 * m->h12;
    const int held[2] = {(at[0] <= 0.0 && g[0] >= 0.0) || (at[0] >= 1.0 && g[0] <= 0.0),
                         (at[1] <= 0.0 && g[1] >= 0.0) || (at[1] >= 1.0 && g[1] <= 0.0)};
    to[0] = held[0] ? at[0] : least_of(at[0], g[0], m->h11, m->gauss[0]);
    to[1] = held[1] ? at[1] : least_of(at[1], g[1], m->h22, m->gauss[1]);
    if (held[0] || held[1] || !(m->h11 > 0.0 && det > 0x1p-40 * m->h11 * m->h22))
        return;
    const double a = at[0] - (m->h22 * g[0] - m->h12 * g[1]) / det, b = at[1] - (m->h11 * g[1] - m->h12 * g[0]) / det;
    to[0] = clamp(a);
    to[1] = clamp(b);
    if (to[0] != a && to[1] == b)
        to[1] = least_of(at[1], g[1] + m->h12 * (to[0] - at[0]), m->h22, m->gauss[1]);
    else if (to[1] != b && to[0] == a)
        to[0] = least_of(at[0], g[0] + m->h12 * (to[1] - at[1]), m->h11, m->gauss[0]);
}

/* Moves `at` to a local minimum, to rounding; t is the expansion there. */
static void descend(const struct quadratic *f, double at[2], struct quadratic_taylor *t)
{
    double last = 1.0;
    taylor_at(f, at, t);
    for (int n = 0; n < STEPS; n++) {
        struct slopes m;
        struct quadratic_taylor there;
        double to[2];
        slopes_of(f, at, t, &m);
        step_from(&m, at, to);
        const double move = quadratic_larger(fabs(to[0] - at[0]), fabs(to[1] - at[1]));
        if (move < SETTLED || (move < SHORT && move > 0.5 * last))
            return;
        last = move;
        taylor_at(f, to, &there);
        const double here = vector_dot(t->c[0][0], t->c[0][0]);
        for (int k = 0; move > SHORT && !(vector_dot(there.c[0][0], there.c[0][0]) < here); k++) {
            if (k == HALVINGS)
                return;
            to[0] = 0.5 * (at[0] + to[0]);
            to[1] = 0.5 * (at[1] + to[1]);
            taylor_at(f, to, &there);
        }
        at[0] = to[0];
        at[1] = to[1];
        *t = there;
    }
}

/* ---- the closest point ---- */

/* r_u x r_v an eighth of the way to the middle, as in generated/: there collapsed corners have a normal, too. */
static void normal_beside(const struct quadratic *f, const double at[2], double n[3])
{
    const double middle = f->triangle ? 1.0 / 3.0 : 0.5, u = quadratic_u(f, at), v = at[1];
    struct quadratic_taylor t;
    footpoint_quadratic_taylor(f, u + 0.125 * (middle - u), v + 0.125 * (middle - v), &t);
    vector_cross(t.c[1][0], t.c[0][1], n);
}

/* (xi,eta) and edges of a place of the face that begins at a corner `first`. */
static void write_place(const struct quadratic *f, int first, const double at[2], struct quadratic_answer *answer)
{
    const int low = at[0] <= 0.0, high = at[0] >= 1.0, bottom = at[1] <= 0.0, top = at[1] >= 1.0;
    answer->edges = bottom | high << 1 | top << 2 | low << 3;
    answer->loc[0] = 2.0 * at[0] - 1.0;
    answer->loc[1] = 2.0 * at[1] - 1.0;
    if (f->triangle) {
        const double part[3] = {(1.0 - at[0]) * (1.0 - at[1]), at[0] * (1.0 - at[1]), at[1]};
        answer->edges = bottom << first | (high | top) << (1 + first) % 3 | (low | top) << (2 + first) % 3;
        answer->loc[0] = part[(4 - first) % 3];
        answer->loc[1] = part[(5 - first) % 3];
    }
}

/* Into [0,1], to an end of it where rounding may have led away from that. */
static double end_or_inside(double x)
{
    return x < SETTLED ? 0.0 : x > 1.0 - SETTLED ? 1.0 : x;
}

/* (a,b) of a place of the face, and for which of its corners. */
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

int footpoint_quadratic_closest(int nodes, const double *x, const double start[2], struct quadratic_answer *answer)
{
    struct quadratic f;
    struct quadratic_taylor t;
    double y[MOST_NODES][3], at[2];
    int exponent, boxes = MOST_BOXES, status = FOOTPOINT_UNPROVED;
    const int triangle = nodes == 3 || nodes == 6, wrong = differences_of(nodes, x, y, &exponent);
    if (wrong)
        return wrong;
    answer->loc[0] = start[0];
    answer->loc[1] = start[1];
    for (int starts = 0, turns = 0;; turns++) {
        double nearer[2];
        const int first = place_of(triangle, answer->loc, at);
        face_of(nodes, (const double(*)[3])y, first, exponent, &f);
        descend(&f, at, &t);
        write_place(&f, first, at, answer);
        if (triangle && turns < TURNS && (1.0 - at[0]) * (1.0 - at[1]) < 0.25)
            continue;
        const enum quadratic_proof proof = footpoint_quadratic_prove(&f, at, &t, &boxes, nearer);
        if (proof == QUADRATIC_NEARER && starts++ < STARTS) {
            write_place(&f, first, nearer, answer);
            turns = -1;
            continue;
        }
        if (proof == QUADRATIC_PROVED)
            status = answer->edges ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
        else if (proof == QUADRATIC_TIED)
            status = FOOTPOINT_NOT_UNIQUE;
        break;
    }
    const double *const r = t.c[0][0], distance = ldexp(sqrt(vector_dot(r, r)), f.exponent);
    if (!isfinite(distance))
        return FOOTPOINT_ERR_DOMAIN;
    double n[3];
    normal_beside(&f, at, n);
    const int on_a_line = !(vector_dot(n, n) > FLAT) && all_on_a_line(&f);
    answer->distance = !on_a_line && vector_dot(n, r) > 0.0 ? -distance : distance;
    return on_a_line && status != FOOTPOINT_UNPROVED ? FOOTPOINT_NO_AREA : status;
}
