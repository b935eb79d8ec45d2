/* Choices of numbers that raise no exception for NaN. */

/* Returns a if x > 0, otherwise b. */
FOOTPOINT_PART REAL footpoint_detail_pick(REAL x, REAL a, REAL b)
{
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
    return __builtin_isgreater(x, 0.0) ? a : b;
#else
    return x > 0.0 ? a : b;
#endif
}

/* Returns the lesser number. */
FOOTPOINT_PART REAL footpoint_detail_least(REAL a, REAL b)
{
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
    return __builtin_isgreater(b, a) ? a : b;
#else
    return a < b ? a : b;
#endif
}

FOOTPOINT_PART REAL footpoint_detail_length(const REAL a[3])
{
    return sqrt(footpoint_detail_dot(a, a));
}
