/* The closest point of a bilinear segment within a box of xi and eta, by Newton's method with a trust region: the
 * robust rival. The model is quadratic with the true Hessian. The region is a square; its intersection with the box is
 * a rectangle, over which the model, indefinite or not, is minimised exactly. Up to rounding the distance never grows.
 *
 * In the products of rivals.h the square of the distance is, up to a constant, twice
 *   f = (u^2 g11 + v^2 g22 + w^2 g33)/2 + w g12 + u w g13 + v w g23 - u g1 - v g2 - w g3,  w = u v. */
#ifndef FOOTPOINT_TRUST_REGION_H
#define FOOTPOINT_TRUST_REGION_H

#include "rivals.h"

#define TRUST_REGION_TOLERANCE 1e-10
#define TRUST_REGION_ROUNDING 1e-13 /* a decrease of the height, over squares of edges, that rounding may hide */

/* m(p) = b1 p1 + b2 p2 + (k11 p1^2 + 2 k12 p1 p2 + k22 p2^2)/2; k11, k22 > 0. */
struct trust_model {
    FOOTPOINT_REAL b1, b2, k11, k12, k22;
};

RIVAL_FN FOOTPOINT_REAL trust_height(const struct rival_products *g, struct rival_point p)
{
    const FOOTPOINT_REAL half = 0.5, w = p.u * p.v;
    return p.u * (half * p.u * g->g11 + w * g->g13 - g->g1) + p.v * (half * p.v * g->g22 + w * g->g23 - g->g2) +
           w * (half * w * g->g33 + g->g12 - g->g3);
}

RIVAL_FN struct trust_model trust_model_at(const struct rival_products *g, struct rival_point p)
{
    const FOOTPOINT_REAL t = g->g13 + p.v * g->g33, s = g->g23 + p.u * g->g33, y = p.u * g->g13 + p.v * s;
    const FOOTPOINT_REAL ev = g->g12 + p.v * g->g23, eu = g->g12 + p.u * g->g13;
    struct trust_model m;
    m.k11 = g->g11 + p.v * (g->g13 + t);
    m.k22 = g->g22 + p.u * (g->g23 + s);
    m.k12 = g->g12 + (y + y) - g->g3;
    m.b1 = p.u * m.k11 + p.v * ev - g->g1 - p.v * g->g3;
    m.b2 = p.v * m.k22 + p.u * eu - g->g2 - p.u * g->g3;
    return m;
}

RIVAL_FN FOOTPOINT_REAL trust_value(const struct trust_model *m, struct rival_point p)
{
    const FOOTPOINT_REAL half = 0.5;
    return p.u * (m->b1 + half * m->k11 * p.u + m->k12 * p.v) + p.v * (m->b2 + half * m->k22 * p.v);
}

/* Returns the least point of the model on the four edges of the rectangle. */
RIVAL_FN struct rival_point trust_edges(const struct trust_model *m, const struct rival_box *r)
{
    const FOOTPOINT_REAL one = 1.0, per_k11 = one / m->k11, per_k22 = one / m->k22;
    const FOOTPOINT_REAL side[4] = {r->low[0], r->high[0], r->low[1], r->high[1]};
    struct rival_point best = {r->low[0], r->low[1]};
    FOOTPOINT_REAL least = trust_value(m, best);
    for (int k = 0; k < 4; k++) {
        struct rival_point p;
        if (k < 2) {
            p.u = side[k];
            p.v = rival_between(r->low[1], -(m->b2 + m->k12 * p.u) * per_k22, r->high[1]);
        } else {
            p.v = side[k];
            p.u = rival_between(r->low[0], -(m->b1 + m->k12 * p.v) * per_k11, r->high[0]);
        }
        const FOOTPOINT_REAL value = trust_value(m, p);
        if (value < least) {
            least = value;
            best = p;
        }
    }
    return best;
}

/* Returns the least point of the model in the rectangle. */
RIVAL_FN struct rival_point trust_least(const struct trust_model *m, const struct rival_box *r)
{
    const FOOTPOINT_REAL none = 0.0, one = 1.0;
    if (none < m->k11 * m->k22 - m->k12 * m->k12) {
        const struct rival_point p = rival_solve(m->k11, m->k12, m->k22, -m->b1, -m->b2, one);
        if (r->low[0] <= p.u && p.u <= r->high[0] && r->low[1] <= p.v && p.v <= r->high[1])
            return p;
    }
    return trust_edges(m, r);
}

RIVAL_FN FOOTPOINT_REAL trust_larger(FOOTPOINT_REAL a, FOOTPOINT_REAL b)
{
    return a < b ? b : a;
}

/** Runs from the middle of the box until a step is within the tolerance. Returns the number of steps, or 0 if `most` do
 *  not suffice. */
RIVAL_FN int rival_trust_region(RIVAL_NODES, const struct rival_box *box, int most, double tolerance,
                                FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL half = 0.5, quarter = 0.25, nearly = 0.75, limit = tolerance;
    const FOOTPOINT_REAL rounding = TRUST_REGION_ROUNDING;
    struct rival_basis b;
    rival_basis_centre(xA, xB, xC, xD, xS, &b);
    const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
    struct rival_point p = {half * (box->low[0] + box->high[0]), half * (box->low[1] + box->high[1])};
    FOOTPOINT_REAL radius = trust_larger(box->high[0] - p.u, box->high[1] - p.v), height = trust_height(&g, p);
    int n = 0, stands = 0;
    for (; n < most && !stands; n++) {
        const struct trust_model m = trust_model_at(&g, p);
        const struct rival_box r = {
            {trust_larger(box->low[0] - p.u, -radius), trust_larger(box->low[1] - p.v, -radius)},
            {-trust_larger(p.u - box->high[0], -radius), -trust_larger(p.v - box->high[1], -radius)}};
        const struct rival_point step = trust_least(&m, &r), next = {p.u + step.u, p.v + step.v};
        const FOOTPOINT_REAL size = trust_larger(fabs(step.u), fabs(step.v));
        const FOOTPOINT_REAL higher = trust_height(&g, next), fall = trust_value(&m, step);
        stands = size <= limit;
        if (stands || -fall <= rounding * (m.k11 + m.k22) || higher - height <= quarter * fall) {
            radius = higher - height <= nearly * fall ? trust_larger(radius, size + size) : radius;
            p = next;
            height = higher;
        } else {
            radius = quarter * size;
        }
    }
    *xi = p.u;
    *eta = p.v;
    return stands ? n : 0;
}

#endif
