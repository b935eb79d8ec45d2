/* The closest point of a closed curved face, with its proof: by steps from the middle, or of the edges. */

/* Returns the square of the longest edge's chord. */
FOOTPOINT_PART REAL footpoint_detail_KIND_longest(const REAL *const *x)
{
    REAL most = 0.0, e[3];
    int k;
    FOOTPOINT_UNROLL
    for (k = 0; k < CORNERS; k++) {
        footpoint_detail_from(x[k], x[(k + 1) % CORNERS], e);
        most = footpoint_detail_greater(most, footpoint_detail_dot(e, e));
    }
    return most;
}

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

/* Returns the squared distance at z, with its sign. If tangents are not nearly parallel, the normal is u x v. */
FOOTPOINT_PART REAL footpoint_detail_KIND_signed(const REAL *const *x,
                                                 const footpoint_detail_KIND_anchor *z, REAL size,
                                                 int region, REAL_BITS *flat)
{
    const footpoint_detail_local *const r = &z->r;
    const REAL bend = footpoint_detail_sum(r->uv);
    const REAL first = footpoint_detail_sum(r->u) + footpoint_detail_sum(r->uu) + bend;
    const REAL second = footpoint_detail_sum(r->v) + footpoint_detail_sum(r->vv) + bend;
    const REAL edge = region ? 1.0 : 0.0, all = first * second;
    REAL n[3], m[3], u[3], v[3], nn, mm;
    int i;
    footpoint_detail_cross(r->u, r->v, n);
    nn = footpoint_detail_dot(n, n);
    if (!(footpoint_detail_bits(nn - 1e-4 * (all * all)) >> REAL_TOP)) {
        *flat = footpoint_detail_bits(nn - REAL_FLAT * (size * size));
        return copysign(z->dd, footpoint_detail_facing(n, r->d, z->dd, size,
                                                       size * (footpoint_detail_dot(r->u, r->u) +
                                                               footpoint_detail_dot(r->v, r->v)),
                                                       edge));
    }
    footpoint_detail_KIND_inward(x, z->at[0], z->at[1], m);
    mm = footpoint_detail_dot(m, m);
    *flat = footpoint_detail_bits(mm - REAL_FLAT * (size * size));
    footpoint_detail_KIND_surface(x, z->at[0], z->at[1], u, v, n);
    for (i = 0; i < 3; i++)
        n[i] = r->d[i];
    return copysign(z->dd, footpoint_detail_side(u, v, m, n, z->dd, size, edge));
}

/* Computes the corners of the face, (xi,eta). */
FOOTPOINT_PART void footpoint_detail_KIND_whole(REAL part[CORNERS][2])
{
    int k;
    FOOTPOINT_UNROLL
    for (k = 0; k < CORNERS; k++)
        footpoint_detail_SHAPE_corner(k, part[k]);
}

/* Applies footpoint_detail_KIND_sole to a part with the given corners (xi,eta). */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_sole_of(const footpoint_detail_KIND_anchor *z,
                                                       REAL part[CORNERS][2], REAL promise)
{
    REAL h[CORNERS][2];
    int k;
    FOOTPOINT_UNROLL
    for (k = 0; k < CORNERS; k++)
        footpoint_detail_KIND_way(z, part[k], h[k]);
    return footpoint_detail_KIND_sole(z, h, promise);
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

/* Returns 1 if (xi,eta) is inside. */
FOOTPOINT_PART int footpoint_detail_KIND_is_inside(const REAL at[2])
{
    const REAL third = 1.0 - at[0] - at[1], low = footpoint_detail_least(at[0], at[1]);
    const REAL room = CORNERS == 3 ? footpoint_detail_least(low, third)
                                   : 1.0 - footpoint_detail_greater(fabs(at[0]), fabs(at[1]));
    return !(footpoint_detail_bits(room - REAL_EDGE) >> REAL_TOP);
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
    size = 4.0 * of.size * of.size;
    longest = footpoint_detail_KIND_longest(x);
    at[2] = footpoint_detail_KIND_signed(x, &z, size, *region, &flat);
    beyond = footpoint_detail_above(z.dd, longest);
    doubt |= flat | footpoint_detail_outside(z.far * z.far * (z.far * z.far)) |
             footpoint_detail_outside(size * size);
    return FOOTPOINT_UNPROVED * (int)(doubt >> REAL_TOP) +
           FOOTPOINT_ERR_DOMAIN * (int)((beyond & ~doubt) >> REAL_TOP);
}
