/* The two domains of curved faces, for projection along a direction. */

/* Returns the distance of (xi,eta) beyond the edges: <= 0 inside. */
FOOTPOINT_PART REAL footpoint_detail_square_beyond(REAL xi, REAL eta)
{
    const REAL u = fabs(xi), v = fabs(eta);
    return (u > v ? u : v) - 1.0;
}

FOOTPOINT_PART REAL footpoint_detail_triangle_beyond(REAL xi, REAL eta)
{
    const REAL least = xi < eta ? xi : eta, over = xi + eta - 1.0;
    return -least > over ? -least : over;
}

/* Computes starting point k: the middle, then points towards the corners. */
FOOTPOINT_FN void footpoint_detail_square_start(int k, REAL at[3])
{
    at[0] = k == 0 ? 0.0 : k == 1 || k == 4 ? -0.75 : 0.75;
    at[1] = k == 0 ? 0.0 : k < 3 ? -0.75 : 0.75;
    at[2] = 0.0;
}

FOOTPOINT_FN void footpoint_detail_triangle_start(int k, REAL at[3])
{
    at[0] = k == 0 ? 1.0 / 3.0 : k == 2 ? 0.75 : k == 4 ? 0.5 : 0.125;
    at[1] = k == 0 ? 1.0 / 3.0 : k == 3 ? 0.75 : k == 4 ? 0.5 : 0.125;
    at[2] = 0.0;
}
