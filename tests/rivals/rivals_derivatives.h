/* Hand-written derivatives of xi, eta and the gap by all coordinates of the nodes and of the slave node, the last of x:
 * by the implicit function theorem, by forward differentiation through Newton's iteration, and by central differences.
 * slope[0], [1] and [2] are the derivatives of xi, eta and the gap. */
#ifndef FOOTPOINT_RIVALS_DERIVATIVES_H
#define FOOTPOINT_RIVALS_DERIVATIVES_H

#include <math.h>

enum { RIVAL_COORDINATES = 30 }; /* most coordinates of a kind */

/* ---- the implicit function theorem ---- */

/** Differentiates (7), (8) of a four-node segment by the nodes, with one division by the determinant. Returns 0 if
 *  there is no normal. */
static inline int rival_implicit(const double (*x)[3], const double loc[2], double *gap,
                                 double (*slope)[RIVAL_COORDINATES])
{
    const double xi = loc[0], eta = loc[1];
    const double phi[5] = {0.25 * (1 - xi) * (1 - eta), 0.25 * (1 + xi) * (1 - eta), 0.25 * (1 + xi) * (1 + eta),
                           0.25 * (1 - xi) * (1 + eta), -1};
    const double by_xi[5] = {-0.25 * (1 - eta), 0.25 * (1 - eta), 0.25 * (1 + eta), -0.25 * (1 + eta), 0};
    const double by_eta[5] = {-0.25 * (1 - xi), -0.25 * (1 + xi), 0.25 * (1 + xi), 0.25 * (1 - xi), 0};
    double a[3], b[3], c[3], d[3], n[3], aa = 0, ab = 0, bb = 0, cd = 0, nn = 0;
    for (int i = 0; i < 3; i++) {
        a[i] = by_xi[1] * (x[1][i] - x[0][i]) + by_xi[2] * (x[2][i] - x[3][i]);
        b[i] = by_eta[2] * (x[2][i] - x[1][i]) + by_eta[3] * (x[3][i] - x[0][i]);
        c[i] = 0.25 * (x[0][i] - x[1][i] + (x[2][i] - x[3][i]));
        d[i] = x[4][i] - (phi[0] * x[0][i] + phi[1] * x[1][i] + phi[2] * x[2][i] + phi[3] * x[3][i]);
        aa += a[i] * a[i];
        ab += a[i] * b[i];
        bb += b[i] * b[i];
        cd += c[i] * d[i];
    }
    for (int i = 0; i < 3; i++) {
        n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        nn += n[i] * n[i];
    }
    const double h12 = ab - cd, over = 1 / (aa * bb - h12 * h12), length = sqrt(nn);
    *gap = 0;
    for (int i = 0; i < 3; i++) {
        n[i] /= length;
        *gap += n[i] * d[i];
    }
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++) {
            const double f = by_xi[k] * d[i] - phi[k] * a[i], g = by_eta[k] * d[i] - phi[k] * b[i];
            slope[0][3 * k + i] = (bb * f - h12 * g) * over;
            slope[1][3 * k + i] = (aa * g - h12 * f) * over;
            slope[2][3 * k + i] = -phi[k] * n[i];
        }
    return nn > 0;
}

/** Differentiates any face. phi contains the shape functions at the foot point and, in the following rows, their
 *  derivatives by xi, eta, xi xi, xi eta and eta eta, in the order of footpoint_KIND_shape. */
static inline int rival_implicit_face(int nodes, const double *phi, const double (*x)[3], double *gap,
                                      double (*slope)[RIVAL_COORDINATES])
{
    double r[6][3], n[3], h[3], nn = 0;
    for (int row = 0; row < 6; row++)
        for (int i = 0; i < 3; i++) {
            r[row][i] = row ? 0 : -x[nodes][i];
            for (int k = 0; k < nodes; k++)
                r[row][i] += phi[nodes * row + k] * x[k][i];
        }
    for (int i = 0; i < 3; i++) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        n[i] = r[1][a] * r[2][b] - r[1][b] * r[2][a];
        nn += n[i] * n[i];
    }
    for (int row = 0; row < 3; row++) {
        const double *const a = r[row < 2 ? 1 : 2], *const b = r[row < 1 ? 1 : 2], *const c = r[3 + row],
                            *const e = r[0];
        h[row] = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + c[0] * e[0] + c[1] * e[1] + c[2] * e[2];
    }
    const double over = 1 / (h[0] * h[2] - h[1] * h[1]), length = sqrt(nn);
    *gap = 0;
    for (int i = 0; i < 3; i++) {
        n[i] /= length;
        *gap -= n[i] * r[0][i];
    }
    for (int k = 0; k <= nodes; k++) {
        const double p = k < nodes ? phi[k] : -1, u = k < nodes ? phi[nodes + k] : 0,
                     v = k < nodes ? phi[2 * nodes + k] : 0;
        for (int i = 0; i < 3; i++) {
            const double f = -u * r[0][i] - p * r[1][i], g = -v * r[0][i] - p * r[2][i];
            slope[0][3 * k + i] = (h[2] * f - h[1] * g) * over;
            slope[1][3 * k + i] = (h[0] * g - h[1] * f) * over;
            slope[2][3 * k + i] = -p * n[i];
        }
    }
    return nn > 0;
}

/* ---- forward differentiation, four nodes ---- */

struct rival_dual {
    double value, slope[15];
};

static inline struct rival_dual rival_add(struct rival_dual a, struct rival_dual b, double times)
{
    a.value += times * b.value;
    for (int k = 0; k < 15; k++)
        a.slope[k] += times * b.slope[k];
    return a;
}

