/* Finds certain closest points of curved faces; see curved_face.h. */
#include "curved_face.h"

#include <math.h>
#include <string.h>

typedef long double real;

/* A box of the square of a and b, with the coefficients of a polynomial of degree 4 in each. */
struct box {
    real a, b, wide, high;
};

static void point_of(const struct curved_face *f, real a, real b, double loc[2])
{
    loc[0] = (double)(f->triangle ? a * (1 - b) : 2 * a - 1);
    loc[1] = (double)(f->triangle ? b : 2 * b - 1);
}

void curved_face_of(struct curved_face *f, int nodes, double (*x)[3], const double xs[3])
{
    static const int quad[3][3] = {{0, 7, 3}, {4, 8, 6}, {1, 5, 2}}, three[3][3] = {{0, 5, 2}, {3, -1, 2}, {1, 4, 2}};
    f->triangle = nodes == 6;
    for (int k = 0; k < 3; k++) {
        real y[3][3]; /* values at the halves */
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                const int n = f->triangle ? three[i][j] : quad[i][j];
                y[i][j] = n >= 0 && n < nodes ? (real)x[n][k] : 0;
            }
        if (nodes == 6) /* xi = 1/4, eta = 1/2 */
            y[1][1] = (-(real)x[0][k] - x[1][k]) / 8 + (real)x[3][k] / 4 + (real)x[4][k] / 2 + (real)x[5][k] / 2;
        if (nodes == 8)
            y[1][1] =
                ((real)x[4][k] + x[5][k] + x[6][k] + x[7][k]) / 2 - ((real)x[0][k] + x[1][k] + x[2][k] + x[3][k]) / 4;
        for (int i = 0; i < 3; i++)
            y[i][1] = 2 * y[i][1] - (y[i][0] + y[i][2]) / 2;
        for (int j = 0; j < 3; j++)
            y[1][j] = 2 * y[1][j] - (y[0][j] + y[2][j]) / 2;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                f->net[i][j][k] = y[i][j] - xs[k];
    }
}

void curved_face_point(const struct curved_face *f, double xi, double eta, double r[3])
{
    const real b = f->triangle ? (real)eta : (1 + (real)eta) / 2,
               a = f->triangle ? (b == 1 ? 0 : xi / (1 - b)) : (1 + (real)xi) / 2;
    const real p[3] = {(1 - a) * (1 - a), 2 * a * (1 - a), a * a}, q[3] = {(1 - b) * (1 - b), 2 * b * (1 - b), b * b};
    for (int k = 0; k < 3; k++) {
        real sum = 0;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                sum += p[i] * q[j] * f->net[i][j][k];
        r[k] = (double)sum;
    }
}

/* ---- halves ---- */

enum { MOST = 5 };

/* Computes the coefficients of the two halves of `n` in a row, `stride` apart. */
static void halve_row(const real *c, int n, int stride, real *low, real *high)
{
    real w[MOST];
    for (int i = 0; i < n; i++)
        w[i] = c[i * stride];
    for (int i = 0; i < n; i++) {
        low[i * stride] = w[0];
        high[(n - 1 - i) * stride] = w[n - 1 - i];
        for (int k = 0; k + 1 < n - i; k++)
            w[k] = (w[k] + w[k + 1]) / 2;
    }
}

static void halve(const real *c, int n, bool in_a, real *low, real *high)
{
    for (int i = 0; i < n; i++)
        if (in_a)
            halve_row(c + i, n, n, low + i, high + i);
        else
            halve_row(c + n * i, n, 1, low + n * i, high + n * i);
}

/* Returns true if a box is wider in xi: near the corner C of a triangle its extent is small. */
static bool is_wide(const struct curved_face *f, const struct box *x)
{
    return x->wide * (f->triangle ? 1 - x->b : 1) > x->high;
}

static struct box half_of(const struct box *x, bool in_a, bool upper)
{
    struct box h = *x;
    if (in_a) {
        h.wide /= 2;
        h.a += upper ? h.wide : 0;
    } else {
        h.high /= 2;
        h.b += upper ? h.high : 0;
    }
    return h;
}

static real extent(const struct curved_face *f, const struct box *x)
{
    return fmaxl(x->wide * (f->triangle ? 1 - x->b : 1), x->high);
}

/* ---- the closest point ---- */

struct nearest {
    const struct curved_face *face;
    real square, a, b;
};

static real least_of(const real *c, int count)
{
    real least = c[0];
    for (int i = 1; i < count; i++)
        least = fminl(least, c[i]);
    return least;
}

