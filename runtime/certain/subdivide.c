/* That a local minimum p of the distance to a face of degree 2 is the least: by subdivision with bounds.
 *
 * With g = r(p) - xS, z = (s,t) the way from p in u and v, and c_ij as in quadratic.h, r - xS = g + L z + y,
 * L z = c10 s + c01 t, and y is all of degree 2 and more.  So
 *     |r - xS|^2 - |g|^2 = 2 g . L z + |L z|^2 + 2 (g + L z) . y + |y|^2,
 * where the first term is not negative, as no direction leads down from p, and the last one is not.  Over a range of s and t
 * what is left is at least h11 s^2 - e |s t| + h22 t^2 with bounds on the factors, whose terms are polynomials of s and t
 * alone.  If that form is positive, no point of the range is nearer, nor as near: a question to be asked for the whole
 * face, which on ordinary ones settles it.
 *
 * Elsewhere boxes of (a,b) are halved.  The square of the distance is a polynomial of degree 4 in a and in b, nowhere less
 * than the least of its Bernstein coefficients; these are formed for each box from its own control points, so that their
 * errors are of the size of the box and its distance.  A box is dropped if it is settled as above, or if its bound says
 * that it is farther away than p, or nearer by less than the tolerance. */
#include "ieee.h"
#include "quadratic.h"

#include <float.h>
#include <string.h>

enum { DEPTH = 80 };

#define UNIT (0.5 * DBL_EPSILON)

/* How far points of a box may be from where its control points have them: 64 u from nodes to control points, 3 u for each
 * of at most DEPTH halvings and 8 u for a triangle's folding in, in each of three coordinates; and of the distance of p. */
#define ASTRAY (1024.0 * UNIT)

/* Bounds on rounding errors of g . c10 and g . c01, and of h11, h12 and e with |s|, |t| <= 1: from those of c_ij in
 * quadratic.h, as |c_ij| <= 2^(i + j) in each coordinate, at most 330 u and, of e, 33,000 u; 10,000 u of e from its own
 * products and sums. */
#define SLOPE_ERROR (512.0 * UNIT)
#define FORM_ERROR 0x1p-37
#define PRODUCT_ERROR 0x1p-48 /* relative, of the determinant and what it is compared with */
#define RANGE_ERROR 0x1p-50   /* of ends of boxes, in u and v */

/* Of a coefficient: 27 products, their sums and factors, over the largest square of a control point. */
#define COEFFICIENT_ERROR (64.0 * UNIT)

#define LEAST_EXTENT 0x1p-50 /* smaller boxes are not halved */

struct box {
    double net[9][3], low[2], wide[2]; /* (a,b) from low to low + wide */
};

/* What is asked of p: factors of s^i t^j beyond the first degree; slopes as far as they lead down, and up into the face. */
struct form {
    double u, v, q[4][4];
    double down[2], up[2], room;   /* of the square of the distance */
    double nearer, farther, alone; /* squares of distances: below, a point is nearer; above, none is; none is as near */
    int touching;                  /* p is xS, to the tolerance: other points may be as near, not nearer */
};

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double product(const struct quadratic_taylor *t, int i, int j, int m, int n)
{
    return 2.0 * vector_dot(t->c[i][j], t->c[m][n]);
}

static void form_of(const struct quadratic *f, const double at[2], const struct quadratic_taylor *t, struct form *m)
{
    const double slope[2] = {product(t, 0, 0, 1, 0), product(t, 0, 0, 0, 1)};
    const int starts[2] = {at[0] <= 0.0, at[1] <= 0.0}, ends[2] = {at[0] >= 1.0, at[1] >= 1.0};
    for (int k = 0; k < 2; k++) {
        const double into = starts[k] ? slope[k] : ends[k] && !f->triangle ? -slope[k] : -fabs(slope[k]);
        m->up[k] = quadratic_larger(into - 2.0 * SLOPE_ERROR, 0.0);
        m->down[k] = m->up[k] > 0.0 ? 0.0 : 0.5 * quadratic_larger(-into, 0.0) + SLOPE_ERROR;
    }
    m->u = quadratic_u(f, at);
    m->v = at[1];
    m->q[2][0] = 0.5 * product(t, 1, 0, 1, 0) + product(t, 0, 0, 2, 0);
    m->q[1][1] = product(t, 1, 0, 0, 1) + product(t, 0, 0, 1, 1);
    m->q[0][2] = 0.5 * product(t, 0, 1, 0, 1) + product(t, 0, 0, 0, 2);
    m->q[3][0] = product(t, 1, 0, 2, 0);
    m->q[2][1] = product(t, 0, 0, 2, 1) + product(t, 1, 0, 1, 1) + product(t, 0, 1, 2, 0);
    m->q[1][2] = product(t, 0, 0, 1, 2) + product(t, 0, 1, 1, 1) + product(t, 1, 0, 0, 2);
    m->q[0][3] = product(t, 0, 1, 0, 2);
    m->q[3][1] = product(t, 1, 0, 2, 1);
    m->q[2][2] = product(t, 0, 0, 2, 2) + product(t, 1, 0, 1, 2) + product(t, 0, 1, 2, 1);
    m->q[1][3] = product(t, 0, 1, 1, 2);
    m->q[3][2] = product(t, 1, 0, 2, 2);
    m->q[2][3] = product(t, 0, 1, 2, 2);
    const double distance = sqrt(vector_dot(t->c[0][0], t->c[0][0]));
    const double far = quadratic_larger(distance, QUADRATIC_TOLERANCE);
    const double near = far - 0.25 * QUADRATIC_TOLERANCE, floor = far - QUADRATIC_TOLERANCE + 2.0 * ASTRAY;
    m->touching = distance < QUADRATIC_TOLERANCE;
    m->room = 0.5 * QUADRATIC_TOLERANCE * far;
    m->nearer = near * near;
    m->farther = floor * floor;
    m->alone = (distance + 2.0 * ASTRAY) * (distance + 2.0 * ASTRAY);
}

