/* Proves that a local minimum p of the distance to a face of degree 2 is the global minimum, by subdivision with bounds.
 *
 * With g = r(p) - xS, the offset z = (s,t) in u and v from p, and c_ij as in quadratic.h, r - xS = g + L z + y,
 * L z = c10 s + c01 t, and y has all terms of degree 2 and more.  So
 *     |r - xS|^2 - |g|^2 = 2 g . L z + |L z|^2 + 2 (g + L z) . y + |y|^2.
 * The first term is not negative, because no direction leads down from p, nor is the last.  Over a range of s and t the others are
 * at least h11 s^2 - e |s t| + h22 t^2 with bounds on the factors, whose terms are polynomials of only s and t.  If that form is
 * positive, no point of the range is nearer, or as near.  On ordinary faces this test settles the whole face.  On slim faces c10
 * and c01 are nearly parallel, and so is almost all of y.  There the test uses s - k t - l t^2 and t, with k and l for which only
 * c10 lies along c10.
 *
 * Otherwise boxes of (a,b) are halved.  The square of the distance is a polynomial of degree 4 in a and in b, and is at least its
 * smallest Bernstein coefficient.  Coefficients are computed for each box from its own control points, so that their errors are of
 * the size of the box and its distance.  The distance is also at least the distance of a plane beyond which all of these control points
 * lie: for slim boxes, a plane along them.  A box is dropped if it is settled as above, or if a bound proves that it is farther
 * away than p, or nearer by less than the tolerance. */
#include "ieee.h"
#include "quadratic.h"

#include <float.h>
#include <string.h>

enum { DEPTH = 80, DOUBTS = 64 /* limit on halvings of boxes that may be as near */ };

#define UNIT (0.5 * DBL_EPSILON)

/* Bounds the errors of points of a box computed from its control points, and of the distance of p: 64 u from nodes to control
 * points, 3 u for each of at most DEPTH halvings and 8 u for a triangle's folding, in each of three coordinates. */
#define ASTRAY (1024.0 * UNIT)

/* Rounding errors of coefficients, as in quadratic.h, and of a product of two, beyond the errors of its factors. */
#define VALUE_ERROR (54.0 * UNIT)
#define PURE_ERROR (70.0 * UNIT)
#define CROSSED_ERROR (256.0 * UNIT)
#define SUM_ERROR (64.0 * UNIT)
#define PRODUCT_ERROR 0x1p-48 /* relative, of the determinant and its comparison */
#define RANGE_ERROR 0x1p-50   /* of ends of boxes, in u and v */

/* Error of a coefficient, with 27 products, their sums and factors, over the largest square of a control point. */
#define COEFFICIENT_ERROR (64.0 * UNIT)

#define PLANE_ERROR (32.0 * UNIT) /* of the distance of a plane */

#define NEARLY 64.0    /* squares of lengths with a smaller ratio are nearly equal */
#define NEARER 0x1p-41 /* a point nearer by this is better */

#define LEAST_EXTENT 0x1p-50 /* smaller boxes are not halved */

struct box {
    double net[9][3], low[2], wide[2]; /* (a,b) from low to low + wide */
};

enum { DEGREE = 6, TERMS = DEGREE + 2 };

/* The gain of |r - xS|^2 from p on, in y = s - k t - l t^2 and z = t, or y = t - k s - l s^2 and z = s. */
struct form {
    double q[4][TERMS], slack[4][TERMS]; /* factors of y^i z^j beyond the first degree; their rounding errors */
    double down[2], up[2];               /* slopes in y and z, halved, if they lead down; and up into the face */
    double skew, bow;                    /* k, l */
    int first;                           /* y begins with s: 0, or t: 1 */
};

/* The statement about p to be proved. */
struct question {
    double at[2]; /* u, v */
    double room;  /* of the square of the distance */
    double nearer, farther,
        alone;             /* squares of distances: below, a point is nearer; above, no point is; no point is as near */
    double point[3], same; /* r - xS at p, and the squared distance within which other points are that point */
    int into[2];           /* u and v may only grow: 1, only fall: -1, do both: 0 */
    struct form form[2];   /* by s and t; at right angles */
    int forms;             /* number of forms computed so far */
};

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* ---- around p ---- */

