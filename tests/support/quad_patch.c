/* See quad_patch.h; equations (45)-(50), and for the twins those of runtime/geometry/gregory.c. */
#include "quad_patch.h"

#include <math.h>
#include <string.h>

typedef quadruple point[3];

struct net {
    point p[4][4], twin[2][2]; /* twin[i - 1][j - 1]: P_ij as the edges along eta want it */
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

/* A corner, and from it a third of an edge in the plane normal to n. */
static void handle(const point from, const point to, const point n, point p)
{
    point d;
    combine(1, to, -1, from, d);
    const quadruple along = exact_dot(d, n);
    for (int k = 0; k < 3; k++)
        p[k] = from[k] + (d[k] - along * n[k]) / 3;
}

/* The two inner points beside an edge p0 ... p3, from the row beside it at its ends, q0 and q3, and the normals there. */
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

/* Casteljau's algorithm; the four points are overwritten. */
static void casteljau(point p[4], quadruple t, point r)
{
    for (int n = 3; n > 0; n--)
        for (int i = 0; i < n; i++)
            combine(1 - t, p[i], t, p[i + 1], p[i]);
    memcpy(r, p[0], sizeof(point));
}

static void evaluate(bool twins, const struct net *net, quadruple xi, quadruple eta, point r)
{
    const quadruple s = (1 + xi) / 2, t = (1 + eta) / 2;
    point p[4][4], row[4];
    memcpy(p, net->p, sizeof p);
    for (int i = 0; i < 2 && twins; i++) /* (47)-(50): near an edge its own points count alone */
        for (int j = 0; j < 2; j++) {
            const quadruple u = i ? 1 - s : s, v = j ? 1 - t : t;
            combine(u / (u + v), net->p[i + 1][j + 1], v / (u + v), net->twin[i][j], p[i + 1][j + 1]);
        }
    for (int i = 0; i < 4; i++)
        casteljau(p[i], t, row[i]);
    casteljau(row, s, r);
}

/* A central difference of fourth order. */
static void slope(bool twins, const struct net *net, quadruple xi, quadruple eta, bool by_eta, point d)
{
    const quadruple h = 1e-7;
    point at[4];
    for (int i = 0; i < 4; i++) {
        const quadruple step = (i < 2 ? i - 2 : i - 1) * h;
        evaluate(twins, net, by_eta ? xi : xi + step, by_eta ? eta + step : eta, at[i]);
    }
    for (int k = 0; k < 3; k++)
        d[k] = (8 * (at[2][k] - at[1][k]) - (at[3][k] - at[0][k])) / (12 * h);
}

static void tangents(bool twins, const struct net *net, quadruple xi, quadruple eta, struct patch_foot *at)
{
    at->xi = xi;
    at->eta = eta;
    evaluate(twins, net, xi, eta, at->r);
    slope(twins, net, xi, eta, false, at->r_xi);
    slope(twins, net, xi, eta, true, at->r_eta);
    exact_normal(at->r_xi, at->r_eta, at->normal);
}

void patch_point(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta, struct patch_foot *at)
{
    struct net net;
    make_net(twins, x, &net);
    tangents(twins, &net, xi, eta, at);
}

static void stationary(const quadruple *slave, const struct patch_foot *at, quadruple f[2])
{
    point d;
    combine(1, slave, -1, at->r, d);
    f[0] = -exact_dot(at->r_xi, d);
    f[1] = -exact_dot(at->r_eta, d);
}

bool patch_foot_near(bool twins, const quadruple x[PATCH_COORDINATES], quadruple xi, quadruple eta,
                     struct patch_foot *foot)
{
    enum { STEPS = 40 };
    const quadruple h = 1e-9, *const slave = x + PATCH_COORDINATES - 3;
    struct net net;
    double last = 1;
    make_net(twins, x, &net);
    for (int step = 0; step < STEPS && last > 1e-24; step++) {
        struct patch_foot at, right, above;
        quadruple f[2], by_xi[2], by_eta[2];
        tangents(twins, &net, xi, eta, &at);
        tangents(twins, &net, xi + h, eta, &right);
        tangents(twins, &net, xi, eta + h, &above);
        stationary(slave, &at, f);
        stationary(slave, &right, by_xi);
        stationary(slave, &above, by_eta);
        const quadruple h11 = (by_xi[0] - f[0]) / h, h12 = (by_eta[0] - f[0]) / h;
        const quadruple h21 = (by_xi[1] - f[1]) / h, h22 = (by_eta[1] - f[1]) / h, det = h11 * h22 - h12 * h21;
        const quadruple u = (h12 * f[1] - h22 * f[0]) / det, v = (h21 * f[0] - h11 * f[1]) / det;
        xi += u;
        eta += v;
        last = fabs((double)u) + fabs((double)v);
        foot->condition = fmax(
            exact_condition(h11, h12, h22),
            exact_condition(exact_dot(at.r_xi, at.r_xi), exact_dot(at.r_xi, at.r_eta), exact_dot(at.r_eta, at.r_eta)));
    }
    if (!(last <= 1e-24))
        return false;
    const double condition = foot->condition;
    point d;
    tangents(twins, &net, xi, eta, foot);
    foot->condition = condition;
    combine(1, slave, -1, foot->r, d);
    foot->gap = exact_dot(d, foot->normal);
    return true;
}
