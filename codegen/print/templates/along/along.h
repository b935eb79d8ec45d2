/* Projection along a direction. */

#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3)
#endif
#ifndef FOOTPOINT_OUTSIDE
#define FOOTPOINT_OUTSIDE 1
#endif
#ifndef FOOTPOINT_NOT_UNIQUE
#define FOOTPOINT_NOT_UNIQUE 2
#endif

/* The largest error of xi and eta behind FOOTPOINT_OK. */
#define ALONG_PROMISE REAL_ALONG

/* Returns the larger number without a branch, which would keep loops from being vectorised. */
FOOTPOINT_PART REAL footpoint_detail_larger(REAL a, REAL b)
{
    return 0.5 * (a + b + fabs(a - b));
}

/* Returns the excess of |x| over 1, and 0 below. */
FOOTPOINT_PART REAL footpoint_detail_excess(REAL x)
{
    const REAL more = fabs(x) - 1.0;
    return 0.5 * (more + fabs(more));
}

/* Returns half of the last digit of 1. */
FOOTPOINT_PART REAL footpoint_detail_unit(void)
{
    return 1.0 / (REAL)((REAL_BITS)1 << REAL_DIGITS);
}

/* Returns the sum of the absolute values. */
FOOTPOINT_PART REAL footpoint_detail_manhattan(const REAL a[3])
{
    return fabs(a[0]) + fabs(a[1]) + fabs(a[2]);
}

/* Returns the status of a proved point on the face: nothing is proved if the compiler may change results. */
FOOTPOINT_PART int footpoint_detail_met(void)
{
    return FOOTPOINT_LOOSE ? FOOTPOINT_UNPROVED : FOOTPOINT_OK;
}

/* Scales the direction to a length of about 1. Returns FOOTPOINT_ERR_DEGENERATE if it has no length. */
FOOTPOINT_FN int footpoint_detail_along_scale(const REAL along[3], REAL p[3])
{
    REAL most = 0.0;
    int exponent, i;
    if (!footpoint_detail_finite(&along, 1))
        return FOOTPOINT_ERR_NOT_FINITE;
    for (i = 0; i < 3; i++)
        most = fabs(along[i]) > most ? fabs(along[i]) : most;
    if (footpoint_detail_below(most, REAL_MIN) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    (void)frexp(most, &exponent);
    for (i = 0; i < 3; i++)
        p[i] = ldexp(along[i], -exponent);
    return FOOTPOINT_OK;
}
