/* Parts that functions at a place of a face share. */

#ifndef FOOTPOINT_UNUSED /* before functions that a macro defines: a file that calls one of them may not call the others */
#if defined(__GNUC__)
#define FOOTPOINT_UNUSED __attribute__((unused))
#else
#define FOOTPOINT_UNUSED
#endif
#endif

/* The largest gap, or coordinate of a slave node, in the quick way, so that products of lengths are finite: 2^64. */
#define FOOTPOINT_DETAIL_MOST 18446744073709551616.0

/* A function at the place (xi,eta): x are the nodes and the slave node, and element i of row k goes to row[k][i * step].
 * The highest bit of its result is set if there is no answer.  Then nothing is written, unless `always`; a row that is NULL is
 * never written.  Results are finite, unless `again`: then the caller must test them. */
typedef REAL_BITS footpoint_detail_place(const REAL *const *x, REAL xi, REAL eta, REAL *const *row,
                                         size_t step, int always, int again);

/* Tests that x is not > 0, or too large for products of lengths. */
FOOTPOINT_PART REAL_BITS footpoint_detail_not_above(REAL x)
{
    const REAL_BITS bits = footpoint_detail_bits(x);
    return (bits - footpoint_detail_bits(REAL_MIN)) | (bits + ((REAL_BITS)1 << (REAL_DIGITS - 1)));
}

/* Tests that |xi| or |eta| is 2 or more, or NaN, by the highest bit of their exponents. */
FOOTPOINT_PART REAL_BITS footpoint_detail_far(REAL xi, REAL eta)
{
    return (footpoint_detail_bits(xi) | footpoint_detail_bits(eta)) << 1;
}

/* Tests that the tangents a and b at (xi,eta) are parallel within rounding errors, in a unit of length in which the
 * segment is about 1 long.  They are sums of edges times at most this power of xi and eta. */
FOOTPOINT_FN REAL_BITS footpoint_detail_flat(const REAL a[3], const REAL b[3], REAL xi, REAL eta,
                                             int degree)
{
    const REAL far = 0.5 * (xi * xi + eta * eta), aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    const REAL bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    const REAL x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2],
               z = a[0] * b[1] - a[1] * b[0];
    REAL most = REAL_FLAT * (aa + bb);
    for (; degree > 0 && far > 1.0; degree--)
        most *= far;
    return footpoint_detail_not_above(x * x + y * y + z * z - most);
}

/* Rescales n numbers by this power of 2.  Returns 0 if one of them is infinite or NaN. */
FOOTPOINT_FN int footpoint_detail_rescale(REAL *x, int n, int exponent)
{
    REAL_BITS flaw = 0;
    int i;
    for (i = 0; i < n; i++) {
        x[i] = ldexp(x[i], exponent);
        flaw |= footpoint_detail_infinite(x[i]);
    }
    return !(flaw >> REAL_TOP);
}

/* Repeats a function in a unit of length in which the segment is about 1 long.  Row k has shape[2 k] elements, which scale with
 * the power shape[2 k + 1] of lengths; space has room for all of them.  tangents: 0, or a function that computes r_xi and r_eta as
 * rows `first` and the next, which grow with xi and eta to the power `degree`. */
FOOTPOINT_COLD int footpoint_detail_place_again(footpoint_detail_place *place,
                                                footpoint_detail_place *tangents, int first,
                                                int degree, const REAL *const *x, int nodes,
                                                int vectors, REAL xi, REAL eta, REAL *const *row,
                                                size_t step, int rows, const int *shape,
                                                REAL *space)
{
    REAL y[10][3], r[2][3], *own[16];
    const REAL *z[10];
    int exponent = 0, finite = 1, i, k;
    const int status = footpoint_detail_scale(x, nodes, vectors, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    if ((footpoint_detail_infinite(xi) | footpoint_detail_infinite(eta)) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    for (i = 0; i < vectors; i++)
        z[i] = y[i];
    for (k = 0; k < 16; k++)
        own[k] = tangents && (k == first || k == first + 1) ? r[k - first] : 0;
    if (tangents && ((tangents(z, xi, eta, own, 1, 0, 1) >> REAL_TOP) ||
                     (footpoint_detail_flat(r[0], r[1], xi, eta, degree) >> REAL_TOP)))
        return FOOTPOINT_ERR_DEGENERATE;
    for (k = 0; k < rows; space += shape[2 * k], k++)
        own[k] = row[k] ? space : 0;
    if (place(z, xi, eta, own, 1, 0, 1) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    for (k = 0; k < rows; k++)
        finite = finite && (!own[k] || footpoint_detail_rescale(own[k], shape[2 * k],
                                                                exponent * shape[2 * k + 1]));
    if (!finite)
        return FOOTPOINT_ERR_NOT_FINITE;
    for (k = 0; k < rows; k++)
        for (i = 0; row[k] && i < shape[2 * k]; i++)
            row[k][(size_t)i * step] = own[k][i];
    return FOOTPOINT_OK;
}