static void search_nearest(struct nearest *n, const struct box *x, const real c[25])
{
    for (int corner = 0; corner < 4; corner++) {
        const real value = c[(corner & 1 ? 20 : 0) + (corner & 2 ? 4 : 0)];
        if (value < n->square) {
            n->square = value;
            n->a = x->a + (corner & 1 ? x->wide : 0);
            n->b = x->b + (corner & 2 ? x->high : 0);
        }
    }
    if (extent(n->face, x) < 1e-9L)
        return;
    real half[2][25], least[2];
    const bool in_a = is_wide(n->face, x);
    halve(c, 5, in_a, half[0], half[1]);
    for (int i = 0; i < 2; i++)
        least[i] = least_of(half[i], 25);
    const int first = least[1] < least[0];
    for (int i = 0; i < 2; i++) {
        const int k = i ? !first : first;
        const struct box h = half_of(x, in_a, k);
        if (least[k] < n->square)
            search_nearest(n, &h, half[k]);
    }
}

/* Computes value, derivative and second derivative of B_i of degree 2. */
static void basis(real t, real b[3][3])
{
    const real value[3][3] = {{(1 - t) * (1 - t), 2 * t * (1 - t), t * t}, {2 * t - 2, 2 - 4 * t, 2 * t}, {2, -4, 2}};
    memcpy(b, value, sizeof value);
}

/* Polishes the nearest point by Newton's steps for the gradient of the squared distance, in the coordinates that are not at an end of
 * their range; boxes end at the rounding of that square. */
static void polish(struct nearest *n)
{
    const bool free_a = n->a > 0 && n->a < 1 && (n->b < 1 || !n->face->triangle), free_b = n->b > 0 && n->b < 1;
    for (int step = 0; step < 3 && (free_a || free_b); step++) {
        real p[3][3], q[3][3], d[6][3] = {{0}}, g[2] = {0}, h[3] = {0};
        basis(n->a, p);
        basis(n->b, q);
        for (int k = 0; k < 3; k++) {
            static const int order[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
            for (int row = 0; row < 6; row++)
                for (int i = 0; i < 9; i++)
                    d[row][k] += p[order[row][0]][i / 3] * q[order[row][1]][i % 3] * n->face->net[i / 3][i % 3][k];
            g[0] += free_a ? d[0][k] * d[1][k] : 0;
            g[1] += free_b ? d[0][k] * d[2][k] : 0;
            h[0] += d[1][k] * d[1][k] + d[0][k] * d[3][k];
            h[1] += free_a && free_b ? d[1][k] * d[2][k] + d[0][k] * d[4][k] : 0;
            h[2] += d[2][k] * d[2][k] + d[0][k] * d[5][k];
        }
        const real determinant = h[0] * h[2] - h[1] * h[1];
        const real a = (h[2] * g[0] - h[1] * g[1]) / determinant, b = (h[0] * g[1] - h[1] * g[0]) / determinant;
        if (!(fabsl(a) + fabsl(b) < 1e-6L)) /* not a minimum itself */
            return;
        n->a = fminl(1, fmaxl(0, n->a - a));
        n->b = fminl(1, fmaxl(0, n->b - b));
    }
}

/* Returns the squared distance of the point itself; the search's own has lost digits. */
static real square_at(const struct nearest *n)
{
    real p[3][3], q[3][3], square = 0;
    basis(n->a, p);
    basis(n->b, q);
    for (int k = 0; k < 3; k++) {
        real r = 0;
        for (int i = 0; i < 9; i++)
            r += p[0][i / 3] * q[0][i % 3] * n->face->net[i / 3][i % 3][k];
        square += r * r;
    }
    return square;
}

double curved_face_closest(const struct curved_face *f, double loc[2])
{
    static const real two[3] = {1, 2, 1}, four[5] = {1, 4, 6, 4, 1};
    real c[25] = {0};
    for (int i = 0; i < 9; i++)
        for (int j = 0; j < 9; j++) {
            const int u = i / 3 + j / 3, v = i % 3 + j % 3;
            const real w = two[i / 3] * two[j / 3] * two[i % 3] * two[j % 3] / (four[u] * four[v]);
            for (int k = 0; k < 3; k++)
                c[5 * u + v] += w * f->net[i / 3][i % 3][k] * f->net[j / 3][j % 3][k];
        }
    struct nearest n = {f, INFINITY, 0, 0};
    search_nearest(&n, &(struct box){0, 0, 1, 1}, c);
    const real found = square_at(&n);
    polish(&n);
    point_of(f, n.a, n.b, loc);
    return (double)sqrtl(fminl(found, square_at(&n)));
}
