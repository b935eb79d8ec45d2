/* The proof that the closest point of a closed bilinear segment lies near a given point. */

/* The numbers for the proof at (u,v) of r = c0 + xi a + eta b + xi eta c, with a common factor: products of r_xi, r_eta,
 * c and D = xS - r, two letters each: uu = r_xi . r_xi, uc = r_xi . c, ...; slopes f = r_xi . D and g = r_eta . D;
 * and dd = D . D.  masked: see footpoint_detail_choose. */
typedef struct {
    REAL u, v, uu, uv, vv, uc, vc, cc, dc, f, g, dd;
    int masked;
} footpoint_detail_quad4_local;

/* Bounds over the whole segment: wide >= |r_xi|^2, high >= |r_eta|^2; rounding errors of slopes, off_f and off_g;
 * of the determinant that footpoint_detail_quad4_least_det returns; and of the Hessian, by row. */
typedef struct {
    REAL wide, high, off_f, off_g, off_det, off_rows;
} footpoint_detail_quad4_bounds;

/* Returns the slope of half the squared distance from an edge of u, of slope f, into the segment; 0 inside.  *falls:
 * the steepest possible fall, f being off by `off`. */
FOOTPOINT_PART REAL footpoint_detail_quad4_grows(int masked, REAL u, REAL f, REAL off, REAL *falls)
{
    const REAL outward = footpoint_detail_pick_of(masked, 1.0 - fabs(u), -fabs(f), u * f);
    *falls = footpoint_detail_greater_of(masked, off - outward, 0.0);
    return footpoint_detail_greater_of(masked, outward, 0.0);
}

/* Returns the largest permitted distance of a point from u: `promise`, and within the region, or REAL_CLOSE. */
FOOTPOINT_PART REAL footpoint_detail_quad4_reach(int masked, REAL u, REAL promise)
{
    return footpoint_detail_least_of(
        masked, promise, footpoint_detail_greater_of(masked, 1.0 - fabs(u), REAL_CLOSE));
}

/* Returns a number Q for footpoint_detail_quad4_sole, from lines below the quadratics; `grows`: the sum of both edges'
 * slopes. */
FOOTPOINT_PART REAL footpoint_detail_quad4_least_det(const footpoint_detail_quad4_local *q,
                                                     REAL grows)
{
    const REAL bent = footpoint_detail_greater_of(q->masked, fabs(q->dc) - 0.5 * grows, 0.0);
    const REAL mixed = q->uv - copysign(bent, q->dc), det = q->uu * q->vv - mixed * mixed;
    const REAL by_t = 2.0 * (q->vv * q->uc - mixed * q->vc);
    const REAL by_s = 2.0 * (q->uu * q->vc - mixed * q->uc);
    return det -
           footpoint_detail_least_of(q->masked, fabs(by_t) + by_t * q->v, fabs(by_s) + by_s * q->u);
}

