/* A closed curved face as a whole: the longest edge, its corners, the side on which a slave node lies. */

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

/* Returns 1 if (xi,eta) is inside. */
FOOTPOINT_PART int footpoint_detail_KIND_is_inside(const REAL at[2])
{
    const REAL third = 1.0 - at[0] - at[1], low = footpoint_detail_least(at[0], at[1]);
    const REAL room = CORNERS == 3 ? footpoint_detail_least(low, third)
                                   : 1.0 - footpoint_detail_greater(fabs(at[0]), fabs(at[1]));
    return !(footpoint_detail_bits(room - REAL_EDGE) >> REAL_TOP);
}