/* ---- around p ---- */

/* The least of factor x over a range. */
static double least(double factor, const double range[2])
{
    return factor * (factor > 0.0 ? range[0] : range[1]);
}

static double widest(const double range[2])
{
    return quadratic_larger(fabs(range[0]), fabs(range[1]));
}

/* Whether no point of the box is nearer than p, nor as near. */
static int is_settled(const struct quadratic *f, const struct form *m, const struct box *x)
{
    const double *const low = x->low, b = low[1] + x->wide[1];
    const double first = f->triangle ? low[0] * (1.0 - b) : low[0];
    const double last = (low[0] + x->wide[0]) * (f->triangle ? 1.0 - low[1] : 1.0);
    const double s[2] = {first - m->u - RANGE_ERROR, last - m->u + RANGE_ERROR}, S = widest(s);
    const double t[2] = {low[1] - m->v - RANGE_ERROR, b - m->v + RANGE_ERROR}, T = widest(t);
    const double h11 = m->q[2][0] + least(m->q[3][0], s) + least(m->q[2][1], t) + m->up[0] / S - FORM_ERROR;
    const double h22 = m->q[0][2] + least(m->q[0][3], t) + least(m->q[1][2], s) + m->up[1] / T - FORM_ERROR;
    const double e = fabs(m->q[1][1]) + S * S * (fabs(m->q[3][1]) + T * fabs(m->q[3][2])) + S * T * fabs(m->q[2][2]) +
                     T * T * (fabs(m->q[1][3]) + S * fabs(m->q[2][3])) + FORM_ERROR;
    const double det = (1.0 - PRODUCT_ERROR) * (h11 * h22) - 0.25 * (e * e);
    const double p = m->down[0], q = m->down[1]; /* what the form less 2 (p |s| + q |t|) loses must be small: */
    return h11 > 0.0 && h22 > 0.0 && det > 0.0 &&
           h22 * (p * p) + e * (p * q) + h11 * (q * q) <= (1.0 - PRODUCT_ERROR) * (m->room * det);
}

/* ---- boxes ---- */

/* All of the face.  Of a triangle, lines of one b have u from 0 to 1 - b. */
static void box_of(const struct quadratic *f, struct box *x)
{
    memcpy(x->net, f->net, sizeof x->net);
    x->low[0] = x->low[1] = 0.0;
    x->wide[0] = x->wide[1] = 1.0;
    for (int k = 0; f->triangle && k < 3; k++) {
        const double ca = f->net[1][k], bc = 2.0 * f->net[4][k] - f->net[3][k] - ca + f->net[0][k];
        x->net[4][k] = 0.5 * (ca + bc);
        x->net[7][k] = bc;
        x->net[5][k] = x->net[8][k] = f->net[2][k];
    }
}

/* Bernstein coefficients of the square of the distance.
 *  @return a bound on their errors */