/* A coefficient of r - xS, its largest component and the error of that. */
struct term {
    double c[3], size, error;
};

static double size_of(const double c[3])
{
    return quadratic_larger(quadratic_larger(fabs(c[0]), fabs(c[1])), fabs(c[2]));
}

static double error_of(const struct quadratic *f, int i, int j)
{
    const double U = f->extent[0], V = f->extent[1];
    return i + j == 0 ? VALUE_ERROR : j == 0 ? PURE_ERROR * U : i == 0 ? PURE_ERROR * V : CROSSED_ERROR * smaller(U, V);
}

/* Adds twice the product of two terms to a factor. */
static void add_product(struct form *m, int i, int j, const struct term *a, const struct term *b)
{
    m->q[i][j] += 2.0 * vector_dot(a->c, b->c);
    m->slack[i][j] += 6.0 * (a->size * b->error + b->size * a->error + SUM_ERROR * (a->size * b->size));
}

/* Adds a part of a term to another term. */
static void add_part(const struct term *from, double by, struct term *to)
{
    for (int n = 0; n < 3; n++)
        to->c[n] += by * from->c[n];
    to->error += fabs(by) * (from->error + 16.0 * UNIT * from->size);
}

/* Computes the coefficients of r - xS in y and z, from the coefficients of s^i, which belong to (y + k z + l z^2)^i; likewise for t^i.
 *  @return the highest power of z */
static int terms_of(const struct quadratic *f, const struct quadratic_taylor *t, const struct form *m,
                    struct term to[3][DEGREE + 1])
{
    const double k = m->skew, l = m->bow;
    const double power[3][3][5] = {
        {{1.0}}, {{0.0, k, l}, {1.0}}, {{0.0, 0.0, k * k, 2.0 * k * l, l * l}, {0.0, 2.0 * k, 2.0 * l}, {1.0}}};
    const int straight = k == 0.0 && l == 0.0;
    struct term given[3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            struct term *const at = straight ? &to[i][j] : &given[i][j];
            memcpy(at->c, m->first ? t->c[j][i] : t->c[i][j], sizeof at->c);
            at->size = size_of(at->c);
            at->error = m->first ? error_of(f, j, i) : error_of(f, i, j);
        }
    if (straight)
        return 2;
    memset(to, 0, 3 * sizeof to[0]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int y = 0; y <= i; y++)
                for (int z = i - y; z <= 2 * (i - y); z++)
                    add_part(&given[i][j], power[i][y][z], &to[y][j + z]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= DEGREE; j++)
            to[i][j].size = size_of(to[i][j].c);
    return DEGREE;
}

/* Adds the slope of g by c, in a coordinate that may grow or fall as `into` allows. */
static void add_slope(struct form *m, int k, int into, const struct term *g, const struct term *c)
{
    const double slope = 2.0 * vector_dot(g->c, c->c), up = into ? into * slope : -fabs(slope);
    const double error = 3.0 * (g->size * c->error + c->size * g->error + SUM_ERROR * (g->size * c->size));
    m->up[k] = quadratic_larger(up - 2.0 * error, 0.0);
    m->down[k] = m->up[k] > 0.0 ? 0.0 : 0.5 * quadratic_larger(-up, 0.0) + error;
}

