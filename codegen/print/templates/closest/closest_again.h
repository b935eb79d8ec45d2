/* Closest points after the quick way has failed. */

/* Computes half of the Hessian of the squared distance at (xi,eta), {11, 12, 22}, with second derivatives by differences, or the
 * Gauss-Newton matrix, without them, if it is not positive definite. */
FOOTPOINT_COLD void footpoint_detail_KIND_second(const REAL *const *x, const REAL at[2],
                                                 const REAL u[3], const REAL v[3], const REAL d[3],
                                                 REAL h[3])
{
    const REAL step = REAL_INWARD, uu = footpoint_detail_dot(u, u), uv = footpoint_detail_dot(u, v);
    const REAL vv = footpoint_detail_dot(v, v), ud = footpoint_detail_dot(u, d);
    const REAL vd = footpoint_detail_dot(v, d);
    REAL a[3], b[3], e[3];
    footpoint_detail_KIND_surface(x, at[0] + step, at[1], a, b, e);
    h[0] = uu - (footpoint_detail_dot(a, d) - ud) / step;
    h[1] = uv - (footpoint_detail_dot(b, d) - vd) / step;
    footpoint_detail_KIND_surface(x, at[0], at[1] + step, a, b, e);
    h[2] = vv - (footpoint_detail_dot(b, d) - vd) / step;
    if (!(h[0] > 0.0 && h[2] > 0.0 && h[0] * h[2] > h[1] * h[1])) {
        h[0] = uu;
        h[1] = uv;
        h[2] = vv;
    }
}

/* Moves (xi,eta) inside the face downhill to the foot point, or towards an edge, by Newton's steps, which are damped if the distance
 * does not fall. */
FOOTPOINT_COLD void footpoint_detail_KIND_descend(const REAL *const *x, REAL at[2])
{
    REAL u[3], v[3], d[3], dd, damp = 0.0;
    int i, k;
    footpoint_detail_KIND_surface(x, at[0], at[1], u, v, d);
    dd = footpoint_detail_dot(d, d);
    for (i = 0; i < 100 && damp < 1e6; i++) {
        const REAL uu = footpoint_detail_dot(u, u), vv = footpoint_detail_dot(v, v);
        const REAL ud = footpoint_detail_dot(u, d), vd = footpoint_detail_dot(v, d);
        const REAL more = damp + REAL_MARGIN;
        const REAL least = REAL_MARGIN * REAL_MARGIN * (uu + vv) + REAL_MIN;
        REAL h[3], to[2], a[3], b[3], e[3], ee, over;
        footpoint_detail_KIND_second(x, at, u, v, d, h);
        h[0] += more * uu + least;
        h[2] += more * vv + least;
        over = 1.0 / (h[0] * h[2] - h[1] * h[1]);
        to[0] = at[0] + over * (h[2] * ud - h[1] * vd);
        to[1] = at[1] + over * (h[0] * vd - h[1] * ud);
        footpoint_detail_SHAPE_clamp(at, to);
        footpoint_detail_KIND_surface(x, to[0], to[1], a, b, e);
        ee = footpoint_detail_dot(e, e);
        if (ee > dd + REAL_MARGIN * (dd + 8.0 * sqrt(dd) + REAL_MARGIN)) { /* more than rounding */
            damp = damp > 0.0 ? 10.0 * damp : 1e-3;
            continue;
        }
        damp = damp > 1e-6 ? 0.1 * damp : 0.0;
        if (fabs(to[0] - at[0]) + fabs(to[1] - at[1]) < REAL_MARGIN)
            i = 100;
        for (k = 0; k < 2; k++)
            at[k] = to[k];
        for (k = 0; k < 3; k++) {
            u[k] = a[k];
            v[k] = b[k];
            d[k] = e[k];
        }
        dd = ee;
    }
}

