/* Points of edges, and statuses of closest points. */

#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3)
#endif

/* Of the nearest point found, dd and edge being the squares of its distance and of that of the nearest point of the edges:
 * FOOTPOINT_ERR_DEGENERATE if something is not finite in `all`, size, the sum of the squares of edges, is not between
 * least and 1 / least, or there is no area, nn being the square of its vector; else FOOTPOINT_ERR_DOMAIN beyond the
 * longest edge; else FOOTPOINT_ERR_DEGENERATE where the search has a flaw, dd says nothing then. */
FOOTPOINT_PART int footpoint_detail_closest_status(REAL_BITS flaw, REAL all, REAL nn, REAL size,
                                                   REAL least, REAL dd, REAL edge, REAL longest)
{
    const REAL_BITS away =
        footpoint_detail_below(longest, edge) & (footpoint_detail_below(longest, dd) | flaw);
    const REAL_BITS nodes =
        footpoint_detail_below(size, least) | footpoint_detail_below(1.0 / least, size) |
        footpoint_detail_bits(nn - REAL_FLAT * (size * size)) | footpoint_detail_infinite(all);
    return FOOTPOINT_ERR_DEGENERATE * (int)((nodes | (flaw & ~away)) >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((away & ~nodes) >> REAL_TOP);
}

/* The root of the square of a distance, with its sign. */
FOOTPOINT_PART REAL footpoint_detail_signed_root(REAL dd)
{
    const REAL root = sqrt(fabs(dd));
    return dd < 0.0 ? -root : root;
}

/* A search of closest points: x as NAME has its vectors; at = {xi, eta, square of the distance with its sign, square of
 * the cosine between xS - r and the normal}. */
typedef int footpoint_detail_nearest(const REAL *const *x, REAL zero, REAL at[4], int *region);

/* NAME_closest in a unit of length in which the segment is about 1 long; with nodes = 0 not. */
FOOTPOINT_COLD int footpoint_detail_closest_again(footpoint_detail_nearest *nearest,
                                                  const REAL *const *x, int nodes, int vectors,
                                                  REAL at[4], int *region)
{
    REAL y[10][3];
    const REAL *z[10];
    int exponent = 0, i, status = footpoint_detail_scale(x, nodes, vectors, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < vectors; i++)
        z[i] = y[i];
    status = nearest(z, 0.0, at, region);
    at[2] = footpoint_detail_signed_root(at[2]);
    at[2] = exponent ? ldexp(at[2], exponent) : at[2];
    return status;
}

/* NAME_closest, with the distance in at: where the status is FOOTPOINT_ERR_DEGENERATE once more. */
FOOTPOINT_PART int footpoint_detail_closest(footpoint_detail_nearest *nearest, const REAL *const *x,
                                            int nodes, int vectors, REAL at[4], int *region)
{
    REAL other[4] = {0.0, 0.0, 0.0, 0.0};
    int i, where = 0, status = nearest(x, 0.0, at, region);
    at[2] = footpoint_detail_signed_root(at[2]);
    if (status == FOOTPOINT_ERR_DEGENERATE) {
        status = footpoint_detail_closest_again(nearest, x, nodes, vectors, other, &where);
        for (i = 0; i < 4; i++)
            at[i] = other[i];
        *region = where;
    }
    return status;
}

/* Its answer to the caller, if there is one. */
FOOTPOINT_PART int footpoint_detail_closest_answer(int status, const REAL at[4], int where,
                                                   REAL loc[2], REAL *dist, int *region)
{
    if (status == FOOTPOINT_OK) {
        loc[0] = at[0];
        loc[1] = at[1];
        *dist = at[2];
        *region = where;
    }
    return status;
}
