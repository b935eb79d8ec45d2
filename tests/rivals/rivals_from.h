/* Newton's iteration from the last answer, with gap and status, as in contact codes that store xi and eta of their
 * pairs. rival_KIND_from(x, tolerance, loc, &gap) starts at loc and returns 0 if there is no answer.
 *
 * Four-node segments are expanded about the last answer with the polynomial of rivals.h, so that the first step
 * evaluates no polynomial. Fixed numbers of steps: one or two of Newton's, and one of Chebyshev's, which corrects a
 * step by the second derivatives of the slopes. */
#ifndef FOOTPOINT_RIVALS_FROM_H
#define FOOTPOINT_RIVALS_FROM_H

#include "newton_lanes_calls.h"

/* Expands about (xi,eta), all vectors times 4; u and v are the steps from there. */
RIVAL_FN void rival_basis_about(const double (*x)[3], double xi, double eta, struct rival_basis *b)
{
    const double s = 1 + xi, t = 1 + eta;
    for (int i = 0; i < 3; i++) {
        const double ab = x[1][i] - x[0][i], ad = x[3][i] - x[0][i], as = x[4][i] - x[0][i], ab2 = ab + ab;
        b->c3[i] = (x[2][i] - x[3][i]) - ab;
        b->e1[i] = ab2 + t * b->c3[i];
        b->e2[i] = (ad + ad) + s * b->c3[i];
        b->d[i] = 4 * as - s * ab2 - t * b->e2[i];
    }
}

/* Takes Newton's steps from u = v = 0 until they converge. */
RIVAL_FN int rival_quad4_from(const double (*x)[3], double tolerance, double loc[2], double *gap)
{
    struct rival_basis b;
    rival_basis_about(x, loc[0], loc[1], &b);
    const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
    struct rival_point p = rival_first(&g, 1, 1.0);
    int stands = rival_stands((struct rival_point){0, 0}, p, tolerance);
    for (int n = 1; n < RIVAL_FAIR_STEPS_MAX && !stands; n++) {
        const struct rival_point next = rival_step(&g, 1, p, 1.0);
        stands = rival_stands(p, next, tolerance);
        p = next;
    }
    loc[0] += p.u;
    loc[1] += p.v;
    return rival_basis_gap(&b, p, gap) && stands;
}

/* Returns the correction of Chebyshev's step p from u = v = 0: the second-order terms that p leaves in the slopes. */
RIVAL_FN struct rival_point rival_chebyshev(const struct rival_products *g, struct rival_point p)
{
    const double up = p.u * g->g13, vp = p.v * g->g23;
    const struct rival_point more =
        rival_solve(g->g11, g->g12 - g->g3, g->g22, -p.v * (2 * up + vp), -p.u * (2 * vp + up), 1.0);
    return (struct rival_point){p.u + more.u, p.v + more.v};
}

enum rival_fixed { RIVAL_FROM_NEWTON, RIVAL_FROM_NEWTON_TWICE, RIVAL_FROM_CHEBYSHEV };

RIVAL_FN int rival_quad4_from_fixed(const double (*x)[3], enum rival_fixed steps, double loc[2], double *gap)
{
    struct rival_basis b;
    rival_basis_about(x, loc[0], loc[1], &b);
    const struct rival_products g = rival_products_of(&b, steps == RIVAL_FROM_NEWTON ? RIVAL_ONE_NEWTON : RIVAL_MANY);
    struct rival_point p = rival_first(&g, 1, 1.0);
    if (steps == RIVAL_FROM_NEWTON_TWICE)
        p = rival_step(&g, 1, p, 1.0);
    else if (steps == RIVAL_FROM_CHEBYSHEV)
        p = rival_chebyshev(&g, p);
    loc[0] += p.u;
    loc[1] += p.v;
    return rival_basis_gap(&b, p, gap);
}

/** Searches NEWTON_LANES columns from the last answers in xi0 and eta0. */
RIVAL_FN void newton_lanes_from(const double *const x[15], double tolerance, const double xi0[], const double eta0[],
                                double xi[], double eta[], double gap[], int answered[])
{
    struct newton_lanes lanes;
    double found[NEWTON_LANES];
    long long stands[NEWTON_LANES];
    for (int i = 0; i < NEWTON_LANES; i++) {
        const double node[5][3] = {{x[0][i], x[1][i], x[2][i]},
                                   {x[3][i], x[4][i], x[5][i]},
                                   {x[6][i], x[7][i], x[8][i]},
                                   {x[9][i], x[10][i], x[11][i]},
                                   {x[12][i], x[13][i], x[14][i]}};
        struct rival_basis b;
        rival_basis_about(node, xi0[i], eta0[i], &b);
        const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
        const struct rival_point p = rival_first(&g, 1, 1.0);
        const double du = fabs(p.u), dv = fabs(p.v), most = du < dv ? dv : du;
        newton_lanes_set(&lanes, i, &g);
        lanes.u[i] = p.u;
        lanes.v[i] = p.v;
        lanes.moving[i] = most <= tolerance ? 0 : 1;
    }
    newton_lanes_run(&lanes, NEWTON_LANES_TAPER, tolerance);
    for (int i = 0; i < NEWTON_LANES; i++) {
        lanes.u[i] += xi0[i];
        lanes.v[i] += eta0[i];
    }
    newton_lanes_gap(&lanes, x, found, stands);
    for (int i = 0; i < NEWTON_LANES; i++) {
        xi[i] = lanes.u[i];
        eta[i] = lanes.v[i];
        gap[i] = found[i];
        answered[i] = stands[i] != 0;
    }
}

/* Faces with curved edges: Newton's steps on the polynomial about the middle. */
#define RIVAL_DEFINE(kind, vectors)                                                                                    \
    RIVAL_FN int rival_##kind##_from(const double(*x)[3], double tolerance, double loc[2], double *gap)                \
    {                                                                                                                  \
        struct rival_face f;                                                                                           \
        struct rival_place place;                                                                                      \
        int stands = 0;                                                                                                \
        rival_face_##kind(x, 1, &f);                                                                                   \
        struct rival_point p = {f.mixed ? loc[0] : 3 * loc[0] - 1, f.mixed ? loc[1] : 3 * loc[1] - 1};                 \
        for (int n = 0; n < RIVAL_FAIR_STEPS_MAX && !stands; n++) {                                                    \
            const struct rival_point next = rival_face_step(&f, 1, p);                                                 \
            stands = rival_stands(p, next, tolerance);                                                                 \
            p = next;                                                                                                  \
        }                                                                                                              \
        loc[0] = rival_face_local(&f, p.u);                                                                            \
        loc[1] = rival_face_local(&f, p.v);                                                                            \
        rival_face_place(&f, loc, &place);                                                                             \
        const int normal = rival_gap(&place, gap);                                                                     \
        *gap /= rival_face_factor(&f);                                                                                 \
        return normal && stands;                                                                                       \
    }
RIVAL_FACES(RIVAL_DEFINE)
#undef RIVAL_DEFINE

/* Patches. */
RIVAL_FN int rival_patch_from(const double (*x)[3], int bezier, double tolerance, double loc[2], double *gap)
{
    const struct rival_point p = {0.5 + 0.5 * loc[0], 0.5 + 0.5 * loc[1]};
    return rival_patch_stands(x, bezier, tolerance, p, loc, gap);
}

#endif
