/* Local contact searches as a good finite element programmer writes them by hand: the methods that generated code must
 * beat. All are inline, so that a loop over them can be vectorised, and spend no multiplication that algebra avoids.
 *
 * Truncated iterations. Any bilinear segment is r = r0 + e1 u + e2 v + c3 u v about one of its points r0, up to a
 * common factor of e1, e2, c3 and d = xS - r0 that cancels. The nine scalar products of e1, e2, c3, d are
 *   g11 = e1.e1  g12 = e1.e2  g13 = e1.c3  g22 = e2.e2  g23 = e2.c3  g33 = c3.c3  g1 = e1.d  g2 = e2.d  g3 = c3.d.
 *
 * With them a Gauss-Newton step or a Newton step on (7), (8) costs the same 19 multiplications and a division. From
 *   t = g13 + v g33,  s = g23 + u g33,  y = u g13 + v s = c3.(r - r0)
 * follow r_u.r_u = g11 + v (g13 + t), r_v.r_v = g22 + u (g23 + s), r_u.r_v = g12 + y, and c3.(xS - r) = g3 - y. The
 * equations for the new point, instead of the increment, have the right-hand sides
 *   Gauss-Newton:  g1 + v g3 + u v t,  g2 + u g3 + u v s
 *   Newton:  g1 + v y + u v t,  g2 + u y + u v s.
 *
 * The first step, from u = v = 0, needs only five of the products.
 *
 * "centre" starts at (0,0), "quarter" at (-1/2,-1/2), the middle of corner A's quarter. "clamped" keeps u and v of
 * every step within the segment, or within A's quarter of it.
 *
 * A counter of operations may replace the scalar type: define FOOTPOINT_REAL (and its sqrt) before including. */
#ifndef FOOTPOINT_RIVALS_H
#define FOOTPOINT_RIVALS_H

#include <math.h>
#include <stddef.h>

#ifndef FOOTPOINT_REAL
#define FOOTPOINT_REAL double
#endif

#ifdef __OPTIMIZE__
#define RIVAL_FN static inline __attribute__((always_inline))
#else
#define RIVAL_FN static inline
#endif
#define RIVAL_NODES                                                                                                    \
    const FOOTPOINT_REAL xA[3], const FOOTPOINT_REAL xB[3], const FOOTPOINT_REAL xC[3], const FOOTPOINT_REAL xD[3],    \
        const FOOTPOINT_REAL xS[3]

enum rival_start { RIVAL_CENTRE, RIVAL_QUARTER };

/** Iterations fail after this number of steps. */
enum { RIVAL_STEPS_MAX = 50 };

