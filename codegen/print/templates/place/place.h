/* What the functions at a place of a face share. */

#ifndef FOOTPOINT_UNUSED /* before functions that a macro defines: who asks for one of them may not call the others */
#if defined(__GNUC__)
#define FOOTPOINT_UNUSED __attribute__((unused))
#else
#define FOOTPOINT_UNUSED
#endif
#endif

/* A function at the place (xi,eta): x are the nodes and the slave node, and element i of row k goes to row[k][i * step].
 * The highest bit of what it returns is set if that is no answer; unless `always` nothing is written then, nor to a row
 * that is NULL. */
typedef REAL_BITS footpoint_detail_place(const REAL *const *x, REAL xi, REAL eta, REAL *const *row,
                                         size_t step, int always);

/* If x is not > 0, or not a number that products of lengths may be. */
FOOTPOINT_PART REAL_BITS footpoint_detail_not_above(REAL x)
{
    return footpoint_detail_bits(x) | footpoint_detail_below(x, REAL_MIN) |
           footpoint_detail_infinite(x);
}

/* Once more, in a unit of length in which the segment is about 1 long; row k has shape[2 k] elements, which go with the
 * power shape[2 k + 1] of lengths. */
FOOTPOINT_COLD int footpoint_detail_place_again(footpoint_detail_place *place, const REAL *const *x,
                                                int nodes, int vectors, REAL xi, REAL eta,
                                                REAL *const *row, size_t step, int rows,
                                                const int *shape)
{
    REAL y[10][3];
    const REAL *z[10];
    int exponent = 0, i, k;
    const int status = footpoint_detail_scale(x, nodes, vectors, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    if ((footpoint_detail_infinite(xi) | footpoint_detail_infinite(eta)) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    for (i = 0; i < vectors; i++)
        z[i] = y[i];
    if (place(z, xi, eta, row, step, 0) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    for (k = 0; k < rows; k++)
        for (i = 0; row[k] && i < shape[2 * k]; i++)
            row[k][(size_t)i * step] = ldexp(row[k][(size_t)i * step], exponent * shape[2 * k + 1]);
    return FOOTPOINT_OK;
}
