/* Rivals with numbers that are fitted to a scene's training samples, in the rivals' favour: the starting point and the
 * box of truncated iterations, and the coefficients of polynomials. See rivals.h and bench_tune.h. */
#ifndef FOOTPOINT_RIVALS_TUNED_H
#define FOOTPOINT_RIVALS_TUNED_H

#include "rivals.h"

enum { RIVAL_TERMS = 165 }; /* terms of a full cubic in eight variables */

struct rival_tuning {
    FOOTPOINT_REAL s, t, xi0, eta0; /* the start: fractions of AB and AD, and xi0 = 2 s - 1, eta0 = 2 t - 1 */
    struct rival_clamp clamp;       /* limits of the fractions about the start; twice these in the last step */
    struct rival_box box;           /* the box of the scene's contact points */
    FOOTPOINT_REAL xi[RIVAL_TERMS], eta[RIVAL_TERMS];
};

/** Truncated iterations from the best point of a scene: R(name, Gauss-Newton steps, Newton steps, clamped). */
#define RIVAL_TUNED_ITERATIONS(R)                                                                                      \
    R(gn1_best, 1, 0, 0)                                                                                               \
    R(gn2_best, 2, 0, 0)                                                                                               \
    R(gn3_best, 3, 0, 0)                                                                                               \
    R(gn4_best, 4, 0, 0)                                                                                               \
    R(n1_best, 0, 1, 0)                                                                                                \
    R(n2_best, 0, 2, 0)                                                                                                \
    R(n3_best, 0, 3, 0)                                                                                                \
    R(n4_best, 0, 4, 0)                                                                                                \
    R(gn1n1_best, 1, 1, 0)                                                                                             \
    R(gn1n2_best, 1, 2, 0)                                                                                             \
    R(gn1n3_best, 1, 3, 0)                                                                                             \
    R(gn2n1_best, 2, 1, 0)                                                                                             \
    R(gn1_best_clamped, 1, 0, 1)                                                                                       \
    R(gn2_best_clamped, 2, 0, 1)                                                                                       \
    R(gn3_best_clamped, 3, 0, 1)                                                                                       \
    R(gn4_best_clamped, 4, 0, 1)                                                                                       \
    R(n1_best_clamped, 0, 1, 1)                                                                                        \
    R(n2_best_clamped, 0, 2, 1)                                                                                        \
    R(n3_best_clamped, 0, 3, 1)                                                                                        \
    R(n4_best_clamped, 0, 4, 1)                                                                                        \
    R(gn1n1_best_clamped, 1, 1, 1)                                                                                     \
    R(gn1n2_best_clamped, 1, 2, 1)                                                                                     \
    R(gn1n3_best_clamped, 1, 3, 1)                                                                                     \
    R(gn2n1_best_clamped, 2, 1, 1)

/** Polynomials in the inputs of the similarity frame: R(name, coefficients for each of xi and eta). */
#define RIVAL_POLYNOMIALS(R)                                                                                           \
    R(ten_terms, 10)                                                                                                   \
    R(quadratic, 45)                                                                                                   \
    R(cubic, RIVAL_TERMS)

RIVAL_FN struct rival_basis rival_basis_tuned(RIVAL_NODES, const struct rival_tuning *t)
{
    struct rival_basis b;
    for (int i = 0; i < 3; i++) {
        const FOOTPOINT_REAL ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], as = xS[i] - xA[i];
        b.c3[i] = dc - ab;
        b.e1[i] = ab + t->t * b.c3[i];
        b.e2[i] = ad + t->s * b.c3[i];
        b.d[i] = as - t->s * ab - t->t * b.e2[i];
    }
    return b;
}

RIVAL_FN void rival_iterate_tuned(RIVAL_NODES, const struct rival_tuning *t, int gauss_newton, int newton, int clamped,
                                  FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL two = 2.0;
    const struct rival_basis b = rival_basis_tuned(xA, xB, xC, xD, xS, t);
    const struct rival_plan plan = {gauss_newton, newton, two, clamped ? &t->clamp : NULL};
    const struct rival_point p = rival_steps(&b, &plan);
    *xi = t->xi0 + p.u;
    *eta = t->eta0 + p.v;
}

#define RIVAL_DEFINE(name, gauss_newton, newton, clamped)                                                              \
    RIVAL_FN void rival_##name(RIVAL_NODES, const struct rival_tuning *t, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)     \
    {                                                                                                                  \
        rival_iterate_tuned(xA, xB, xC, xD, xS, t, gauss_newton, newton, clamped, xi, eta);                            \
    }
RIVAL_TUNED_ITERATIONS(RIVAL_DEFINE)
#undef RIVAL_DEFINE

/* Computes the paper's frame, section 3.1, from scalar products: A the origin, B = (1,0,0), D in the x-y plane. */
enum { RIVAL_XC, RIVAL_YC, RIVAL_ZC, RIVAL_XD, RIVAL_YD, RIVAL_XS, RIVAL_YS, RIVAL_ZS, RIVAL_INPUTS };

