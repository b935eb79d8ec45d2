/* Products of vectors, and their differences, without loops: compilers would vectorise these although scalars are quicker. */

FOOTPOINT_PART void footpoint_detail_from(const REAL a[3], const REAL b[3], REAL d[3])
{
    d[0] = b[0] - a[0];
    d[1] = b[1] - a[1];
    d[2] = b[2] - a[2];
}

FOOTPOINT_PART void footpoint_detail_cross(const REAL a[3], const REAL b[3], REAL c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

FOOTPOINT_PART REAL footpoint_detail_dot(const REAL a[3], const REAL b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
