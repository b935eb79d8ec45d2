/* The scale of coordinates that are relative to the segment. */

/* Returns 4 over the sum of the distances of the corners from A, component by component.  Coordinates relative to the segment are
 * differences from xA times this factor. */
FOOTPOINT_PART REAL footpoint_detail_relative(const REAL *const *x, int corners)
{
    REAL sum = 0.0;
    int i;
    for (i = 1; i < corners; i++)
        sum += fabs(x[i][0] - x[0][0]) + fabs(x[i][1] - x[0][1]) + fabs(x[i][2] - x[0][2]);
    return 4.0 / sum;
}

/* Returns the largest power of 2 that is at most x > 0. */
FOOTPOINT_PART REAL footpoint_detail_leading(REAL x)
{
    union {
        REAL number;
        REAL_BITS bits;
    } both;
    both.bits = footpoint_detail_bits(x) >> (REAL_DIGITS - 1) << (REAL_DIGITS - 1);
    return both.number;
}