static double coefficients_of(const double net[9][3], double c[5][5])
{
    static const double weight[9] = {1.0, 2.0, 1.0, 2.0, 4.0, 2.0, 1.0, 2.0, 1.0};
    static const double per[5] = {1.0, 1.0 / 4.0, 1.0 / 6.0, 1.0 / 4.0, 1.0};
    double b[9][3], most = 0.0;
    memset(c, 0, 25 * sizeof c[0][0]);
    for (int i = 0; i < 9; i++)
        for (int k = 0; k < 3; k++)
            b[i][k] = weight[i] * net[i][k];
    for (int i = 0; i < 9; i++) {
        const double square = vector_dot(net[i], net[i]);
        most = quadratic_larger(most, square);
        c[2 * (i / 3)][2 * (i % 3)] += weight[i] * weight[i] * square;
        for (int j = i + 1; j < 9; j++)
            c[i / 3 + j / 3][i % 3 + j % 3] += 2.0 * vector_dot(b[i], b[j]);
    }
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++)
            c[i][j] *= per[i] * per[j];
    return COEFFICIENT_ERROR * most;
}

/* Whether what hides the polynomial's least value among its coefficients is rather along a than along b. */
static int is_bent_along_a(double c[5][5])
{
    double a = 0.0, b = 0.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 5; j++) {
            a = quadratic_larger(a, fabs((c[i][j] - c[i + 1][j]) - (c[i + 1][j] - c[i + 2][j])));
            b = quadratic_larger(b, fabs((c[j][i] - c[j][i + 1]) - (c[j][i + 1] - c[j][i + 2])));
        }
    return a >= b;
}

/* x becomes the lower half, `other` the upper one. */
static void halve(struct box *x, int along, struct box *other)
{
    const int step = along ? 3 : 9, next = along ? 9 : 3;
    double *const from = x->net[0], *const to = other->net[0];
    memcpy(other->low, x->low, sizeof x->low);
    x->wide[along] *= 0.5;
    memcpy(other->wide, x->wide, sizeof x->wide);
    other->low[along] += x->wide[along];
    for (int row = 0; row < 3; row++)
        for (int k = 0; k < 3; k++) {
            double *const low = from + row * next + k, *const high = to + row * next + k;
            const double first = 0.5 * (low[0] + low[step]), second = 0.5 * (low[step] + low[2 * step]);
            high[2 * step] = low[2 * step];
            high[step] = second;
            high[0] = low[2 * step] = 0.5 * (first + second);
            low[step] = first;
        }
}

/* Corners of a box: one that is nearer than p, and which is p itself, as a coefficient. */
static int has_nearer(const struct form *m, const double at[2], const struct box *x, double c[5][5], double start[2],
                      int *own)
{
    double best = m->nearer;
    *own = -1;
    for (int k = 0; k < 4; k++) {
        const int i = k & 1 ? 4 : 0, j = k & 2 ? 4 : 0;
        const double a = x->low[0] + (i ? x->wide[0] : 0.0), b = x->low[1] + (j ? x->wide[1] : 0.0);
        if (a == at[0] && b == at[1])
            *own = 5 * i + j;
        else if (c[i][j] < best) {
            best = c[i][j];
            start[0] = a;
            start[1] = b;
        }
    }
    return best < m->nearer;
}

/* What no point of the box is below, but for p, if that is a corner. */
static double bound_of(double c[5][5], int own, double error)
{
    double lowest = HUGE_VAL;
    for (int i = 0; i < 25; i++)
        if (i != own)
            lowest = smaller(lowest, c[i / 5][i % 5]);
    return lowest - error;
}

enum quadratic_proof footpoint_quadratic_prove(const struct quadratic *f, const double at[2],
                                               const struct quadratic_taylor *t, int *boxes, double start[2])
{
    struct box stack[DEPTH + 1];
    struct form m;
    enum quadratic_proof proof = QUADRATIC_PROVED;
    form_of(f, at, t, &m);
    box_of(f, &stack[0]);
    for (int top = 0; top >= 0; --*boxes) {
        struct box *const x = &stack[top];
        double c[5][5];
        int own;
        if (*boxes <= 0)
            return QUADRATIC_GIVEN_UP;
        top--;
        if (is_settled(f, &m, x))
            continue;
        const double error = coefficients_of((const double(*)[3])x->net, c);
        if (has_nearer(&m, at, x, c, start, &own)) {
            if (!m.touching)
                return QUADRATIC_NEARER;
            proof = QUADRATIC_TIED;
            continue;
        }
        const double bound = bound_of(c, own, error);
        if (bound >= m.farther) {
            if (bound <= m.alone)
                proof = QUADRATIC_TIED;
            continue;
        }
        const int along = !is_bent_along_a(c);
        if (top + 2 > DEPTH || x->wide[along] < LEAST_EXTENT)
            return QUADRATIC_GIVEN_UP;
        struct box other;
        halve(x, along, &other);
        top += 2;
        if (vector_dot(x->net[4], x->net[4]) > vector_dot(other.net[4], other.net[4]))
            stack[top] = other; /* the nearer one first */
        else {
            stack[top] = *x;
            *x = other;
        }
    }
    return proof;
}