/** Truncated iterations: R(name, start, Gauss-Newton steps, Newton steps, clamped). */
#define RIVAL_ITERATIONS(R)                                                                                            \
    R(gn1_centre, RIVAL_CENTRE, 1, 0, 0)                                                                               \
    R(gn2_centre, RIVAL_CENTRE, 2, 0, 0)                                                                               \
    R(gn3_centre, RIVAL_CENTRE, 3, 0, 0)                                                                               \
    R(gn4_centre, RIVAL_CENTRE, 4, 0, 0)                                                                               \
    R(n1_centre, RIVAL_CENTRE, 0, 1, 0)                                                                                \
    R(n2_centre, RIVAL_CENTRE, 0, 2, 0)                                                                                \
    R(n3_centre, RIVAL_CENTRE, 0, 3, 0)                                                                                \
    R(n4_centre, RIVAL_CENTRE, 0, 4, 0)                                                                                \
    R(gn1n1_centre, RIVAL_CENTRE, 1, 1, 0)                                                                             \
    R(gn1n2_centre, RIVAL_CENTRE, 1, 2, 0)                                                                             \
    R(gn1n3_centre, RIVAL_CENTRE, 1, 3, 0)                                                                             \
    R(gn2n1_centre, RIVAL_CENTRE, 2, 1, 0)                                                                             \
    R(gn1_centre_clamped, RIVAL_CENTRE, 1, 0, 1)                                                                       \
    R(gn2_centre_clamped, RIVAL_CENTRE, 2, 0, 1)                                                                       \
    R(gn3_centre_clamped, RIVAL_CENTRE, 3, 0, 1)                                                                       \
    R(gn4_centre_clamped, RIVAL_CENTRE, 4, 0, 1)                                                                       \
    R(n1_centre_clamped, RIVAL_CENTRE, 0, 1, 1)                                                                        \
    R(n2_centre_clamped, RIVAL_CENTRE, 0, 2, 1)                                                                        \
    R(n3_centre_clamped, RIVAL_CENTRE, 0, 3, 1)                                                                        \
    R(n4_centre_clamped, RIVAL_CENTRE, 0, 4, 1)                                                                        \
    R(gn1n1_centre_clamped, RIVAL_CENTRE, 1, 1, 1)                                                                     \
    R(gn1n2_centre_clamped, RIVAL_CENTRE, 1, 2, 1)                                                                     \
    R(gn1n3_centre_clamped, RIVAL_CENTRE, 1, 3, 1)                                                                     \
    R(gn2n1_centre_clamped, RIVAL_CENTRE, 2, 1, 1)                                                                     \
    R(gn1_quarter, RIVAL_QUARTER, 1, 0, 0)                                                                             \
    R(gn2_quarter, RIVAL_QUARTER, 2, 0, 0)                                                                             \
    R(gn3_quarter, RIVAL_QUARTER, 3, 0, 0)                                                                             \
    R(gn4_quarter, RIVAL_QUARTER, 4, 0, 0)                                                                             \
    R(n1_quarter, RIVAL_QUARTER, 0, 1, 0)                                                                              \
    R(n2_quarter, RIVAL_QUARTER, 0, 2, 0)                                                                              \
    R(n3_quarter, RIVAL_QUARTER, 0, 3, 0)                                                                              \
    R(n4_quarter, RIVAL_QUARTER, 0, 4, 0)                                                                              \
    R(gn1n1_quarter, RIVAL_QUARTER, 1, 1, 0)                                                                           \
    R(gn1n2_quarter, RIVAL_QUARTER, 1, 2, 0)                                                                           \
    R(gn1n3_quarter, RIVAL_QUARTER, 1, 3, 0)                                                                           \
    R(gn2n1_quarter, RIVAL_QUARTER, 2, 1, 0)                                                                           \
    R(gn1_quarter_clamped, RIVAL_QUARTER, 1, 0, 1)                                                                     \
    R(gn2_quarter_clamped, RIVAL_QUARTER, 2, 0, 1)                                                                     \
    R(gn3_quarter_clamped, RIVAL_QUARTER, 3, 0, 1)                                                                     \
    R(gn4_quarter_clamped, RIVAL_QUARTER, 4, 0, 1)                                                                     \
    R(n1_quarter_clamped, RIVAL_QUARTER, 0, 1, 1)                                                                      \
    R(n2_quarter_clamped, RIVAL_QUARTER, 0, 2, 1)                                                                      \
    R(n3_quarter_clamped, RIVAL_QUARTER, 0, 3, 1)                                                                      \
    R(n4_quarter_clamped, RIVAL_QUARTER, 0, 4, 1)                                                                      \
    R(gn1n1_quarter_clamped, RIVAL_QUARTER, 1, 1, 1)                                                                   \
    R(gn1n2_quarter_clamped, RIVAL_QUARTER, 1, 2, 1)                                                                   \
    R(gn1n3_quarter_clamped, RIVAL_QUARTER, 1, 3, 1)                                                                   \
    R(gn2n1_quarter_clamped, RIVAL_QUARTER, 2, 1, 1)

/* The segment about its starting point, scaled. */
struct rival_basis {
    FOOTPOINT_REAL e1[3], e2[3], c3[3], d[3];
};

struct rival_products {
    FOOTPOINT_REAL g11, g12, g13, g22, g23, g33, g1, g2, g3;
};

struct rival_point {
    FOOTPOINT_REAL u, v;
};

