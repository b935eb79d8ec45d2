/* Checked searches where the quick way does not tell. */

/* A checked search: x as NAME has its vectors.  The highest bit of what it returns is set if the answer is not good; with way =
 * 0, in a loop over arrays, or 2, alone, if it is not good beyond doubt; with 1, in full, nothing is promised of xi and eta.
 * zero: see footpoint_detail_zero. */
typedef REAL_BITS footpoint_detail_search(const REAL *const *x, int way, REAL zero, REAL *xi,
                                          REAL *eta, REAL *gap);

/* A status, but FOOTPOINT_UNPROVED instead of FOOTPOINT_OK of functions that prove nothing, which have promise < 0. */
FOOTPOINT_PART int footpoint_detail_claim(int status, REAL promise)
{
    return promise < 0.0 && status == FOOTPOINT_OK ? FOOTPOINT_UNPROVED : status;
}

/* NAME in full: the search, and where that is not good once more, in a unit of length in which the segment is about 1
 * long; with nodes = 0 not. */
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
    if (footpoint_detail_infinite(g) >> REAL_TOP) /* a distance beyond all numbers */
        return FOOTPOINT_ERR_DEGENERATE;
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return FOOTPOINT_OK;
}
