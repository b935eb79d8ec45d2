/* What a good finite element programmer writes by hand for the local contact search: the methods that generated code
 * has to beat.  All are inline, so that a loop over them can be vectorised, and spend no multiplication that algebra
 * avoids.
 *
 * Truncated iterations.  Any bilinear segment is r = r0 + e1 u + e2 v + c3 u v about a point r0 of it, up to a common
 * factor of e1, e2, c3 and d = xS - r0 that cancels.  With e1, e2, c3, d known by their nine scalar products
 *     g11 = e1.e1  g12 = e1.e2  g13 = e1.c3  g22 = e2.e2  g23 = e2.c3  g33 = c3.c3  g1 = e1.d  g2 = e2.d  g3 = c3.d,
 * a Gauss-Newton step or a Newton step on (7), (8) costs the same 19 multiplications and a division.  From
 *     t = g13 + v g33,  s = g23 + u g33,  y = u g13 + v s = c3.(r - r0)
 * come r_u.r_u = g11 + v (g13 + t), r_v.r_v = g22 + u (g23 + s), r_u.r_v = g12 + y, and c3.(xS - r) = g3 - y.  Solving
 * for the new point instead of the increment leaves as right-hand sides
 *     Gauss-Newton:  g1 + v g3 + u v t,  g2 + u g3 + u v s         Newton:  g1 + v y + u v t,  g2 + u y + u v s.
 * The first step, from u = v = 0, needs five of the products only.
 *
 * "centre" starts at (0,0), "quarter" at (-1/2,-1/2), the middle of corner A's quarter.  "clamped" keeps u and v of
 * every step within what the start stands for: the segment, or A's quarter of it.
 *
 * A count of operations replaces the scalar type: define FOOTPOINT_REAL (and its sqrt) before. */
#ifndef FOOTPOINT_RIVALS_H
#define FOOTPOINT_RIVALS_H

#include <math.h>

#ifndef FOOTPOINT_REAL
#define FOOTPOINT_REAL double
#endif

#define RIVAL_FN static inline __attribute__((always_inline))
#define RIVAL_NODES                                                                                                    \
    const FOOTPOINT_REAL xA[3], const FOOTPOINT_REAL xB[3], const FOOTPOINT_REAL xC[3], const FOOTPOINT_REAL xD[3],    \
        const FOOTPOINT_REAL xS[3]

enum rival_start { RIVAL_CENTRE, RIVAL_QUARTER };

/** Truncated iterations: R(name, start, Gauss-Newton steps, Newton steps, clamped). */
#define RIVAL_ITERATIONS(R)                                                                                            \
    R(gn1_centre, RIVAL_CENTRE, 1, 0, 0)                                                                               \
    R(gn2_centre, RIVAL_CENTRE, 2, 0, 0)                                                                               \
    R(gn3_centre, RIVAL_CENTRE, 3, 0, 0)                                                                               \
    R(gn4_centre, RIVAL_CENTRE, 4, 0, 0)                                                                               \
    R(gn1n1_centre, RIVAL_CENTRE, 1, 1, 0)                                                                             \
    R(gn1n2_centre, RIVAL_CENTRE, 1, 2, 0)                                                                             \
    R(gn2n1_centre, RIVAL_CENTRE, 2, 1, 0)                                                                             \
    R(gn1_centre_clamped, RIVAL_CENTRE, 1, 0, 1)                                                                       \
    R(gn2_centre_clamped, RIVAL_CENTRE, 2, 0, 1)                                                                       \
    R(gn3_centre_clamped, RIVAL_CENTRE, 3, 0, 1)                                                                       \
    R(gn1n1_centre_clamped, RIVAL_CENTRE, 1, 1, 1)                                                                     \
    R(gn2n1_centre_clamped, RIVAL_CENTRE, 2, 1, 1)                                                                     \
    R(gn1_quarter, RIVAL_QUARTER, 1, 0, 0)                                                                             \
    R(gn2_quarter, RIVAL_QUARTER, 2, 0, 0)                                                                             \
    R(gn3_quarter, RIVAL_QUARTER, 3, 0, 0)                                                                             \
    R(gn4_quarter, RIVAL_QUARTER, 4, 0, 0)                                                                             \
    R(gn1n1_quarter, RIVAL_QUARTER, 1, 1, 0)                                                                           \
    R(gn1n2_quarter, RIVAL_QUARTER, 1, 2, 0)                                                                           \
    R(gn2n1_quarter, RIVAL_QUARTER, 2, 1, 0)                                                                           \
    R(gn1_quarter_clamped, RIVAL_QUARTER, 1, 0, 1)                                                                     \
    R(gn2_quarter_clamped, RIVAL_QUARTER, 2, 0, 1)                                                                     \
    R(gn3_quarter_clamped, RIVAL_QUARTER, 3, 0, 1)                                                                     \
    R(gn1n1_quarter_clamped, RIVAL_QUARTER, 1, 1, 1)                                                                   \
    R(gn1n2_quarter_clamped, RIVAL_QUARTER, 1, 2, 1)                                                                   \
    R(gn2n1_quarter_clamped, RIVAL_QUARTER, 2, 1, 1)

