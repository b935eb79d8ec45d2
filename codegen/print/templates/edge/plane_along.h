/* The intersection of a line with an edge: a root of a polynomial of degree at most two. */

/* Bounds the error of xi with FOOTPOINT_OK. */
#ifndef ALONG_PROMISE
#define ALONG_PROMISE REAL_ALONG
#endif

/* Holds a line relative to an edge: it meets the curve where g = a[0] + xi (a[1] + xi a[2]) is 0. By rounding, a[0] is
 * off by 3 units of far, a[1] by 3 and a[2] by 4 of wide; far and wide also bound their absolute values. */
struct footpoint_detail_line {
    REAL a[3], far, wide;
};

/* Computes the direction in a unit, 2^exponent, in which it is about 1 long. Returns a status. */
FOOTPOINT_FN int footpoint_detail_plane_direction(const REAL along[2], REAL p[2], int *exponent)
{
    REAL most;
    if ((footpoint_detail_infinite(along[0]) | footpoint_detail_infinite(along[1])) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    most = footpoint_detail_greater(fabs(along[0]), fabs(along[1]));
    if (footpoint_detail_below(most, REAL_MIN) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    (void)frexp(most, exponent);
    p[0] = ldexp(along[0], -*exponent);
    p[1] = ldexp(along[1], -*exponent);
    return FOOTPOINT_OK;
}

/* Adds up the absolute values of the products of a cross product. */
FOOTPOINT_PART REAL footpoint_detail_plane_across(const REAL p[2], REAL x, REAL y)
{
    return fabs(p[0]) * fabs(y) + fabs(p[1]) * fabs(x);
}

/* Returns its highest bit set unless a root is proved to lie within the promise of xi, which is at most 2 from the
 * edge.  The slope is off by 8 (1 + x) units of wide, and changes by 2 a[2] per unit. */
FOOTPOINT_PART REAL_BITS footpoint_detail_plane_root(const struct footpoint_detail_line *l, REAL xi)
{
    const REAL x = fabs(xi), promise = 0.99 * ALONG_PROMISE * (1.0 + x) * 0.5;
    const REAL g = fabs(l->a[0] + xi * (l->a[1] + xi * l->a[2]));
    const REAL slope =
        fabs(l->a[1] + 2.0 * xi * l->a[2]) - 2.0 * ALONG_PROMISE * (1.0 + x) * l->wide;
    const REAL left =
        promise * slope - g - REAL_UNIT * (5.0 * l->far + x * (7.0 + 9.0 * x) * l->wide);
    return footpoint_detail_bits(slope) | footpoint_detail_bits(left) |
           footpoint_detail_infinite(left) | footpoint_detail_fast();
}

/* Returns its highest bit set if the line may meet the edge elsewhere: g / (t - xi) is linear, and its signs at both
 * ends are not surely equal. */
FOOTPOINT_PART REAL_BITS footpoint_detail_plane_elsewhere(const struct footpoint_detail_line *l,
                                                          REAL xi)
{
    const REAL left = l->a[1] + (xi - 1.0) * l->a[2], right = l->a[1] + (xi + 1.0) * l->a[2];
    const REAL off = 4.0 * ALONG_PROMISE * (1.0 + fabs(xi)) * l->wide;
    return footpoint_detail_bits(fabs(left) - off) | footpoint_detail_bits(fabs(right) - off) |
           (footpoint_detail_bits(left) ^ footpoint_detail_bits(right));
}

/* Computes both roots, the nearer to 0 first; returns 0 if they are not real. */
FOOTPOINT_FN int footpoint_detail_plane_roots(const struct footpoint_detail_line *l, REAL root[2])
{
    const REAL under = l->a[1] * l->a[1] - 4.0 * l->a[2] * l->a[0];
    const REAL q = -0.5 * (l->a[1] + copysign(sqrt(under > 0.0 ? under : 0.0), l->a[1]));
    root[0] = q != 0.0 ? l->a[0] / q : 0.0;
    root[1] = l->a[2] != 0.0 ? q / l->a[2] : 1.0 / REAL_MIN;
    return under >= 0.0;
}

/* Returns the status of roots that are not far: see the contract.  xi is the relevant root; of two on the edge it is
 * root[0]. */
FOOTPOINT_FN int footpoint_detail_plane_meet(const struct footpoint_detail_line *l, REAL root[2],
                                             REAL *xi)
{
    const int real = footpoint_detail_plane_roots(l, root);
    const REAL under = l->a[1] * l->a[1] - 4.0 * l->a[2] * l->a[0];
    const REAL off = REAL_UNIT * l->wide * (12.0 * l->wide + 40.0 * l->far);
    *xi = root[0];
    if (footpoint_detail_fast() >> REAL_TOP)
        return FOOTPOINT_UNPROVED;
    if (!real)
        return under < -off ? FOOTPOINT_ERR_DOMAIN : FOOTPOINT_UNPROVED;
    if (footpoint_detail_plane_root(l, root[0]) >> REAL_TOP)
        return FOOTPOINT_UNPROVED;
    if (!(footpoint_detail_plane_elsewhere(l, root[0]) >> REAL_TOP))
        return fabs(root[0]) > 1.0 ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
    return fabs(root[0]) < 1.0 - ALONG_PROMISE && fabs(root[1]) < 1.0 - ALONG_PROMISE &&
                   !(footpoint_detail_plane_root(l, root[1]) >> REAL_TOP)
               ? FOOTPOINT_NOT_UNIQUE
               : FOOTPOINT_UNPROVED;
}
