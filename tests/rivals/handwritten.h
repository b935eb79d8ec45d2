/* The formulas of the shipped genomes (evolve/frames/parallelogram.gen, steps.gen) as a finite element programmer
 * writes them: vectors, scalar products, and a function for each idea. The reference for the speed of the emitted code.
 *
 * A method is a truncated iteration about the point (xi0, eta0): a start with the taper, then steps of Gauss, Newton
 * and Chebyshev, optionally kept in a box. FOOTPOINT_FN is defined as in the generated headers. */
#ifndef FOOTPOINT_HANDWRITTEN_H
#define FOOTPOINT_HANDWRITTEN_H

#define HAND_NODES const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3]

/* Scalar products of e1, e2, m3 and d: 4 (r - r0) = e1 u + e2 v + m3 u v, d = 4 (xS - r0). */
struct hand_products {
    double e11, e12, e22, d1, d2, c1, c2, cd, cc;
};

struct hand_point {
    double u, v;
};

struct hand_box {
    double lo, hi; /* limits of u and v */
};

FOOTPOINT_FN double hand_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

FOOTPOINT_FN struct hand_products hand_expand(HAND_NODES, double xi0, double eta0)
{
    double e1[3], e2[3], m3[3], d[3];
    for (int i = 0; i < 3; i++) {
        const double ab = xB[i] - xA[i], ad = xD[i] - xA[i], as = xS[i] - xA[i];
        m3[i] = xC[i] - xD[i] - ab;
        e1[i] = 2 * ab + (1 + eta0) * m3[i];
        e2[i] = 2 * ad + (1 + xi0) * m3[i];
        d[i] = 2 * (2 * as - (1 + xi0) * ab) - (1 + eta0) * e2[i];
    }
    return (struct hand_products){hand_dot(e1, e1), hand_dot(e1, e2), hand_dot(e2, e2),
                                  hand_dot(d, e1),  hand_dot(d, e2),  hand_dot(m3, e1),
                                  hand_dot(m3, e2), hand_dot(m3, d),  hand_dot(m3, m3)};
}

/* In-plane coordinates of d and m3, times the determinant. */
struct hand_plane {
    double det, p, q, a, b;
};

FOOTPOINT_FN struct hand_plane hand_in_plane(const struct hand_products *g)
{
    return (struct hand_plane){g->e11 * g->e22 - g->e12 * g->e12, g->e22 * g->d1 - g->e12 * g->d2,
                               g->e11 * g->d2 - g->e12 * g->d1, g->e22 * g->c1 - g->e12 * g->c2,
                               g->e11 * g->c2 - g->e12 * g->c1};
}

/* Solves for the taper to second order with one division. On a plane segment w = u v satisfies a b w^2 - (1 + a q + b
 * p) w + p q = 0. */
FOOTPOINT_FN struct hand_point hand_taper(const struct hand_products *g)
{
    const struct hand_plane h = hand_in_plane(g);
    const double linear = h.det * h.det + h.a * h.q + h.b * h.p;
    const double r = 1 / (h.det * linear);
    const double w = h.p * h.q * r * h.det;
    return (struct hand_point){(h.p - h.a * w) * r * linear, (h.q - h.b * w) * r * linear};
}

/* Takes one Gauss-Newton step on (7), (8). */
FOOTPOINT_FN struct hand_point hand_gauss(const struct hand_products *g, struct hand_point x)
{
    const double t = g->c1 + x.v * g->cc, s = g->c2 + x.u * g->cc, y = x.u * g->c1 + x.v * s, w = x.u * x.v;
    const double r11 = g->e11 + x.v * (g->c1 + t), r12 = g->e12 + y, r22 = g->e22 + x.u * (g->c2 + s);
    const double f1 = g->d1 + x.v * g->cd + w * t, f2 = g->d2 + x.u * g->cd + w * s;
    const double inverse = 1 / (r11 * r22 - r12 * r12);
    return (struct hand_point){(r22 * f1 - r12 * f2) * inverse, (r11 * f2 - r12 * f1) * inverse};
}

