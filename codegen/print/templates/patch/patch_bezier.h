/* The Bezier patch near one of its points: only its net. */

typedef struct {
    footpoint_detail_net net;
} footpoint_detail_bezier_terms;

FOOTPOINT_PART void footpoint_detail_bezier_shape(const REAL *const *n,
                                                  footpoint_detail_net_bent bent[4],
                                                  footpoint_detail_bezier_terms *t)
{
    footpoint_detail_net_expand(n, bent, &t->net);
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