RIVAL_FN FOOTPOINT_REAL rival_dot(const FOOTPOINT_REAL a[3], const FOOTPOINT_REAL b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Expands about (0,0), all vectors times 4; u = xi, v = eta. */
RIVAL_FN void rival_basis_centre(RIVAL_NODES, struct rival_basis *b)
{
    for (int i = 0; i < 3; i++) {
        const FOOTPOINT_REAL ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], as = xS[i] - xA[i];
        b->c3[i] = dc - ab;
        b->e1[i] = ab + dc;
        b->e2[i] = (ad + ad) + b->c3[i];
        const FOOTPOINT_REAL half = (as + as) - ab;
        b->d[i] = (half + half) - b->e2[i];
    }
}

/* Expands about (-1/2,-1/2): e1, e2 times 8, c3 times 4, d times 16, so that u = 2 xi + 1, v = 2 eta + 1. */
RIVAL_FN void rival_basis_quarter(RIVAL_NODES, struct rival_basis *b)
{
    for (int i = 0; i < 3; i++) {
        const FOOTPOINT_REAL ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], as = xS[i] - xA[i];
        const FOOTPOINT_REAL ad2 = ad + ad, as2 = as + as;
        b->c3[i] = dc - ab;
        b->e1[i] = (ab + ab) + (ab + dc);
        b->e2[i] = (ad2 + ad2) + b->c3[i];
        const FOOTPOINT_REAL quarter = (as2 + as2) - ad;
        const FOOTPOINT_REAL half = quarter + quarter;
        b->d[i] = (half + half) - b->e1[i];
    }
}

/* Returns `scale` times the solution of a symmetric pair of equations. */
RIVAL_FN struct rival_point rival_solve(FOOTPOINT_REAL k11, FOOTPOINT_REAL k12, FOOTPOINT_REAL k22, FOOTPOINT_REAL b1,
                                        FOOTPOINT_REAL b2, FOOTPOINT_REAL scale)
{
    const FOOTPOINT_REAL inverse = scale / (k11 * k22 - k12 * k12);
    struct rival_point p;
    p.u = (k22 * b1 - k12 * b2) * inverse;
    p.v = (k11 * b2 - k12 * b1) * inverse;
    return p;
}

/* Takes a step from u = v = 0. */
RIVAL_FN struct rival_point rival_first(const struct rival_products *g, int newton, FOOTPOINT_REAL scale)
{
    return rival_solve(g->g11, newton ? g->g12 - g->g3 : g->g12, g->g22, g->g1, g->g2, scale);
}

RIVAL_FN struct rival_point rival_step(const struct rival_products *g, int newton, struct rival_point p,
                                       FOOTPOINT_REAL scale)
{
    const FOOTPOINT_REAL t = g->g13 + p.v * g->g33, s = g->g23 + p.u * g->g33;
    const FOOTPOINT_REAL y = p.u * g->g13 + p.v * s, w = p.u * p.v;
    const FOOTPOINT_REAL k11 = g->g11 + p.v * (g->g13 + t), k22 = g->g22 + p.u * (g->g23 + s);
    if (newton)
        return rival_solve(k11, g->g12 + (y + y) - g->g3, k22, g->g1 + p.v * y + w * t, g->g2 + p.u * y + w * s, scale);
    return rival_solve(k11, g->g12 + y, k22, g->g1 + p.v * g->g3 + w * t, g->g2 + p.u * g->g3 + w * s, scale);
}

/* Limits of u and v after a step. */
struct rival_box {
    FOOTPOINT_REAL low[2], high[2];
};

struct rival_clamp {
    struct rival_box plain, scaled; /* for all steps but the last, and for the last */
};

/* Clamps by comparisons that compile to the machine's maximum and minimum. */
RIVAL_FN FOOTPOINT_REAL rival_between(FOOTPOINT_REAL low, FOOTPOINT_REAL x, FOOTPOINT_REAL high)
{
    const FOOTPOINT_REAL above = x < low ? low : x;
    return high < above ? high : above;
}

RIVAL_FN struct rival_point rival_clamped(struct rival_point p, const struct rival_box *box)
{
    p.u = rival_between(box->low[0], p.u, box->high[0]);
    p.v = rival_between(box->low[1], p.v, box->high[1]);
    return p;
}

enum rival_needs { RIVAL_ONE_GAUSS_NEWTON, RIVAL_ONE_NEWTON, RIVAL_MANY };

