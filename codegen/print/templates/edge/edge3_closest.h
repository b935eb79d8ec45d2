/* Closest points of edges of three nodes. With the cubic f of edge3.h at p, 4 times the squared distance at p + t is
 * its value at p plus t (2 f + t q(t)), q(t) = f' + f'' t / 3 + c[3] t^2 / 2. If q >= low > 0 on the edge, the closest
 * point lies within 2 |f| / low of p; at an end, f counts only if the distance falls inwards. */

/* Returns xi clamped to the edge. */
FOOTPOINT_PART REAL footpoint_detail_edge3_clamp(REAL xi, int *region)
{
    const int left = (int)(footpoint_detail_bits(xi + 1.0) >> REAL_TOP);
    const int right = (int)(footpoint_detail_bits(1.0 - xi) >> REAL_TOP);
    *region = left ? 1 : 2 * right;
    return left ? -1.0 : right ? 1.0 : xi;
}

/* Returns how fast the distance falls inwards at an end, or in either direction, if the cubic is f. */
FOOTPOINT_PART REAL footpoint_detail_edge3_fall(REAL f, int region)
{
    return region == 1 ? -f : region == 2 ? f : fabs(f);
}

/* Proves a closest point: the highest bit of the result is not set if it lies within the promise of the place at which
 * the distance falls at the rate `fall`, off by at most `error`. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge3_closed(REAL fall, REAL error, REAL low,
                                                       REAL promise)
{
    const REAL left = 0.49 * promise * low - fall - error;
    return footpoint_detail_bits(low) | footpoint_detail_bits(left) |
           footpoint_detail_outside(low) | footpoint_detail_infinite(left) |
           footpoint_detail_fast();
}

/* Returns the signed distance for d = S - r over the tangent t. */
FOOTPOINT_PART REAL footpoint_detail_edge3_distance(const struct footpoint_detail_parabola *e,
                                                    const REAL t[2], const REAL d[2], int region)
{
    const REAL dist = sqrt(footpoint_detail_plane_dot(d, d));
    const int behind =
        region ? footpoint_detail_plane_behind(d, t, e->wide[0] + e->wide[1])
               : (int)(footpoint_detail_bits(footpoint_detail_plane_cross(d, t)) >> REAL_TOP);
    return behind ? -dist : dist;
}

/* Takes two steps, and moves to the end beyond which they lead; the highest bit of the result is set unless that is
 * proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_edge3_near(const REAL *const *x, REAL promise, REAL *xi,
                                                     REAL *dist, int *region)
{
    struct footpoint_detail_parabola e;
    REAL f[3], t[2], d[2], low, tt;
    footpoint_detail_edge3_parabola(x, &e);
    *xi = footpoint_detail_edge3_begin(&e);
    (void)footpoint_detail_edge3_proceed(&e, promise, xi);
    *xi = footpoint_detail_edge3_clamp(*xi, region);
    footpoint_detail_edge3_values(e.c, *xi, f);
    low = 0.999 * f[1] - 0.67 * fabs(f[2]) * (1.0 + fabs(*xi));
    footpoint_detail_edge3_frame(&e, *xi, t, d);
    tt = footpoint_detail_plane_dot(t, t);
    *dist = footpoint_detail_edge3_distance(&e, t, d, *region);
    return footpoint_detail_edge3_closed(footpoint_detail_edge3_fall(f[0], *region),
                                         footpoint_detail_edge3_rounding(&e, fabs(*xi)), low,
                                         promise) |
           footpoint_detail_bits(tt - 1e-5 * e.size) | footpoint_detail_infinite(tt + *dist);
}

/* Returns a lower bound of q, which is convex, on the edge: the lowest point of its tangent at its least value. */
FOOTPOINT_FN REAL footpoint_detail_edge3_lowest(const struct footpoint_detail_parabola *e,
                                                const REAL f[3], REAL p)
{
    const REAL *const c = e->c;
    const REAL first = 2.0 / 3.0 * f[2], second = 0.5 * c[3], low = -1.0 - p, high = 1.0 - p;
    REAL at = c[3] > 0.0 ? -first / c[3] : low, value, slope, left, right;
    at = at > low ? at : low;
    at = at < high ? at : high;
    value = f[1] + at * (first + at * second);
    slope = first + 2.0 * at * second;
    left = value + slope * (low - at);
    right = value + slope * (high - at);
    return (left < right ? left : right) - 40.0 * footpoint_detail_edge3_rounding(e, 1.0);
}

