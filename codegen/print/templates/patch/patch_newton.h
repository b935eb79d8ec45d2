/* Newton's steps on patches. */

/* Clamps p to the patch. */
FOOTPOINT_PART REAL footpoint_detail_KIND_kept(REAL p)
{
    const REAL most = p < 1.0 ? p : 1.0;
    return most > -1.0 ? most : -1.0;
}

/* Computes a step h of Chebyshev's method where the surface is r: Newton's step n and a second-order correction without
 * third derivatives. The error falls by the third power until these matter. Numerators are computed beside the division
 * of n, without waiting for it. */
FOOTPOINT_PART void footpoint_detail_KIND_chebyshev(const footpoint_detail_local *r,
                                                    const footpoint_detail_newton *n, REAL h[2])
{
    const REAL uuu = 1.5 * footpoint_detail_dot(r->u, r->uu);
    const REAL vvv = 1.5 * footpoint_detail_dot(r->v, r->vv);
    const REAL uuv = 2.0 * footpoint_detail_dot(r->u, r->uv) + footpoint_detail_dot(r->v, r->uu);
    const REAL uvv = 2.0 * footpoint_detail_dot(r->v, r->uv) + footpoint_detail_dot(r->u, r->vv);
    const REAL f = footpoint_detail_dot(r->u, r->d), g = footpoint_detail_dot(r->v, r->d);
    const REAL s = n->r22 * f - n->r12 * g, t = n->r11 * g - n->r12 * f;
    const REAL ss = s * s, st = s * t, tt = t * t, square = n->per * n->per;
    const REAL a = uuu * ss + uuv * st + 0.5 * uvv * tt, b = 0.5 * uuv * ss + uvv * st + vvv * tt;
    h[0] = n->per * (s - square * (n->r22 * a - n->r12 * b));
    h[1] = n->per * (t - square * (n->r11 * b - n->r12 * a));
}

/* Takes such a step from (*p,*q), clamped to the patch, not proved. */
FOOTPOINT_PART void footpoint_detail_KIND_correct(const footpoint_detail_local *r,
                                                  const footpoint_detail_newton *n, REAL *p,
                                                  REAL *q)
{
    REAL h[2];
    footpoint_detail_KIND_chebyshev(r, n, h);
    *p = footpoint_detail_KIND_kept(*p + h[0]);
    *q = footpoint_detail_KIND_kept(*q + h[1]);
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
