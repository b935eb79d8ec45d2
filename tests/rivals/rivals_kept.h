/* The hand-derived functions of the paper's lattice that bred functions replaced: a start with the taper, then Newton
 * or Chebyshev steps whose determinant is kept away from 0, about the best point of the scene and within its box.
 * Evolution composed its functions from the same steps (evolve/frames/steps.gen); they must not lose to these. */
#ifndef FOOTPOINT_RIVALS_KEPT_H
#define FOOTPOINT_RIVALS_KEPT_H

#include "rivals_tuned.h"

/* One Gauss-Newton step inside the box, or with the taper to first or second order. */
enum rival_kept_start { RIVAL_KEPT_GAUSS, RIVAL_KEPT_TAPER, RIVAL_KEPT_MORE };

/** R(name, start, Newton steps, Chebyshev steps); if there are two, the last applies its squares twice. */
#define RIVAL_KEPT(R)                                                                                                  \
    R(hand_kept_newton, RIVAL_KEPT_GAUSS, 1, 0)                                                                        \
    R(hand_kept_medium, RIVAL_KEPT_TAPER, 1, 0)                                                                        \
    R(hand_kept_balanced, RIVAL_KEPT_MORE, 0, 1)                                                                       \
    R(hand_kept_fine, RIVAL_KEPT_MORE, 2, 0)                                                                           \
    R(hand_kept_precise, RIVAL_KEPT_MORE, 3, 0)                                                                        \
    R(hand_kept_accurate, RIVAL_KEPT_MORE, 0, 2)                                                                       \
    R(hand_kept_full, RIVAL_KEPT_MORE, 4, 0)

struct rival_matrix {
    FOOTPOINT_REAL k11, k12, k22, t, s, inverse;
};

RIVAL_FN struct rival_point rival_by(const struct rival_matrix *m, FOOTPOINT_REAL b1, FOOTPOINT_REAL b2)
{
    struct rival_point p;
    p.u = (m->k22 * b1 - m->k12 * b2) * m->inverse;
    p.v = (m->k11 * b2 - m->k12 * b1) * m->inverse;
    return p;
}

RIVAL_FN struct rival_point rival_kept_start(const struct rival_products *g, enum rival_kept_start start,
                                             const struct rival_box *box)
{
    const FOOTPOINT_REAL one = 1.0, half = 0.5, zero = 0.0;
    const struct rival_matrix m = {g->g11, g->g12, g->g22, zero, zero, one / (g->g11 * g->g22 - g->g12 * g->g12)};
    struct rival_point p = rival_by(&m, g->g1, g->g2);
    const struct rival_point in = rival_clamped(p, box);
    if (start == RIVAL_KEPT_GAUSS)
        return in;
    const struct rival_point taper = rival_by(&m, g->g13, g->g23);
    FOOTPOINT_REAL w = in.u * in.v;
    if (start == RIVAL_KEPT_MORE) {
        const FOOTPOINT_REAL linear = one - (taper.u * in.v + taper.v * in.u);
        w = w * (linear < half ? half : linear);
    }
    p.u = p.u - taper.u * w;
    p.v = p.v - taper.v * w;
    return p;
}

/* Takes a Newton step, then corrects it several times by the squares that it omits, within a limit. */
RIVAL_FN struct rival_point rival_kept_step(const struct rival_products *g, struct rival_point p, int squares,
                                            const struct rival_box *box)
{
    const FOOTPOINT_REAL one = 1.0, least = (FOOTPOINT_REAL)0.02, most = (FOOTPOINT_REAL)0.05;
    const struct rival_box limit = {{-most, -most}, {most, most}};
    struct rival_matrix m;
    m.t = g->g13 + p.v * g->g33;
    m.s = g->g23 + p.u * g->g33;
    const FOOTPOINT_REAL y = p.u * g->g13 + p.v * m.s, w = p.u * p.v;
    m.k11 = g->g11 + p.v * (g->g13 + m.t);
    m.k22 = g->g22 + p.u * (g->g23 + m.s);
    m.k12 = g->g12 + (y + y) - g->g3;
    const FOOTPOINT_REAL first = m.k11 * m.k22, det = first - m.k12 * m.k12, low = least * first;
    const FOOTPOINT_REAL kept = det < low ? low : det;
    m.inverse = one / kept;
    const FOOTPOINT_REAL stay = (kept - det) * m.inverse;
    struct rival_point to = rival_by(&m, g->g1 + p.v * y + w * m.t, g->g2 + p.u * y + w * m.s);
    to.u = to.u + stay * p.u;
    to.v = to.v + stay * p.v;
    struct rival_point found = to;
    for (int i = 0; i < squares; i++) {
        const FOOTPOINT_REAL du = found.u - p.u, dv = found.v - p.v, a = m.t * du, b = m.s * dv;
        const struct rival_point c = rival_clamped(rival_by(&m, dv * (a + a + b), du * (b + b + a)), &limit);
        found.u = to.u - c.u;
        found.v = to.v - c.v;
        if (i + 1 < squares)
            found = rival_clamped(found, box);
    }
    return rival_clamped(found, box);
}

#define RIVAL_DEFINE(name, start, newton, chebyshev)                                                                   \
    RIVAL_FN void rival_##name(RIVAL_NODES, const struct rival_tuning *t, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)     \
    {                                                                                                                  \
        const struct rival_basis b = rival_basis_tuned(xA, xB, xC, xD, xS, t);                                         \
        const struct rival_products g = rival_products_of(&b, RIVAL_MANY);                                             \
        struct rival_point p = rival_kept_start(&g, start, &t->clamp.plain);                                           \
        for (int i = 0; i < (newton) + (chebyshev); i++)                                                               \
            p = rival_kept_step(&g, p, i < (newton) ? 0 : 1 + i, &t->clamp.plain);                                     \
        *xi = t->xi0 + (p.u + p.u);                                                                                    \
        *eta = t->eta0 + (p.v + p.v);                                                                                  \
    }
RIVAL_KEPT(RIVAL_DEFINE)
#undef RIVAL_DEFINE

#endif