/* Takes one or two Gauss-Newton steps from the centre, with or without the taper between them, and without a box. */
FOOTPOINT_FN void hand_gauss_steps(HAND_NODES, int taper, int second, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, 0, 0);
    const struct hand_plane h = hand_in_plane(&g);
    const double inverse = 1 / h.det, p = h.p * inverse, q = h.q * inverse, w = p * q;
    struct hand_point x = {p, q};
    if (taper)
        x = (struct hand_point){p - h.a * inverse * w, q - h.b * inverse * w};
    if (second)
        x = hand_gauss(&g, x);
    *xi = x.u;
    *eta = x.v;
}

FOOTPOINT_FN void hand_fast(HAND_NODES, double *xi, double *eta)
{
    hand_gauss_steps(xA, xB, xC, xD, xS, 0, 0, xi, eta);
}

FOOTPOINT_FN void hand_gauss2(HAND_NODES, double *xi, double *eta)
{
    hand_gauss_steps(xA, xB, xC, xD, xS, 0, 1, xi, eta);
}

FOOTPOINT_FN void hand_medium(HAND_NODES, double *xi, double *eta)
{
    hand_gauss_steps(xA, xB, xC, xD, xS, 1, 1, xi, eta);
}

FOOTPOINT_FN void hand_coarse(HAND_NODES, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, 0, 0);
    const struct hand_point x = hand_taper(&g);
    *xi = x.u;
    *eta = x.v;
}

FOOTPOINT_FN double hand_clamp(double u, struct hand_box box)
{
    const double above = u < box.lo ? box.lo : u;
    return above > box.hi ? box.hi : above;
}

FOOTPOINT_FN struct hand_point hand_clamp_point(struct hand_point x, struct hand_box box)
{
    return (struct hand_point){hand_clamp(x.u, box), hand_clamp(x.v, box)};
}

/* Takes one Gauss-Newton step about the point (x0,x0), then the taper to second order, in the box about it that
 * contains the contact points. */
FOOTPOINT_FN void hand_lattice_gauss(HAND_NODES, double x0, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, x0, x0);
    const struct hand_plane h = hand_in_plane(&g);
    const double inverse = 1 / h.det;
    *xi = x0 + h.p * inverse;
    *eta = x0 + h.q * inverse;
}

FOOTPOINT_FN void hand_lattice_taper(HAND_NODES, double x0, struct hand_box box, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, x0, x0);
    const struct hand_plane h = hand_in_plane(&g);
    const double inverse = 1 / h.det, p = h.p * inverse, q = h.q * inverse, a = h.a * inverse, b = h.b * inverse;
    const double linear = 1 - (a * q + b * p), w = p * q * (linear < 0.6 ? 0.6 : linear);
    const struct hand_point x = hand_clamp_point((struct hand_point){p - a * w, q - b * w}, box);
    *xi = x0 + x.u;
    *eta = x0 + x.v;
}

FOOTPOINT_FN void hand_lattice_gauss2(HAND_NODES, double x0, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, x0, x0);
    const struct hand_plane h = hand_in_plane(&g);
    const double inverse = 1 / h.det;
    const struct hand_point x = hand_gauss(&g, (struct hand_point){h.p * inverse, h.q * inverse});
    *xi = x0 + x.u;
    *eta = x0 + x.v;
}

#define HAND_LATTICE(scene, x0, high)                                                                                  \
    FOOTPOINT_FN void hand_##scene##_gauss(HAND_NODES, double *xi, double *eta)                                        \
    {                                                                                                                  \
        hand_lattice_gauss(xA, xB, xC, xD, xS, x0, xi, eta);                                                           \
    }                                                                                                                  \
    FOOTPOINT_FN void hand_##scene##_taper(HAND_NODES, double *xi, double *eta)                                        \
    {                                                                                                                  \
        const struct hand_box box = {-1 - (x0), (high) - (x0)};                                                        \
        hand_lattice_taper(xA, xB, xC, xD, xS, x0, box, xi, eta);                                                      \
    }                                                                                                                  \
    FOOTPOINT_FN void hand_##scene##_gauss2(HAND_NODES, double *xi, double *eta)                                       \
    {                                                                                                                  \
        hand_lattice_gauss2(xA, xB, xC, xD, xS, x0, xi, eta);                                                          \
    }
HAND_LATTICE(paper, -0.45, 0.0)
HAND_LATTICE(whole, -0.15, 1.0)

#endif
