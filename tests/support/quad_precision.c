/* See quad_precision.h. */
#include "quad_precision.h"

#include <math.h>

static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};

/* Powers of xi and eta of the monomials; six nodes have the first six, and eight all but the last. */
static const int power_all[MOST_NODES][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2}};

/* x^power, and its derivatives. */
static quadruple power_of(quadruple x, int power, int derivative)
{
    quadruple y = 1;
    for (int i = 0; i < derivative; i++)
        y *= power - i;
    for (int i = derivative; i < power; i++)
        y *= x;
    return power < derivative ? 0 : y;
}

static quadruple monomial(int m, quadruple xi, quadruple eta, int by_xi, int by_eta)
{
    return power_of(xi, power_all[m][0], by_xi) * power_of(eta, power_all[m][1], by_eta);
}

static double magnitude(quadruple x)
{
    return fabs((double)x);
}

/* Solves for all right sides at once, by Gauss and Jordan; a is left the identity. */
static void solve(int n, quadruple a[MOST_NODES][MOST_NODES], quadruple b[MOST_NODES][MOST_NODES])
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k; i < n; i++)
            best = magnitude(a[i][k]) > magnitude(a[best][k]) ? i : best;
        for (int j = 0; j < n; j++) {
            const quadruple s = a[k][j], t = b[k][j];
            a[k][j] = a[best][j];
            b[k][j] = b[best][j];
            a[best][j] = s;
            b[best][j] = t;
        }
        const quadruple pivot = a[k][k];
        for (int j = 0; j < n; j++) {
            a[k][j] /= pivot;
            b[k][j] /= pivot;
        }
        for (int i = 0; i < n; i++) {
            const quadruple factor = a[i][k];
            for (int j = 0; j < n && i != k; j++) {
                a[i][j] -= factor * a[k][j];
                b[i][j] -= factor * b[k][j];
            }
        }
    }
}

struct exact_face exact_face_of(int nodes)
{
    struct exact_face f = {.nodes = nodes, .place = nodes % 3 == 0 && nodes < 9 ? triangle : square};
    quadruple at[MOST_NODES][MOST_NODES] = {{0}}, unit[MOST_NODES][MOST_NODES] = {{0}};
    for (int k = 0; k < nodes; k++)
        for (int m = 0; m < nodes; m++) {
            at[k][m] = monomial(m, f.place[k][0], f.place[k][1], 0, 0);
            unit[k][m] = k == m;
        }
    solve(nodes, at, unit);
    for (int k = 0; k < nodes; k++)
        for (int m = 0; m < nodes; m++)
            f.shape[k][m] = unit[m][k];
    return f;
}

static quadruple shape(const struct exact_face *f, int k, quadruple xi, quadruple eta, int by_xi, int by_eta)
{
    quadruple sum = 0;
    for (int m = 0; m < f->nodes; m++)
        sum += f->shape[k][m] * monomial(m, xi, eta, by_xi, by_eta);
    return sum;
}

static void point(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta, int by_xi, int by_eta,
                  quadruple r[3])
{
    r[0] = r[1] = r[2] = 0;
    for (int k = 0; k < f->nodes; k++) {
        const quadruple weight = shape(f, k, xi, eta, by_xi, by_eta);
        for (int i = 0; i < 3; i++)
            r[i] += weight * x[3 * k + i];
    }
}

quadruple exact_dot(const quadruple a[3], const quadruple b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Newton's iteration, from a root that is right to 50 binary digits. */
static quadruple root_of(quadruple x)
{
    quadruple root = sqrt((double)x);
    for (int i = 0; i < 2; i++)
        root = 0.5 * (root + x / root);
    return root;
}

void exact_unit(quadruple v[3])
{
    const quadruple length = root_of(exact_dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

void exact_normal(const quadruple a[3], const quadruple b[3], quadruple n[3])
{
    for (int i = 0; i < 3; i++)
        n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    exact_unit(n);
}

void exact_point(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta, quadruple r[3],
                 quadruple normal[3])
{
    quadruple a[3], b[3];
    point(f, x, xi, eta, 0, 0, r);
    point(f, x, xi, eta, 1, 0, a);
    point(f, x, xi, eta, 0, 1, b);
    exact_normal(a, b, normal);
}

double exact_condition(quadruple h11, quadruple h12, quadruple h22)
{
    const double mean = (double)(h11 + h22) / 2, difference = (double)(h11 - h22) / 2;
    const double away = hypot(difference, (double)h12), large = fabs(mean) + away;
    return large / fabs((double)(h11 * h22 - h12 * h12) / large);
}

bool exact_foot_near(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta,
                     struct exact_foot *foot)
{
    enum { STEPS = 60 };
    quadruple r[3], a[3], b[3], aa[3], ab[3], bb[3], d[3];
    double last = 1;
    for (int step = 0; step < STEPS && last > 1e-27; step++) {
        point(f, x, xi, eta, 0, 0, r);
        point(f, x, xi, eta, 1, 0, a);
        point(f, x, xi, eta, 0, 1, b);
        point(f, x, xi, eta, 2, 0, aa);
        point(f, x, xi, eta, 1, 1, ab);
        point(f, x, xi, eta, 0, 2, bb);
        for (int i = 0; i < 3; i++)
            d[i] = x[3 * f->nodes + i] - r[i];
        const quadruple h11 = exact_dot(a, a) - exact_dot(d, aa), h12 = exact_dot(a, b) - exact_dot(d, ab),
                        h22 = exact_dot(b, b) - exact_dot(d, bb);
        const quadruple det = h11 * h22 - h12 * h12, f1 = exact_dot(a, d), f2 = exact_dot(b, d);
        const quadruple u = (h22 * f1 - h12 * f2) / det, v = (h11 * f2 - h12 * f1) / det;
        xi += u;
        eta += v;
        last = magnitude(u) + magnitude(v);
        foot->condition =
            fmax(exact_condition(h11, h12, h22), exact_condition(exact_dot(a, a), exact_dot(a, b), exact_dot(b, b)));
    }
    if (!(last <= 1e-27))
        return false;
    foot->xi = xi;
    foot->eta = eta;
    exact_point(f, x, xi, eta, r, foot->normal);
    for (int i = 0; i < 3; i++)
        d[i] = x[3 * f->nodes + i] - r[i];
    foot->gap = exact_dot(d, foot->normal);
    for (int k = 0; k < f->nodes; k++)
        foot->phi[k] = shape(f, k, xi, eta, 0, 0);
    return true;
}
