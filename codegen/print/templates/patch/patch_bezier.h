/* The Bezier patch near one of its points: only its net. */

typedef struct {
    footpoint_detail_net net;
} footpoint_detail_bezier_terms;

FOOTPOINT_PART void footpoint_detail_bezier_shape(const REAL *const *n,
                                                  footpoint_detail_net_bent bent[4],
                                                  footpoint_detail_bezier_terms *t)
{
    footpoint_detail_net_bend_all(n, bent, &t->net);
    footpoint_detail_net_expand(bent, &t->net);
}

FOOTPOINT_PART void footpoint_detail_bezier_local(const footpoint_detail_bezier_terms *t, REAL p,
                                                  REAL q, footpoint_detail_local *l)
{
    footpoint_detail_net_local(&t->net, p, q, l);
}

/* Returns the excess of third derivatives over the net's bounds, inside and along edges: 0. */
FOOTPOINT_PART REAL footpoint_detail_bezier_inner(const footpoint_detail_bezier_terms *t, REAL p,
                                                  REAL q)
{
    (void)t, (void)p, (void)q;
    return 0.0;
}

FOOTPOINT_FN REAL footpoint_detail_bezier_rim(const footpoint_detail_bezier_terms *t)
{
    (void)t;
    return 0.0;
}

/* Returns the distance from (p,q) within which the bounds hold. */
FOOTPOINT_PART REAL footpoint_detail_bezier_ball(REAL p, REAL q)
{
    (void)p, (void)q;
    return 0.125;
}

/* Returns the ball for a step from a near start: a fixed one, so that bounds do not wait for the step. */
FOOTPOINT_PART REAL footpoint_detail_bezier_proof_ball(REAL step)
{
    (void)step;
    return 0.0625;
}

/* Adds to Chebyshev's step h from (p,q), whose surface is l, what third derivatives make of Newton's step n. */
FOOTPOINT_PART void footpoint_detail_bezier_bend(const footpoint_detail_bezier_terms *of, REAL p,
                                                 REAL q, const footpoint_detail_local *l,
                                                 const footpoint_detail_newton *n, REAL h[2])
{
    const footpoint_detail_net *const t = &of->net;
    const REAL w = 1.0 - p * p, a = p * w, a1 = 1.0 - 3.0 * (p * p), p2 = p + p, p6 = 6.0 * p;
    const REAL z = 1.0 - q * q, c = q * z, c1 = 1.0 - 3.0 * (q * q), q2 = q + q, q6 = 6.0 * q;
    const REAL b = p * (0.5 + 0.25 * w), b1 = 0.75 * w, b2 = -1.5 * p;
    const REAL g = q * (0.5 + 0.25 * z), g1 = 0.75 * z, g2 = -1.5 * q;
    const REAL ss = n->s * n->s, st = n->s * n->t, tt = n->t * n->t;
    REAL m[4], k[4], f, e;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
        const footpoint_detail_pack x0 = footpoint_detail_of(t->X0)[i],
                                    y0 = footpoint_detail_of(t->Y0)[i];
        const footpoint_detail_pack x1 = footpoint_detail_of(t->X1)[i],
                                    y1 = footpoint_detail_of(t->Y1)[i];
        const footpoint_detail_pack m0 = footpoint_detail_of(t->m)[i];
        const footpoint_detail_pack X = p * m0 + a * x1 - w * x0, X1 = m0 + a1 * x1 + p2 * x0;
        const footpoint_detail_pack Y = c * y1 - z * y0, Y1 = c1 * y1 + q2 * y0;
        const footpoint_detail_pack uuu = -6.0 * (footpoint_detail_of(t->x1)[i] + g * x1) - 1.5 * Y;
        const footpoint_detail_pack uuv = g1 * (2.0 * x0 - p6 * x1) + b2 * Y1;
        const footpoint_detail_pack uvv = b1 * (2.0 * y0 - q6 * y1) + g2 * X1;
        const footpoint_detail_pack vvv = -6.0 * (footpoint_detail_of(t->y1)[i] + b * y1) - 1.5 * X;
        footpoint_detail_into(m)[i] = 0.5 * (ss * uuu + tt * uvv) + st * uuv;
        footpoint_detail_into(k)[i] = 0.5 * (ss * uuv + tt * vvv) + st * uvv;
    }
    e = footpoint_detail_dot(l->d, m);
    f = footpoint_detail_dot(l->d, k);
    h[0] += n->per * (n->r22 * e - n->r12 * f);
    h[1] += n->per * (n->r11 * f - n->r12 * e);
}
