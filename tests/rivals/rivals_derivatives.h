/* Derivatives of xi, eta and the gap by all fifteen coordinates, as they are written by hand: by the implicit function
 * theorem, by forward differentiation through Newton's iteration, and by central differences. */
#ifndef FOOTPOINT_RIVALS_DERIVATIVES_H
#define FOOTPOINT_RIVALS_DERIVATIVES_H

#include <math.h>

struct rival_derivatives {
    double gap, xi[15], eta[15], by_gap[15];
};

/* (7), (8) differentiated by the nodes; the determinant divided by once. */
static inline void rival_implicit(const double *const x[5], double xi, double eta, struct rival_derivatives *o)
{
    const double phi[5] = {0.25 * (1 - xi) * (1 - eta), 0.25 * (1 + xi) * (1 - eta), 0.25 * (1 + xi) * (1 + eta),
                           0.25 * (1 - xi) * (1 + eta), -1};
    const double by_xi[5] = {-0.25 * (1 - eta), 0.25 * (1 - eta), 0.25 * (1 + eta), -0.25 * (1 + eta), 0};
    const double by_eta[5] = {-0.25 * (1 - xi), -0.25 * (1 + xi), 0.25 * (1 + xi), 0.25 * (1 - xi), 0};
    double a[3], b[3], c[3], d[3], n[3], aa = 0, ab = 0, bb = 0, cd = 0, nn = 0, gap = 0;
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
    for (int i = 0; i < 3; i++) {
        n[i] /= length;
        gap += n[i] * d[i];
    }
    for (int k = 0; k < 5; k++)
        for (int i = 0; i < 3; i++) {
            const double f = by_xi[k] * d[i] - phi[k] * a[i], g = by_eta[k] * d[i] - phi[k] * b[i];
            o->xi[3 * k + i] = (bb * f - h12 * g) * over;
            o->eta[3 * k + i] = (aa * g - h12 * f) * over;
            o->by_gap[3 * k + i] = -phi[k] * n[i];
        }
    o->gap = gap;
}

/* ---- forward differentiation ---- */

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

static inline struct rival_dual rival_dot(const struct rival_dual a[3], const struct rival_dual b[3])
{
    return rival_add(rival_add(rival_multiply(a[0], b[0]), rival_multiply(a[1], b[1]), 1), rival_multiply(a[2], b[2]),
                     1);
}

/* Newton's iteration in dual numbers until it stands, and a step more, in which the derivatives arrive. */
static inline void rival_forward(const double *const x[5], struct rival_derivatives *o)
{
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
    for (int step = 0, last = 0; step < 50 && last < 2; step++) {
        for (int i = 0; i < 3; i++) {
            a[i] = rival_add(c[1][i], rival_multiply(v, c[3][i]), 1);
            b[i] = rival_add(c[2][i], rival_multiply(u, c[3][i]), 1);
            d[i] = rival_add(rival_add(p[4][i], c[0][i], -1), rival_multiply(u, c[1][i]), -1);
            d[i] = rival_add(d[i], rival_multiply(v, b[i]), -1);
        }
        const struct rival_dual h11 = rival_dot(a, a), h22 = rival_dot(b, b), f = rival_dot(a, d), g = rival_dot(b, d);
        const struct rival_dual h12 = rival_add(rival_dot(a, b), rival_dot(c[3], d), -1);
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
    struct rival_dual nn = rival_dot(n, n), length = nn;
    length.value = sqrt(nn.value);
    for (int k = 0; k < 15; k++)
        length.slope[k] = nn.slope[k] / (2 * length.value);
    const struct rival_dual gap = rival_divide(rival_dot(d, n), length);
    o->gap = gap.value;
    for (int k = 0; k < 15; k++) {
        o->xi[k] = u.slope[k];
        o->eta[k] = v.slope[k];
        o->by_gap[k] = gap.slope[k];
    }
}

/* ---- differences ---- */

/* `search` once at the nodes moved each way by `step`. */
static inline void rival_differences(const double *const x[5], double step,
                                     void search(const double *const *, double *, double *, double *),
                                     struct rival_derivatives *o)
{
    double moved[5][3];
    const double *const y[5] = {moved[0], moved[1], moved[2], moved[3], moved[4]};
    for (int k = 0; k < 15; k++)
        moved[k / 3][k % 3] = x[k / 3][k % 3];
    for (int k = 0; k < 15; k++) {
        double at[2][3], *const one = &moved[k / 3][k % 3], old = *one;
        *one = old + step;
        search(y, &at[0][0], &at[0][1], &at[0][2]);
        *one = old - step;
        search(y, &at[1][0], &at[1][1], &at[1][2]);
        *one = old;
        o->xi[k] = (at[0][0] - at[1][0]) / (2 * step);
        o->eta[k] = (at[0][1] - at[1][1]) / (2 * step);
        o->by_gap[k] = (at[0][2] - at[1][2]) / (2 * step);
    }
}

#endif
