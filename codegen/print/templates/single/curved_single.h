/* Newton's step of curved faces with a proof, in single precision. */

/* Holds rounding errors of vectors, as lengths: of tangents and second derivatives, and of d = xS - r. */
typedef struct {
    REAL tangents, place;
} footpoint_detail_KIND_blur;

FOOTPOINT_PART void footpoint_detail_KIND_blur_at(const footpoint_detail_KIND_terms *of, REAL x,
                                                  REAL y, footpoint_detail_KIND_blur *b)
{
    b->tangents = REAL_UNIT * footpoint_detail_KIND_tangents_off(of, x, y);
    b->place = REAL_UNIT * footpoint_detail_KIND_place_off(of, x, y);
}

/* Takes a Newton step from (*p,*q) to the foot point. The highest bit of the result is not set if a minimum of the
 * distance is proved to lie within promise * max(1, |xi|, |eta|) of the answer.
 *
 * F = (r_xi . D, r_eta . D) with D = xS - r has the Jacobian -H, H = [r11 r12; r12 r22], and `step` = |H^-1 F|, in
 * maximum norms. Row i of the derivatives of H adds up to at most l_i = R_i A + 2 R A_i + |D| T_i. Here R_i = |r_i|,
 * A_i = |r_i1| + |r_i2| and T_i = |r_i11| + 2 |r_i12| + |r_i22|; R and A are sums over i; each is the largest value in
 * a ball of 1/8. Let w = max(r22 l_1 + |r12| l_2, |r12| l_1 + r11 l_2) / det, so that |1 - H^-1 H(y)| <= w |y - x|. If
 * h = w step <= 1/4, then a root lies within 1.2 step of x and within 0.7 h step of the answer, and H is positive
 * definite all the way there (Newton and Kantorovich).
 *
 * Rounding: in l_i, errors of vectors, `blur`, are added to their absolute values. Dot products and Cramer's rule count
 * as 8 units of |r_i| |D|. Each row of H is off by 2 `off_h`; F is off by that times the step, and `tilt` bounds |H^-1|
 * times it. Errors of F and of h grow by at most 1 / (1 - tilt). The weak inequality of `det` keeps its relative error
 * below 4e-4. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_step(const footpoint_detail_KIND_terms *of,
                                                    REAL promise, REAL *p, REAL *q)
{
    const REAL ball = 0.125, x = fabs(*p), y = fabs(*q), middle = footpoint_detail_KIND_middle();
    footpoint_detail_KIND_blur blur;
    footpoint_detail_local r;
    footpoint_detail_newton n;
    REAL third[2], mixed, step, off_h, off, h, tilt, room, u, v, d, inverse;
    footpoint_detail_KIND_local(of, *p, *q, &r);
    footpoint_detail_newton_of(&r, &n);
    footpoint_detail_KIND_third(of, x, y, third);
    footpoint_detail_KIND_blur_at(of, x, y, &blur);
    third[0] += 3.0 * blur.tangents;
    third[1] += 3.0 * blur.tangents;
    mixed = fabs(n.r12);
    step = footpoint_detail_greater(fabs(n.s), fabs(n.t));
    inverse = (footpoint_detail_greater(n.r11, n.r22) + mixed) * n.per;
    u = sqrt(footpoint_detail_dot(r.u, r.u)) + blur.tangents;
    v = sqrt(footpoint_detail_dot(r.v, r.v)) + blur.tangents;
    d = sqrt(footpoint_detail_dot(r.d, r.d)) + blur.place;
    *p += n.s;
    *q += n.t;
    {
        const REAL uu = footpoint_detail_sum(r.uu), uv = footpoint_detail_sum(r.uv);
        const REAL vv = footpoint_detail_sum(r.vv), bend = uu + uv + vv + 3.0 * blur.tangents;
        const REAL a1 = uu + uv + 2.0 * blur.tangents + ball * third[0];
        const REAL a2 = vv + uv + 2.0 * blur.tangents + ball * third[1], a = a1 + a2;
        const REAL r1 = u + ball * a1, r2 = v + ball * a2, both = r1 + r2, away = d + ball * both;
        const REAL l1 = r1 * a + 2.0 * both * a1 + away * third[0];
        const REAL l2 = r2 * a + 2.0 * both * a2 + away * third[1];
        REAL turn = d * blur.tangents, f, g;
        off_h = (u + v) * (2.0 * blur.tangents + 4.0 * REAL_UNIT * (u + v)) +
                bend * (blur.place + 4.0 * REAL_UNIT * d) + turn;
        tilt = 2.0 * off_h * inverse;
        turn += 2.0 * off_h * step;
        f = u * (blur.place + 8.0 * REAL_UNIT * d) + turn;
        g = v * (blur.place + 8.0 * REAL_UNIT * d) + turn;
        off = n.per * footpoint_detail_greater(n.r22 * f + mixed * g, n.r11 * g + mixed * f);
        h = footpoint_detail_greater(n.r22 * l1 + mixed * l2, mixed * l1 + n.r11 * l2) * n.per *
            (step + 2.0 * off);
    }
    room = footpoint_detail_greater(fabs(*p + middle), fabs(*q + middle));
    room = (0.999 * promise - 3.0 * REAL_UNIT) * footpoint_detail_greater(1.0, room) -
           ((0.72 * h + 4e-4) * step + 1.3 * off);
    return footpoint_detail_bits(room) | footpoint_detail_bits(0.249 - (h + tilt)) |
           footpoint_detail_bits(0.1 - tilt) | footpoint_detail_bits(0.1 - (step + 1.3 * off)) |
           footpoint_detail_bits(n.r11) | footpoint_detail_outside(n.det) |
           footpoint_detail_bits(n.det * (1.0 - REAL_WEAK) - REAL_WEAK * (n.r12 * n.r12)) |
           footpoint_detail_infinite(room + h + tilt) | footpoint_detail_fast();
}