/* Computes a form from first, skew and bow.  A skew form ignores that s or t is held. */
static void form_of(const struct quadratic *f, const struct quadratic_taylor *t, const struct question *of,
                    struct form *m)
{
    struct term c[3][DEGREE + 1];
    memset(m->q, 0, sizeof m->q);
    memset(m->slack, 0, sizeof m->slack);
    const int most = terms_of(f, t, m, c);
    add_slope(m, 0, m == of->form ? of->into[m->first] : 0, &c[0][0], &c[1][0]);
    add_slope(m, 1, of->into[!m->first], &c[0][0], &c[0][1]);
    if (m != of->form && of->form[0].up[m->first] > 0.0) {
        m->up[0] = m->down[0] = 0.0;
        m->up[1] = of->form[0].up[!m->first];
        m->down[1] = of->form[0].down[!m->first];
    }
    add_product(m, 2, 0, &c[1][0], &c[1][0]);
    add_product(m, 0, 2, &c[0][1], &c[0][1]);
    m->q[2][0] *= 0.5;
    m->q[0][2] *= 0.5;
    add_product(m, 1, 1, &c[1][0], &c[0][1]);
    for (int i = 0; i < 3; i++)
        for (int j = i < 2 ? 2 - i : 0; j <= most; j++)
            if (c[i][j].size + c[i][j].error > 0.0) {
                add_product(m, i, j, &c[0][0], &c[i][j]);
                add_product(m, i + 1, j, &c[1][0], &c[i][j]);
                add_product(m, i, j + 1, &c[0][1], &c[i][j]);
            }
}

/* Chooses the skew form by the longer of r_u and r_v, or by one that is nearly as long and not held, and by the parts of the other,
 * and of its bend, at right angles to it. */
static void skew_form_of(const struct quadratic *f, const struct quadratic_taylor *t, struct question *m)
{
    struct form *const to = &m->form[1];
    const double *const u = t->c[1][0], *const v = t->c[0][1], uu = vector_dot(u, u), vv = vector_dot(v, v);
    to->first = vv * (m->into[0] ? NEARLY : 1.0) > uu * (m->into[1] ? NEARLY : 1.0);
    const double *const e = to->first ? v : u, ee = to->first ? vv : uu, per = ee > 0.0 ? 1.0 / ee : 0.0;
    const double *const along = to->first ? t->c[0][2] : t->c[2][0];
    const double *const across = to->first ? t->c[2][0] : t->c[0][2];
    to->skew = -per * vector_dot(u, v);
    to->bow =
        m->form[0].up[to->first] > 0.0
            ? 0.0
            : -per * (vector_dot(e, across) + to->skew * (vector_dot(e, t->c[1][1]) + to->skew * vector_dot(e, along)));
    form_of(f, t, m, to);
}

static void ask(const struct quadratic *f, const double at[2], const struct quadratic_taylor *t, struct question *m)
{
    const double *const g = t->c[0][0];
    for (int k = 0; k < 2; k++)
        m->into[k] = at[k] <= 0.0 ? 1 : at[k] >= 1.0 && !f->triangle ? -1 : 0;
    m->at[0] = quadratic_u(f, at);
    m->at[1] = at[1];
    const double distance = sqrt(vector_dot(g, g));
    const double near = distance - NEARER, floor = distance - f->tolerance + 2.0 * ASTRAY;
    m->room = 0.5 * f->tolerance * distance;
    m->nearer = near * near;
    m->farther = floor * floor;
    m->alone = (distance + 2.0 * ASTRAY) * (distance + 2.0 * ASTRAY);
    m->same = f->tolerance * (4.0 * f->tolerance + 8.0 * distance);
    memcpy(m->point, g, sizeof m->point);
    m->form[0].skew = m->form[0].bow = 0.0;
    m->form[0].first = m->forms = 0;
}

/* Returns the minimum of factor x over a range. */
static double least(double factor, const double range[2])
{
    return factor * (factor > 0.0 ? range[0] : range[1]);
}

static double widest(const double range[2])
{
    return quadratic_larger(fabs(range[0]), fabs(range[1]));
}

/* Returns 1 if h11 y^2 - e |y z| + h22 z^2 is positive and, less 2 (p |y| + q |z|), falls by at most `room`. */
static int is_positive(double h11, double e, double h22, double p, double q, double room)
{
    const double det = (1.0 - PRODUCT_ERROR) * (h11 * h22) - 0.25 * (e * e);
    return h11 > 0.0 && h22 > 0.0 && det > 0.0 &&
           h22 * (p * p) + e * (p * q) + h11 * (q * q) <= (1.0 - PRODUCT_ERROR) * (room * det);
}

