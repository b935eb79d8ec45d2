/* The closest point of a bilinear segment r = c0 + c1 xi + c2 eta + c3 xi eta, clamped to it, with certainty.
 *
 * Half the squared distance f has the Hessian [a(eta) m; m b(xi)], a = |r_xi|^2, b = |r_eta|^2 and
 * m = r_xi . r_eta - c3 . (xS - r), which is bilinear in (xi, eta): so its bounds over the segment are those at
 * corners, and where a b > m^2 holds for them f is convex there, and a point that no direction leads down from is the
 * closest. Newton's method finds it from the value of an expression.
 *
 * Elsewhere: given eta, xi = N/D with N = (xS - c0 - c2 eta) . (c1 + c3 eta) and D = a(eta); put into (8) that leaves
 *     P(eta) = (q2 - eta c22) D^2 + N' N D - D' N^2 / 2,      q = xS - c0, qi = q . ci, cij = ci . cj,
 * of degree 5.  Its roots in [-1,1], isolated in the Bernstein basis, are all stationary points inside; the closest of
 * them and of the four edges, which are straight, is the answer. */
#include "../generated/footpoint_quad4.h"
#include "attach.h"

#include <float.h>

enum { DEGREE = 5, MAX_STEPS = 8, MAX_DEPTH = 32, MAX_SECANTS = 60 };

/* Newton's method is done when its next step would be below this. */
#define NEXT_STEP 1e-10

/* Intervals of eta are halved down to this, within MAX_DEPTH. */
#define MIN_WIDTH 1e-9

/* What the distance is made of: vectors, and their scalar products. */
struct segment {
    double c1[3], c2[3], c3[3], q[3];
    double c11, c12, c13, c22, c23, c33, q1, q2, q3;
};

static void set_segment(struct segment *f, const double x[4][3], const double xs[3])
{
    for (int i = 0; i < 3; i++) {
        const double ab = x[1][i] - x[0][i], dc = x[2][i] - x[3][i], ad = x[3][i] - x[0][i], bc = x[2][i] - x[1][i];
        f->c1[i] = 0.25 * (ab + dc);
        f->c2[i] = 0.25 * (ad + bc);
        f->c3[i] = 0.25 * (dc - ab);
        f->q[i] = (xs[i] - x[0][i]) - (f->c1[i] + f->c2[i] - f->c3[i]);
    }
    f->c11 = vector_dot(f->c1, f->c1);
    f->c12 = vector_dot(f->c1, f->c2);
    f->c13 = vector_dot(f->c1, f->c3);
    f->c22 = vector_dot(f->c2, f->c2);
    f->c23 = vector_dot(f->c2, f->c3);
    f->c33 = vector_dot(f->c3, f->c3);
    f->q1 = vector_dot(f->q, f->c1);
    f->q2 = vector_dot(f->q, f->c2);
    f->q3 = vector_dot(f->q, f->c3);
}

