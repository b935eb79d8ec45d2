/* The closest point of a closed curved face, with its proof: by steps from the middle, or of the edges. */

/* Finds the nearest point of all edges that steps reach. */
FOOTPOINT_PART void footpoint_detail_KIND_on_edges(const REAL *const *x, REAL at[2])
{
    REAL c[5][8], place[8], best = 0.0, along = 0.0, t, from[2], to[2];
    int k, edge = 0;
    for (k = 0; k < CORNERS; k++)
        (void)footpoint_detail_curve_begin(x[k], x[CORNERS + k], x[(k + 1) % CORNERS], x[NODES], k,
                                           CORNERS, c, place);
    footpoint_detail_curve_steps(CORNERS, c, place);
    for (k = 0; k < CORNERS; k++) {
        const REAL dd = footpoint_detail_curve_end(x[k], x[CORNERS + k], x[(k + 1) % CORNERS],
                                                   x[NODES], k, CORNERS, place, &t);
        if (k == 0 || dd < best) {
            best = dd;
            along = t;
            edge = k;
        }
    }
    footpoint_detail_SHAPE_corner(edge, from);
    footpoint_detail_SHAPE_corner((edge + 1) % CORNERS, to);
    for (k = 0; k < 2; k++)
        at[k] = along >= 1.0 ? to[k] : from[k] + (0.5 + 0.5 * along) * (to[k] - from[k]);
}

/* Returns the promise to prove for the whole face: the caller's, if REAL_WITHIN does not suffice. */
FOOTPOINT_PART REAL footpoint_detail_KIND_needed(const footpoint_detail_KIND_anchor *z,
                                                 REAL promise)
{
    return promise < REAL_WITHIN &&
                   !(footpoint_detail_KIND_within(z, REAL_WITHIN, promise) >> REAL_TOP)
               ? REAL_WITHIN
               : promise;
}

/* Proves (xi,eta), which is inside. The highest bit of the result is not set if the closest point of the face is proved
 * to lie within `promise` of it. */
FOOTPOINT_FN REAL_BITS footpoint_detail_KIND_closest_at(const REAL *const *x, REAL promise,
                                                        const REAL at[2])
{
    footpoint_detail_KIND_terms of;
    footpoint_detail_KIND_anchor z;
    REAL whole[CORNERS][2];
    if (!footpoint_detail_KIND_is_inside(at))
        return (REAL_BITS)1 << REAL_TOP;
    footpoint_detail_KIND_expand(x, &of);
    footpoint_detail_KIND_anchor_at(&of, at, 0, &z);
    footpoint_detail_KIND_whole(whole);
    return footpoint_detail_KIND_sole_of(&z, whole, footpoint_detail_KIND_needed(&z, promise)) |
           footpoint_detail_outside(z.far * z.far * (z.far * z.far));
}

/* The quick way: at = {xi, eta, square of the distance with its sign}; FOOTPOINT_UNPROVED without a proof. `bare` steps
 * precede the first tested step. */
FOOTPOINT_FN int footpoint_detail_KIND_close(const REAL *const *x, REAL promise, int bare,
                                             REAL at[3], int *region)
{
    const REAL middle = footpoint_detail_KIND_middle(), far = CORNERS == 3 ? 1.0 : 1.6;
    footpoint_detail_KIND_terms of;
    footpoint_detail_KIND_anchor z;
    REAL p, q, longest, size, whole[CORNERS][2];
    REAL_BITS doubt = 0, flat = 0, beyond;
    int k, inside = 1;
    footpoint_detail_KIND_expand(x, &of);
    footpoint_detail_KIND_start(&of, &p, &q);
    footpoint_detail_KIND_whole(whole);
    at[0] = at[1] = at[2] = middle;
    *region = 0;
    if (footpoint_detail_infinite(p + q) >> REAL_TOP)
        return FOOTPOINT_UNPROVED;
    for (k = 0; k < bare && fabs(p) < far && fabs(q) < far; k++)
        footpoint_detail_KIND_bare(&of, &p, &q);
    for (k = 0; k < 3 && inside; k++) {
        if (fabs(p) < far && fabs(q) < far)
            footpoint_detail_KIND_bare(&of, &p, &q);
        if (footpoint_detail_infinite(p + q) >> REAL_TOP)
            return FOOTPOINT_UNPROVED;
        at[0] = p + middle;
        at[1] = q + middle;
        inside = footpoint_detail_KIND_is_inside(at);
        if (!inside)
            footpoint_detail_KIND_on_edges(x, at);
        *region = footpoint_detail_KIND_region(at);
        footpoint_detail_KIND_anchor_at(&of, at, *region, &z);
        doubt = footpoint_detail_KIND_sole_of(&z, whole, footpoint_detail_KIND_needed(&z, promise));
        if (!(doubt >> REAL_TOP))
            break;
    }
    size = footpoint_detail_KIND_extent(&of);
    longest = footpoint_detail_KIND_longest(x);
    at[2] = footpoint_detail_KIND_signed(x, &z, size, *region, &flat);
    beyond = footpoint_detail_above(z.dd, longest);
    doubt |= flat | footpoint_detail_outside(z.far * z.far * (z.far * z.far)) |
             footpoint_detail_outside(size * size);
    return FOOTPOINT_UNPROVED * (int)(doubt >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((beyond & ~doubt) >> REAL_TOP);
}
