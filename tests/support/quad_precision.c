/* Computes foot points in quadruple precision; see quad_precision.h. */
#include "quad_precision.h"

#include <math.h>

static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};

/* Powers of xi and eta of the monomials; six nodes have the first six, and eight all but the last. */
static const int power_all[MOST_NODES][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2}};

/* Computes 1, x and x^2, or their derivatives. */
static void powers(quadruple x, int derivative, quadruple y[3])
{
    y[0] = derivative == 0;
    y[1] = derivative == 0 ? x : derivative == 1;
    y[2] = derivative == 0 ? x * x : derivative == 1 ? 2 * x : 2;
}

/* Computes the monomials, or their derivatives. */
static void monomials(quadruple xi, quadruple eta, int by_xi, int by_eta, quadruple value[MOST_NODES])
{
    quadruple u[3], v[3];
    powers(xi, by_xi, u);
    powers(eta, by_eta, v);
    for (int m = 0; m < MOST_NODES; m++)
        value[m] = power_all[m][0] < by_xi || power_all[m][1] < by_eta ? 0 : u[power_all[m][0]] * v[power_all[m][1]];
}

static double magnitude(quadruple x)
{
    return fabs((double)x);
}

/* Solves for all right sides at once, by Gauss and Jordan; a becomes the identity. */
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
    for (int k = 0; k < nodes; k++) {
        monomials(f.place[k][0], f.place[k][1], 0, 0, at[k]);
        unit[k][k] = 1;
    }
    solve(nodes, at, unit);
    for (int k = 0; k < nodes; k++)
        for (int m = 0; m < nodes; m++)
            f.shape[k][m] = unit[m][k];
    return f;
}

/* A face as a polynomial: the factor of each monomial. */
struct polynomial {
    int terms;
    quadruple factor[MOST_NODES][3];
};

static struct polynomial expand(const struct exact_face *f, const quadruple *x)
{
    struct polynomial p = {.terms = f->nodes};
    for (int k = 0; k < f->nodes; k++)
        for (int m = 0; m < f->nodes; m++)
            for (int i = 0; i < 3 && f->shape[k][m] != 0; i++)
                p.factor[m][i] += f->shape[k][m] * x[3 * k + i];
    return p;
}

static void point(const struct polynomial *p, quadruple xi, quadruple eta, int by_xi, int by_eta, quadruple r[3])
{
    quadruple weight[MOST_NODES];
    monomials(xi, eta, by_xi, by_eta, weight);
    r[0] = r[1] = r[2] = 0;
    for (int m = 0; m < p->terms; m++)
        for (int i = 0; i < 3 && weight[m] != 0; i++)
            r[i] += weight[m] * p->factor[m][i];
}

quadruple exact_dot(const quadruple a[3], const quadruple b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns a root by Newton's iteration, from a root that is right to 50 binary digits. */
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
    const struct polynomial p = expand(f, x);
    quadruple a[3], b[3];
    point(&p, xi, eta, 0, 0, r);
    point(&p, xi, eta, 1, 0, a);
    point(&p, xi, eta, 0, 1, b);
    exact_normal(a, b, normal);
}

double exact_condition(quadruple h11, quadruple h12, quadruple h22)
{
    const double mean = (double)(h11 + h22) / 2, difference = (double)(h11 - h22) / 2;
    const double away = hypot(difference, (double)h12), large = fabs(mean) + away;
    return large / fabs((double)(h11 * h22 - h12 * h12) / large);
}

/* A point of the face: the vector to the slave node, the tangents, and the slopes of half the squared distance. */
struct place {
    quadruple d[3], a[3], b[3], slope[2];
};

static struct place place_at(const struct polynomial *p, const quadruple *slave, quadruple xi, quadruple eta)
{
    struct place at;
    point(p, xi, eta, 0, 0, at.d);
    point(p, xi, eta, 1, 0, at.a);
    point(p, xi, eta, 0, 1, at.b);
    for (int i = 0; i < 3; i++)
        at.d[i] = slave[i] - at.d[i];
    at.slope[0] = -exact_dot(at.a, at.d);
    at.slope[1] = -exact_dot(at.b, at.d);
    return at;
}

/* Steps towards slopes of 0 by the inverse of the Hessian in `foot`; returns the step's length. */
static double step_down(struct exact_foot *foot, const quadruple slope[2])
{
    const quadruple u = foot->inverse[0] * slope[0] + foot->inverse[1] * slope[1];
    const quadruple v = foot->inverse[1] * slope[0] + foot->inverse[2] * slope[1];
    foot->xi -= u;
    foot->eta -= v;
    return magnitude(u) + magnitude(v);
}

static void finish(const struct exact_face *f, const struct polynomial *p, const quadruple *slave,
                   struct exact_foot *foot)
{
    const struct place at = place_at(p, slave, foot->xi, foot->eta);
    quadruple weight[MOST_NODES];
    exact_normal(at.a, at.b, foot->normal);
    foot->gap = exact_dot(at.d, foot->normal);
    monomials(foot->xi, foot->eta, 0, 0, weight);
    for (int k = 0; k < f->nodes; k++) {
        foot->phi[k] = 0;
        for (int m = 0; m < f->nodes; m++)
            if (f->shape[k][m] != 0)
                foot->phi[k] += f->shape[k][m] * weight[m];
    }
}

void exact_inverse(quadruple h11, quadruple h12, quadruple h22, quadruple inverse[3])
{
    const quadruple det = h11 * h22 - h12 * h12;
    inverse[0] = h22 / det;
    inverse[1] = -h12 / det;
    inverse[2] = h11 / det;
}

bool exact_foot_near(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta,
                     struct exact_foot *foot)
{
    enum { STEPS = 60 };
    const struct polynomial p = expand(f, x);
    const quadruple *const slave = x + 3 * f->nodes;
    double last = 1;
    foot->xi = xi;
    foot->eta = eta;
    for (int step = 0; step < STEPS && last > 1e-27; step++) {
        const struct place at = place_at(&p, slave, foot->xi, foot->eta);
        quadruple aa[3], ab[3], bb[3];
        point(&p, foot->xi, foot->eta, 2, 0, aa);
        point(&p, foot->xi, foot->eta, 1, 1, ab);
        point(&p, foot->xi, foot->eta, 0, 2, bb);
        const quadruple g11 = exact_dot(at.a, at.a), g12 = exact_dot(at.a, at.b), g22 = exact_dot(at.b, at.b);
        const quadruple h11 = g11 - exact_dot(at.d, aa), h12 = g12 - exact_dot(at.d, ab);
        const quadruple h22 = g22 - exact_dot(at.d, bb);
        exact_inverse(h11, h12, h22, foot->inverse);
        foot->condition = fmax(exact_condition(h11, h12, h22), exact_condition(g11, g12, g22));
        last = step_down(foot, at.slope);
    }
    finish(f, &p, slave, foot);
    return last <= 1e-27;
}

bool exact_foot_beside(const struct exact_face *f, const quadruple *x, quadruple xi, quadruple eta,
                       const struct exact_foot *known, struct exact_foot *foot)
{
    enum { STEPS = 10 };
    const struct polynomial p = expand(f, x);
    const quadruple *const slave = x + 3 * f->nodes;
    double last = 1;
    *foot = *known;
    foot->xi = xi;
    foot->eta = eta;
    for (int step = 0; step < STEPS && last > 1e-19; step++)
        last = step_down(foot, place_at(&p, slave, foot->xi, foot->eta).slope);
    finish(f, &p, slave, foot);
    return last <= 1e-19;
}
