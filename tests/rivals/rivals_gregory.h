/* Local contact searches on Gregory and Bezier patches as a good finite element programmer writes them by hand: the
 * methods that generated code must beat. All vectors have four lanes, of which three are used, so that a single search
 * uses the machine's vector registers.
 *
 * Control points (runtime/geometry/gregory.c has the equations): at each corner, with the handles a and b towards its
 * neighbours along xi and eta and the normal n, k = n.(a x b)/(a.a) and h = a.b/(a.a) for the edge along xi, the same
 * with -n over b.b for the edge along eta. Positions are powers of u = (1 + xi)/2 and v = (1 + eta)/2, relative to A,
 * by Horner's scheme with derivatives, plus q e for each corner.
 *
 * Iterations start at the facet's foot point, or at its foot point along interpolated normals, and stay on the
 * patch. */
#ifndef FOOTPOINT_RIVALS_GREGORY_H
#define FOOTPOINT_RIVALS_GREGORY_H

#include "rivals.h"

/* All functions are inlined, so the calling convention of vectors does not matter. */
#pragma GCC diagnostic ignored "-Wpsabi"

typedef double rival_lanes __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double)), may_alias));

/** A patch prepared for searches. */
struct rival_patch {
    double origin[3];
    double c[4][4][4]; /* of u^i v^j; last index: coordinate */
    double e[4][4];    /* twin minus inner point at A, B, C, D */
    int bezier;        /* has no twins */
};

/** Point and derivatives by u and v. */
struct rival_jet {
    rival_lanes r, u, v, uu, uv, vv;
};

RIVAL_FN rival_lanes *rival_at(double *p)
{
    return (void *)p;
}

RIVAL_FN rival_lanes rival_load(const double *p)
{
    return *(const rival_lanes *)(const void *)p;
}

RIVAL_FN rival_lanes rival_vector(const double x[3])
{
    return (rival_lanes){x[0], x[1], x[2], 0};
}

RIVAL_FN double rival_scalar(rival_lanes a, rival_lanes b)
{
    const rival_lanes p = a * b;
    return p[0] + p[1] + p[2];
}

RIVAL_FN rival_lanes rival_cross(rival_lanes a, rival_lanes b)
{
    const rival_lanes a1 = {a[1], a[2], a[0], 0}, b1 = {b[1], b[2], b[0], 0}, c = a * b1 - a1 * b;
    return (rival_lanes){c[1], c[2], c[0], 0};
}

/* Computes the inner points of an edge relative to the edge, times 3, from the edge's three differences, turned handles
 * g and factors. */
RIVAL_FN void rival_across(rival_lanes c0, rival_lanes c1, rival_lanes c2, rival_lanes g0, rival_lanes g3, double k0,
                           double k1, double h0, double h1, rival_lanes *a1, rival_lanes *a2)
{
    const double k = k0 + k1;
    *a1 = k * g0 + k0 * g3 + (h0 + h0) * c1 + h1 * c0;
    *a2 = k1 * g0 + k * g3 + h0 * c2 + (h1 + h1) * c1;
}

/* Converts Bernstein coefficients to powers. */
RIVAL_FN void rival_powers(rival_lanes p[4])
{
    const rival_lanes d0 = p[1] - p[0], d1 = p[2] - p[1], d2 = p[3] - p[2], dd = d1 - d0;
    p[3] = d2 - d1 - dd;
    p[1] = 3 * d0;
    p[2] = 3 * dd;
}

/* Indices of the corners in the net. */
static const int rival_place[4][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};

/* Converts the net to powers of u and v. */
RIVAL_FN void rival_net_powers(rival_lanes p[4][4], struct rival_patch *patch)
{
    for (int i = 0; i < 4; i++)
        rival_powers(p[i]);
    for (int j = 0; j < 4; j++) {
        rival_lanes along[4] = {p[0][j], p[1][j], p[2][j], p[3][j]};
        rival_powers(along);
        for (int i = 0; i < 4; i++)
            *rival_at(patch->c[i][j]) = along[i];
    }
}

