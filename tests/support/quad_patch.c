/* Computes patches; see quad_patch.h; equations (45)-(50), and for the twins those in runtime/geometry/gregory.c. */
#include "quad_patch.h"

#include <math.h>
#include <string.h>

typedef quadruple point[3];

struct net {
    point p[4][4], twin[2][2]; /* twin[i - 1][j - 1]: P_ij of the edges along eta */
};

static void combine(quadruple a, const point x, quadruple b, const point y, point sum)
{
    for (int k = 0; k < 3; k++)
        sum[k] = a * x[k] + b * y[k];
}

static void cross(const point a, const point b, point c)
{
    for (int k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Computes the handle of a corner: a third of an edge in the plane normal to n. */
static void handle(const point from, const point to, const point n, point p)
{
    point d;
    combine(1, to, -1, from, d);
    const quadruple along = exact_dot(d, n);
    for (int k = 0; k < 3; k++)
        p[k] = from[k] + (d[k] - along * n[k]) / 3;
}

/* Computes the two inner points beside an edge p0 ... p3, from the ends of the row beside it, q0 and q3, and the normals there. */
static void smooth(const point p0, const point p1, const point p2, const point p3, const point q0, const point q3,
                   const point n0, const point n3, point q1, point q2)
{
    point c0, c1, c2, a0, a3, g0, g3;
    combine(1, p1, -1, p0, c0);
    combine(1, p2, -1, p1, c1);
    combine(1, p3, -1, p2, c2);
    combine(1, q0, -1, p0, a0);
    combine(1, q3, -1, p3, a3);
    cross(n0, c0, g0);
    cross(n3, c2, g3);
    const quadruple k0 = exact_dot(a0, g0) / exact_dot(c0, c0), h0 = exact_dot(a0, c0) / exact_dot(c0, c0);
    const quadruple k1 = exact_dot(a3, g3) / exact_dot(c2, c2), h1 = exact_dot(a3, c2) / exact_dot(c2, c2);
    for (int k = 0; k < 3; k++) {
        q1[k] = p1[k] + ((k0 + k1) * g0[k] + k0 * g3[k] + 2 * h0 * c1[k] + h1 * c0[k]) / 3;
        q2[k] = p2[k] + (k1 * g0[k] + (k0 + k1) * g3[k] + h0 * c2[k] + 2 * h1 * c1[k]) / 3;
    }
}

static void make_net(bool twins, const quadruple *coordinate, struct net *net)
{
    static const int at[4][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}}, inner[4] = {1, 0, 0, 2}, beside[4] = {1, 0, 3, 2};
    point x[4], n[4];
    memcpy(x, coordinate, sizeof x);
    memcpy(n, coordinate + 12, sizeof n);
    for (int c = 0; c < 4; c++)
        exact_unit(n[c]);
    for (int c = 0; c < 4; c++) {
        const int i = at[c][0], j = at[c][1], m = inner[i], l = inner[j];
        point(*const p)[4] = net->p;
        memcpy(p[i][j], x[c], sizeof(point));
        handle(x[c], x[beside[c]], n[c], p[m][j]);
        handle(x[c], x[3 - c], n[c], p[i][l]);
        for (int k = 0; k < 3; k++)
            p[m][l][k] = p[m][j][k] + p[i][l][k] - p[i][j][k];
    }
    point(*const p)[4] = net->p;
    if (twins) {
        point q[4][2];
        smooth(p[0][0], p[1][0], p[2][0], p[3][0], p[0][1], p[3][1], n[0], n[1], q[0][0], q[0][1]);
        smooth(p[0][3], p[1][3], p[2][3], p[3][3], p[0][2], p[3][2], n[3], n[2], q[1][0], q[1][1]);
        smooth(p[0][0], p[0][1], p[0][2], p[0][3], p[1][0], p[1][3], n[0], n[3], q[2][0], q[2][1]);
        smooth(p[3][0], p[3][1], p[3][2], p[3][3], p[2][0], p[2][3], n[1], n[2], q[3][0], q[3][1]);
        memcpy(p[1][1], q[0][0], sizeof(point));
        memcpy(p[2][1], q[0][1], sizeof(point));
        memcpy(p[1][2], q[1][0], sizeof(point));
        memcpy(p[2][2], q[1][1], sizeof(point));
        memcpy(net->twin[0], q[2], sizeof q[2]);
        memcpy(net->twin[1], q[3], sizeof q[3]);
    }
}

/* Computes Bernstein's polynomials of third degree and their derivatives. */
static void bernstein(quadruple t, quadruple b[4], quadruple d[4])
{
    const quadruple u = 1 - t, tt = t * t, tu = t * u, uu = u * u;
    const quadruple bernstein[4] = {u * uu, 3 * t * uu, 3 * u * tt, t * tt};
    const quadruple derivative[4] = {-3 * uu, 3 * (uu - 2 * tu), 3 * (2 * tu - tt), 3 * tt};
    memcpy(b, bernstein, sizeof bernstein);
    memcpy(d, derivative, sizeof derivative);
}

/* Adds factor x to v. */
static void add(quadruple factor, const point x, point v)
{
    for (int k = 0; k < 3; k++)
        v[k] += factor * x[k];
}

/* Blends by (47)-(50) an inner point, which near an edge is only that edge's own, and adds its change to the tangents. */
static void blend(const struct net *net, int i, int j, quadruple s, quadruple t, quadruple weight, point p,
                  struct patch_foot *at)
{
    const quadruple u = i == 2 ? 1 - s : s, v = j == 2 ? 1 - t : t, sum = u + v;
    point away;
    combine(1, net->p[i][j], -1, net->twin[i - 1][j - 1], away);
    combine(1, net->twin[i - 1][j - 1], u / sum, away, p);
    const quadruple slope = weight / (sum * sum);
    add(i == 2 ? -slope * v : slope * v, away, at->r_xi);
    add(j == 2 ? slope * u : -slope * u, away, at->r_eta);
}

/* Computes the point and its tangents: xi and eta are from -1 to 1, Bernstein's arguments from 0 to 1. */
static void evaluate(bool twins, const struct net *net, quadruple xi, quadruple eta, struct patch_foot *at)
{
    const quadruple s = (1 + xi) / 2, t = (1 + eta) / 2;
    quadruple b_s[4], d_s[4], b_t[4], d_t[4];
    bernstein(s, b_s, d_s);
    bernstein(t, b_t, d_t);
    at->xi = xi;
    at->eta = eta;
    for (int k = 0; k < 3; k++)
        at->r[k] = at->r_xi[k] = at->r_eta[k] = 0;
    for (int i = 0; i < 4; i++) {
        point along = {0}, slope = {0};
        for (int j = 0; j < 4; j++) {
            point p;
            if (twins && i % 3 && j % 3)
                blend(net, i, j, s, t, b_s[i] * b_t[j], p, at);
            else
                memcpy(p, net->p[i][j], sizeof p);
            add(b_t[j], p, along);
            add(d_t[j], p, slope);
        }
        add(b_s[i], along, at->r);
        add(d_s[i], along, at->r_xi);
        add(b_s[i], slope, at->r_eta);
    }
    for (int k = 0; k < 3; k++) {
        at->r_xi[k] /= 2;
        at->r_eta[k] /= 2;
    }
}

void patch_point(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta, struct patch_foot *at)
{
    struct net net;
    make_net(twins, x, &net);
    evaluate(twins, &net, xi, eta, at);
    exact_normal(at->r_xi, at->r_eta, at->normal);
}

/* Computes the slopes of half the squared distance. */
static void stationary(const quadruple *slave, const struct patch_foot *at, quadruple f[2])
{
    point d;
    combine(1, slave, -1, at->r, d);
    f[0] = -exact_dot(at->r_xi, d);
    f[1] = -exact_dot(at->r_eta, d);
}

/* Steps until a step is at most `shortest`, with the inverse of the Hessian in `foot`, or, if `newton`, by differences of the
 * slopes. */
static bool descend(bool twins, const quadruple *x, bool newton, double shortest, struct patch_foot *foot)
{
    enum { STEPS = 40 };
    const quadruple h = 1e-9, *const slave = x + PATCH_COORDINATES - 3;
    struct net net;
    double last = 1;
    make_net(twins, x, &net);
    for (int step = 0; step < STEPS && last > shortest; step++) {
        quadruple f[2];
        evaluate(twins, &net, foot->xi, foot->eta, foot);
        stationary(slave, foot, f);
        if (newton) {
            struct patch_foot right, above;
            quadruple by_xi[2], by_eta[2];
            evaluate(twins, &net, foot->xi + h, foot->eta, &right);
            evaluate(twins, &net, foot->xi, foot->eta + h, &above);
            stationary(slave, &right, by_xi);
            stationary(slave, &above, by_eta);
            const quadruple h11 = (by_xi[0] - f[0]) / h, h22 = (by_eta[1] - f[1]) / h;
            const quadruple h12 = (by_eta[0] - f[0] + by_xi[1] - f[1]) / (2 * h);
            exact_inverse(h11, h12, h22, foot->inverse);
            foot->condition =
                fmax(exact_condition(h11, h12, h22),
                     exact_condition(exact_dot(foot->r_xi, foot->r_xi), exact_dot(foot->r_xi, foot->r_eta),
                                     exact_dot(foot->r_eta, foot->r_eta)));
        }
        const quadruple u = foot->inverse[0] * f[0] + foot->inverse[1] * f[1];
        const quadruple v = foot->inverse[1] * f[0] + foot->inverse[2] * f[1];
        foot->xi -= u;
        foot->eta -= v;
        last = fabs((double)u) + fabs((double)v);
    }
    evaluate(twins, &net, foot->xi, foot->eta, foot);
    exact_normal(foot->r_xi, foot->r_eta, foot->normal);
    point d;
    combine(1, slave, -1, foot->r, d);
    foot->gap = exact_dot(d, foot->normal);
    return last <= shortest;
}

bool patch_foot_near(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta,
                     struct patch_foot *foot)
{
    foot->xi = xi;
    foot->eta = eta;
    return descend(twins, x, true, 1e-24, foot);
}

bool patch_foot_beside(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta,
                       const struct patch_foot *known, struct patch_foot *foot)
{
    *foot = *known;
    foot->xi = xi;
    foot->eta = eta;
    return descend(twins, x, false, 1e-19, foot);
}
