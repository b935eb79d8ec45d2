/* Statuses and answers of closest points. */

#ifndef FOOTPOINT_NOT_UNIQUE
#define FOOTPOINT_NOT_UNIQUE 2
#endif
#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3)
#endif

/* Returns the status of a closest point: dd and edge are the squares of its distance and of the distance to the edges.
 * FOOTPOINT_ERR_DEGENERATE if something in `all` is not finite, if size, the sum of the squares of edges, is not between least
 * and 1 / least, or if there is no area, nn being the square of its vector.  FOOTPOINT_ERR_DOMAIN beyond the longest edge; if the
 * search has a flaw and dd no meaning, beyond four times that.  FOOTPOINT_ERR_DEGENERATE for any other flaw. */
FOOTPOINT_PART int footpoint_detail_closest_status(REAL_BITS flaw, REAL all, REAL nn, REAL size,
                                                   REAL least, REAL dd, REAL edge, REAL longest)
{
    const REAL_BITS away =
        (footpoint_detail_below(longest, edge) & footpoint_detail_below(longest, dd) & ~flaw) |
        (footpoint_detail_below(16.0 * longest, edge) & flaw);
    const REAL_BITS nodes =
        footpoint_detail_below(size, least) | footpoint_detail_below(1.0 / least, size) |
        footpoint_detail_bits(nn - REAL_FLAT * (size * size)) | footpoint_detail_infinite(all);
    return FOOTPOINT_ERR_DEGENERATE * (int)((nodes | (flaw & ~away)) >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((away & ~nodes) >> REAL_TOP);
}

/* Returns the root of a squared distance, with its sign. */
FOOTPOINT_PART REAL footpoint_detail_signed_root(REAL dd)
{
    const REAL root = sqrt(fabs(dd));
    return dd < 0.0 ? -root : root;
}

/* The quick way: at = {xi, eta, square of the distance with its sign}; FOOTPOINT_UNPROVED without a proof.
 * lanes = 1 in a loop over arrays. */
typedef int footpoint_detail_nearby(const REAL *const *x, int lanes, REAL zero, REAL at[3],
                                    int *region);

/* Writes its answer for the caller, if there is an answer. */
FOOTPOINT_PART int footpoint_detail_closest_answer(int status, const REAL at[3], int where,
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