/* Computes all nine scalar products, or those that a single step needs. */
RIVAL_FN struct rival_products rival_products_of(const struct rival_basis *b, enum rival_needs needs)
{
    struct rival_products g;
    g.g11 = rival_dot(b->e1, b->e1);
    g.g12 = rival_dot(b->e1, b->e2);
    g.g22 = rival_dot(b->e2, b->e2);
    g.g1 = rival_dot(b->e1, b->d);
    g.g2 = rival_dot(b->e2, b->d);
    g.g13 = g.g23 = g.g33 = g.g3 = 0;
    if (needs != RIVAL_ONE_GAUSS_NEWTON)
        g.g3 = rival_dot(b->c3, b->d);
    if (needs == RIVAL_MANY) {
        g.g13 = rival_dot(b->e1, b->c3);
        g.g23 = rival_dot(b->e2, b->c3);
        g.g33 = rival_dot(b->c3, b->c3);
    }
    return g;
}

/* The steps of an iteration from u = v = 0. They are constants at each call, so that no branch remains. The result of
 * the last step is scaled within its division. */
struct rival_plan {
    int gauss_newton, newton;
    FOOTPOINT_REAL scale;
    const struct rival_clamp *clamp; /* or NULL */
};

/* Takes step k, from 0, if the plan has it. */
RIVAL_FN struct rival_point rival_advance(const struct rival_products *g, const struct rival_plan *plan, int k,
                                          struct rival_point p)
{
    const int last = plan->gauss_newton + plan->newton - 1, newton = k >= plan->gauss_newton;
    const FOOTPOINT_REAL one = 1.0, scale = k == last ? plan->scale : one;
    if (k > last)
        return p;
    p = k == 0 ? rival_first(g, newton, scale) : rival_step(g, newton, p, scale);
    return plan->clamp ? rival_clamped(p, k == last ? &plan->clamp->scaled : &plan->clamp->plain) : p;
}

RIVAL_FN struct rival_point rival_steps(const struct rival_basis *b, const struct rival_plan *plan)
{
    const int many = plan->gauss_newton + plan->newton > 1;
    const struct rival_products g = rival_products_of(b, many           ? RIVAL_MANY
                                                         : plan->newton ? RIVAL_ONE_NEWTON
                                                                        : RIVAL_ONE_GAUSS_NEWTON);
    struct rival_point p = {0, 0};
    p = rival_advance(&g, plan, 0, p);
    p = rival_advance(&g, plan, 1, p);
    p = rival_advance(&g, plan, 2, p);
    return rival_advance(&g, plan, 3, p);
}

/* Runs a truncated iteration. The last step of a "quarter" is halved. */
RIVAL_FN void rival_iterate(RIVAL_NODES, enum rival_start start, int gauss_newton, int newton, int clamped,
                            FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL one = 1.0, half = 0.5;
    const struct rival_box unit = {{-one, -one}, {one, one}}, quarter = {{-half, -half}, {half, half}};
    const struct rival_clamp centre_clamp = {unit, unit}, quarter_clamp = {unit, quarter};
    struct rival_basis b;
    if (start == RIVAL_CENTRE)
        rival_basis_centre(xA, xB, xC, xD, xS, &b);
    else
        rival_basis_quarter(xA, xB, xC, xD, xS, &b);
    const struct rival_clamp *clamp = start == RIVAL_CENTRE ? &centre_clamp : &quarter_clamp;
    const struct rival_plan plan = {gauss_newton, newton, start == RIVAL_CENTRE ? one : half, clamped ? clamp : NULL};
    const struct rival_point p = rival_steps(&b, &plan);
    *xi = start == RIVAL_CENTRE ? p.u : p.u - half;
    *eta = start == RIVAL_CENTRE ? p.v : p.v - half;
}

#define RIVAL_DEFINE(name, start, gauss_newton, newton, clamped)                                                       \
    RIVAL_FN void rival_##name(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)                                   \
    {                                                                                                                  \
        rival_iterate(xA, xB, xC, xD, xS, start, gauss_newton, newton, clamped, xi, eta);                              \
    }
RIVAL_ITERATIONS(RIVAL_DEFINE)
#undef RIVAL_DEFINE

#endif
