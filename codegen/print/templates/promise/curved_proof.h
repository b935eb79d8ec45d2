/* Answers of curved faces by Newton's steps, the last one proved. */

/* Computes the gap (9) at (p,q). */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_reach(const footpoint_detail_KIND_terms *of, REAL p,
                                                     REAL q, REAL least, REAL *gap)
{
    const REAL all = footpoint_detail_KIND_growth(fabs(p), fabs(q)) * of->size;
    footpoint_detail_local r;
    footpoint_detail_KIND_local(of, p, q, &r);
    return footpoint_detail_normal_gap(r.u, r.v, r.d, all * all, all * all, of->size * of->size,
                                       least, p + q, gap);
}

/* xi, eta and the gap by `bare` steps of Newton, and steps until one is proved, up to four; in a loop over arrays, fixed = 1, two
 * of them, with the same answer where these are enough.  x as NAME has its vectors. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_curved(const REAL *const *x, REAL promise, int bare,
                                                      int fixed, REAL least, REAL *xi, REAL *eta,
                                                      REAL *gap)
{
    footpoint_detail_KIND_terms of;
    REAL_BITS doubt;
    REAL p, q;
    int k;
    footpoint_detail_KIND_expand(x, &of);
    footpoint_detail_KIND_start(&of, &p, &q);
    if (!fixed && footpoint_detail_infinite(p + q) >> REAL_TOP) {
        *xi = *eta = *gap = p + q;
        return (REAL_BITS)1 << REAL_TOP; /* compilers' minima and maxima of NaN raise exceptions */
    }
    FOOTPOINT_UNROLL
    for (k = 0; k < bare; k++)
        footpoint_detail_KIND_bare(&of, &p, &q);
    doubt = footpoint_detail_KIND_step(&of, promise, &p, &q);
    if (fixed) {
        REAL s = p, t = q;
        const REAL_BITS still = footpoint_detail_KIND_step(&of, promise, &s, &t);
        p = doubt >> REAL_TOP ? s : p;
        q = doubt >> REAL_TOP ? t : q;
        doubt &= still;
    } else
        for (k = 0; k < 3 && doubt >> REAL_TOP; k++)
            doubt = footpoint_detail_KIND_step(&of, promise, &p, &q);
    *xi = p + footpoint_detail_KIND_middle();
    *eta = q + footpoint_detail_KIND_middle();
    return doubt | footpoint_detail_KIND_reach(&of, p, q, least, gap);
}