/* Finds the closest point by a descent from `start`, in a unit of length in which the segment is about 1 long. */
FOOTPOINT_COLD int footpoint_detail_KIND_closest_from(const REAL *const *x, const REAL start[2],
                                                      REAL at[3], int *region)
{
    REAL y[10][3], to[2];
    const REAL *z[10];
    int exponent = 0, i, status = footpoint_detail_scale(x, NODES, VECTORS, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    for (i = 0; i < 2; i++)
        to[i] = start[i] + REAL_INWARD * (footpoint_detail_SHAPE_middle() - start[i]);
    footpoint_detail_KIND_descend(z, to);
    status = footpoint_detail_KIND_nearest(z, 0, 1e-6, to[0], to[1], at, region);
    if (status == FOOTPOINT_OK && *region == 0) { /* beside an edge, a descent does not reach it */
        REAL other[3];
        int where;
        const REAL dd = fabs(at[2]);
        (void)footpoint_detail_KIND_nearest(z, 0, 1e-6, 9.0, 9.0, other, &where);
        if (fabs(other[2]) <= dd + REAL_MARGIN * (dd + 8.0 * sqrt(dd))) {
            for (i = 0; i < 3; i++)
                at[i] = other[i];
            *region = where;
        }
    }
    at[2] = ldexp(footpoint_detail_signed_root(at[2]), exponent);
    return status;
}

/* Searches in that unit, unless `scalable` is 0, and if there is still no answer, by a descent from the middle. */
FOOTPOINT_COLD int footpoint_detail_KIND_closest_again(footpoint_detail_nearest *nearest,
                                                       const REAL *const *x, int scalable,
                                                       REAL at[3], int *region)
{
    const REAL middle[2] = {footpoint_detail_SHAPE_middle(), footpoint_detail_SHAPE_middle()};
    REAL y[10][3];
    const REAL *z[10];
    int exponent = 0, i, status = footpoint_detail_scale(x, NODES, VECTORS, y, &exponent);
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    status = scalable ? nearest(z, 0.0, at, region) : FOOTPOINT_ERR_DEGENERATE;
    at[2] = ldexp(footpoint_detail_signed_root(at[2]), exponent);
    if (status == FOOTPOINT_ERR_DEGENERATE)
        status = footpoint_detail_KIND_closest_from(x, middle, at, region);
    return status;
}

/* Writes the tangent e, counter-clockwise, of edge k at a point of it where r_xi and r_eta are u and v. */
FOOTPOINT_PART void footpoint_detail_KIND_tangent(const REAL u[3], const REAL v[3], int k,
                                                  REAL e[3])
{
    REAL from[2], to[2];
    int i;
    footpoint_detail_SHAPE_corner(k, from);
    footpoint_detail_SHAPE_corner((k + 1) % CORNERS, to);
    for (i = 0; i < 3; i++)
        e[i] = (to[0] - from[0]) * u[i] + (to[1] - from[1]) * v[i];
}

/* Returns the distance that a better search might find if the point at `at` is not a foot point, or is on an edge beside which xS
 * lies over the face: less by twice the gain in the tangent plane. */
FOOTPOINT_PART REAL footpoint_detail_KIND_least(const REAL *const *x, const REAL at[3], int region)
{
    REAL u[3], v[3], d[3], e[3], n[3], in[3], dd, ahead, height;
    if (region > CORNERS)
        return fabs(at[2]);
    footpoint_detail_KIND_surface(x, at[0], at[1], u, v, d);
    footpoint_detail_cross(u, v, n);
    if (region > 0) {
        footpoint_detail_KIND_tangent(u, v, region - 1, e);
        footpoint_detail_cross(n, e, in);
        if (footpoint_detail_dot(in, d) <= 0.0)
            return fabs(at[2]);
    }
    dd = footpoint_detail_dot(d, d);
    ahead = footpoint_detail_dot(d, n);
    height = ahead * ahead / (footpoint_detail_dot(n, n) + REAL_MIN);
    if (dd - height <= 1e-12 * dd)
        return fabs(at[2]);
    height = 2.0 * height - dd;
    return sqrt(height > 0.0 ? height : 0.0);
}

/* Returns the status of a point farther away than the longest edge, after a descent if errors of the search may hide a nearer
 * point. */
FOOTPOINT_COLD int footpoint_detail_KIND_closest_beyond(const REAL *const *x, REAL at[3],
                                                        int *region)
{
    const REAL least = footpoint_detail_KIND_least(x, at, *region);
    REAL longest = 0.0, e[3];
    int k;
    for (k = 0; k < CORNERS; k++) {
        footpoint_detail_from(x[k], x[(k + 1) % CORNERS], e);
        longest = footpoint_detail_dot(e, e) > longest ? footpoint_detail_dot(e, e) : longest;
    }
    if (least * least > longest || least >= fabs(at[2]))
        return FOOTPOINT_ERR_DOMAIN;
    return footpoint_detail_KIND_closest_from(x, at, at, region);
}

/* Finds the closest point, with the distance in at, and repeats the search if it has no answer. */
FOOTPOINT_PART int footpoint_detail_KIND_closest(footpoint_detail_nearest *nearest,
                                                 const REAL *const *x, int scalable, REAL at[3],
                                                 int *region)
{
    REAL other[3] = {0.0, 0.0, 0.0};
    int i, where = 0, status = nearest(x, 0.0, at, region);
    at[2] = footpoint_detail_signed_root(at[2]);
    if (status == FOOTPOINT_ERR_DOMAIN)
        status = footpoint_detail_KIND_closest_beyond(x, at, region);
    else if (status == FOOTPOINT_ERR_DEGENERATE) {
        status = footpoint_detail_KIND_closest_again(nearest, x, scalable, other, &where);
        for (i = 0; i < 3; i++)
            at[i] = other[i];
        *region = where;
    }
    return status;
}
