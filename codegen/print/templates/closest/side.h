/* The sign of distances: the side of a face on which a slave node lies.  All kinds and functions share this rule. */

/* Returns 1 if x > 0 and 0 if x < 0, to choose between two values without a branch, which would keep loops from
 * being vectorised and is predicted badly. */
FOOTPOINT_PART REAL footpoint_detail_step(REAL x)
{
    return 0.5 + copysign(0.5, x);
}

/* Returns a if step is 0, b if it is 1; both must be finite. */
FOOTPOINT_PART REAL footpoint_detail_either(REAL step, REAL a, REAL b)
{
    return (1.0 - step) * a + step * b;
}

/* Returns a number < 0 if d = xS - r points behind a face whose normal at r is n, > 0 otherwise.  At a point of an edge,
 * for which `edge` is 1 (inside 0), xS is behind only by more than a small angle and by more than the rounding
 * errors: beside a flat face, in its plane, it is not.  dd: the square of d; size: of the edges; spread: of the products
 * whose differences make n. */
FOOTPOINT_PART REAL footpoint_detail_facing(const REAL n[3], const REAL d[3], REAL dd, REAL size,
                                            REAL spread, REAL edge)
{
    const REAL ahead = footpoint_detail_dot(n, d), nn = footpoint_detail_dot(n, n);
    const REAL beside =
        nn * (REAL_ANGLE * dd + REAL_SMALL * size) + REAL_SMALL * (dd * spread) + REAL_MIN;
    return ahead * fabs(ahead) + edge * beside;
}

/* Returns the same for the normal u x v, u = r_xi and v = r_eta, or, if that vanishes, as at collapsed and at straight
 * corners, for m, the normal at a point REAL_INWARD of the way to the middle. */
FOOTPOINT_PART REAL footpoint_detail_side(const REAL u[3], const REAL v[3], const REAL m[3],
                                          const REAL d[3], REAL dd, REAL size, REAL edge)
{
    const REAL spread = size * (footpoint_detail_dot(u, u) + footpoint_detail_dot(v, v));
    REAL n[3], large;
    int i;
    footpoint_detail_cross(u, v, n);
    large = footpoint_detail_step(footpoint_detail_dot(n, n) -
                                  REAL_INWARD * REAL_INWARD * footpoint_detail_dot(m, m));
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        n[i] = footpoint_detail_either(large, m[i], n[i]);
    return footpoint_detail_facing(n, d, dd, size, spread, edge);
}
