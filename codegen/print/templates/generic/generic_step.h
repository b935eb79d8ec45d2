/* A step of Newton's method and the gap, in plain arithmetic. */

/* Takes a step to the point at which xS - r is normal to the face.  Tangents are at most quadratic in xi and in eta, so
 * differences over two units are their derivatives. */
FOOTPOINT_FN void footpoint_detail_KIND_plain_step(const REAL *const *x, REAL *xi, REAL *eta)
{
    REAL u[5][3], v[5][3], d[3], other[3], f, g, ff, fg, gg, det;
    footpoint_detail_KIND_surface(x, *xi, *eta, u[0], v[0], d);
    footpoint_detail_KIND_surface(x, *xi + 1.0, *eta, u[1], v[1], other);
    footpoint_detail_KIND_surface(x, *xi - 1.0, *eta, u[2], v[2], other);
    footpoint_detail_KIND_surface(x, *xi, *eta + 1.0, u[3], v[3], other);
    footpoint_detail_KIND_surface(x, *xi, *eta - 1.0, u[4], v[4], other);
    f = footpoint_detail_dot(d, u[0]);
    g = footpoint_detail_dot(d, v[0]);
    ff = footpoint_detail_dot(u[0], u[0]) -
         0.5 * (footpoint_detail_dot(d, u[1]) - footpoint_detail_dot(d, u[2]));
    fg = footpoint_detail_dot(u[0], v[0]) -
         0.5 * (footpoint_detail_dot(d, u[3]) - footpoint_detail_dot(d, u[4]));
    gg = footpoint_detail_dot(v[0], v[0]) -
         0.5 * (footpoint_detail_dot(d, v[3]) - footpoint_detail_dot(d, v[4]));
    det = ff * gg - fg * fg;
    *xi = *xi + (gg * f - fg * g) / det;
    *eta = *eta + (ff * g - fg * f) / det;
}

/* Returns the distance of xS along the normal at (xi,eta), to which xS - r must be parallel. */
FOOTPOINT_FN REAL footpoint_detail_KIND_plain_gap(const REAL *const *x, REAL xi, REAL eta)
{
    REAL u[3], v[3], d[3], n[3];
    footpoint_detail_KIND_surface(x, xi, eta, u, v, d);
    footpoint_detail_cross(u, v, n);
    return footpoint_detail_dot(d, n) / sqrt(footpoint_detail_dot(n, n));
}