/* Returns 1 if the square of the distance, times 4, is above `least` between low and high, on pieces that get narrower
 * if bounds about their middles do not suffice.  The bound on a piece is off by 1200 units of size and far, squares by
 * 104. */
FOOTPOINT_FN int footpoint_detail_edge3_above(const struct footpoint_detail_parabola *e, REAL least,
                                              REAL low, REAL high)
{
    const REAL slop = 2000.0 * REAL_UNIT * (e->far + e->size);
    REAL width = high - low, f[3];
    int i;
    for (i = 0; i < 2000 && low < high; i++) {
        const REAL half = 0.5 * width, middle = low + half;
        REAL bend, bound;
        footpoint_detail_edge3_values(e->c, middle, f);
        bend = f[1] - 0.67 * fabs(f[2]) * half;
        bound = 4.0 * footpoint_detail_edge3_square(e, middle) - 2.0 * fabs(f[0]) * half +
                (bend < 0.0 ? bend * half * half : 0.0);
        if (bound - slop > least) {
            low += width;
            width = 2.0 * width < high - low ? 2.0 * width : high - low;
        } else
            width *= 0.5;
    }
    return low >= high;
}

/* Returns 1 if an end is the closest point: the distance rises for a while, and is greater beyond. */
FOOTPOINT_FN int footpoint_detail_edge3_ends(const struct footpoint_detail_parabola *e,
                                             const REAL f[3], int region)
{
    const REAL rise = -footpoint_detail_edge3_fall(f[0], region), p = region == 1 ? -1.0 : 1.0;
    const REAL square = 4.0 * footpoint_detail_edge3_square(e, p);
    REAL first = 0.5 * rise / (fabs(f[1]) + fabs(f[2]));
    first = first < 1.0 ? first : 1.0;
    if (!region || !(rise > 32.0 * footpoint_detail_edge3_rounding(e, 1.0)))
        return 0;
    return region == 1 ? footpoint_detail_edge3_above(e, square, -1.0 + first, 1.0)
                       : footpoint_detail_edge3_above(e, square, -1.0, 1.0 - first);
}

/* Finds candidates for the closest point: the ends, and the places at which the cubic rises through 0 between its
 * extremes.  Returns their number. */
FOOTPOINT_FN int footpoint_detail_edge3_candidates(const REAL c[4], REAL p[5])
{
    const REAL under = c[2] * c[2] - 3.0 * c[3] * c[1];
    const REAL root = under > 0.0 ? sqrt(under) : 0.0;
    const REAL q = -(c[2] + (c[2] < 0.0 ? -root : root));
    REAL knot[4] = {-1.0, -1.0, -1.0, 1.0}, low[3], high[3];
    int i, n = 2;
    if (under > 0.0 && q != 0.0) {
        const REAL one = c[1] / q, other = c[3] > 0.0 ? q / (3.0 * c[3]) : one;
        knot[1] = one < other ? one : other;
        knot[2] = one < other ? other : one;
    }
    p[0] = -1.0;
    p[1] = 1.0;
    for (i = 1; i < 3; i++) {
        knot[i] = knot[i] > -1.0 ? knot[i] : -1.0;
        knot[i] = knot[i] < 1.0 ? knot[i] : 1.0;
    }
    for (i = 0; i < 3; i++) {
        footpoint_detail_edge3_values(c, knot[i], low);
        footpoint_detail_edge3_values(c, knot[i + 1], high);
        if (low[0] < 0.0 && high[0] > 0.0)
            p[n++] = footpoint_detail_edge3_between(c, knot[i], knot[i + 1]);
    }
    return n;
}

/* Computes the tangent, of any length; if it almost vanishes at an end, a little inside. */
FOOTPOINT_FN void footpoint_detail_edge3_side(const struct footpoint_detail_parabola *e, REAL xi,
                                              REAL t[2])
{
    const REAL inside = xi * (1.0 - REAL_INWARD);
    REAL inner[2], d[2];
    footpoint_detail_edge3_frame(e, inside, inner, d);
    footpoint_detail_edge3_frame(e, xi, t, d);
    if (footpoint_detail_plane_dot(t, t) <
        REAL_INWARD * REAL_INWARD * footpoint_detail_plane_dot(inner, inner)) {
        t[0] = inner[0];
        t[1] = inner[1];
    }
}

