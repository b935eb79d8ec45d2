/* Normals near points at which the face itself has no normal. */

/* Computes the normal m, of any length, at the point REAL_INWARD of the way from (xi,eta) to the middle; from an edge whose ends
 * coincide, on the bisector there. */
FOOTPOINT_PART void footpoint_detail_KIND_inward(const REAL *const *x, REAL xi, REAL eta, REAL m[3])
{
    const REAL middle = footpoint_detail_SHAPE_middle();
    REAL at[2], u[3], v[3], d[3];
    at[0] = xi;
    at[1] = eta;
    footpoint_detail_SHAPE_bisect(x, at);
    at[0] += REAL_INWARD * (middle - at[0]);
    at[1] += REAL_INWARD * (middle - at[1]);
    footpoint_detail_KIND_surface(x, at[0], at[1], u, v, d);
    footpoint_detail_cross(u, v, m);
}
