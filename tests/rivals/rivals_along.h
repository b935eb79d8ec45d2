/* The intersection of a line with a face, as in contact codes: Newton's iteration from the middle in three unknowns,
 * xi, eta and the distance along the direction; for a triangle the formula. The iteration may end at a solution outside
 * of the face although another lies inside. */
#ifndef FOOTPOINT_RIVALS_ALONG_H
#define FOOTPOINT_RIVALS_ALONG_H

#include "rivals_calls.h"

/** Solves xS = r(xi, eta) + distance p, |p| = 1, for corners x[0] to x[3] and slave node x[4]; at = {xi, eta,
 *  distance}. Returns the number of steps, or 0 if `most` steps do not suffice. */
static inline int rival_along_newton(const double (*x)[3], const double p[3], int most, double tolerance, double at[3])
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

/** Intersects a plane triangle: Moeller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997. */
static inline int rival_along_tri3(const double (*x)[3], const double p[3], double at[3])
{
    double u[3], v[3], s[3], pv[3], su[3];
    for (int k = 0; k < 3; k++) {
        u[k] = x[1][k] - x[0][k];
        v[k] = x[2][k] - x[0][k];
        s[k] = x[3][k] - x[0][k];
    }
    rival_cross_product(p, v, pv);
    rival_cross_product(s, u, su);
    const double volume = rival_product(u, pv), over = 1 / volume;
    at[0] = rival_product(s, pv) * over;
    at[1] = rival_product(p, su) * over;
    at[2] = -rival_product(v, su) * over;
    return volume != 0;
}

/** Intersects a face of six, eight or nine nodes. */
static inline int rival_along_face(const struct rival_face *f, const double p[3], int most, double tolerance,
                                   double at[3])
{
    double step = HUGE_VAL, u = 0, v = 0, t = 0;
    int n = 0;
    for (; n < most && step > tolerance; n++) {
        struct rival_face_jet j;
        double m[3], k[3], g[3];
        rival_face_jet_at(f, u, v, &j);
        for (int i = 0; i < 3; i++)
            j.w[i] -= t * p[i];
        rival_cross_product(j.v, p, m);
        rival_cross_product(p, j.u, k);
        rival_cross_product(j.u, j.v, g);
        const double over = 1 / rival_product(j.u, m);
        const double du = over * rival_product(j.w, m), dv = over * rival_product(j.w, k);
        u += du;
        v += dv;
        t += over * rival_product(j.w, g);
        step = fabs(du) + fabs(dv);
    }
    at[0] = rival_face_local(f, u);
    at[1] = rival_face_local(f, v);
    at[2] = t / rival_face_factor(f);
    return step <= tolerance ? n : 0;
}

#endif
