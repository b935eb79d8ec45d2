/* Curved faces from a near start. */

/* Moves from (*xi,*eta) to the foot point and computes the gap there, by a Newton step and up to `stages` tested steps.
 * The highest bit of the result is not set if a minimum of the distance is proved to lie within promise of the answer,
 * see footpoint_detail_KIND_step(), and the answer is at most half of the face from the start. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_from(const REAL *const *x, REAL promise, REAL least,
                                                    int stages, REAL *xi, REAL *eta, REAL *gap)
{
    const REAL middle = footpoint_detail_KIND_middle(), s = *xi, t = *eta;
    REAL p = s - middle, q = t - middle;
    footpoint_detail_KIND_terms of;
    REAL_BITS doubt;
    footpoint_detail_KIND_expand(x, &of);
    footpoint_detail_KIND_bare(&of, &p, &q);
    if (footpoint_detail_infinite(p + q) >> REAL_TOP) {
        *xi = *eta = *gap = p + q;
        return (REAL_BITS)1 << REAL_TOP; /* compilers' maxima of NaN raise exceptions */
    }
    do
        doubt = footpoint_detail_KIND_step(&of, promise, &p, &q);
    while (--stages > 0 && doubt >> REAL_TOP);
    *xi = p + middle;
    *eta = q + middle;
    return doubt | footpoint_detail_above(*xi - s, 1.0) | footpoint_detail_above(*eta - t, 1.0) |
           footpoint_detail_KIND_reach(&of, p, q, least, gap);
}
