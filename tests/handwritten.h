/* The formulas of the shipped genomes (evolve/frames/parallelogram.gen) as a finite element programmer writes them by
 * hand: vectors, scalar products, and one function for each idea.  The reference for the speed of the emitted code.
 *
 * A method is a truncated iteration about the point (xi0, eta0): start with the taper to first or second order, clamped
 * to a box or not, then Newton steps, clamped likewise.  FOOTPOINT_FN is that of the generated headers. */
#ifndef FOOTPOINT_HANDWRITTEN_H
#define FOOTPOINT_HANDWRITTEN_H

#define HAND_NODES const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3]

/* Scalar products of e1, e2, m3 and d: 4 (r - r0) = e1 u + e2 v + m3 u v, d = 4 (xS - r0). */
struct hand_products {
    double e11, e12, e22, d1, d2, c1, c2, cd, cc;
};

struct hand_box {
    double lo, hi; /* of u and of v */
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

/* Taper to second order, with one division: w = u v obeys a b w^2 - (1 + a q + b p) w + p q = 0 on a plane segment. */
FOOTPOINT_FN void hand_taper(const struct hand_products *g, double *u, double *v)
{
    const double det = g->e11 * g->e22 - g->e12 * g->e12;
    const double p = g->e22 * g->d1 - g->e12 * g->d2, q = g->e11 * g->d2 - g->e12 * g->d1; /* times det */
    const double a = g->e22 * g->c1 - g->e12 * g->c2, b = g->e11 * g->c2 - g->e12 * g->c1;
    const double linear = det * det + a * q + b * p;
    const double r = 1 / (det * linear);
    const double w = p * q * r * det;
    *u = (p - a * w) * r * linear;
    *v = (q - b * w) * r * linear;
}

/* One Newton step on (7), (8). */
FOOTPOINT_FN void hand_newton(const struct hand_products *g, double *u, double *v)
{
    const double t = g->c1 + *v * g->cc, s = g->c2 + *u * g->cc;
    const double y = *u * g->c1 + *v * s, w = *u * *v;
    const double r11 = g->e11 + *v * (g->c1 + t), r22 = g->e22 + *u * (g->c2 + s), r12 = g->e12 + 2 * y - g->cd;
    const double f1 = g->d1 + *v * y + w * t, f2 = g->d2 + *u * y + w * s;
    const double inverse = 1 / (r11 * r22 - r12 * r12);
    *u = (r22 * f1 - r12 * f2) * inverse;
    *v = (r11 * f2 - r12 * f1) * inverse;
}

FOOTPOINT_FN double hand_clamp(double u, struct hand_box box)
{
    const double above = u < box.lo ? box.lo : u;
    return above > box.hi ? box.hi : above;
}

/* Centre of the segment, nothing clamped. */
FOOTPOINT_FN void hand_search(HAND_NODES, int steps, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, 0, 0);
    double u, v;
    hand_taper(&g, &u, &v);
    for (int i = 0; i < steps; i++)
        hand_newton(&g, &u, &v);
    *xi = u;
    *eta = v;
}

FOOTPOINT_FN void hand_coarse(HAND_NODES, double *xi, double *eta)
{
    hand_search(xA, xB, xC, xD, xS, 0, xi, eta);
}

FOOTPOINT_FN void hand_balanced(HAND_NODES, double *xi, double *eta)
{
    hand_search(xA, xB, xC, xD, xS, 1, xi, eta);
}

FOOTPOINT_FN void hand_accurate(HAND_NODES, double *xi, double *eta)
{
    hand_search(xA, xB, xC, xD, xS, 2, xi, eta);
}

/* One Gauss-Newton step, from the centre. */
FOOTPOINT_FN void hand_fast(HAND_NODES, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, 0, 0);
    const double inverse = 1 / (g.e11 * g.e22 - g.e12 * g.e12);
    *xi = (g.e22 * g.d1 - g.e12 * g.d2) * inverse;
    *eta = (g.e11 * g.d2 - g.e12 * g.d1) * inverse;
}

