/* The proof that a closest point, known to be near a given point, is nearer still. */

/* The highest bit of the result is not set if the closest point, known to be within `close` of z, in s and in t, is within promise:
 * inside, both slopes vanish there, and have changed by the Hessian at z and at most half the third derivatives times close^2. On an
 * edge where the slope outwards keeps its sign, the slope along it vanishes. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_within(const footpoint_detail_KIND_anchor *z,
                                                      REAL close, REAL promise)
{
    const REAL bend = z->bent * (close * close), off = z->off,
               p = CORNERS == 3 ? 0.5 * promise : promise;
    const REAL f = fabs(z->f) + z->off_f + bend, g = fabs(z->g) + z->off_g + bend;
    const REAL h11 = footpoint_detail_dot(z->r.u, z->r.u) - z->a;
    const REAL h12 = footpoint_detail_dot(z->r.u, z->r.v) - z->b;
    const REAL h22 = footpoint_detail_dot(z->r.v, z->r.v) - z->c;
    const REAL det = h11 * h22 - h12 * h12 - 4.0 * off * (fabs(h11) + fabs(h22));
    const REAL turn = fabs(h12) + off, kept = z->stiff * close;
    const REAL both = p * det - 1.05 * footpoint_detail_greater((h22 + off) * f + turn * g,
                                                                (h11 + off) * g + turn * f);
    const REAL of_s =
        fabs(z->held[0]) > 0.0 ? z->held[0] * z->f - z->off_f - kept : p * (h11 - off) - 1.05 * f;
    const REAL of_t =
        fabs(z->held[1]) > 0.0 ? z->held[1] * z->g - z->off_g - kept : p * (h22 - off) - 1.05 * g;
    const REAL room =
        footpoint_detail_least(footpoint_detail_least(of_s, of_t),
                               fabs(z->held[0]) + fabs(z->held[1]) > 0.0 ? of_s : both);
    REAL reach[2];
    footpoint_detail_KIND_reach_of(z, 1.0, reach);
    return footpoint_detail_bits(room) | footpoint_detail_bits(footpoint_detail_least(h11, h22)) |
           footpoint_detail_bits((fabs(z->held[0]) > 0.0 ? 1.0 : reach[0]) - 2.0 * close) |
           footpoint_detail_bits((fabs(z->held[1]) > 0.0 ? 1.0 : reach[1]) - 2.0 * close) |
           footpoint_detail_infinite(room);
}