/** Computes a Bezier patch, whose innermost points complete parallelograms. */
RIVAL_FN void rival_bezier_of(const double x[4][3], const double n[4][3], struct rival_patch *patch)
{
    const double third = 1.0 / 3;
    rival_lanes corner[4], p[4][4];
    patch->bezier = 1;
    for (int k = 0; k < 3; k++)
        patch->origin[k] = x[0][k];
    for (int c = 0; c < 4; c++)
        corner[c] = rival_vector(x[c]) - rival_vector(x[0]);
    for (int c = 0; c < 4; c++) {
        const int i = rival_place[c][0], j = rival_place[c][1], m = i ? 2 : 1, l = j ? 2 : 1;
        const rival_lanes normal = rival_vector(n[c]), xi = corner[c ^ 1] - corner[c], eta = corner[3 - c] - corner[c];
        p[i][j] = corner[c];
        p[m][j] = corner[c] + third * (xi - rival_scalar(xi, normal) * normal);
        p[i][l] = corner[c] + third * (eta - rival_scalar(eta, normal) * normal);
        p[m][l] = p[m][j] + p[i][l] - corner[c];
    }
    rival_net_powers(p, patch);
}

RIVAL_FN void rival_patch_of(const double x[4][3], const double n[4][3], struct rival_patch *patch)
{
    const double third = 1.0 / 3;
    rival_lanes corner[4], a[4], b[4], ga[4], gb[4], p[4][4], twin[4];
    double ka[4], kb[4], ha[4], hb[4];
    patch->bezier = 0;
    for (int k = 0; k < 3; k++)
        patch->origin[k] = x[0][k];
    for (int c = 0; c < 4; c++)
        corner[c] = rival_vector(x[c]) - rival_vector(x[0]);
    for (int c = 0; c < 4; c++) {
        const rival_lanes normal = rival_vector(n[c]), xi = corner[c ^ 1] - corner[c], eta = corner[3 - c] - corner[c];
        a[c] = third * (xi - rival_scalar(xi, normal) * normal);
        b[c] = third * (eta - rival_scalar(eta, normal) * normal);
        ga[c] = rival_cross(normal, a[c]);
        gb[c] = rival_cross(normal, b[c]);
        const double triple = rival_scalar(ga[c], b[c]), mixed = rival_scalar(a[c], b[c]);
        const double ia = 1 / rival_scalar(a[c], a[c]), ib = 1 / rival_scalar(b[c], b[c]);
        ka[c] = triple * ia;
        kb[c] = -triple * ib;
        ha[c] = mixed * ia;
        hb[c] = mixed * ib;
    }
    for (int c = 0; c < 4; c++) {
        const int i = rival_place[c][0], j = rival_place[c][1];
        p[i][j] = corner[c];
        p[i ? 2 : 1][j] = corner[c] + a[c];
        p[i][j ? 2 : 1] = corner[c] + b[c];
    }
    for (int j = 0; j < 4; j += 3) { /* AB, DC; handles and turned handles at their far ends point backwards */
        const int l = j ? 3 : 0, r = j ? 2 : 1, in = j ? 2 : 1;
        rival_lanes a1, a2;
        rival_across(a[l], p[2][j] - p[1][j], -a[r], ga[l], -ga[r], ka[l], -ka[r], ha[l], -ha[r], &a1, &a2);
        p[1][in] = p[1][j] + third * a1;
        p[2][in] = p[2][j] + third * a2;
    }
    for (int i = 0; i < 4; i += 3) { /* AD, BC */
        const int l = i ? 1 : 0, r = i ? 2 : 3;
        rival_lanes a1, a2;
        rival_across(b[l], p[i][2] - p[i][1], -b[r], gb[l], -gb[r], kb[l], -kb[r], hb[l], -hb[r], &a1, &a2);
        twin[l] = p[i][1] + third * a1;
        twin[r] = p[i][2] + third * a2;
    }
    *rival_at(patch->e[0]) = twin[0] - p[1][1];
    *rival_at(patch->e[1]) = twin[1] - p[2][1];
    *rival_at(patch->e[2]) = twin[2] - p[2][2];
    *rival_at(patch->e[3]) = twin[3] - p[1][2];
    rival_net_powers(p, patch);
}

