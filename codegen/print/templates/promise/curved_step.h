/* Newton's step of curved faces with a proof, in double. */

/* Takes a Newton step, too. The highest bit of the result is not set if a minimum of the distance is proved to lie
 * within promise * max(1, |xi|, |eta|) of the answer.
 *
 * By Newton and Kantorovich, in maximum norms: F = (r_xi . D, r_eta . D) with D = xS - r has the Jacobian -H, H = [r11
 * r12; r12 r22], and `step` = |H^-1 F|. Row i of the derivatives of H adds up to at most l_i = R_i A + 2 R A_i + |D|
 * T_i. Here R_i = |r_i|, A_i = |r_i1| + |r_i2| and T_i = |r_i11| + 2 |r_i12| + |r_i22|; R and A are sums over i; each
 * is the largest value in a ball of 1/8. Let w = max(r22 l_1 + |r12| l_2, |r12| l_1 + r11 l_2) / det, so that |1 - H^-1
 * H(y)| <= w |y - x|. If h = w step <= 1/4, then a root lies within 1.2 step of x and within 0.7 h step of the answer,
 * and H is positive definite all the way there.
 *
 * Rounding, of sums in any order, u = 1.11e-16: let far = |D| + growth size, see above. Coordinates of tangents and
 * second derivatives are off by 10 u growth size (1.8 times that), of D by 20 u spread size + 7 u |D|, at most 18 u
 * far, and dot products and Cramer's rule count as 8 u |r_i| |D|: F is off by 30 u far (|r_i| + |D|), and for fine
 * promises finer. Entries of H are off by 56 u far^2; that and the errors of l_i count as much as 480 u step far^2
 * more, and take 3000 u far^2 |H^-1| of the limit of h. The weak inequality of `det` keeps the rounding errors of w and
 * of the step below the margins of 0.72, 0.249, 0.999 and 0.1 for 1/8 / 1.2. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_step(const footpoint_detail_KIND_terms *of,
                                                    REAL promise, REAL *p, REAL *q)
{
    const REAL unit = 1.12e-16, ball = 0.125, x = fabs(*p), y = fabs(*q);
    const REAL middle = footpoint_detail_KIND_middle();
    footpoint_detail_local r;
    footpoint_detail_newton n;
    REAL third[2], mixed, step, far, off, h, room, other;
    footpoint_detail_KIND_local(of, *p, *q, &r);
    footpoint_detail_newton_of(&r, &n);
    footpoint_detail_KIND_third(of, x, y, third);
    mixed = fabs(n.r12);
    step = footpoint_detail_greater(fabs(n.s), fabs(n.t));
    *p += n.s;
    *q += n.t;
    {
        const REAL u = footpoint_detail_sum(r.u), v = footpoint_detail_sum(r.v);
        const REAL d = footpoint_detail_sum(r.d), uv = footpoint_detail_sum(r.uv);
        const REAL a1 = footpoint_detail_sum(r.uu) + uv + ball * third[0];
        const REAL a2 = footpoint_detail_sum(r.vv) + uv + ball * third[1], a = a1 + a2;
        const REAL r1 = u + ball * a1, r2 = v + ball * a2, both = r1 + r2, away = d + ball * both;
        const REAL l1 = r1 * a + 2.0 * both * a1 + away * third[0];
        const REAL l2 = r2 * a + 2.0 * both * a2 + away * third[1];
        const REAL grown = footpoint_detail_KIND_growth(x, y) * of->size;
        REAL place, turn, f, g, along = u, across = v;
        far = d + grown;
        place = 30.0 * far;
        turn = place * d;
        if (promise < 1e-9) {
            place = 20.0 * footpoint_detail_KIND_spread(x, y) * of->size + 15.0 * d;
            turn = 10.0 * grown * d;
            along = sqrt(footpoint_detail_dot(r.u, r.u));
            across = sqrt(footpoint_detail_dot(r.v, r.v));
        }
        turn += 480.0 * step * (far * far);
        f = place * along + turn;
        g = place * across + turn;
        off = unit * n.per * footpoint_detail_greater(n.r22 * f + mixed * g, n.r11 * g + mixed * f);
        h = footpoint_detail_greater(n.r22 * l1 + mixed * l2, mixed * l1 + n.r11 * l2) * n.per *
            (step + 2.0 * off);
    }
    room = footpoint_detail_greater(fabs(*p + middle), fabs(*q + middle));
    room = footpoint_detail_greater(1.0, room);
    room = 0.999 * promise * room - (0.72 * h * step + 1.2 * off);
    other = 3000.0 * unit * n.per * (far * far) * (footpoint_detail_greater(n.r11, n.r22) + mixed);
    other = 0.249 - (h + other);
    return footpoint_detail_bits(room) | footpoint_detail_bits(other) |
           footpoint_detail_bits(0.1 - (step + off)) | footpoint_detail_bits(n.r11) |
           footpoint_detail_bits(n.det * (1.0 - 1e-6) - 1e-6 * (n.r12 * n.r12)) |
           footpoint_detail_infinite(room + other) | footpoint_detail_fast();
}
