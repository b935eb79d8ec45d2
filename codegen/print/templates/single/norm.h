/* Lengths of vectors, for bounds of rounding errors. */

FOOTPOINT_PART REAL footpoint_detail_norm(const REAL a[3])
{
    return sqrt(footpoint_detail_dot(a, a));
}
