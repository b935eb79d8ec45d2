/* Choices of numbers that raise no exception for NaN. */

/* Returns a if x > 0, otherwise b. masked: see footpoint_detail_choose. */
FOOTPOINT_PART REAL footpoint_detail_pick_of(int masked, REAL x, REAL a, REAL b)
{
    return footpoint_detail_choose(masked, footpoint_detail_exceeds(x, 0.0), a, b);
}

FOOTPOINT_PART REAL footpoint_detail_pick(REAL x, REAL a, REAL b)
{
    return footpoint_detail_exceeds(x, 0.0) ? a : b;
}

/* Returns the lesser number. */
FOOTPOINT_PART REAL footpoint_detail_least_of(int masked, REAL a, REAL b)
{
    return footpoint_detail_choose(masked, footpoint_detail_exceeds(b, a), a, b);
}

FOOTPOINT_PART REAL footpoint_detail_least(REAL a, REAL b)
{
    return footpoint_detail_exceeds(b, a) ? a : b;
}

FOOTPOINT_PART REAL footpoint_detail_length(const REAL a[3])
{
    return sqrt(footpoint_detail_dot(a, a));
}
