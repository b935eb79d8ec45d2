/* Bounds that all proofs use. */

/* Returns its highest bit set if the compiler may change results, in which case nothing is proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_fast(void)
{
    return (REAL_BITS)FOOTPOINT_LOOSE << REAL_TOP;
}

/* Compares numbers; NaN raises no exception. */
FOOTPOINT_PART int footpoint_detail_exceeds(REAL a, REAL b)
{
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
    return __builtin_isgreater(a, b);
#else
    return a > b;
#endif
}

/* Returns 1 if loops over pairs are worth masks: compilers have vectors of numbers and of their bits. */
FOOTPOINT_PART int footpoint_detail_masks(void)
{
#if defined(__GNUC__) && defined(__AVX2__) && !defined(FOOTPOINT_DEVICE)
    return sizeof(REAL) == sizeof(double);
#else
    return 0;
#endif
}

/* Returns a or b. masked = 1: by a mask of bits, in loops of which compilers would otherwise make branches. */
FOOTPOINT_PART REAL footpoint_detail_choose(int masked, int first, REAL a, REAL b)
{
    union {
        REAL number;
        REAL_BITS bits;
    } x, y;
    const REAL_BITS mask = (REAL_BITS)0 - (REAL_BITS)first;
    if (!masked)
        return first ? a : b;
    x.number = a;
    y.number = b;
    x.bits = (x.bits & mask) | (y.bits & ~mask);
    return x.number;
}

/* Returns the greater number. */
FOOTPOINT_PART REAL footpoint_detail_greater_of(int masked, REAL a, REAL b)
{
    return footpoint_detail_choose(masked, footpoint_detail_exceeds(a, b), a, b);
}

FOOTPOINT_PART REAL footpoint_detail_greater(REAL a, REAL b)
{
    return footpoint_detail_exceeds(a, b) ? a : b;
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
