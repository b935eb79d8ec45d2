/* Answers if the quick way fails: proved or repaired. */

/* Answers if a search is not good beyond doubt; promise <= 0: nothing is promised. It repeats the search, because a
 * loop takes fewer steps, in a unit of length in which the segment is about 1 long if it is far from that, then
 * repairs. */
FOOTPOINT_COLD int footpoint_detail_KIND_answer(footpoint_detail_search *search,
                                                const REAL *const *x, int nodes, REAL promise,
                                                REAL loc[2], REAL *gap)
{
    int status, exponent = 0, i;
    REAL y[VECTORS][3], xi, eta, g;
    const REAL *z[VECTORS];
    REAL_BITS doubt;
    if (!(promise > 0.0))
        return footpoint_detail_claim(footpoint_detail_again(search, x, nodes, VECTORS, loc, gap),
                                      promise);
    status = footpoint_detail_scale(x, NODES, VECTORS, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    doubt = search(x, 2, 0.0, &xi, &eta, &g);
    if (doubt >> REAL_TOP) {
        for (i = 0; i < VECTORS; i++)
            z[i] = y[i];
        if (nodes > 0 && (exponent > REAL_ORDINARY || exponent < -REAL_ORDINARY))
            doubt = search(z, 2, 0.0, &xi, &eta, &g);
        if (doubt >> REAL_TOP) {
            if (search(nodes > 0 ? z : x, 1, 0.0, &xi, &eta, &g) >> REAL_TOP)
                return FOOTPOINT_ERR_DEGENERATE;
            status = footpoint_detail_KIND_repair(y, promise, &xi, &eta);
            doubt = footpoint_detail_KIND_gap(z, xi, eta, 1e-6, &g);
        }
        g = ldexp(g, exponent);
        if ((doubt | footpoint_detail_infinite(g)) >> REAL_TOP)
            return FOOTPOINT_ERR_DEGENERATE; /* the distance overflows */
    }
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return status;
}
