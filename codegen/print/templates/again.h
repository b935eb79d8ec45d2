/* Checked searches after the quick way has failed. */

/* A checked search: x has the vectors of the call.  The highest bit of the result is set if the answer fails: with way = 0, in a loop
 * over arrays, or 2, in a single call, if it is not good beyond doubt; with way = 1, in full, if there is no answer, without a
 * promise for xi and eta.  zero: see footpoint_detail_zero. */
typedef REAL_BITS footpoint_detail_search(const REAL *const *x, int way, REAL zero, REAL *xi,
                                          REAL *eta, REAL *gap);

/* Returns a status, with FOOTPOINT_UNPROVED instead of FOOTPOINT_OK for functions that prove nothing, whose promise is < 0. */
FOOTPOINT_PART int footpoint_detail_claim(int status, REAL promise)
{
    return promise < 0.0 && status == FOOTPOINT_OK ? FOOTPOINT_UNPROVED : status;
}

/* Searches in full; if that fails and nodes > 0, also in a unit of length in which the segment is about 1 long. */
FOOTPOINT_COLD int footpoint_detail_again(footpoint_detail_search *search, const REAL *const *x,
                                          int nodes, int vectors, REAL loc[2], REAL *gap)
{
    REAL y[10][3], xi, eta, g;
    const REAL *z[10];
    int exponent = 0, status, i;
    if (search(x, 1, 0.0, &xi, &eta, &g) >> REAL_TOP) {
        status = footpoint_detail_scale(x, nodes, vectors, y, &exponent);
        if (status != FOOTPOINT_OK)
            return status;
        for (i = 0; i < vectors; i++)
            z[i] = y[i];
        if (search(z, 1, 0.0, &xi, &eta, &g) >> REAL_TOP)
            return FOOTPOINT_ERR_DEGENERATE;
    }
    g = exponent ? ldexp(g, exponent) : g;
    if (footpoint_detail_infinite(g) >> REAL_TOP) /* the distance overflows */
        return FOOTPOINT_ERR_DEGENERATE;
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return FOOTPOINT_OK;
}
