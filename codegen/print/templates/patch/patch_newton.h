/* Newton's steps on patches. */

/* Clamps p to the patch. */
FOOTPOINT_PART REAL footpoint_detail_KIND_kept(REAL p)
{
    const REAL most = p < 1.0 ? p : 1.0;
    return most > -1.0 ? most : -1.0;
}

/* Takes a step of Chebyshev's method from (*p,*q), whose surface is r: Newton's step n and a second-order correction without
 * third derivatives. The error falls by the third power until these matter. The result is clamped to the patch, not proved. */
FOOTPOINT_PART void footpoint_detail_KIND_correct(const footpoint_detail_local *r,
                                                  const footpoint_detail_newton *n, REAL *p,
                                                  REAL *q)
{
    const REAL uuu = 1.5 * footpoint_detail_dot(r->u, r->uu);
    const REAL vvv = 1.5 * footpoint_detail_dot(r->v, r->vv);
    const REAL uuv = 2.0 * footpoint_detail_dot(r->u, r->uv) + footpoint_detail_dot(r->v, r->uu);
    const REAL uvv = 2.0 * footpoint_detail_dot(r->v, r->uv) + footpoint_detail_dot(r->u, r->vv);
    const REAL ss = n->s * n->s, st = n->s * n->t, tt = n->t * n->t;
    const REAL f = uuu * ss + uuv * st + 0.5 * uvv * tt, g = 0.5 * uuv * ss + uvv * st + vvv * tt;
    *p = footpoint_detail_KIND_kept(*p + (n->s - (n->r22 * f - n->r12 * g) * n->per));
    *q = footpoint_detail_KIND_kept(*q + (n->t - (n->r11 * g - n->r12 * f) * n->per));
}

/* Such a step from (*p,*q). */
FOOTPOINT_PART void footpoint_detail_KIND_bare(const footpoint_detail_KIND_terms *of, REAL *p,
                                               REAL *q)
{
    footpoint_detail_local r;
    footpoint_detail_newton n;
    footpoint_detail_KIND_local(of, *p, *q, &r);
    footpoint_detail_newton_of(&r, &n);
    footpoint_detail_KIND_correct(&r, &n, p, q);
}

/* Updates d, u and v after a step (s,t), to its second order. */
FOOTPOINT_PART void footpoint_detail_KIND_follow(REAL s, REAL t, footpoint_detail_local *r)
{
    int k;
    FOOTPOINT_UNROLL
    for (k = 0; k < 3; k++) {
        const REAL u = s * r->uu[k] + t * r->uv[k], v = s * r->uv[k] + t * r->vv[k];
        r->d[k] -= s * (r->u[k] + 0.5 * u) + t * (r->v[k] + 0.5 * v);
        r->u[k] += u;
        r->v[k] += v;
    }
}