/* Taper to first order, then a Gauss-Newton step. */
FOOTPOINT_FN void hand_medium(HAND_NODES, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, 0, 0);
    const double inverse = 1 / (g.e11 * g.e22 - g.e12 * g.e12);
    const double p = (g.e22 * g.d1 - g.e12 * g.d2) * inverse, q = (g.e11 * g.d2 - g.e12 * g.d1) * inverse;
    const double a = (g.e22 * g.c1 - g.e12 * g.c2) * inverse, b = (g.e11 * g.c2 - g.e12 * g.c1) * inverse;
    const double u = p - a * (p * q), v = q - b * (p * q);
    const double t = g.c1 + v * g.cc, s = g.c2 + u * g.cc, y = u * g.c1 + v * s, w = u * v;
    const double k11 = g.e11 + v * (g.c1 + t), k22 = g.e22 + u * (g.c2 + s), k12 = g.e12 + y;
    const double f1 = g.d1 + v * g.cd + w * t, f2 = g.d2 + u * g.cd + w * s;
    const double again = 1 / (k11 * k22 - k12 * k12);
    *xi = (k22 * f1 - k12 * f2) * again;
    *eta = (k11 * f2 - k12 * f1) * again;
}

FOOTPOINT_FN void hand_most_accurate(HAND_NODES, double *xi, double *eta)
{
    hand_search(xA, xB, xC, xD, xS, 3, xi, eta);
}

/* A Newton step whose determinant is at least 0.02 of its first product. */
FOOTPOINT_FN void hand_guarded_newton(const struct hand_products *g, double *u, double *v)
{
    const double t = g->c1 + *v * g->cc, s = g->c2 + *u * g->cc;
    const double y = *u * g->c1 + *v * s, w = *u * *v;
    const double r11 = g->e11 + *v * (g->c1 + t), r22 = g->e22 + *u * (g->c2 + s), r12 = g->e12 + 2 * y - g->cd;
    const double f1 = g->d1 + *v * y + w * t, f2 = g->d2 + *u * y + w * s;
    const double m = r11 * r22, j = m - r12 * r12, least = 0.02 * m, kept = j < least ? least : j;
    const double inverse = 1 / kept;
    *u = ((kept - j) * *u + (r22 * f1 - r12 * f2)) * inverse;
    *v = ((kept - j) * *v + (r11 * f2 - r12 * f1)) * inverse;
}

/* About the point (x0,x0), for contact points within `half` of it in xi and eta: taper to first order, Newton steps. */
FOOTPOINT_FN void hand_guarded(HAND_NODES, double x0, double half, int steps, double *xi, double *eta)
{
    const struct hand_products g = hand_expand(xA, xB, xC, xD, xS, x0, x0);
    const struct hand_box box = {-half, half};
    const double inverse = 1 / (g.e11 * g.e22 - g.e12 * g.e12);
    const double p = (g.e22 * g.d1 - g.e12 * g.d2) * inverse, q = (g.e11 * g.d2 - g.e12 * g.d1) * inverse;
    const double a = (g.e22 * g.c1 - g.e12 * g.c2) * inverse, b = (g.e11 * g.c2 - g.e12 * g.c1) * inverse;
    const double linear = 1 - (a * q + b * p), w = p * q * (linear < 0.6 ? 0.6 : linear);
    double u = hand_clamp(p - a * w, box), v = hand_clamp(q - b * w, box);
    for (int i = 0; i < steps; i++) {
        hand_guarded_newton(&g, &u, &v);
        u = hand_clamp(u, box);
        v = hand_clamp(v, box);
    }
    *xi = x0 + u;
    *eta = x0 + v;
}

#define HAND_GUARDED(name, x0, half, steps)                                                                            \
    FOOTPOINT_FN void hand_##name(HAND_NODES, double *xi, double *eta)                                                 \
    {                                                                                                                  \
        hand_guarded(xA, xB, xC, xD, xS, x0, half, steps, xi, eta);                                                    \
    }
HAND_GUARDED(paper_taper, -0.5, 0.5, 0)
HAND_GUARDED(paper_newton1, -0.5, 0.5, 1)
HAND_GUARDED(paper_newton2, -0.5, 0.5, 2)
HAND_GUARDED(whole_taper, 0.0, 1.0, 0)
HAND_GUARDED(whole_newton1, 0.0, 1.0, 1)
HAND_GUARDED(whole_newton2, 0.0, 1.0, 2)

#endif
