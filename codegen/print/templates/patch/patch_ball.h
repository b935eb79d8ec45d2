/* The size of a patch. */

/* Returns roughly the sum of the squares of its edges. */
FOOTPOINT_PART REAL footpoint_detail_KIND_extent(const footpoint_detail_KIND_terms *of)
{
    return 0.25 * of->net.base * of->net.base;
}

/* Returns a lower bound on the distance of the patch, for any slave node: by a ball about the mean of the corners. The
 * patch is a mean of corners, plus at most 3/2 of handles, a third of an edge, and the shift by inner points. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_none_within(const REAL *const *x)
{
    footpoint_detail_KIND_terms of;
    REAL e[3], most = 0.0, longest = 0.0, middle;
    int k, i;
    footpoint_detail_KIND_expand(x, &of);
    middle = footpoint_detail_length(of.net.d);
    if (footpoint_detail_infinite(middle) >> REAL_TOP || !(of.net.tilt <= 1.01))
        return of.net.tilt <= 1.01 ? middle : 0.0;
    for (k = 0; k < CORNERS; k++) {
        for (i = 0; i < 3; i++)
            e[i] = (x[k][i] - x[VECTORS - 1][i]) + of.net.d[i];
        most = footpoint_detail_greater(most, footpoint_detail_dot(e, e));
        footpoint_detail_from(x[k], x[(k + 1) % CORNERS], e);
        longest = footpoint_detail_greater(longest, footpoint_detail_dot(e, e));
    }
    most = sqrt(most) + 0.51 * sqrt(longest) + footpoint_detail_KIND_moved(&of);
    return footpoint_detail_greater(middle - most - 1e-12 * (middle + of.net.far), 0.0);
}
