/* Units of length of patches side by side. */

enum { FOOTPOINT_LANES = 16 }; /* pairs at a time */

/* Computes the largest power of two that is at most x, an ordinary number, and its inverse. */
FOOTPOINT_PART void footpoint_detail_powers(REAL x, REAL *power, REAL *inverse)
{
    const REAL_BITS one = (REAL_BITS)1 << (REAL_DIGITS - 1), all = ((REAL_BITS)1 << REAL_TOP) - one;
    union {
        REAL number;
        REAL_BITS bits;
    } is, per;
    is.bits = footpoint_detail_bits(x) & all;
    per.bits = (all - one) - is.bits;
    *power = is.number;
    *inverse = per.number;
}
