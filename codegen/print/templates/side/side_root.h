/* Roots in loops that vectorise. */

/* Computes 1 / sqrt(x) of ordinary x. It avoids sqrt if that may set errno, because then loops would not vectorise. */
FOOTPOINT_PART double footpoint_detail_KIND_side_root(double x)
{
#if defined(__NO_MATH_ERRNO__) || !defined(__GNUC__)
    return 1.0 / sqrt(x);
#else
    union {
        double number;
        unsigned long long bits;
    } y;
    const double half = 0.5 * x;
    double e;
    y.bits = REAL_ROOT - footpoint_detail_bits(x) / 2;
    y.number *= 1.5 - half * (y.number * y.number);
    y.number *= 1.5 - half * (y.number * y.number);
    e = 0.5 - half * (y.number * y.number);
    return y.number + y.number * e * (1.0 + 1.5 * e);
#endif
}
