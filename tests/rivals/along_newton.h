/* Newton's iteration for where a line meets a bilinear segment, as contact codes have it: three unknowns, xi, eta and the
 * distance along the direction, from the centre until none moves.  It may end at the solution outside of the segment
 * though there is one inside. */
#ifndef FOOTPOINT_ALONG_NEWTON_H
#define FOOTPOINT_ALONG_NEWTON_H

#include <math.h>

/** xS = r(xi, eta) + distance p, |p| = 1, of corners x[0] to x[3] and the slave node x[4]; at = {xi, eta, distance}.
 *  Returns the steps taken, or 0 if `most` of them were not enough. */
static inline int rival_along_newton(const double *const *x, const double p[3], int most, double tolerance,
                                     double at[3])
{
    double c[4][3], step = HUGE_VAL;
    int n = 0;
    for (int i = 0; i < 3; i++) {
        c[0][i] = 0.25 * (x[0][i] + x[1][i] + x[2][i] + x[3][i]) - x[4][i];
        c[1][i] = 0.25 * (x[1][i] + x[2][i] - x[0][i] - x[3][i]);
        c[2][i] = 0.25 * (x[2][i] + x[3][i] - x[0][i] - x[1][i]);
        c[3][i] = 0.25 * (x[0][i] + x[2][i] - x[1][i] - x[3][i]);
    }
    at[0] = at[1] = at[2] = 0.0;
    for (; n < most && step > tolerance; n++) {
        double f[3], u[3], v[3], m[3], k[3], g[3], over;
        for (int i = 0; i < 3; i++) {
            u[i] = c[1][i] + at[1] * c[3][i];
            v[i] = c[2][i] + at[0] * c[3][i];
            f[i] = -(c[0][i] + at[0] * c[1][i] + at[1] * v[i] + at[2] * p[i]);
        }
        for (int i = 0; i < 3; i++) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            m[i] = v[a] * p[b] - v[b] * p[a];
            k[i] = p[a] * u[b] - p[b] * u[a];
            g[i] = u[a] * v[b] - u[b] * v[a];
        }
        over = 1.0 / (u[0] * m[0] + u[1] * m[1] + u[2] * m[2]);
        const double du = over * (f[0] * m[0] + f[1] * m[1] + f[2] * m[2]);
        const double dv = over * (f[0] * k[0] + f[1] * k[1] + f[2] * k[2]);
        const double dt = over * (f[0] * g[0] + f[1] * g[1] + f[2] * g[2]);
        at[0] += du;
        at[1] += dv;
        at[2] += dt;
        step = fabs(du) + fabs(dv);
    }
    return step <= tolerance ? n : 0;
}

#endif