/* Computes a cubic's value, derivative, and half its second derivative. */
RIVAL_FN void rival_horner(const rival_lanes c[4], double t, rival_lanes *f, rival_lanes *df, rival_lanes *ddf)
{
    const rival_lanes s2 = c[2] + t * c[3], d2 = s2 + t * c[3], s1 = c[1] + t * s2;
    *f = c[0] + t * s1;
    *df = s1 + t * d2;
    *ddf = d2 + t * c[3];
}

/* Adds the blend at a corner: u and v are measured from there, su and sv are the signs of their directions. */
RIVAL_FN void rival_blend(rival_lanes e, double u, double v, double su, double sv, int second, struct rival_jet *jet)
{
    const double s = 1 - u, t = 1 - v, w = v / (u + v + 1e-300), st = s * t, f = 9 * st * w, uv = u * v, sw = s * w;
    const double t2w = t * (2 - w);
    jet->r += (f * st * uv) * e;
    jet->u += (su * f * t * v * (sw - (u + u))) * e;
    jet->v += (sv * f * s * u * (t2w - (v + v))) * e;
    if (!second)
        return;
    const double z = 1 - w, zt = z * t;
    jet->uu += (18 * t * t * w * (uv - sw * (v + v + sw))) * e;
    jet->uv += (su * sv * f * (4 * uv - 2 * (u * t2w + v * sw) + st * w * (3 - (w + w)))) * e;
    jet->vv += (18 * s * s * (w * u * (v - 2 * t2w) + zt * zt * z)) * e;
}

/* Evaluates the patch; `second`: with second derivatives. */
RIVAL_FN void rival_patch_jet(const struct rival_patch *patch, double u, double v, int second, struct rival_jet *jet)
{
    rival_lanes f[4], g[4], h[4], spare;
    for (int i = 0; i < 4; i++) {
        const rival_lanes row[4] = {rival_load(patch->c[i][0]), rival_load(patch->c[i][1]), rival_load(patch->c[i][2]),
                                    rival_load(patch->c[i][3])};
        rival_horner(row, v, &f[i], &g[i], &h[i]);
    }
    rival_horner(f, u, &jet->r, &jet->u, &jet->uu);
    rival_horner(g, u, &jet->v, &jet->uv, &spare);
    rival_horner(h, u, &jet->vv, &spare, &spare);
    jet->uu += jet->uu;
    jet->vv += jet->vv;
    if (patch->bezier)
        return;
    rival_blend(rival_load(patch->e[0]), u, v, 1, 1, second, jet);
    rival_blend(rival_load(patch->e[1]), 1 - u, v, -1, 1, second, jet);
    rival_blend(rival_load(patch->e[2]), 1 - u, 1 - v, -1, -1, second, jet);
    rival_blend(rival_load(patch->e[3]), u, 1 - v, 1, -1, second, jet);
}

/* Takes one step of Newton or Gauss-Newton for d = xS - A. */
RIVAL_FN struct rival_point rival_patch_step(const struct rival_patch *patch, rival_lanes d, int newton,
                                             struct rival_point p)
{
    struct rival_jet jet;
    rival_patch_jet(patch, p.u, p.v, newton, &jet);
    const rival_lanes miss = d - jet.r;
    double k11 = rival_scalar(jet.u, jet.u), k12 = rival_scalar(jet.u, jet.v), k22 = rival_scalar(jet.v, jet.v);
    if (newton) {
        k11 -= rival_scalar(jet.uu, miss);
        k12 -= rival_scalar(jet.uv, miss);
        k22 -= rival_scalar(jet.vv, miss);
    }
    const struct rival_point move =
        rival_solve(k11, k12, k22, rival_scalar(jet.u, miss), rival_scalar(jet.v, miss), 1.0);
    p.u = rival_between(0.0, p.u + move.u, 1.0);
    p.v = rival_between(0.0, p.v + move.v, 1.0);
    return p;
}

