/* Bounds that all proofs use. */

/* Returns its highest bit set if the compiler may change results, in which case nothing is proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_fast(void)
{
    return (REAL_BITS)FOOTPOINT_LOOSE << REAL_TOP;
}

/* Returns the greater number; a comparison with NaN raises no exception. */
FOOTPOINT_PART REAL footpoint_detail_greater(REAL a, REAL b)
{
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
    return __builtin_isgreater(a, b) ? a : b;
#else
    return a > b ? a : b;
#endif
}

/* Returns the sum of the absolute values. */
FOOTPOINT_PART REAL footpoint_detail_sum(const REAL a[3])
{
    return fabs(a[0]) + fabs(a[1]) + fabs(a[2]);
}

/* Returns the scalar product of a, >= 0, and |b|. */
FOOTPOINT_PART REAL footpoint_detail_weigh(const REAL a[3], const REAL b[3])
{
    return a[0] * fabs(b[0]) + a[1] * fabs(b[1]) + a[2] * fabs(b[2]);
}

/* Not less than the root of x >= 0, and at most 1.061 times that: half of its exponent, as logarithms have it. */
FOOTPOINT_PART REAL footpoint_detail_root_bound(REAL x)
{
    union {
        REAL number;
        REAL_BITS bits;
    } both;
    both.bits = (footpoint_detail_bits(x) >> 1) + (footpoint_detail_bits(1.0) >> 1);
    return both.number;
}