/* Returns 1 if another candidate is as near as p[best], elsewhere, and no point is nearer than both. */
FOOTPOINT_FN int footpoint_detail_edge3_tie(const struct footpoint_detail_parabola *e,
                                            const REAL *p, int n, int best)
{
    const REAL dist = sqrt(footpoint_detail_edge3_square(e, p[best]));
    const REAL rounding = 16.0 * REAL_UNIT * (dist + sqrt(e->size));
    const REAL tie = 0.9 * REAL_TIE * sqrt(footpoint_detail_plane_dot(e->h, e->h)) - rounding;
    const REAL least = dist > tie ? 4.0 * (dist - tie) * (dist - tie) : -1.0;
    int i, found = 0;
    for (i = 0; i < n; i++) {
        REAL t[2], d[2], to[2];
        footpoint_detail_edge3_frame(e, p[best], t, to);
        footpoint_detail_edge3_frame(e, p[i], t, d);
        found = found ||
                (sqrt(footpoint_detail_plane_dot(d, d)) < dist + 0.9 * tie &&
                 fabs(d[0] - to[0]) + fabs(d[1] - to[1]) > REAL_APART * (e->wide[0] + e->wide[1]));
    }
    return found && tie > 0.0 && footpoint_detail_edge3_above(e, least, -1.0, 1.0);
}

FOOTPOINT_COLD int footpoint_detail_edge3_seek(const REAL *const *x, REAL promise, REAL *xi,
                                               REAL *dist, int *region)
{
    struct footpoint_detail_parabola e;
    REAL f[3], t[2], d[2], side[2], p[5], least = 0.0, fall, error;
    int i, n, best = 0;
    footpoint_detail_edge3_parabola(x, &e);
    n = footpoint_detail_edge3_candidates(e.c, p);
    for (i = 0; i < n; i++) {
        const REAL square = footpoint_detail_edge3_square(&e, p[i]);
        best = i == 0 || square < least ? i : best;
        least = i == 0 || square < least ? square : least;
    }
    *xi = p[best];
    *region = best < 2 ? best + 1 : 0;
    if (best >= 2) {
        (void)footpoint_detail_edge3_check(&e, promise, xi);
        *xi = footpoint_detail_edge3_clamp(*xi, region);
    }
    footpoint_detail_edge3_frame(&e, *xi, t, d);
    footpoint_detail_edge3_side(&e, *xi, side);
    *dist = footpoint_detail_edge3_distance(&e, side, d, *region);
    footpoint_detail_edge3_values(e.c, *xi, f);
    if (footpoint_detail_fast() >> REAL_TOP)
        return FOOTPOINT_UNPROVED;
    fall = footpoint_detail_edge3_fall(footpoint_detail_edge3_sharp(&e, *xi, &error), *region);
    if (!(footpoint_detail_edge3_closed(fall, error, footpoint_detail_edge3_lowest(&e, f, *xi),
                                        promise) >>
          REAL_TOP) ||
        footpoint_detail_edge3_ends(&e, f, *region))
        return FOOTPOINT_OK;
    return footpoint_detail_edge3_tie(&e, p, n, best) ? FOOTPOINT_NOT_UNIQUE : FOOTPOINT_UNPROVED;
}

/* Computes the tangent at an end, of any length. */
FOOTPOINT_PART void footpoint_detail_edge3_tangent(const REAL *const *x, REAL xi, REAL t[2])
{
    struct footpoint_detail_parabola e;
    footpoint_detail_edge3_parabola(x, &e);
    footpoint_detail_edge3_side(&e, xi, t);
}

/* Returns 1 if no point of the edge is nearer than dist by more than REAL_TIE. */
FOOTPOINT_FN int footpoint_detail_edge3_at_least(const REAL *const *x, REAL dist)
{
    struct footpoint_detail_parabola e;
    const REAL least = dist - 0.9 * REAL_TIE;
    footpoint_detail_edge3_parabola(x, &e);
    return !(footpoint_detail_fast() >> REAL_TOP) &&
           footpoint_detail_edge3_above(&e, least > 0.0 ? 4.0 * least * least : -1.0, -1.0, 1.0);
}