/* Not above the least of c + 2 b t + a t^2 for t in [-1,1]. */
static double below(double c, double b, double a)
{
    return fabs(b) < a ? c - fabs(b) : c - 2.0 * fabs(b) + a;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* The largest |m| over the segment, at a corner. */
static double most_mixed(const struct segment *f)
{
    const double m = f->c12 - f->q3, sum = 2.0 * (f->c13 + f->c23), difference = 2.0 * (f->c13 - f->c23);
    const double even = fabs(m + 2.0 * f->c33) + fabs(sum), odd = fabs(m - 2.0 * f->c33) + fabs(difference);
    return larger(even, odd);
}

/* Whether f is convex over the whole segment; false if that does not show. */
static int convex(const struct segment *f)
{
    const double a = below(f->c11, f->c13, f->c33), b = below(f->c22, f->c23, f->c33), m = most_mixed(f);
    return a > 0.0 && b > 0.0 && a * b > (1.0 + 1e-6) * m * m;
}

static struct model model_of(const struct segment *f, double u, double v)
{
    struct model m;
    m.h00 = f->c11 + v * (2.0 * f->c13 + v * f->c33);
    m.h11 = f->c22 + u * (2.0 * f->c23 + u * f->c33);
    m.h01 = f->c12 - f->q3 + 2.0 * (u * f->c13 + v * (f->c23 + u * f->c33));
    m.g[0] = u * m.h00 - (f->q1 + v * (f->q3 - f->c12 - v * f->c23));
    m.g[1] = v * m.h11 - (f->q2 + u * (f->q3 - f->c12 - u * f->c13));
    return m;
}

/* Newton's method within the segment; 1 when it has settled: the next step would be at most the third and fourth
 * derivatives of f times the square of the last one, through the inverse of the Hessian. */
static int settle(const struct segment *f, double loc[2])
{
    const double bend = 2.0 * (fabs(f->c13) + fabs(f->c23)) + 8.0 * f->c33;
    for (int n = 0; n < MAX_STEPS; n++) {
        const struct model m = model_of(f, loc[0], loc[1]);
        const double det = m.h00 * m.h11 - m.h01 * m.h01;
        double move[2];
        if (!(det > 0.0))
            return 0;
        least_in_square(&m, loc, move);
        loc[0] = clamp(loc[0] + move[0], -1.0, 1.0);
        loc[1] = clamp(loc[1] + move[1], -1.0, 1.0);
        if (bend * (move[0] * move[0] + move[1] * move[1]) * (m.h00 + m.h11) <= NEXT_STEP * det)
            return 1;
    }
    return 0;
}

/* ---- the certain way -------------------------------------------------------------------------------------------- */

static double numerator(const struct segment *f, double v)
{
    return f->q1 + v * (f->q3 - f->c12 - v * f->c23);
}

static double denominator(const struct segment *f, double v)
{
    return f->c11 + v * (2.0 * f->c13 + v * f->c33);
}

static double quintic(const struct segment *f, double v)
{
    const double n = numerator(f, v), d = denominator(f, v), n1 = f->q3 - f->c12 - 2.0 * v * f->c23;
    return (f->q2 - v * f->c22) * d * d + n1 * n * d - (f->c13 + v * f->c33) * n * n;
}

/* Product of two polynomials of degree n and m, all in the Bernstein basis. */
static void multiply(int n, const double *a, int m, const double *b, double *product)
{
    static const double binomial[6][6] = {{1, 0, 0, 0, 0, 0}, {1, 1, 0, 0, 0, 0}, {1, 2, 1, 0, 0, 0},
                                          {1, 3, 3, 1, 0, 0}, {1, 4, 6, 4, 1, 0}, {1, 5, 10, 10, 5, 1}};
    for (int k = 0; k <= n + m; k++) {
        double sum = 0.0;
        for (int i = k > m ? k - m : 0; i <= (k < n ? k : n); i++)
            sum += binomial[n][i] * a[i] * binomial[m][k - i] * b[k - i];
        product[k] = sum / binomial[n + m][k];
    }
}

/* Bernstein coefficients of P on [-1,1], from those of its factors, and *noise, which bounds what is rounding in them.
 */
static void bernstein(const struct segment *f, double p[DEGREE + 1], double *noise)
{
    const double l = f->q3 - f->c12;
    const double n[3] = {f->q1 - l - f->c23, f->q1 + f->c23, f->q1 + l - f->c23};
    const double d[3] = {f->c11 - 2.0 * f->c13 + f->c33, f->c11 - f->c33, f->c11 + 2.0 * f->c13 + f->c33};
    const double n1[2] = {l + 2.0 * f->c23, l - 2.0 * f->c23}, d1[2] = {f->c13 - f->c33, f->c13 + f->c33};
    const double r[2] = {f->q2 + f->c22, f->q2 - f->c22};
    double square2[5], first[6], second[6], third[6], most = 0.0;
    multiply(2, d, 2, d, square2);
    multiply(1, r, 4, square2, first);
    multiply(2, n, 2, d, square2);
    multiply(1, n1, 4, square2, second);
    multiply(2, n, 2, n, square2);
    multiply(1, d1, 4, square2, third);
    for (int i = 0; i <= DEGREE; i++) {
        p[i] = first[i] + second[i] - third[i];
        most = larger(most, fabs(first[i]) + fabs(second[i]) + fabs(third[i]));
    }
    *noise = 64.0 * DBL_EPSILON * most;
}

/* The closest point so far, of a segment. */
struct best {
    double loc[2], square;
};

/* Takes part: the point that belongs to a root v. */
static void consider(const struct segment *f, double v, struct best *best)
{
    const double d = denominator(f, v), u = d > 0.0 ? clamp(numerator(f, v) / d, -1.0, 1.0) : 0.0;
    double away[3];
    for (int i = 0; i < 3; i++)
        away[i] = f->q[i] - u * f->c1[i] - v * (f->c2[i] + u * f->c3[i]);
    const double square_distance = vector_dot(away, away);
    if (square_distance < best->square) {
        best->square = square_distance;
        best->loc[0] = u;
        best->loc[1] = v;
    }
}

/* The root between low and high, where signs differ, by secants that keep it bracketed (Illinois). */
static double root_between(const struct segment *f, double low, double high)
{
    double at_low = quintic(f, low), at_high = quintic(f, high), v = 0.5 * (low + high), moved = 1.0;
    for (int n = 0; n < MAX_SECANTS && moved > 1e-9; n++) {
        v = (low * at_high - high * at_low) / (at_high - at_low);
        const double at = quintic(f, v);
        if (at * at_high < 0.0) {
            low = high;
            at_low = at_high;
        } else {
            at_low *= 0.5;
        }
        moved = fabs(v - high);
        high = v;
        at_high = at;
    }
    return v;
}

/* How often the coefficients change sign, those within the noise left out. */
static int sign_changes(const double p[DEGREE + 1], double noise)
{
    int changes = 0, last = 0;
    for (int i = 0; i <= DEGREE; i++) {
        const int sign = (p[i] > noise) - (p[i] < -noise);
        changes += sign * last < 0;
        last = sign != 0 ? sign : last;
    }
    return changes;
}

/* p, over an interval, to its halves (de Casteljau). */
static void halve(const double p[DEGREE + 1], double left[DEGREE + 1], double right[DEGREE + 1])
{
    for (int i = 0; i <= DEGREE; i++)
        right[i] = p[i];
    for (int n = 0; n <= DEGREE; n++) {
        left[n] = right[0];
        for (int i = 0; i < DEGREE - n; i++)
            right[i] = 0.5 * (right[i] + right[i + 1]);
    }
}

/* An interval of v, and P there in its Bernstein basis. */
struct interval {
    double low, high, p[DEGREE + 1];
};

/* Every root in [-1,1] takes part; of roots that rounding cannot tell apart, one does. */
static void consider_roots(const struct segment *f, struct best *best)
{
    struct interval stack[MAX_DEPTH + 1];
    double noise;
    int count = 1;
    stack[0].low = -1.0;
    stack[0].high = 1.0;
    bernstein(f, stack[0].p, &noise);
    while (count > 0) {
        const struct interval top = stack[--count];
        const double middle = 0.5 * (top.low + top.high);
        const int changes = sign_changes(top.p, noise);
        if (changes == 0)
            continue;
        if (changes == 1 && quintic(f, top.low) * quintic(f, top.high) < 0.0) {
            consider(f, root_between(f, top.low, top.high), best);
            continue;
        }
        if (top.high - top.low < MIN_WIDTH) {
            consider(f, middle, best);
            continue;
        }
        struct interval *const left = &stack[count], *const right = &stack[count + 1];
        halve(top.p, left->p, right->p);
        left->low = top.low;
        left->high = right->low = middle;
        right->high = top.high;
        if (fabs(right->p[0]) <= noise) /* a root that the halves may each take for the other's */
            consider(f, middle, best);
        count += 2;
    }
}

static void search(const struct segment *f, const double x[4][3], const double xs[3], double loc[2])
{
    struct best best = {{0.0, 0.0}, HUGE_VAL};
    best.square = footpoint_attach_edges(4, x, square, xs, best.loc);
    consider_roots(f, &best);
    loc[0] = best.loc[0];
    loc[1] = best.loc[1];
    /* The digits that the quintic has lost; far moves are no part of that. */
    if (!settle(f, loc) || fabs(loc[0] - best.loc[0]) > 1e-3 || fabs(loc[1] - best.loc[1]) > 1e-3) {
        loc[0] = best.loc[0];
        loc[1] = best.loc[1];
    }
}

void footpoint_attach_quad4(const double x[4][3], const double xs[3], double loc[2])
{
    struct segment f;
    set_segment(&f, x, xs);
    if (convex(&f)) {
        footpoint_quad4_coarse_at(x[0], x[1], x[2], x[3], xs, &loc[0], &loc[1]);
        if (!(fabs(loc[0]) + fabs(loc[1]) < HUGE_VAL))
            loc[0] = loc[1] = 0.0;
        loc[0] = clamp(loc[0], -1.0, 1.0);
        loc[1] = clamp(loc[1], -1.0, 1.0);
        if (settle(&f, loc))
            return;
    }
    search(&f, x, xs, loc);
}