/* Computes the range of y. */
static void range_of(const struct form *f, const double range[2][2], double y[2])
{
    const double *const s = range[f->first], *const z = range[!f->first], Z = widest(z);
    const double square = Z * Z, bow[2] = {smaller(f->bow, 0.0) * square, quadratic_larger(f->bow, 0.0) * square};
    const double skew[2] = {least(f->skew, z), -least(-f->skew, z)};
    const double error =
        f->skew == 0.0 && f->bow == 0.0 ? 0.0 : RANGE_ERROR * (1.0 + fabs(f->skew) * Z + fabs(f->bow) * square);
    y[0] = s[0] - skew[1] - bow[1] - error;
    y[1] = s[1] - skew[0] - bow[0] + error;
}

/* Bounds the factor of |y z|, without the terms of y^2 z and y z^2. */
static double mixed_of(const struct form *f, double Y, double Z)
{
    double e = 0.0;
    for (int i = 3; i > 0; i--) {
        double sum = 0.0;
        for (int j = TERMS - 1; j > 0; j--)
            sum = sum * Z + (i + j == 3 ? 0.0 : fabs(f->q[i][j]) + f->slack[i][j]);
        e = e * Y + sum;
    }
    return e;
}

/* Returns 1 if the form proves that no point of a range of s and t is nearer than p, or as near.  Terms with y^2 z count with y^2
 * or with |y z|, terms with y z^2 with z^2 or |y z|, the latter on slim faces. */
static int is_settled(const struct form *f, double room, const double range[2][2])
{
    const double *const z = range[!f->first], p = f->down[0], q = f->down[1];
    double y[2], high = 0.0;
    range_of(f, range, y);
    const double Y = widest(y), Z = widest(z), e = mixed_of(f, Y, Z);
    for (int j = TERMS - 1; j > 3; j--)
        high = (high + fabs(f->q[0][j]) + f->slack[0][j]) * Z;
    const double h11 = f->q[2][0] - f->slack[2][0] + least(f->q[3][0], y) - f->slack[3][0] * Y + f->up[0] / Y;
    const double h22 = f->q[0][2] - f->slack[0][2] + least(f->q[0][3], z) - (f->slack[0][3] + high) * Z + f->up[1] / Z;
    const double with_h11 = least(f->q[2][1], z) - f->slack[2][1] * Z;
    const double with_h22 = least(f->q[1][2], y) - f->slack[1][2] * Y;
    const double with_e[2] = {Y * (fabs(f->q[2][1]) + f->slack[2][1]), Z * (fabs(f->q[1][2]) + f->slack[1][2])};
    return is_positive(h11 + with_h11, e, h22 + with_h22, p, q, room) ||
           is_positive(h11 + with_h11, e + with_e[1], h22, p, q, room) ||
           is_positive(h11, e + with_e[0], h22 + with_h22, p, q, room);
}

/* ---- boxes ---- */

/* Returns the box of the whole face.  On a triangle, lines of constant b have u from 0 to 1 - b. */
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

/* Computes Bernstein coefficients of the squared distance.
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

/* Returns 1 if second differences of the coefficients, which hide the least value, are larger along a than along b. */
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

/* Halves a box: x becomes the lower half, `other` the upper half. */
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

/* Returns 1 if no point of the box is nearer than p, or as near. */
static int is_box_settled(const struct quadratic *f, const struct quadratic_taylor *t, struct question *m,
                          const struct box *x)
{
    const double *const low = x->low, b = low[1] + x->wide[1];
    const double first = f->triangle ? low[0] * (1.0 - b) : low[0];
    const double last = (low[0] + x->wide[0]) * (f->triangle ? 1.0 - low[1] : 1.0);
    const double range[2][2] = {{first - m->at[0] - RANGE_ERROR, last - m->at[0] + RANGE_ERROR},
                                {low[1] - m->at[1] - RANGE_ERROR, b - m->at[1] + RANGE_ERROR}};
    for (int k = 0; k < 2; k++) {
        if (k == m->forms) {
            if (k == 0)
                form_of(f, t, m, &m->form[0]);
            else
                skew_form_of(f, t, m);
            m->forms++;
        }
        if (is_settled(&m->form[k], m->room, range))
            return 1;
    }
    return 0;
}