/** Returns the facet's foot point after two steps: u, v, within 0..1. */
RIVAL_FN struct rival_point rival_facet_foot(const double x[4][3], const double n[4][3], const double xs[3],
                                             enum rival_start start)
{
    struct rival_point p;
    (void)n;
    rival_iterate(x[0], x[1], x[2], x[3], xs, start, 1, 1, 1, &p.u, &p.v);
    p.u = 0.5 + 0.5 * p.u;
    p.v = 0.5 + 0.5 * p.v;
    return p;
}

/* Computes value and derivatives of a bilinear function with corners A, B, C, D. */
RIVAL_FN void rival_bilinear(const double x[4][3], double u, double v, rival_lanes *r, rival_lanes *r_u,
                             rival_lanes *r_v)
{
    const rival_lanes a = rival_vector(x[0]), b = rival_vector(x[1]) - a, d = rival_vector(x[3]) - a;
    const rival_lanes c = rival_vector(x[2]) - rival_vector(x[1]) - d;
    *r_u = b + v * c;
    *r_v = d + u * c;
    *r = a + u * b + v * *r_v;
}

/** Returns the facet's foot point along the interpolated node normals, r(u,v) + h n(u,v) = xS, after a Gauss-Newton
 *  step on the facet and a Newton step. It is near the smoothed surface's foot point if the normals suit the nodes. */
RIVAL_FN struct rival_point rival_normal_foot(const double x[4][3], const double n[4][3], const double xs[3],
                                              enum rival_start start)
{
    rival_lanes r, r_u, r_v, m, m_u, m_v;
    struct rival_point p;
    rival_iterate(x[0], x[1], x[2], x[3], xs, start, 1, 0, 1, &p.u, &p.v);
    p.u = 0.5 + 0.5 * p.u;
    p.v = 0.5 + 0.5 * p.v;
    rival_bilinear(x, p.u, p.v, &r, &r_u, &r_v);
    rival_bilinear(n, p.u, p.v, &m, &m_u, &m_v);
    const rival_lanes d = rival_vector(xs) - r;
    const double h = rival_scalar(d, m) / rival_scalar(m, m);
    const rival_lanes a = r_u + h * m_u, b = r_v + h * m_v, by_u = rival_cross(b, m), by_v = rival_cross(m, a);
    const double inverse = 1 / rival_scalar(a, by_u);
    p.u = rival_between(0.0, p.u + rival_scalar(d, by_u) * inverse, 1.0);
    p.v = rival_between(0.0, p.v + rival_scalar(d, by_v) * inverse, 1.0);
    return p;
}

/** Takes a fixed number of steps from a point on the patch. */
RIVAL_FN struct rival_point rival_patch_steps(const struct rival_patch *patch, const double xs[3], int gauss_newton,
                                              int newton, struct rival_point p)
{
    const rival_lanes d = rival_vector(xs) - rival_vector(patch->origin);
    for (int k = 0; k < gauss_newton; k++)
        p = rival_patch_step(patch, d, 0, p);
    for (int k = 0; k < newton; k++)
        p = rival_patch_step(patch, d, 1, p);
    return p;
}

/** Takes steps until u and v move by at most the tolerance, the first `gauss_newton` of them Gauss-Newton steps.
 *  Returns their number, or 0 if `most` do not suffice. */
RIVAL_FN int rival_patch_converge(const struct rival_patch *patch, const double xs[3], int gauss_newton, int most,
                                  double tolerance, struct rival_point *p)
{
    const rival_lanes d = rival_vector(xs) - rival_vector(patch->origin);
    int n = 0, stands = 0;
    for (; n < most && !stands; n++) {
        const struct rival_point next =
            n < gauss_newton ? rival_patch_step(patch, d, 0, *p) : rival_patch_step(patch, d, 1, *p);
        const double du = next.u - p->u, dv = next.v - p->v;
        stands = (fabs(du) <= tolerance) & (fabs(dv) <= tolerance);
        *p = next;
    }
    return stands ? n : 0;
}

#endif
