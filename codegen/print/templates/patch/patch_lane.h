/* The proof of a step on a patch in a loop over arrays, and its gap. */

/* Proves a step as patch_proof.h does, but counts rounding term by term, in units of 1.5 u: in single precision edges
 * and normals are rounded before the net is computed from them. An edge is rounded once in both cases. A normal enters
 * a product with at least two roundings, so its own rounding adds half as much.
 *
 * H as computed at x is off by less than k, F by less than (f,g). With eta = |H^-1 F| + off, |1 - H^-1 H(y)| <= most +
 * w |y - x|, most = |H^-1| k. If 2 most + w eta <= 1/4, then there is a root within 1.25 eta of x, within (1.25 most +
 * 0.79 w eta) eta + off of the step's end, and H is positive definite on the whole way there. Third derivatives are off
 * by at most 25000 units of far if footpoint_detail_KIND_ball() admits them. det >= 1e-3 r11 r22 keeps its rounding
 * errors below the margins of 1.3, 0.8 and 0.249. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_lane(const footpoint_detail_KIND_terms *of,
                                                    const footpoint_detail_local *r, REAL promise,
                                                    REAL *p, REAL *q)
{
    const REAL unit = 1.5 * REAL_UNIT, turn = unit * of->net.turn, far = unit * of->net.far;
    const REAL x = *p, y = *q, second = 280.0 * far, more = 25000.0 * far;
    const REAL u = footpoint_detail_sum(r->u) + 3.0 * turn;
    const REAL v = footpoint_detail_sum(r->v) + 3.0 * turn;
    const REAL uu = footpoint_detail_sum(r->uu) + 3.0 * second;
    const REAL uv = footpoint_detail_sum(r->uv) + 3.0 * second;
    const REAL vv = footpoint_detail_sum(r->vv) + 3.0 * second;
    const REAL inner = footpoint_detail_KIND_inner(of, x, y) + more;
    const REAL third = of->net.third[0] + inner, fourth = of->net.third[1] + inner;
    REAL d = footpoint_detail_sum(r->d), place, f, g, k1, k2, k12, mixed, step, s, t, off, most,
         way;
    REAL ball, h, room, other;
    footpoint_detail_newton n;
    footpoint_detail_newton_of(r, &n);
    mixed = fabs(n.r12);
    step = footpoint_detail_greater(fabs(n.s), fabs(n.t));
    s = x + n.s;
    t = y + n.t;
    *p = footpoint_detail_KIND_kept(s);
    *q = footpoint_detail_KIND_kept(t);
    place = unit * (of->net.place + 18.0 * d);
    d += 3.0 * place;
    f = place * u + turn * d;
    g = place * v + turn * d;
    k12 = turn * (u + v) + second * d + place * uv + 4.0 * unit * (u * v);
    k1 = 2.0 * turn * u + second * d + place * uu + 4.0 * unit * (u * u) + k12;
    k2 = 2.0 * turn * v + second * d + place * vv + 4.0 * unit * (v * v) + k12;
    off = footpoint_detail_greater(n.r22 * f + mixed * g, n.r11 * g + mixed * f);
    off = n.per * (off + 8.0 * unit * step * (n.r11 * n.r22));
    most = n.per * footpoint_detail_greater(n.r22 * k1 + mixed * k2, n.r11 * k2 + mixed * k1);
    way = step + off;
    ball = 1.25 * way;
    {
        const REAL a1 = uu + uv + ball * third, a2 = vv + uv + ball * fourth, a = a1 + a2;
        const REAL r1 = u + ball * a1, r2 = v + ball * a2, both = r1 + r2, away = d + ball * both;
        const REAL l1 = r1 * a + 2.0 * both * a1 + away * third;
        const REAL l2 = r2 * a + 2.0 * both * a2 + away * fourth;
        h = footpoint_detail_greater(n.r22 * l1 + mixed * l2, mixed * l1 + n.r11 * l2) *
            (n.per * way);
    }
    room = footpoint_detail_greater(fabs(s - *p), fabs(t - *q));
    room = 0.999 * promise - (room + (1.3 * most + 0.8 * h) * way + 1.01 * off);
    other = 0.249 - (h + 2.0 * most);
    return footpoint_detail_bits(room) | footpoint_detail_bits(other) |
           footpoint_detail_bits(footpoint_detail_KIND_ball(x, y) - ball) |
           footpoint_detail_bits(1.01 - of->net.tilt) | footpoint_detail_bits(n.r11) |
           footpoint_detail_bits(n.det * (1.0 - 1e-3) - 1e-3 * (n.r12 * n.r12)) |
           footpoint_detail_infinite(room + other) | footpoint_detail_fast();
}

/* Returns 1 / sqrt(x) of ordinary x by four Newton steps, without a call or a division. */
FOOTPOINT_PART REAL footpoint_detail_KIND_root(REAL x)
{
    union {
        REAL number;
        REAL_BITS bits;
    } y;
    const REAL half = 0.5 * x;
    y.bits = REAL_ROOT - footpoint_detail_bits(x) / 2;
    y.number *= 1.5 - half * y.number * y.number;
    y.number *= 1.5 - half * y.number * y.number;
    y.number *= 1.5 - half * y.number * y.number;
    return y.number * (1.5 - half * y.number * y.number);
}

/* Computes the gap of r, if the tangents are not parallel. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_rise(const footpoint_detail_local *r, REAL *gap)
{
    REAL n[3], nn;
    footpoint_detail_cross(r->u, r->v, n);
    nn = footpoint_detail_dot(n, n);
    *gap = footpoint_detail_dot(r->d, n) * footpoint_detail_KIND_root(nn);
    return footpoint_detail_infinite(*gap) |
           footpoint_detail_bits(
               nn - 1e-3 * (footpoint_detail_dot(r->u, r->u) * footpoint_detail_dot(r->v, r->v)));
}
