/* Corners of faces, counter-clockwise, and their ranges of xi and eta. */

/* Returns 1 if two nodes have the same coordinates. */
FOOTPOINT_PART int footpoint_detail_same(const REAL *a, const REAL *b)
{
    return (a[0] == b[0]) & (a[1] == b[1]) & (a[2] == b[2]);
}

/* Computes (xi,eta) of corner k. */
FOOTPOINT_PART void footpoint_detail_square_corner(int k, REAL at[2])
{
    at[0] = k == 1 || k == 2 ? 1.0 : -1.0;
    at[1] = k > 1 ? 1.0 : -1.0;
}

FOOTPOINT_PART void footpoint_detail_triangle_corner(int k, REAL at[2])
{
    at[0] = k == 1 ? 1.0 : 0.0;
    at[1] = k == 2 ? 1.0 : 0.0;
}

/* Returns both coordinates of the middle. */
FOOTPOINT_PART REAL footpoint_detail_square_middle(void)
{
    return 0.0;
}

FOOTPOINT_PART REAL footpoint_detail_triangle_middle(void)
{
    return 1.0 / 3.0;
}

/* Moves (xi,eta) to the middle of its edge if the ends of this edge coincide.  Triangles have no such edges. */
FOOTPOINT_PART void footpoint_detail_square_bisect(const REAL *const *x, REAL at[2])
{
    if ((at[1] <= -1.0 && footpoint_detail_same(x[0], x[1])) ||
        (at[1] >= 1.0 && footpoint_detail_same(x[2], x[3])))
        at[0] = 0.0;
    if ((at[0] <= -1.0 && footpoint_detail_same(x[0], x[3])) ||
        (at[0] >= 1.0 && footpoint_detail_same(x[1], x[2])))
        at[1] = 0.0;
}

FOOTPOINT_PART void footpoint_detail_triangle_bisect(const REAL *const *x, REAL at[2])
{
    (void)x;
    (void)at;
}
