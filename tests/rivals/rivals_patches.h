/* The hand-written searches on Gregory and Bezier patches (rivals_gregory.h) as methods of footpoint-bench. x contains
 * corners, normals and the slave node. Names with quarter_ start in A's quarter. Operations are not counted, because
 * vectors have lanes. */
#ifndef FOOTPOINT_RIVALS_PATCHES_H
#define FOOTPOINT_RIVALS_PATCHES_H

#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "rivals_gregory.h"

/** R(kind, name, facet or normal foot point, start, Gauss-Newton steps, Newton steps). */
#define RIVAL_PATCHES_OF(R, kind, P)                                                                                   \
    R(kind, P##patch_facet_foot, facet, RIVAL_CENTRE, 0, 0)                                                            \
    R(kind, P##patch_normal_foot, normal, RIVAL_CENTRE, 0, 0)                                                          \
    R(kind, P##patch_gn1, facet, RIVAL_CENTRE, 1, 0)                                                                   \
    R(kind, P##patch_n1, facet, RIVAL_CENTRE, 0, 1)                                                                    \
    R(kind, P##patch_n2, facet, RIVAL_CENTRE, 0, 2)                                                                    \
    R(kind, P##patch_n3, facet, RIVAL_CENTRE, 0, 3)                                                                    \
    R(kind, P##normal_gn1, normal, RIVAL_CENTRE, 1, 0)                                                                 \
    R(kind, P##normal_n1, normal, RIVAL_CENTRE, 0, 1)                                                                  \
    R(kind, P##normal_n2, normal, RIVAL_CENTRE, 0, 2)                                                                  \
    R(kind, P##quarter_facet_foot, facet, RIVAL_QUARTER, 0, 0)                                                         \
    R(kind, P##quarter_gn1, facet, RIVAL_QUARTER, 1, 0)                                                                \
    R(kind, P##quarter_n1, facet, RIVAL_QUARTER, 0, 1)                                                                 \
    R(kind, P##quarter_n2, facet, RIVAL_QUARTER, 0, 2)                                                                 \
    R(kind, P##quarter_n3, facet, RIVAL_QUARTER, 0, 3)
#define RIVAL_PATCHES(R) RIVAL_PATCHES_OF(R, gregory, ) RIVAL_PATCHES_OF(R, bezier, bezier_)

#define rival_gregory_of rival_patch_of
#define RIVAL_DEFINE(kind, name, from, start, gauss_newton, newton)                                                    \
    RIVAL_FN void rival_##name(const double(*x)[3], double *xi, double *eta)                                           \
    {                                                                                                                  \
        struct rival_point p = rival_##from##_foot(x, x + 4, x[8], start);                                             \
        if ((gauss_newton) + (newton) > 0) {                                                                           \
            struct rival_patch patch;                                                                                  \
            rival_##kind##_of(x, x + 4, &patch);                                                                       \
            p = rival_patch_steps(&patch, x[8], gauss_newton, newton, p);                                              \
        }                                                                                                              \
        *xi = 2 * p.u - 1;                                                                                             \
        *eta = 2 * p.v - 1;                                                                                            \
    }
RIVAL_PATCHES(RIVAL_DEFINE)
#undef RIVAL_DEFINE

/** Runs Newton's iteration from the facet's foot point until it converges. Returns the number of steps, or 0. */
RIVAL_FN int rival_patch_newton(const double (*x)[3], int bezier, enum rival_start start, double tolerance, double *xi,
                                double *eta)
{
    struct rival_patch patch;
    struct rival_point p = rival_facet_foot(x, x + 4, x[8], start);
    if (bezier)
        rival_bezier_of(x, x + 4, &patch);
    else
        rival_patch_of(x, x + 4, &patch);
    const int steps = rival_patch_converge(&patch, x[8], 0, RIVAL_STEPS_MAX, tolerance, &p);
    *xi = 2 * p.u - 1;
    *eta = 2 * p.v - 1;
    return steps;
}

/** Runs the same iteration as usually written, on the library's evaluation. */
RIVAL_FN int rival_patch_newton_plain(const double (*x)[3], int bezier, double tolerance, double *xi, double *eta)
{
    struct footpoint_gregory patch;
    struct rival_point p = rival_facet_foot(x, x + 4, x[8], RIVAL_CENTRE);
    const int status =
        bezier ? footpoint_bezier_points(x, x + 4, &patch.net) : footpoint_gregory_points(x, x + 4, &patch);
    int n = 0, stands = status != FOOTPOINT_OK;
    for (; n < RIVAL_STEPS_MAX && !stands; n++) {
        struct footpoint_jet jet;
        double f1 = 0, f2 = 0, k11 = 0, k12 = 0, k22 = 0;
        if (bezier)
            footpoint_bezier_jet(&patch.net, 2 * p.u - 1, 2 * p.v - 1, &jet);
        else
            footpoint_gregory_jet(&patch, 2 * p.u - 1, 2 * p.v - 1, &jet);
        for (int k = 0; k < 3; k++) {
            const double d = x[8][k] - patch.net.origin[k] - jet.r[k];
            f1 += jet.r_xi[k] * d;
            f2 += jet.r_eta[k] * d;
            k11 += jet.r_xi[k] * jet.r_xi[k] - jet.r_xixi[k] * d;
            k12 += jet.r_xi[k] * jet.r_eta[k] - jet.r_xieta[k] * d;
            k22 += jet.r_eta[k] * jet.r_eta[k] - jet.r_etaeta[k] * d;
        }
        const struct rival_point move = rival_solve(k11, k12, k22, f1, f2, 0.5), before = p;
        p.u = rival_between(0, p.u + move.u, 1);
        p.v = rival_between(0, p.v + move.v, 1);
        const double du = p.u - before.u, dv = p.v - before.v;
        stands = (du <= tolerance) & (du >= -tolerance) & (dv <= tolerance) & (dv >= -tolerance);
    }
    *xi = 2 * p.u - 1;
    *eta = 2 * p.v - 1;
    return stands ? n : 0;
}

#endif