/* Proves the closest point.  The highest bit of the result is not set if the closest point of the closed segment is proved to lie within
 * `promise` of (u,v), in xi and in eta, and in the same region unless it is within REAL_CLOSE of that region's border.  f,
 * g: how fast half the squared distance may fall, see footpoint_detail_quad4_grows; least_det: Q.
 *
 * Let phi be half the squared distance.  With a = r_xi and b = r_eta at (u,v)
 *   phi(u + s, v + t) - phi(u,v) = -s f - t g - s t D . c + |s (a + t c) + t b|^2 / 2.
 * At an edge s has one sign: there -s f is |s| times the slope outwards, if that is positive.  Otherwise it is at
 * least -|s f|. As |s|, |t| <= 2, slopes outwards are worth |s t| `grows` / 2, which takes as much from |D . c|; so
 *   phi(u + s, v + t) - phi >= (s^2 A + 2 s t K + t^2 B) / 2 - |s| f - |t| g,
 * A = |a + t c|^2, B = b . b, K = mixed + t b . c.  If A B - K^2 >= Q > 0 for all t from -1 - v to 1 - v, then, with
 * wide >= A and high >= B, the form of s sqrt(wide) and t sqrt(high) has a trace of at most 2 and a determinant of
 * at least Q / (wide high), half of which its eigenvalues exceed.  So with x = Q / (4 high), y = Q / (4 wide), the
 * difference is at least (x s^2 - |s| f) + (y t^2 - |t| g), f and g being as above.  It is > 0 for all |s| > p if p
 * (x p - f) > g^2 / (4 y), and likewise for |t| > p' of its own.  Then all points as near as (u,v) are within p and
 * p' of it, and the closest point, which exists, is there.  The same with s and t exchanged.  The term of t^2 of the quadratic A B -
 * K^2 is >= 0 and may be left out.
 *
 * Rounding: slopes are off by off_f and off_g, Q by off_det; 0.999 leaves more room than the remaining operations can lose. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_sole(const footpoint_detail_quad4_local *q,
                                                     const footpoint_detail_quad4_bounds *r,
                                                     REAL promise, REAL f, REAL g, REAL least_det)
{
    const REAL det = least_det - (r->off_det + REAL_MIN);
    REAL room, other;
    room = footpoint_detail_quad4_reach(q->masked, q->u, promise) * det;
    other = footpoint_detail_quad4_reach(q->masked, q->v, promise) * det;
    room = room * (0.999 * room - 4.0 * (r->high * f)) - 4.0 * (r->wide * r->high) * (g * g);
    other = other * (0.999 * other - 4.0 * (r->wide * g)) - 4.0 * (r->wide * r->high) * (f * f);
    return footpoint_detail_bits(det) | footpoint_detail_bits(room) | footpoint_detail_bits(other) |
           footpoint_detail_infinite(room + other) | footpoint_detail_fast();
}

/* Proves a finer promise.  The highest bit of the result is not set if the closest point, known to be within `close` of q, is within
 * promise in xi and in eta: inside, both slopes vanish there, and change by the Hessian at q and at most half the third derivatives
 * times close^2.  At an edge where the slope outwards keeps its sign, the slope along the edge vanishes, and changes by |r_xi|^2 or
 * |r_eta|^2.  1.05 leaves room for rounding in Cramer's rule, which det > 20000 units of mixed^2 limits. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_within(const footpoint_detail_quad4_local *q,
                                                       const footpoint_detail_quad4_bounds *r,
                                                       REAL close, REAL promise)
{
    const REAL in_u = 1.0 - fabs(q->u), in_v = 1.0 - fabs(q->v);
    const REAL bend = (4.0 * (fabs(q->uc) + fabs(q->vc)) + 2.0 * q->cc) * (close * close);
    const REAL more = bend + r->off_rows * close;
    const REAL f = fabs(q->f) + r->off_f + more, g = fabs(q->g) + r->off_g + more;
    const REAL mixed = q->uv - q->dc, turn = fabs(mixed), det = q->uu * q->vv - mixed * mixed;
    const REAL held = 2.0 * close * (r->wide + r->high + fabs(q->dc));
    const REAL both =
        promise * det -
        1.05 * footpoint_detail_greater_of(q->masked, q->vv * f + turn * g, q->uu * g + turn * f);
    const REAL of_u = promise * q->uu - 1.05 * f, of_v = promise * q->vv - 1.05 * g;
    const REAL clear_u =
        footpoint_detail_pick_of(q->masked, in_u, in_u - close, q->u * q->f - r->off_f - held);
    const REAL clear_v =
        footpoint_detail_pick_of(q->masked, in_v, in_v - close, q->v * q->g - r->off_g - held);
    const REAL room = footpoint_detail_pick_of(
        q->masked, in_u, footpoint_detail_pick_of(q->masked, in_v, both, of_u),
        footpoint_detail_pick_of(q->masked, in_v, of_v, 1.0));
    return footpoint_detail_bits(clear_u) | footpoint_detail_bits(clear_v) |
           footpoint_detail_bits(room) |
           footpoint_detail_bits(
               footpoint_detail_pick_of(q->masked, footpoint_detail_least_of(q->masked, in_u, in_v),
                                        det - 20000.0 * REAL_UNIT * (mixed * mixed), 1.0)) |
           footpoint_detail_infinite(room + clear_u + clear_v);
}
