/* The functions for callers that differentiate along a direction. */

/* Returns at least the sum of the squares of the edges that add up to the tangents at loc. */
FOOTPOINT_PART REAL SLOPES_detail_size(const REAL *const *x, const REAL loc[2])
{
    const REAL reach = 1.0 + loc[0] * loc[0] + loc[1] * loc[1], growth = REACH_TO_GROWTH;
    REAL size = 0.0;
    int i, k;
    FOOTPOINT_UNROLL
    for (k = 1; k < NODES; k++) {
        REAL edge[3];
        for (i = 0; i < 3; i++)
            edge[i] = x[k][i] - x[0][i];
        size += footpoint_detail_dot(edge, edge);
    }
    return growth * size;
}

/* Computes derivatives of xi, eta and distance, rows 1 to 3, quickly, from the known distance or, if that is NULL, from
 * the distance that becomes row 0. If numbers are not moderate or the line is nearly parallel, the highest bit of the
 * result is set, and nothing is written. */
FOOTPOINT_PART REAL_BITS SLOPES_detail(const REAL *const *x, const REAL along[3], const REAL loc[2],
                                       const REAL *known, REAL *const *row)
{
    const REAL square = footpoint_detail_dot(along, along), over = 1.0 / sqrt(square);
    const REAL q[3] = {over * along[0], over * along[1], over * along[2]};
    REAL phi[NODES], f[2][NODES], a[3], b[3], c[3][3], v[3][3], t, turn, all;
    REAL *const found[ROW_COUNT] = {phi, f[0], f[1], a, b, c[0], c[1], c[2]};
    REAL_BITS flaw = footpoint_detail_outside(square) | footpoint_detail_far(loc[0], loc[1]);
    (void)NAME_detail(x, loc[0], loc[1], found, 1, 1,
                      1); /* the next sees numbers that are not finite */
    flaw |= footpoint_detail_solve_along(a, b, q, SLOPES_detail_size(x, loc), v, &all);
    t = known ? *known : footpoint_detail_ahead(x, NODES, phi, q);
    turn = -t * over;
    flaw |= footpoint_detail_infinite(all * (1.0 + turn * turn));
    if (flaw >> REAL_TOP)
        return flaw;
    if (row[0])
        row[0][0] = t;
    footpoint_detail_write_slopes(NODES, phi, v, q, turn, row + 1);
    return flaw;
}

/* Repeats it in a unit of length in which the face is about 1 long. Callers' arrays of pointers stay in registers, as
 * none is passed. */
FOOTPOINT_COLD int SLOPES_detail_again(NODE_PARAMETERS, const REAL along[3], const REAL loc[2],
                                       REAL *dist, REAL *d_xi, REAL *d_eta, REAL *d_dist)
{
    const REAL *const x[VECTORS] = {NODE_NAMES}, *y[VECTORS];
    REAL *const row[4] = {dist, d_xi, d_eta, d_dist};
    REAL phi[NODES] = {0.0}, a[3] = {0.0}, b[3] = {0.0}, z[VECTORS][3], q[3], over;
    REAL *const found[ROW_COUNT] = {phi, 0, 0, a, b};
    int exponent = 0, status = footpoint_detail_scale(x, NODES, VECTORS, z, &exponent), k;
    if (status == FOOTPOINT_OK)
        status = footpoint_detail_direction(along, q, &over);
    if (status != FOOTPOINT_OK)
        return status;
    if ((footpoint_detail_infinite(loc[0]) | footpoint_detail_infinite(loc[1])) >> REAL_TOP)
        return FOOTPOINT_ERR_NOT_FINITE;
    for (k = 0; k < VECTORS; k++)
        y[k] = z[k];
    if (NAME_detail(y, loc[0], loc[1], found, 1, 0, 1) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE;
    return footpoint_detail_slopes(y, NODES, ldexp(1.0, exponent), phi, a, b,
                                   SLOPES_detail_size(y, loc), q, over, row);
}

/* footpoint_KIND_gradients_along:  computes dist, with xS = r + dist along / |along|, and the derivatives of xi, eta
 *         and dist at the intersection of the face with the line through xS in the direction `along`, at loc = {xi,
 *         eta} as a projection found it: element 3 k + i by coordinate i of node k; the slave node follows the nodes,
 *         `along` comes last. A row may be NULL. Returns FOOTPOINT_OK; FOOTPOINT_ERR_DEGENERATE if there is no
 *         direction or no area, or if the line is so nearly parallel to the face that rounding may cost derivatives
 *         more than about 1e-9; or FOOTPOINT_ERR_NOT_FINITE for an input or a result. Rows are untouched on error.
 * UPPER_GRADIENTS_ALONG_OF(footpoint_KIND_along), at file scope, defines footpoint_KIND_along_gradients(..., along,
 *         loc, dist, d_xi, d_eta, d_dist), the projection and its derivatives. The status is the projection's, or, if
 *         derivatives cannot be computed, theirs; with FOOTPOINT_UNPROVED they are written. */
FOOTPOINT_FN int SLOPES(NODE_PARAMETERS, const REAL along[3], const REAL loc[2], REAL dist[1],
                        REAL d_xi[SLOPE_COUNT], REAL d_eta[SLOPE_COUNT], REAL d_dist[SLOPE_COUNT])
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL *const row[4] = {dist, d_xi, d_eta, d_dist};
    if (SLOPES_detail(x, along, loc, 0, row) >> REAL_TOP)
        return SLOPES_detail_again(NODE_NAMES, along, loc, dist, d_xi, d_eta, d_dist);
    return FOOTPOINT_OK;
}
