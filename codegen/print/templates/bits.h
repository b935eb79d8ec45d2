/* What every status rests on: the bits of numbers. */

/* Statuses are told by the bits of numbers: -ffast-math leaves integers alone.  Those of infinity are above all
 * others', those of NaN above these.  What the functions below find stands in the highest bit of a result. */
FOOTPOINT_PART REAL_BITS footpoint_detail_bits(REAL x)
{
    union {
        REAL number;
        REAL_BITS bits;
    } both;
    both.number = x;
    return both.bits;
}

/* 0, which compilers do not know to be: added to the numbers of min and max in loops over arrays, of which gcc makes four
 * instructions each where it knows them, else one. */
FOOTPOINT_PART REAL footpoint_detail_zero(void)
{
    const volatile int zero = 0;
    return (REAL)zero;
}

/* Unless 2^-REAL_LOW <= |x| < 2^REAL_HIGH: room for products of what x is made of, and half of all exponents. */
FOOTPOINT_PART REAL_BITS footpoint_detail_outside(REAL x)
{
    return 2 * footpoint_detail_bits(x) - ((REAL_BITS)REAL_MIDDLE << REAL_DIGITS);
}

/* If |x| < least. */
FOOTPOINT_PART REAL_BITS footpoint_detail_below(REAL x, REAL least)
{
    return (footpoint_detail_bits(x) & ~(REAL_BITS)0 >> 1) - footpoint_detail_bits(least);
}

/* If |x| > most, or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_above(REAL x, REAL most)
{
    return footpoint_detail_bits(most) - (footpoint_detail_bits(x) & ~(REAL_BITS)0 >> 1);
}

/* If x is infinite or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_infinite(REAL x)
{
    return (footpoint_detail_bits(x) & ~(REAL_BITS)0 >> 1) + ((REAL_BITS)1 << (REAL_DIGITS - 1));
}
