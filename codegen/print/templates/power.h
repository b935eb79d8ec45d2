/* Powers of lengths, for thresholds that depend on the size of a segment. */

/* Returns |AB| to the power n, which scales a threshold for |AB| = 1. */
FOOTPOINT_FN REAL footpoint_detail_power(const REAL a[3], const REAL b[3], int n)
{
    const REAL x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2], square = x * x + y * y + z * z;
    REAL power = n & 1 ? sqrt(square) : 1.0;
    int i;
    for (i = n < 0 ? -n : n; i > 1; i -= 2)
        power *= square;
    return n < 0 ? 1.0 / power : power;
}
