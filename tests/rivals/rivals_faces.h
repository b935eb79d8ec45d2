/* Searches on the other kinds of segments as a good finite element programmer writes them by hand: Gauss-Newton and
 * Newton steps from the middle. The segment is a polynomial about the middle, r = sum of c[i][j] u^i v^j by Horner's
 * rule; for three nodes there is a formula. Compare rivals.h. x[0], x[1], ... are the nodes in the order of the kind, S
 * last. */
#ifndef FOOTPOINT_RIVALS_FACES_H
#define FOOTPOINT_RIVALS_FACES_H

#include "rivals_converged.h"

/** F(kind, vectors) for each kind with curved edges. */
#define RIVAL_FACES(F) F(tri6, 7) F(quad8, 9) F(quad9, 10)
/** Truncated iterations: R(name, kind, Gauss-Newton steps, Newton steps). */
#define RIVAL_FACE_ITERATIONS(R) RIVAL_FACE_STEPS(R, tri6) RIVAL_FACE_STEPS(R, quad8) RIVAL_FACE_STEPS(R, quad9)
#define RIVAL_FACE_STEPS(R, kind)                                                                                      \
    R(kind##_gn1, kind, 1, 0)                                                                                          \
    R(kind##_gn2, kind, 2, 0)                                                                                          \
    R(kind##_gn3, kind, 3, 0)                                                                                          \
    R(kind##_gn4, kind, 4, 0)                                                                                          \
    R(kind##_gn1n1, kind, 1, 1)                                                                                        \
    R(kind##_gn2n1, kind, 2, 1)                                                                                        \
    R(kind##_gn2n2, kind, 2, 2)

/* The polynomial up to a common factor. Compilers know which terms exist. */
struct rival_face {
    FOOTPOINT_REAL c[3][3][3], d[3]; /* c[i][j]: coefficient of u^i v^j; d: xS minus the middle */
    int mixed, highest;              /* has terms of degree 3; has the term of degree 4 */
};

/* Expands about the middle. A single step needs only the terms of degree 1: `many` is 0. */
RIVAL_FN void rival_face_tri6(const FOOTPOINT_REAL (*x)[3], int many, struct rival_face *f)
{
    const FOOTPOINT_REAL two = 2.0, three = 3.0, four = 4.0;
    f->mixed = f->highest = 0;
    for (int k = 0; k < 3; k++) {
        const FOOTPOINT_REAL a = x[0][k], b = x[1][k], c = x[2][k], d = x[3][k], e = x[4][k], g = x[5][k];
        const FOOTPOINT_REAL ad = a - d, eg = e - g;
        f->c[1][0][k] = (b - a) + four * eg;
        f->c[0][1][k] = (c - a) + four * (e - d);
        if (many) {
            f->c[2][0][k] = two * (ad + (b - d));
            f->c[0][2][k] = two * ((a - g) + (c - g));
            f->c[1][1][k] = four * (ad + eg);
        }
        f->d[k] = three * ((x[6][k] - d) + (x[6][k] - e) + (x[6][k] - g)) + (ad + (b - e) + (c - g));
    }
}

RIVAL_FN void rival_face_quad(const FOOTPOINT_REAL (*x)[3], const FOOTPOINT_REAL *slave, int nine, int many,
                              struct rival_face *f)
{
    f->mixed = 1;
    f->highest = nine;
    for (int k = 0; k < 3; k++) {
        const FOOTPOINT_REAL a = x[0][k], b = x[1][k], c = x[2][k], d = x[3][k];
        const FOOTPOINT_REAL e = x[4][k], g = x[5][k], h = x[6][k], i = x[7][k]; /* mid-sides of AB, BC, CD, DA */
        const FOOTPOINT_REAL fh = g - i, ge = h - e, s = slave[k];
        f->c[1][0][k] = fh + fh;
        f->c[0][1][k] = ge + ge;
        if (many) {
            const FOOTPOINT_REAL ab = a - b, dc = d - c;
            f->c[1][1][k] = ab - dc;
            f->c[2][1][k] = ((c - b) - (a - d)) - f->c[0][1][k];
            f->c[1][2][k] = (-dc - ab) - f->c[1][0][k];
        }
        if (nine) {
            const FOOTPOINT_REAL m = x[8][k], sm = s - m, half = sm + sm;
            f->d[k] = half + half;
            if (many) {
                const FOOTPOINT_REAL u = (g - m) + (i - m), v = (e - m) + (h - m);
                f->c[2][0][k] = u + u;
                f->c[0][2][k] = v + v;
                f->c[2][2][k] = (((a - e) + (b - e)) + ((c - h) + (d - h))) - f->c[2][0][k];
            }
        } else {
            const FOOTPOINT_REAL half = (s - g) + (s - i);
            f->c[2][0][k] = ((a - e) + (b - e)) + ((c - h) + (d - h));
            f->d[k] = (half + half) + f->c[2][0][k];
            if (many)
                f->c[0][2][k] = ((b - g) + (c - g)) + ((d - i) + (a - i));
        }
    }
}

RIVAL_FN void rival_face_quad8(const FOOTPOINT_REAL (*x)[3], int many, struct rival_face *f)
{
    rival_face_quad(x, x[8], 0, many, f);
}

RIVAL_FN void rival_face_quad9(const FOOTPOINT_REAL (*x)[3], int many, struct rival_face *f)
{
    rival_face_quad(x, x[9], 1, many, f);
}

RIVAL_FN FOOTPOINT_REAL rival_product(const FOOTPOINT_REAL a[3], const FOOTPOINT_REAL b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* a x b */
RIVAL_FN void rival_cross_product(const FOOTPOINT_REAL a[3], const FOOTPOINT_REAL b[3], FOOTPOINT_REAL n[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        n[k] = a[i] * b[j] - a[j] * b[i];
    }
}

RIVAL_FN struct rival_point rival_face_first(const struct rival_face *f)
{
    const FOOTPOINT_REAL one = 1.0, *e1 = f->c[1][0], *e2 = f->c[0][1];
    return rival_solve(rival_product(e1, e1), rival_product(e1, e2), rival_product(e2, e2), rival_product(f->d, e1),
                       rival_product(f->d, e2), one);
}

/* xS - r, tangents and half the second derivatives by u u and v v, all with the common factor. */
struct rival_face_jet {
    FOOTPOINT_REAL w[3], u[3], v[3], uu[3], uv[3], vv[3];
};

RIVAL_FN void rival_face_jet_at(const struct rival_face *f, FOOTPOINT_REAL u, FOOTPOINT_REAL v,
                                struct rival_face_jet *j)
{
    const FOOTPOINT_REAL u2 = u + u, v2 = v + v;
    for (int k = 0; k < 3; k++) {
        FOOTPOINT_REAL a1 = f->c[1][1][k], a2 = f->c[2][0][k], b1 = f->c[1][1][k], b2 = f->c[1][1][k];
        FOOTPOINT_REAL top = f->c[0][2][k];
        if (f->highest) {
            a2 = a2 + v * (f->c[2][1][k] + v * f->c[2][2][k]);
            b2 = f->c[2][1][k] + v2 * f->c[2][2][k];
            top = top + u * (f->c[1][2][k] + u * f->c[2][2][k]);
        } else if (f->mixed) {
            a2 = a2 + v * f->c[2][1][k];
            b2 = f->c[2][1][k];
            top = top + u * f->c[1][2][k];
        }
        if (f->mixed) {
            a1 = a1 + v * f->c[1][2][k];
            b1 = b1 + v2 * f->c[1][2][k];
        }
        a1 = f->c[1][0][k] + v * a1;
        j->w[k] = (f->d[k] - v * (f->c[0][1][k] + v * f->c[0][2][k])) - u * (a1 + u * a2);
        j->u[k] = a1 + u2 * a2;
        j->v[k] = (f->c[0][1][k] + v2 * f->c[0][2][k]) + u * (f->mixed ? b1 + u * b2 : b1);
        j->uu[k] = a2;
        j->uv[k] = f->mixed ? b1 + u2 * b2 : b1;
        j->vv[k] = top;
    }
}

RIVAL_FN struct rival_point rival_face_step(const struct rival_face *f, int newton, struct rival_point p)
{
    const FOOTPOINT_REAL one = 1.0;
    struct rival_face_jet j;
    rival_face_jet_at(f, p.u, p.v, &j);
    FOOTPOINT_REAL k11 = rival_product(j.u, j.u), k12 = rival_product(j.u, j.v), k22 = rival_product(j.v, j.v);
    if (newton) {
        const FOOTPOINT_REAL h11 = rival_product(j.w, j.uu), h22 = rival_product(j.w, j.vv);
        k11 = k11 - (h11 + h11);
        k12 = k12 - rival_product(j.w, j.uv);
        k22 = k22 - (h22 + h22);
    }
    struct rival_point next = rival_solve(k11, k12, k22, rival_product(j.w, j.u), rival_product(j.w, j.v), one);
    next.u = p.u + next.u;
    next.v = p.v + next.v;
    return next;
}

/* Converts u or v to xi or eta. */
RIVAL_FN FOOTPOINT_REAL rival_face_local(const struct rival_face *f, FOOTPOINT_REAL u)
{
    const FOOTPOINT_REAL third = 1.0 / 3.0;
    return f->mixed ? u : third + third * u;
}

RIVAL_FN void rival_face_steps(const struct rival_face *f, int gauss_newton, int newton, FOOTPOINT_REAL *xi,
                               FOOTPOINT_REAL *eta)
{
    struct rival_point p = rival_face_first(f);
    if (gauss_newton > 1)
        p = rival_face_step(f, 0, p);
    if (gauss_newton > 2)
        p = rival_face_step(f, 0, p);
    if (gauss_newton > 3)
        p = rival_face_step(f, 0, p);
    if (newton > 0)
        p = rival_face_step(f, 1, p);
    if (newton > 1)
        p = rival_face_step(f, 1, p);
    *xi = rival_face_local(f, p.u);
    *eta = rival_face_local(f, p.v);
}

/* Takes three Gauss-Newton steps, then Newton's until they converge, like rival_newton. Returns the number of steps, or
 * 0. */
RIVAL_FN int rival_face_newton(const struct rival_face *f, int most, double tolerance, FOOTPOINT_REAL *xi,
                               FOOTPOINT_REAL *eta)
{
    struct rival_point p = rival_face_first(f);
    int n = 1, stands = 0;
    for (; n < most && !stands; n++) {
        const struct rival_point next = rival_face_step(f, n >= RIVAL_NEWTON_GAUSS, p);
        stands = rival_stands(p, next, tolerance);
        p = next;
    }
    *xi = rival_face_local(f, p.u);
    *eta = rival_face_local(f, p.v);
    return stands ? n : 0;
}

/* Defines rival_KIND_newton(x, most, tolerance, &xi, &eta), rival_KIND_gn1(x, &xi, &eta), ... */
#define RIVAL_DEFINE(kind, vectors)                                                                                    \
    RIVAL_FN int rival_##kind##_newton(const FOOTPOINT_REAL(*x)[3], int most, double tolerance, FOOTPOINT_REAL *xi,    \
                                       FOOTPOINT_REAL *eta)                                                            \
    {                                                                                                                  \
        struct rival_face f;                                                                                           \
        rival_face_##kind(x, 1, &f);                                                                                   \
        return rival_face_newton(&f, most, tolerance, xi, eta);                                                        \
    }
RIVAL_FACES(RIVAL_DEFINE)
#undef RIVAL_DEFINE
#define RIVAL_DEFINE(name, kind, gauss_newton, newton)                                                                 \
    RIVAL_FN void rival_##name(const FOOTPOINT_REAL(*x)[3], FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)                   \
    {                                                                                                                  \
        struct rival_face f;                                                                                           \
        rival_face_##kind(x, gauss_newton + newton > 1, &f);                                                           \
        rival_face_steps(&f, gauss_newton, newton, xi, eta);                                                           \
    }
RIVAL_FACE_ITERATIONS(RIVAL_DEFINE)
#undef RIVAL_DEFINE

/* Computes the foot point on three nodes: the normal n = AB x AC, and areas over its square (Ericson, Real-Time
 * Collision Detection, 3.4). */
RIVAL_FN void rival_tri3_areas(const FOOTPOINT_REAL (*x)[3], FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL one = 1.0;
    FOOTPOINT_REAL b[3], c[3], s[3], n[3], bs[3], sc[3];
    for (int k = 0; k < 3; k++) {
        b[k] = x[1][k] - x[0][k];
        c[k] = x[2][k] - x[0][k];
        s[k] = x[3][k] - x[0][k];
    }
    rival_cross_product(b, c, n);
    rival_cross_product(b, s, bs);
    rival_cross_product(s, c, sc);
    const FOOTPOINT_REAL per_nn = one / rival_product(n, n);
    *xi = rival_product(sc, n) * per_nn;
    *eta = rival_product(bs, n) * per_nn;
}

#endif