/* Returns 1 if all points of the box are p, in space. */
static int is_same(const struct question *m, const struct box *x)
{
    for (int i = 0; i < 9; i++) {
        double apart[3];
        vector_sub(x->net[i], m->point, apart);
        if (!(vector_dot(apart, apart) < m->same))
            return 0;
    }
    return 1;
}

/* Returns 1 if a corner of a box is nearer than p; finds the coefficient of the corner that is p itself. */
static int has_nearer(const struct question *m, const double at[2], const struct box *x, double c[5][5],
                      double start[2], int *own)
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

/* Returns a lower bound on the squared distance of the box, without p if p is a corner. */
static double bound_of(double c[5][5], int own, double error)
{
    double lowest = HUGE_VAL;
    for (int i = 0; i < 25; i++)
        if (i != own)
            lowest = smaller(lowest, c[i / 5][i % 5]);
    return lowest - error;
}

static double square_of(double x)
{
    return x > 0.0 ? x * x : 0.0;
}

/* Returns a lower bound on the squared distance of the box: from a plane along its length beyond which its control points lie.  Slim
 * boxes lie beside xS if the squared distance is almost constant along them. */
static double bound_along(const double net[9][3])
{
    double a[3], b[3], n[3], least = HUGE_VAL;
    for (int k = 0; k < 3; k++) {
        a[k] = (net[6][k] - net[0][k]) + (net[7][k] - net[1][k]) + (net[8][k] - net[2][k]);
        b[k] = (net[2][k] - net[0][k]) + (net[5][k] - net[3][k]) + (net[8][k] - net[6][k]);
    }
    const double *const e = vector_dot(a, a) > vector_dot(b, b) ? a : b, square = vector_dot(e, e);
    const double by = square > 0.0 ? vector_dot(net[4], e) / square : 0.0;
    for (int k = 0; k < 3; k++)
        n[k] = net[4][k] - by * e[k];
    const double length = sqrt(vector_dot(n, n));
    for (int i = 0; i < 9 && length > 0.0; i++)
        least = smaller(least, vector_dot(n, net[i]) / length);
    return length > 0.0 ? least - PLANE_ERROR : 0.0;
}

enum quadratic_proof footpoint_quadratic_prove(const struct quadratic *f, const double at[2],
                                               const struct quadratic_taylor *t, int *boxes, double start[2])
{
    struct box stack[DEPTH + 1];
    struct question m;
    enum quadratic_proof proof = QUADRATIC_PROVED;
    if (vector_dot(t->c[0][0], t->c[0][0]) <= f->tolerance * f->tolerance)
        return proof; /* no point is nearer by more, and points as near are the same in space */
    int doubts = 0;
    ask(f, at, t, &m);
    box_of(f, &stack[0]);
    for (int top = 0; top >= 0; --*boxes) {
        struct box *const x = &stack[top];
        double c[5][5];
        int own;
        if (*boxes <= 0)
            return QUADRATIC_GIVEN_UP;
        top--;
        if (is_box_settled(f, t, &m, x))
            continue;
        const double error = coefficients_of((const double(*)[3])x->net, c);
        if (has_nearer(&m, at, x, c, start, &own))
            return QUADRATIC_NEARER;
        double bound = bound_of(c, own, error);
        if (bound < m.farther)
            bound = square_of(bound_along((const double(*)[3])x->net));
        const int is_farther = bound >= m.farther;
        if (is_farther && (bound > m.alone || is_same(&m, x)))
            continue;
        const int along = !is_bent_along_a(c);
        const int is_last = top + 2 > DEPTH || x->wide[along] < LEAST_EXTENT;
        if (is_farther && (is_last || doubts++ >= DOUBTS)) {
            proof = QUADRATIC_TIED;
            continue;
        }
        if (is_last)
            return QUADRATIC_GIVEN_UP;
        struct box other;
        halve(x, along, &other);
        top += 2;
        if (vector_dot(x->net[4], x->net[4]) > vector_dot(other.net[4], other.net[4]))
            stack[top] = other; /* the nearer box first */
        else {
            stack[top] = *x;
            *x = other;
        }
    }
    return proof;
}
