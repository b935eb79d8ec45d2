/* The closest point of a closed patch, with its proof: by steps from the end of a search. */

/* The quick way from (xi,eta) = at: at = {xi, eta, square of the distance with its sign}; FOOTPOINT_UNPROVED without a
 * proof. `bare` steps precede the first tested step; their products are of degree 12 in lengths. */
FOOTPOINT_APART int footpoint_detail_KIND_close(const REAL *const *x, REAL promise, int bare,
                                                REAL at[3], int *region)
{
    footpoint_detail_KIND_terms of;
    footpoint_detail_KIND_anchor z;
    REAL size, longest, most, whole[CORNERS][2];
    REAL_BITS doubt, flat = 0, beyond;
    int k, i;
    *region = 0;
    if (!footpoint_detail_finite(x, VECTORS)) {
        at[0] = at[1] = at[2] = 0.0;
        return FOOTPOINT_UNPROVED;
    }
    footpoint_detail_KIND_expand(x, &of);
    for (i = 0; i < 2; i++)
        at[i] =
            footpoint_detail_infinite(at[i]) >> REAL_TOP ? 0.0 : footpoint_detail_KIND_kept(at[i]);
    for (k = 0; k <= bare; k++)
        footpoint_detail_KIND_bare(&of, &at[0], &at[1]);
    if (footpoint_detail_infinite(at[0] + at[1]) >> REAL_TOP)
        at[0] = at[1] = 0.0;
    footpoint_detail_KIND_anchor_at(&of, at, 0, &z);
    if (footpoint_detail_KIND_region(at))
        footpoint_detail_KIND_downhill(&of, &z);
    footpoint_detail_KIND_whole(whole);
    doubt = footpoint_detail_KIND_sole_of(&z, whole, footpoint_detail_KIND_needed(&z, promise));
    at[0] = z.at[0];
    at[1] = z.at[1];
    *region = footpoint_detail_KIND_region(at);
    size = footpoint_detail_KIND_extent(&of);
    longest = footpoint_detail_KIND_longest(x);
    at[2] = footpoint_detail_KIND_signed(x, &z, size, *region, &flat);
    beyond = footpoint_detail_above(z.dd, longest);
    most = z.far * z.far * (z.far * z.far);
    doubt |= flat | footpoint_detail_bits(1.01 - of.net.tilt) |
             footpoint_detail_outside(most * (most * most)) | footpoint_detail_outside(size * size);
    return FOOTPOINT_UNPROVED * (int)(doubt >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((beyond & ~doubt) >> REAL_TOP);
}