static inline struct rival_dual rival_multiply(struct rival_dual a, struct rival_dual b)
{
    for (int k = 0; k < 15; k++)
        a.slope[k] = a.slope[k] * b.value + a.value * b.slope[k];
    a.value *= b.value;
    return a;
}

static inline struct rival_dual rival_divide(struct rival_dual a, struct rival_dual b)
{
    a.value /= b.value;
    for (int k = 0; k < 15; k++)
        a.slope[k] = (a.slope[k] - a.value * b.slope[k]) / b.value;
    return a;
}

static inline struct rival_dual rival_dual_dot(const struct rival_dual a[3], const struct rival_dual b[3])
{
    return rival_add(rival_add(rival_multiply(a[0], b[0]), rival_multiply(a[1], b[1]), 1), rival_multiply(a[2], b[2]),
                     1);
}

/* Runs Newton's iteration from the centre in dual numbers until it converges, after three Gauss-Newton steps. One more
 * step makes the derivatives converge. */
static inline int rival_forward(const double (*x)[3], double loc[2], double *gap, double (*slope)[RIVAL_COORDINATES])
{
    int last = 0;
    struct rival_dual c[4][3], p[5][3] = {{{0}}}, u = {0}, v = {0}, a[3], b[3], d[3], n[3];
    for (int k = 0; k < 15; k++) {
        p[k / 3][k % 3].value = x[k / 3][k % 3];
        p[k / 3][k % 3].slope[k] = 1;
    }
    for (int i = 0; i < 3; i++)
        for (int m = 0; m < 4; m++) {
            static const double sign[4][4] = {{1, 1, 1, 1}, {-1, 1, 1, -1}, {-1, -1, 1, 1}, {1, -1, 1, -1}};
            c[m][i] = (struct rival_dual){0};
            for (int k = 0; k < 4; k++)
                c[m][i] = rival_add(c[m][i], p[k][i], 0.25 * sign[m][k]);
        }
    for (int step = 0; step < 50 && last < 2; step++) {
        for (int i = 0; i < 3; i++) {
            a[i] = rival_add(c[1][i], rival_multiply(v, c[3][i]), 1);
            b[i] = rival_add(c[2][i], rival_multiply(u, c[3][i]), 1);
            d[i] = rival_add(rival_add(p[4][i], c[0][i], -1), rival_multiply(u, c[1][i]), -1);
            d[i] = rival_add(d[i], rival_multiply(v, b[i]), -1);
        }
        const struct rival_dual h11 = rival_dual_dot(a, a), h22 = rival_dual_dot(b, b);
        const struct rival_dual f = rival_dual_dot(a, d), g = rival_dual_dot(b, d);
        const struct rival_dual ab = rival_dual_dot(a, b);
        const struct rival_dual h12 = step < 3 ? ab : rival_add(ab, rival_dual_dot(c[3], d), -1);
        const struct rival_dual det = rival_add(rival_multiply(h11, h22), rival_multiply(h12, h12), -1);
        const struct rival_dual du = rival_divide(rival_add(rival_multiply(h22, f), rival_multiply(h12, g), -1), det);
        const struct rival_dual dv = rival_divide(rival_add(rival_multiply(h11, g), rival_multiply(h12, f), -1), det);
        u = rival_add(u, du, 1);
        v = rival_add(v, dv, 1);
        last += fabs(du.value) + fabs(dv.value) < 1e-12;
    }
    for (int i = 0; i < 3; i++)
        n[i] = rival_add(rival_multiply(a[(i + 1) % 3], b[(i + 2) % 3]), rival_multiply(a[(i + 2) % 3], b[(i + 1) % 3]),
                         -1);
    struct rival_dual nn = rival_dual_dot(n, n), length = nn;
    length.value = sqrt(nn.value);
    for (int k = 0; k < 15; k++)
        length.slope[k] = nn.slope[k] / (2 * length.value);
    const struct rival_dual distance = rival_divide(rival_dual_dot(d, n), length);
    loc[0] = u.value;
    loc[1] = v.value;
    *gap = distance.value;
    for (int k = 0; k < 15; k++) {
        slope[0][k] = u.slope[k];
        slope[1][k] = v.slope[k];
        slope[2][k] = distance.slope[k];
    }
    return last == 2;
}

/* ---- differences ---- */

/* The step for edges of about 1. */
#define RIVAL_DIFFERENCE 1e-6

/** Differentiates `search`, which finds xi, eta and the gap or returns 0, by central differences: it searches once at
 *  the given vectors, and with each coordinate moved by `step` in both directions. */
static inline int rival_differences(int vectors, const double (*x)[3], double step,
                                    int search(const double (*)[3], double[2], double *), double loc[2], double *gap,
                                    double (*slope)[RIVAL_COORDINATES])
{
    double moved[RIVAL_COORDINATES / 3][3];
    int found = search(x, loc, gap);
    for (int k = 0; k < 3 * vectors; k++)
        moved[k / 3][k % 3] = x[k / 3][k % 3];
    for (int k = 0; k < 3 * vectors; k++) {
        double at[2][3], *const one = &moved[k / 3][k % 3], old = *one;
        for (int side = 0; side < 2; side++) {
            *one = side ? old - step : old + step;
            found = search((const double(*)[3])moved, at[side], &at[side][2]) && found;
        }
        *one = old;
        for (int i = 0; i < 3; i++)
            slope[i][k] = (at[0][i] - at[1][i]) / (2 * step);
    }
    return found;
}

#endif