/** Closed forms: R(name). */
#define RIVAL_CLOSED_FORMS(R)                                                                                          \
    R(area)                                                                                                            \
    R(plane)

/** Iterations of the converged Newton method: Gauss-Newton first, and the step at which it stops. */
enum { RIVAL_NEWTON_GAUSS = 3, RIVAL_NEWTON_MAX = 50 };
#define RIVAL_NEWTON_TOLERANCE 1e-10

/** The methods as a table, in the order of the lists above. */
typedef void rival_search(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta);
struct rival {
    const char *name;
    rival_search *search;
};
extern const struct rival rivals[];
extern const int rival_count;

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

/* About (0,0), all times 4; u = xi, v = eta. */
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

/* About (-1/2,-1/2): e1, e2 times 8, c3 times 4, d times 16, so that u = 2 xi + 1, v = 2 eta + 1. */
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

/* scale times the solution of a symmetric pair of equations. */
RIVAL_FN struct rival_point rival_solve(FOOTPOINT_REAL k11, FOOTPOINT_REAL k12, FOOTPOINT_REAL k22, FOOTPOINT_REAL b1,
                                        FOOTPOINT_REAL b2, FOOTPOINT_REAL scale)
{
    const FOOTPOINT_REAL inverse = scale / (k11 * k22 - k12 * k12);
    struct rival_point p;
    p.u = (k22 * b1 - k12 * b2) * inverse;
    p.v = (k11 * b2 - k12 * b1) * inverse;
    return p;
}