RIVAL_FN void rival_similarity(RIVAL_NODES, int heights, FOOTPOINT_REAL x[RIVAL_INPUTS])
{
    const FOOTPOINT_REAL one = 1.0;
    FOOTPOINT_REAL b[3], c[3], d[3], s[3];
    for (int i = 0; i < 3; i++) {
        b[i] = xB[i] - xA[i];
        c[i] = xC[i] - xA[i];
        d[i] = xD[i] - xA[i];
        s[i] = xS[i] - xA[i];
    }
    const FOOTPOINT_REAL bb = rival_dot(b, b), bd = rival_dot(b, d), dd = rival_dot(d, d), bc = rival_dot(b, c),
                         bs = rival_dot(b, s);
    const FOOTPOINT_REAL area2 = bb * dd - bd * bd, area = sqrt(area2), over = one / (area * bb);
    const FOOTPOINT_REAL along = area * over;
    x[RIVAL_XC] = bc * along;
    x[RIVAL_XD] = bd * along;
    x[RIVAL_XS] = bs * along;
    x[RIVAL_YC] = (bb * rival_dot(c, d) - bd * bc) * over;
    x[RIVAL_YD] = area2 * over;
    x[RIVAL_YS] = (bb * rival_dot(d, s) - bd * bs) * over;
    x[RIVAL_ZC] = x[RIVAL_ZS] = 0;
    if (heights) {
        const FOOTPOINT_REAL n[3] = {b[1] * d[2] - b[2] * d[1], b[2] * d[0] - b[0] * d[2], b[0] * d[1] - b[1] * d[0]};
        const FOOTPOINT_REAL across = sqrt(bb) * over;
        x[RIVAL_ZC] = rival_dot(n, c) * across;
        x[RIVAL_ZS] = rival_dot(n, s) * across;
    }
}

/* Evaluate full polynomials in x[first..7] by Horner's scheme, of degree 1, 2 and 3; *c advances along the
 * coefficients. */
RIVAL_FN FOOTPOINT_REAL rival_line(const FOOTPOINT_REAL *c, const FOOTPOINT_REAL x[RIVAL_INPUTS], int first)
{
    FOOTPOINT_REAL sum = c[0];
#define RIVAL_TERM(i)                                                                                                  \
    if (first <= i)                                                                                                    \
        sum = sum + c[1 + i - first] * x[i];
#define RIVAL_EACH(R) R(0) R(1) R(2) R(3) R(4) R(5) R(6) R(7)
    RIVAL_EACH(RIVAL_TERM)
#undef RIVAL_TERM
    return sum;
}

RIVAL_FN FOOTPOINT_REAL rival_square(const FOOTPOINT_REAL *c, const FOOTPOINT_REAL x[RIVAL_INPUTS], int first)
{
    FOOTPOINT_REAL sum = *c++;
#define RIVAL_TERM(i)                                                                                                  \
    if (first <= i) {                                                                                                  \
        sum = sum + x[i] * rival_line(c, x, i);                                                                        \
        c += 9 - i;                                                                                                    \
    }
    RIVAL_EACH(RIVAL_TERM)
#undef RIVAL_TERM
    return sum;
}

RIVAL_FN FOOTPOINT_REAL rival_cube(const FOOTPOINT_REAL *c, const FOOTPOINT_REAL x[RIVAL_INPUTS])
{
    FOOTPOINT_REAL sum = *c++;
#define RIVAL_TERM(i)                                                                                                  \
    sum = sum + x[i] * rival_square(c, x, i);                                                                          \
    c += (9 - i) * (10 - i) / 2;
    RIVAL_EACH(RIVAL_TERM)
#undef RIVAL_TERM
    return sum;
}

RIVAL_FN void rival_quadratic(RIVAL_NODES, const struct rival_tuning *t, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    FOOTPOINT_REAL x[RIVAL_INPUTS];
    rival_similarity(xA, xB, xC, xD, xS, 1, x);
    *xi = rival_square(t->xi, x, 0);
    *eta = rival_square(t->eta, x, 0);
}

RIVAL_FN void rival_cubic(RIVAL_NODES, const struct rival_tuning *t, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    FOOTPOINT_REAL x[RIVAL_INPUTS];
    rival_similarity(xA, xB, xC, xD, xS, 1, x);
    *xi = rival_cube(t->xi, x);
    *eta = rival_cube(t->eta, x);
}

/** Evaluates the terms of (41) and (42), or those without z. */
RIVAL_FN void rival_ten_terms(RIVAL_NODES, const struct rival_tuning *t, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL *a = t->xi, *b = t->eta;
    FOOTPOINT_REAL x[RIVAL_INPUTS];
    rival_similarity(xA, xB, xC, xD, xS, 0, x);
    const FOOTPOINT_REAL xc = x[RIVAL_XC], yc = x[RIVAL_YC], xd = x[RIVAL_XD], yd = x[RIVAL_YD], xs = x[RIVAL_XS],
                         ys = x[RIVAL_YS];
    *xi = a[0] * xs + yd * (a[1] + a[2] * (xc * xc) + a[3] * (xs * xs)) +
          ys * (a[4] + xc * (a[5] + a[6] * yc + a[7] * xs) + a[8] * yc + a[9] * (xd * xd));
    *eta = b[0] + b[1] * xc + yd * (b[2] + b[3] * (yc * yd)) +
           ys * (b[4] + b[5] * xc + yc * (b[6] * ys + b[7] * xs) + yd * (b[8] * xc + b[9] * xs));
}

#endif
