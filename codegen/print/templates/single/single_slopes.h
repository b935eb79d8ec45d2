/* Slopes of the squared distance on a curved face, and rounding errors, in single precision. */

/* Computes the slopes of half the squared distance at (p,q), and bounds rounding errors.
 *
 * Let E and D be the errors of tangents and second derivatives, and of d; let u be the unit of rounding. For |s|, |t|
 * <= 2, N = `all` bounds the sums of the absolute values of the vectors' terms, B bounds those of second and higher
 * derivatives. Third derivatives and k are off by 3 E, a and b of footpoint_detail_KIND_form_over by 9 E + 5 u N,
 * entries of M by 200 E N + 10 E |d| + D B + u N (300 N + 30 |d|). dd is off by 2 D |d| + 10 u dd, and a quadratic's
 * share by 300 u N (N + |d|) beside the errors of M. Derivatives by the turned coordinates of a triangle are off by 4
 * E. Its (xi,eta), less the middle's, is off by u, which adds u B to errors of tangents and u (|r_xi| + |r_eta|) to
 * those of d. Second derivatives of half the squared distance are less than N^2 + |d| B, third derivatives less than (4
 * N + |d|) B. */
FOOTPOINT_PART void footpoint_detail_KIND_slopes(const footpoint_detail_KIND_terms *of, REAL p,
                                                 REAL q, footpoint_detail_KIND_anchor *z)
{
    const footpoint_detail_local *const r = &z->r;
    const REAL x = fabs(p), y = fabs(q), turned = CORNERS == 3 ? 1.0 : 0.0;
    REAL u = footpoint_detail_norm(r->u), v = footpoint_detail_norm(r->v);
    REAL d = footpoint_detail_norm(r->d), all, tangents, place;
    REAL bend =
        footpoint_detail_sum(r->uu) + footpoint_detail_sum(r->uv) + footpoint_detail_sum(r->vv);
    if (CORNERS == 4)
        bend += 2.0 * (footpoint_detail_sum(z->uuv) + footpoint_detail_sum(z->uvv)) +
                4.0 * footpoint_detail_sum(z->k);
    tangents = REAL_UNIT * ((1.0 + 3.0 * turned) * footpoint_detail_KIND_tangents_off(of, x, y) +
                            turned * bend);
    place = REAL_UNIT * (footpoint_detail_KIND_place_off(of, x, y) + turned * 2.0 * (u + v));
    z->f = footpoint_detail_dot(r->u, r->d);
    z->g = footpoint_detail_dot(r->v, r->d);
    u += tangents;
    v += tangents;
    d += place;
    bend += 30.0 * tangents;
    all = u + v + bend;
    z->off_f = u * (place + 5.0 * REAL_UNIT * d) + tangents * d;
    z->off_g = v * (place + 5.0 * REAL_UNIT * d) + tangents * d;
    z->far = d + all;
    z->off = tangents * (200.0 * all + 10.0 * d) + bend * place +
             REAL_UNIT * all * (300.0 * all + 30.0 * d);
    z->off_d = place;
    z->off_dd = 2.0 * d * place + REAL_UNIT * (10.0 * d * d + 300.0 * all * z->far);
    z->bent = (8.0 * all + 2.0 * d) * bend;
    z->stiff = 3.0 * (all * all + d * bend);
}
