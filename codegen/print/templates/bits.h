/* The bits of numbers, on which every status depends. */

/* Statuses depend on the bits of numbers, because -ffast-math does not change integers.  The bits of infinity, as an
 * integer, are above all finite numbers, and NaN is above infinity.  The functions below return their result in the
 * highest bit. */
FOOTPOINT_PART REAL_BITS footpoint_detail_bits(REAL x)
{
    union {
        REAL number;
        REAL_BITS bits;
    } both;
    both.number = x;
    return both.bits;
}

/* Returns a 0 that compilers do not know.  It is added to operands of min and max in loops over arrays, for which gcc
 * otherwise emits four instructions instead of one. */
FOOTPOINT_PART REAL footpoint_detail_zero(void)
{
    const volatile int zero = 0;
    return (REAL)zero;
}

/* Tests that not 2^-REAL_LOW <= |x| < 2^REAL_HIGH: room for products of the parts of x, and half of all exponents. */
FOOTPOINT_PART REAL_BITS footpoint_detail_outside(REAL x)
{
    return 2 * footpoint_detail_bits(x) - ((REAL_BITS)REAL_MIDDLE << REAL_DIGITS);
}

/* Tests |x| < least. */
FOOTPOINT_PART REAL_BITS footpoint_detail_below(REAL x, REAL least)
{
    return (footpoint_detail_bits(x) & ~(REAL_BITS)0 >> 1) - footpoint_detail_bits(least);
}

/* Tests |x| > most, or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_above(REAL x, REAL most)
{
    return footpoint_detail_bits(most) - (footpoint_detail_bits(x) & ~(REAL_BITS)0 >> 1);
}

/* Tests that x is infinite or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_infinite(REAL x)
{
    return (footpoint_detail_bits(x) & ~(REAL_BITS)0 >> 1) + ((REAL_BITS)1 << (REAL_DIGITS - 1));
}
