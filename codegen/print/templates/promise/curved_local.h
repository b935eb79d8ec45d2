/* A curved face near one of its points. */

/* Tangents u = r_xi and v = r_eta, second derivatives, and d = xS - r. */
typedef struct {
    REAL u[4], v[4], uu[4], uv[4], vv[4], d[4]; /* the last of four: see patch_three.h */
} footpoint_detail_local;

/* Newton's step (s,t) there, with the Hessian [r11 r12; r12 r22] of half the squared distance and per = 1 / det. */
typedef struct {
    REAL r11, r12, r22, det, per, s, t;
} footpoint_detail_newton;

FOOTPOINT_PART void footpoint_detail_newton_of(const footpoint_detail_local *r,
                                               footpoint_detail_newton *n)
{
    const REAL f = footpoint_detail_dot(r->u, r->d), g = footpoint_detail_dot(r->v, r->d);
    n->r11 = footpoint_detail_dot(r->u, r->u) - footpoint_detail_dot(r->uu, r->d);
    n->r12 = footpoint_detail_dot(r->u, r->v) - footpoint_detail_dot(r->uv, r->d);
    n->r22 = footpoint_detail_dot(r->v, r->v) - footpoint_detail_dot(r->vv, r->d);
    n->det = n->r11 * n->r22 - n->r12 * n->r12;
    n->per = 1.0 / n->det;
    n->s = (n->r22 * f - n->r12 * g) * n->per;
    n->t = (n->r11 * g - n->r12 * f) * n->per;
}
