/* Orders of the corners of a four-node segment. */

FOOTPOINT_FN REAL footpoint_detail_square_distance(const REAL a[3], const REAL b[3])
{
    const REAL x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

/* Returns the number of the corner nearest to s: 0..3, the first among equals. */
FOOTPOINT_FN int footpoint_detail_nearest_corner(const REAL *const *x, const REAL s[3])
{
    REAL least = footpoint_detail_square_distance(x[0], s);
    int nearest = 0, i;
    for (i = 1; i < 4; i++) {
        const REAL d = footpoint_detail_square_distance(x[i], s);
        nearest = d < least ? i : nearest;
        least = d < least ? d : least;
    }
    return nearest;
}

/* Returns 1 if |AD| > |AB| with corner k for A. */
FOOTPOINT_FN int footpoint_detail_mirrored(const REAL *const *x, int k)
{
    return footpoint_detail_square_distance(x[k], x[(k + 3) & 3]) >
           footpoint_detail_square_distance(x[k], x[(k + 1) & 3]);
}

/* Converts (u,v) of a segment that begins at corner k to xi and eta. */
FOOTPOINT_PART void footpoint_detail_turn_back(int k, REAL u, REAL v, REAL *xi, REAL *eta)
{
    *xi = k == 0 ? u : k == 1 ? -v : k == 2 ? -u : v;
    *eta = k == 0 ? v : k == 1 ? u : k == 2 ? -v : -u;
}
