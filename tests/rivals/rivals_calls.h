/* Hand-written results besides xi and eta, after a search that iterates until it converges: the gap, with a test for a
 * normal; xi and eta clamped to the face with their distance, which contact codes use as the closest point; for a
 * triangle the true closest point. rival_KIND_checked(x, loc, &gap) and rival_KIND_clamped(x, loc, &dist) return 0 if
 * there is no answer. x contains the vectors of the kind, the slave node last. */
#ifndef FOOTPOINT_RIVALS_CALLS_H
#define FOOTPOINT_RIVALS_CALLS_H

#include "four_triangles.h"
#include "rivals_faces.h"
#include "rivals_patches.h"

/* xS - r and the tangents at r, all times the same factor. */
struct rival_place {
    double d[3], u[3], v[3];
};

/* Computes d . n with the unit normal n; returns 0 if it does not exist. */
RIVAL_FN int rival_gap(const struct rival_place *p, double *gap)
{
    double n[3];
    rival_cross_product(p->u, p->v, n);
    const double square = rival_product(n, n);
    *gap = rival_product(p->d, n) / sqrt(square);
    return square > 0;
}

RIVAL_FN double rival_length(const double d[3])
{
    return sqrt(rival_product(d, d));
}

/* Clamps into -1..1, or on a triangle into xi, eta >= 0, xi + eta <= 1. */
RIVAL_FN void rival_clamp(int triangle, double loc[2])
{
    const double low = triangle ? 0 : -1, over = triangle ? loc[0] + loc[1] - 1 : 0;
    for (int k = 0; k < 2; k++) {
        const double at = over > 0 ? loc[k] - 0.5 * over : loc[k];
        loc[k] = at < low ? low : at > 1 ? 1 : at;
    }
}

/* ---- four nodes ---- */

RIVAL_FN void rival_quad4_place(const double (*x)[3], const double loc[2], struct rival_place *p)
{
    const double s = 0.5 + 0.5 * loc[0], t = 0.5 + 0.5 * loc[1];
    for (int k = 0; k < 3; k++) {
        const double ab = x[1][k] - x[0][k], ad = x[3][k] - x[0][k], m = x[2][k] - x[3][k] - ab;
        p->u[k] = ab + t * m;
        p->v[k] = ad + s * m;
        p->d[k] = x[4][k] - x[0][k] - s * ab - t * p->v[k];
    }
}

RIVAL_FN int rival_quad4_search(const double (*x)[3], double loc[2])
{
    return rival_newton(x[0], x[1], x[2], x[3], x[4], RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]);
}

/* ---- three nodes ---- */

RIVAL_FN void rival_tri3_place(const double (*x)[3], const double loc[2], struct rival_place *p)
{
    for (int k = 0; k < 3; k++) {
        p->u[k] = x[1][k] - x[0][k];
        p->v[k] = x[2][k] - x[0][k];
        p->d[k] = x[3][k] - x[0][k] - loc[0] * p->u[k] - loc[1] * p->v[k];
    }
}

RIVAL_FN int rival_tri3_search(const double (*x)[3], double loc[2])
{
    rival_tri3_areas(x, &loc[0], &loc[1]);
    return 1;
}

#define RIVAL_DEFINE(kind, triangle)                                                                                   \
    RIVAL_FN int rival_##kind##_checked(const double(*x)[3], double loc[2], double *gap)                               \
    {                                                                                                                  \
        struct rival_place p;                                                                                          \
        const int found = rival_##kind##_search(x, loc);                                                               \
        rival_##kind##_place(x, loc, &p);                                                                              \
        return rival_gap(&p, gap) && found;                                                                            \
    }                                                                                                                  \
    RIVAL_FN int rival_##kind##_clamped(const double(*x)[3], double loc[2], double *dist)                              \
    {                                                                                                                  \
        struct rival_place p;                                                                                          \
        const int found = rival_##kind##_search(x, loc);                                                               \
        rival_clamp(triangle, loc);                                                                                    \
        rival_##kind##_place(x, loc, &p);                                                                              \
        *dist = rival_length(p.d);                                                                                     \
        return found;                                                                                                  \
    }
RIVAL_DEFINE(quad4, 0)
RIVAL_DEFINE(tri3, 1)
#undef RIVAL_DEFINE

/* Computes the gap at p of the segment with basis b, all of whose vectors are four times too long. */
RIVAL_FN int rival_basis_gap(const struct rival_basis *b, struct rival_point p, double *gap)
{
    struct rival_place at;
    for (int k = 0; k < 3; k++) {
        at.u[k] = b->e1[k] + p.v * b->c3[k];
        at.v[k] = b->e2[k] + p.u * b->c3[k];
        at.d[k] = b->d[k] - p.u * b->e1[k] - p.v * at.v[k];
    }
    const int normal = rival_gap(&at, gap);
    *gap *= 0.25;
    return normal;
}

