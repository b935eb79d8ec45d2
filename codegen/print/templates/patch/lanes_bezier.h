/* Bezier patches side by side: only a net; see patch_bezier.h. */

typedef struct {
    footpoint_detail_NET net;
} footpoint_detail_KIND_terms;

FOOTPOINT_PART void footpoint_detail_KIND_shape(const REAL *const *n,
                                                footpoint_detail_NET_bent bent[4],
                                                footpoint_detail_KIND_terms *t)
{
    footpoint_detail_NET_bend_all(n, bent, &t->net);
    footpoint_detail_NET_expand(bent, &t->net);
}

FOOTPOINT_PART void footpoint_detail_KIND_local(const footpoint_detail_KIND_terms *t, REAL p,
                                                REAL q, footpoint_detail_local *l)
{
    footpoint_detail_NET_local(&t->net, p, q, l);
}

FOOTPOINT_PART REAL footpoint_detail_KIND_inner(const footpoint_detail_KIND_terms *t, REAL p,
                                                REAL q)
{
    (void)t, (void)p, (void)q;
    return 0.0;
}

FOOTPOINT_PART REAL footpoint_detail_KIND_ball(REAL p, REAL q)
{
    (void)p, (void)q;
    return 0.125;
}
