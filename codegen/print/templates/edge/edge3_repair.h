/* Edges of three nodes for which two steps prove nothing, in a unit of length in which the edge is about 1 long. */

/* Returns a root of the cubic between low, where it is < 0, and high, where it is > 0, by Newton's steps, or by halving
 * if these lead outside. */
FOOTPOINT_FN REAL footpoint_detail_edge3_between(const REAL c[4], REAL low, REAL high)
{
    REAL xi = 0.5 * (low + high), f[3];
    int i;
    for (i = 0; i < 100; i++) {
        REAL next;
        footpoint_detail_edge3_values(c, xi, f);
        if (f[0] > 0.0)
            high = xi;
        else
            low = xi;
        next = f[1] > 0.0 ? xi - f[0] / f[1] : low;
        next = next > low && next < high ? next : 0.5 * (low + high);
        if (fabs(next - xi) <= 1e-14 * (1.0 + fabs(xi)))
            return next;
        xi = next;
    }
    return xi;
}

/* Returns a minimum of the distance to the whole curve, downhill from xi. */
FOOTPOINT_FN REAL footpoint_detail_edge3_downhill(const REAL c[4], REAL xi)
{
    REAL f[3], other = xi, step = 0.25;
    int i, rises;
    footpoint_detail_edge3_values(c, xi, f);
    rises = f[0] < 0.0;
    for (i = 0; i < 60 && (f[0] < 0.0) == rises; i++, step *= 2.0) {
        xi = other;
        other = rises ? xi + step : xi - step;
        footpoint_detail_edge3_values(c, other, f);
    }
    return rises ? footpoint_detail_edge3_between(c, xi, other)
                 : footpoint_detail_edge3_between(c, other, xi);
}

/* Returns the squared distance. */
FOOTPOINT_FN REAL footpoint_detail_edge3_square(const struct footpoint_detail_parabola *e, REAL xi)
{
    REAL t[2], d[2];
    footpoint_detail_edge3_frame(e, xi, t, d);
    return footpoint_detail_plane_dot(d, d);
}

/* Returns the cubic from tangent and distance, and bounds its rounding error.  Tangents are off by 2 + 8 x units of
 * `wide`, with x = |xi|, distances by 2 of s and by 2 x + 3 x^2 of `wide`. */
FOOTPOINT_FN REAL footpoint_detail_edge3_sharp(const struct footpoint_detail_parabola *e, REAL xi,
                                               REAL *error)
{
    const REAL x = fabs(xi);
    REAL t[2], d[2], off = 0.0;
    int j;
    footpoint_detail_edge3_frame(e, xi, t, d);
    for (j = 0; j < 2; j++)
        off += fabs(d[j]) * ((2.0 + 8.0 * x) * e->wide[j] + 2.0 * fabs(t[j])) +
               fabs(t[j]) * (2.0 * fabs(e->s[j]) + x * (2.0 + 3.0 * x) * e->wide[j]);
    *error = 2.0 * REAL_UNIT * off;
    return -2.0 * footpoint_detail_plane_dot(t, d);
}

/* Takes one more step from there to xi.  The highest bit of the result is set unless a minimum is proved to lie within
 * the promise of xi. */
FOOTPOINT_FN REAL_BITS footpoint_detail_edge3_check(const struct footpoint_detail_parabola *e,
                                                    REAL promise, REAL *xi)
{
    REAL f[3], error, rest, room, slope, left, off;
    footpoint_detail_edge3_values(e->c, *xi, f);
    if (f[1] > 0.0)
        *xi -= footpoint_detail_edge3_sharp(e, *xi, &error) / f[1];
    footpoint_detail_edge3_values(e->c, *xi, f);
    rest = footpoint_detail_edge3_sharp(e, *xi, &error);
    room = promise * footpoint_detail_greater(1.0, fabs(*xi));
    off = 4.0 * footpoint_detail_edge3_rounding(e, fabs(*xi));
    slope = 0.999 * f[1] - off - 2.01 * (fabs(f[2]) + off) * room;
    left = 0.99 * room * slope - fabs(rest) - error;
    return footpoint_detail_bits(slope) | footpoint_detail_bits(left) |
           footpoint_detail_outside(f[1]) | footpoint_detail_above(*xi, 1e6) |
           footpoint_detail_infinite(left) | footpoint_detail_fast();
}

/* Finds the minimum downhill from the nearest of nine points of the edge. */
FOOTPOINT_COLD int footpoint_detail_edge3_repair(const REAL *const *x, REAL promise, REAL *xi,
                                                 REAL *gap)
{
    struct footpoint_detail_parabola e;
    REAL begin = 0.0, least, square;
    int i, unproved;
    footpoint_detail_edge3_parabola(x, &e);
    least = footpoint_detail_edge3_square(&e, 0.0);
    for (i = -4; i <= 4; i++) {
        square = footpoint_detail_edge3_square(&e, 0.25 * (REAL)i);
        if (square < least) {
            least = square;
            begin = 0.25 * (REAL)i;
        }
    }
    *xi = footpoint_detail_edge3_downhill(e.c, begin);
    unproved = (int)(footpoint_detail_edge3_check(&e, promise, xi) >> REAL_TOP);
    if ((footpoint_detail_edge3_gap(&e, *xi, gap) | footpoint_detail_infinite(*xi + *gap)) >>
        REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    return unproved ? FOOTPOINT_UNPROVED : FOOTPOINT_OK;
}