/** Runs fair Newton and computes gap and status. */
RIVAL_FN int rival_fair_checked(const double (*x)[3], double loc[2], double *gap)
{
    struct rival_basis b;
    struct rival_point p;
    rival_basis_centre(x[0], x[1], x[2], x[3], x[4], &b);
    const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
    const int found = rival_fair_steps(&g, RIVAL_FAIR_STEPS_MAX, RIVAL_FAIR_TOLERANCE, &p);
    loc[0] = p.u;
    loc[1] = p.v;
    return rival_basis_gap(&b, p, gap) && found;
}

/** Computes the closest point of four triangles about the centroid, and its (xi, eta), linear on each triangle. */
RIVAL_FN int rival_quad4_triangles(const double (*x)[3], double loc[2], double *dist)
{
    const double *const corner[4] = {x[0], x[1], x[2], x[3]};
    double r[3];
    *dist = sqrt(rival_four_triangles(corner, x[4], loc, r));
    return 1;
}

/** Computes the closest point of a triangle. */
RIVAL_FN int rival_tri3_regions(const double (*x)[3], double loc[2], double *dist)
{
    struct rival_place p;
    rival_closest_of_triangle(x[0], x[1], x[2], x[3], &loc[0], &loc[1]);
    rival_tri3_place(x, loc, &p);
    *dist = rival_length(p.d);
    return 1;
}

/* ---- six, eight and nine nodes ---- */

/* Returns the common factor of a polynomial of rivals_faces.h. */
RIVAL_FN double rival_face_factor(const struct rival_face *f)
{
    return f->mixed ? 4 : 9;
}

RIVAL_FN void rival_face_place(const struct rival_face *f, const double loc[2], struct rival_place *p)
{
    struct rival_face_jet j;
    rival_face_jet_at(f, f->mixed ? loc[0] : 3 * loc[0] - 1, f->mixed ? loc[1] : 3 * loc[1] - 1, &j);
    for (int k = 0; k < 3; k++) {
        p->d[k] = j.w[k];
        p->u[k] = j.u[k];
        p->v[k] = j.v[k];
    }
}

#define RIVAL_DEFINE(kind, vectors)                                                                                    \
    RIVAL_FN int rival_##kind##_search(const double(*x)[3], double loc[2])                                             \
    {                                                                                                                  \
        return rival_##kind##_newton(x, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]);                    \
    }                                                                                                                  \
    RIVAL_FN int rival_##kind##_checked(const double(*x)[3], double loc[2], double *gap)                               \
    {                                                                                                                  \
        struct rival_face f;                                                                                           \
        struct rival_place p;                                                                                          \
        rival_face_##kind(x, 1, &f);                                                                                   \
        const int found = rival_face_newton(&f, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]);            \
        rival_face_place(&f, loc, &p);                                                                                 \
        const int normal = rival_gap(&p, gap);                                                                         \
        *gap /= rival_face_factor(&f);                                                                                 \
        return normal && found;                                                                                        \
    }                                                                                                                  \
    RIVAL_FN int rival_##kind##_clamped(const double(*x)[3], double loc[2], double *dist)                              \
    {                                                                                                                  \
        struct rival_face f;                                                                                           \
        struct rival_place p;                                                                                          \
        rival_face_##kind(x, 1, &f);                                                                                   \
        const int found = rival_face_newton(&f, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &loc[0], &loc[1]);            \
        rival_clamp(!f.mixed, loc);                                                                                    \
        rival_face_place(&f, loc, &p);                                                                                 \
        *dist = rival_length(p.d) / rival_face_factor(&f);                                                             \
        return found;                                                                                                  \
    }
RIVAL_FACES(RIVAL_DEFINE)
#undef RIVAL_DEFINE

/* ---- patches ---- */

/* Newton's iteration from p until it stands; the gap. */
RIVAL_FN int rival_patch_stands(const double (*x)[3], int bezier, double tolerance, struct rival_point p, double loc[2],
                                double *gap)
{
    struct rival_patch patch;
    struct rival_jet jet;
    if (bezier)
        rival_bezier_of(x, x + 4, &patch);
    else
        rival_patch_of(x, x + 4, &patch);
    const int found = rival_patch_converge(&patch, x[8], 0, RIVAL_STEPS_MAX, tolerance, &p);
    rival_patch_jet(&patch, p.u, p.v, 0, &jet);
    const rival_lanes d = rival_vector(x[8]) - rival_vector(patch.origin) - jet.r, n = rival_cross(jet.u, jet.v);
    const double square = rival_scalar(n, n);
    loc[0] = 2 * p.u - 1;
    loc[1] = 2 * p.v - 1;
    *gap = rival_scalar(d, n) / sqrt(square);
    return square > 0 && found;
}

RIVAL_FN int rival_patch_checked(const double (*x)[3], int bezier, double loc[2], double *gap)
{
    const struct rival_point p = rival_facet_foot(x, x + 4, x[8], RIVAL_CENTRE);
    return rival_patch_stands(x, bezier, RIVAL_NEWTON_TOLERANCE, p, loc, gap);
}

#endif
