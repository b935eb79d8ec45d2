/* The proof that the closest point of a closed curved face lies near a given point. */

/* Computes how far a point may be in a coordinate that an edge holds, where the slope is `slope`, off by `off`: REAL_NEAR
 * if the promise p is coarser or the slope leads outwards that far, so that the closest point is on the edge. */
FOOTPOINT_PART REAL footpoint_detail_KIND_held_reach(const footpoint_detail_KIND_anchor *z,
                                                     REAL held, REAL slope, REAL off, REAL p)
{
    const REAL least = REAL_NEAR, outwards = held * slope - off - 1.1 * least * z->stiff;
    return footpoint_detail_bits(outwards) >> REAL_TOP ? footpoint_detail_least(p, least) : least;
}

/* Computes how far from z, in s and in t, a point may be: promise, half of it for turned coordinates; and within the
 * region, or REAL_NEAR. */
FOOTPOINT_PART void footpoint_detail_KIND_reach_of(const footpoint_detail_KIND_anchor *z,
                                                   REAL promise, REAL reach[2])
{
    const REAL least = REAL_NEAR, p = CORNERS == 3 ? 0.5 * promise : promise;
    REAL room = 1.0 - fabs(z->at[0]), other = 1.0 - fabs(z->at[1]);
    if (CORNERS == 3) { /* two of the three coordinates on an edge */
        const REAL l[3] = {1.0 - z->at[0] - z->at[1], z->at[0], z->at[1]};
        const REAL ends = footpoint_detail_least(l[z->turn], l[(z->turn + 1) % 3]);
        room = fabs(z->held[1]) > 0.0 ? 1.0 : l[(z->turn + 2) % 3];
        room = other = 0.5 * footpoint_detail_least(ends, room);
    }
    reach[0] = fabs(z->held[0]) > 0.0
                   ? footpoint_detail_KIND_held_reach(z, z->held[0], z->f, z->off_f, p)
                   : footpoint_detail_least(p, footpoint_detail_greater(room, least));
    reach[1] = fabs(z->held[1]) > 0.0
                   ? footpoint_detail_KIND_held_reach(z, z->held[1], z->g, z->off_g, p)
                   : footpoint_detail_least(p, footpoint_detail_greater(other, least));
}

/* The highest bit of the result is not set if no point of the part is as near as z but within `promise` of it, and in its region
 * unless it is within REAL_CLOSE of that region's border.
 *
 * If det M >= Q > 0 all over the part, with high >= m22 and wide >= m11, then M exceeds the diagonal matrix of Q / (2 high) and Q / (2
 * wide). So with X = Q / (4 high), Y = Q / (4 wide), f and g what half the square of the distance may fall by, less half of what
 * it grows by, phi(s,t) - phi(z) >= (X s^2 - |s| f) + (Y t^2 - |t| g), which is > 0 for all |s| > p if p (X p - f) > g^2 / (4 Y), and
 * likewise for |t|. 0.999 leaves for what follows more than it can lose, but
 * for what underflows, less than REAL_FAINT. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_sole(const footpoint_detail_KIND_anchor *z,
                                                    REAL h[CORNERS][2], REAL promise)
{
    footpoint_detail_KIND_form m;
    REAL grow[2], f, g, reach[2], room, other, s, t;
    footpoint_detail_KIND_grows(z->held[0], z->f, z->off_f, &grow[0], &f);
    footpoint_detail_KIND_grows(z->held[1], z->g, z->off_g, &grow[1], &g);
    grow[0] *= 0.5;
    grow[1] *= 0.5;
    footpoint_detail_KIND_form_over(z, h, grow, &m);
    footpoint_detail_KIND_reach_of(z, promise, reach);
    room = reach[0] * m.det;
    other = reach[1] * m.det;
    s = room * (0.999 * room - 4.0 * m.high * (f - grow[0])) - 4.0 * (m.wide * m.high) * (g * g);
    t = other * (0.999 * other - 4.0 * m.wide * (g - grow[1])) - 4.0 * (m.wide * m.high) * (f * f);
    return footpoint_detail_bits(m.det) | footpoint_detail_bits(m.low) |
           footpoint_detail_bits(s - REAL_FAINT) | footpoint_detail_bits(t - REAL_FAINT) |
           footpoint_detail_infinite(s + t) | footpoint_detail_fast();
}