/* Gauss-Newton from u = v = 0. */
RIVAL_FN struct rival_point rival_first(const struct rival_products *g, FOOTPOINT_REAL scale)
{
    return rival_solve(g->g11, g->g12, g->g22, g->g1, g->g2, scale);
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

RIVAL_FN FOOTPOINT_REAL rival_clamp(FOOTPOINT_REAL x, FOOTPOINT_REAL limit)
{
    const FOOTPOINT_REAL least = -limit;
    const FOOTPOINT_REAL above = x < least ? least : x;
    return limit < above ? limit : above;
}

/* All nine scalar products, or the five that the first step needs. */
RIVAL_FN struct rival_products rival_products_of(const struct rival_basis *b, int first_only)
{
    struct rival_products g;
    g.g11 = rival_dot(b->e1, b->e1);
    g.g12 = rival_dot(b->e1, b->e2);
    g.g22 = rival_dot(b->e2, b->e2);
    g.g1 = rival_dot(b->e1, b->d);
    g.g2 = rival_dot(b->e2, b->d);
    if (first_only) {
        g.g13 = g.g23 = g.g33 = g.g3 = 0;
        return g;
    }
    g.g13 = rival_dot(b->e1, b->c3);
    g.g23 = rival_dot(b->e2, b->c3);
    g.g33 = rival_dot(b->c3, b->c3);
    g.g3 = rival_dot(b->c3, b->d);
    return g;
}

/* A truncated iteration.  The counts are constants where this is called, so that nothing of the loop is left.  The last
 * step of a "quarter" yields u/2 and v/2: the scale goes into the division. */
RIVAL_FN void rival_iterate(RIVAL_NODES, enum rival_start start, int gauss_newton, int newton, int clamped,
                            FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const int steps = gauss_newton + newton;
    struct rival_basis b;
    if (start == RIVAL_CENTRE)
        rival_basis_centre(xA, xB, xC, xD, xS, &b);
    else
        rival_basis_quarter(xA, xB, xC, xD, xS, &b);
    const struct rival_products g = rival_products_of(&b, steps == 1);
    struct rival_point p;
    for (int k = 0; k < steps; k++) {
        const FOOTPOINT_REAL scale = start == RIVAL_QUARTER && k == steps - 1 ? 0.5 : 1.0;
        p = k == 0 ? rival_first(&g, scale) : rival_step(&g, k >= gauss_newton, p, scale);
        if (clamped) {
            p.u = rival_clamp(p.u, scale);
            p.v = rival_clamp(p.v, scale);
        }
    }
    *xi = start == RIVAL_CENTRE ? p.u : p.u - 0.5;
    *eta = start == RIVAL_CENTRE ? p.v : p.v - 0.5;
}

#define RIVAL_DEFINE(name, start, gauss_newton, newton, clamped)                                                       \
    RIVAL_FN void rival_##name(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)                                   \
    {                                                                                                                  \
        rival_iterate(xA, xB, xC, xD, xS, start, gauss_newton, newton, clamped, xi, eta);                              \
    }
RIVAL_ITERATIONS(RIVAL_DEFINE)
#undef RIVAL_DEFINE

/** Newton's iteration from the centre, three Gauss-Newton steps first, until a step moves neither xi nor eta by more
 * than the tolerance.  Returns the steps taken, or 0 if `most` of them were not enough (xi, eta are then where it
 * stands). */
RIVAL_FN int rival_newton(RIVAL_NODES, int most, double tolerance, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL one = 1.0, limit = tolerance;
    struct rival_basis b;
    rival_basis_centre(xA, xB, xC, xD, xS, &b);
    const struct rival_products g = rival_products_of(&b, 0);
    struct rival_point p = rival_first(&g, one);
    int n = 1;
    for (; n < most; n++) {
        const struct rival_point next = rival_step(&g, n >= RIVAL_NEWTON_GAUSS, p, one);
        const FOOTPOINT_REAL du = next.u - p.u, dv = next.v - p.v;
        p = next;
        if (fabs(du) <= limit && fabs(dv) <= limit)
            break;
    }
    *xi = p.u;
    *eta = p.v;
    return n < most ? n + 1 : 0;
}

/* Twice the area of the triangle of the origin, a and b. */
RIVAL_FN FOOTPOINT_REAL rival_triangle(const FOOTPOINT_REAL a[3], const FOOTPOINT_REAL b[3])
{
    const FOOTPOINT_REAL x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    return sqrt(x * x + y * y + z * z);
}

/** Area coordinates (12)-(16) with the triangles of S itself.  With D1 = SAB, D2 = SBC, D3 = SCD, D4 = SDA the shape
 *  functions of A, B, C, D are D2 D3, D3 D4, D4 D1, D1 D2 over (D1 + D3)(D2 + D4), and so
 *  xi = phi_B + phi_C - phi_A - phi_D = (D4 - D2)/(D4 + D2), eta = (D1 - D3)/(D1 + D3). */
RIVAL_FN void rival_area(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    FOOTPOINT_REAL a[3], b[3], c[3], d[3];
    for (int i = 0; i < 3; i++) {
        a[i] = xA[i] - xS[i];
        b[i] = xB[i] - xS[i];
        c[i] = xC[i] - xS[i];
        d[i] = xD[i] - xS[i];
    }
    const FOOTPOINT_REAL d1 = rival_triangle(a, b), d2 = rival_triangle(b, c), d3 = rival_triangle(c, d),
                         d4 = rival_triangle(d, a);
    *xi = (d4 - d2) / (d4 + d2);
    *eta = (d1 - d3) / (d1 + d3);
}

/** The exact answer of a plane segment: with d = p e1 + q e2 and c3 = a e1 + b e2 in its plane, u = p - a u v and
 *  v = q - b u v give b u^2 + (1 - k) u - p = 0, k = b p - a q.  A warped segment is projected onto the plane of its
 *  mid-lines; a negative discriminant counts as 0. */
RIVAL_FN void rival_plane(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL one = 1.0, none = 0.0;
    struct rival_basis e;
    rival_basis_centre(xA, xB, xC, xD, xS, &e);
    const FOOTPOINT_REAL g11 = rival_dot(e.e1, e.e1), g12 = rival_dot(e.e1, e.e2), g22 = rival_dot(e.e2, e.e2);
    const FOOTPOINT_REAL g13 = rival_dot(e.e1, e.c3), g23 = rival_dot(e.e2, e.c3);
    const FOOTPOINT_REAL g1 = rival_dot(e.e1, e.d), g2 = rival_dot(e.e2, e.d);
    const FOOTPOINT_REAL inverse = one / (g11 * g22 - g12 * g12);
    const FOOTPOINT_REAL p = (g22 * g1 - g12 * g2) * inverse, q = (g11 * g2 - g12 * g1) * inverse;
    const FOOTPOINT_REAL a = (g22 * g13 - g12 * g23) * inverse, b = (g11 * g23 - g12 * g13) * inverse;
    const FOOTPOINT_REAL bp = b * p, linear = one - (bp - a * q), bp2 = bp + bp;
    const FOOTPOINT_REAL square = linear * linear + (bp2 + bp2);
    const FOOTPOINT_REAL u = (p + p) / (linear + sqrt(square < none ? none : square));
    *xi = u;
    *eta = q / (one + b * u);
}

#endif
