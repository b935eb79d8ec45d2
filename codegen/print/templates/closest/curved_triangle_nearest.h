/* The closest point of the closed triangle with curved edges. */

/* Finds the nearer of the search's point (xi,eta), if it is inside, and the nearest point of the edges, as at: see
 * footpoint_detail_nearest.  If rounding hides which is nearer, see footpoint_detail_leeway. */
FOOTPOINT_PART int footpoint_detail_KIND_nearest(const REAL *const *x, REAL_BITS flaw, REAL least,
                                                 REAL xi, REAL eta, REAL at[3], int *region)
{
    REAL c[5][8], places[8], ee[3], t[3], dd[3], u[3], v[3], d[3], m[3], inner, all;
    REAL size, longest, best, edge, edge_u, edge_v, along;
    int within, inside, k, second, last;
    flaw |= footpoint_detail_infinite(xi + eta);
    ee[0] = footpoint_detail_curve_begin(x[0], x[3], x[1], x[NODES], 0, 3, c, places);
    ee[1] = footpoint_detail_curve_begin(x[1], x[4], x[2], x[NODES], 1, 3, c, places);
    ee[2] = footpoint_detail_curve_begin(x[2], x[5], x[0], x[NODES], 2, 3, c, places);
    footpoint_detail_curve_steps(3, c, places);
    dd[0] = footpoint_detail_curve_end(x[0], x[3], x[1], x[NODES], 0, 3, places, &t[0]);
    dd[1] = footpoint_detail_curve_end(x[1], x[4], x[2], x[NODES], 1, 3, places, &t[1]);
    dd[2] = footpoint_detail_curve_end(x[2], x[5], x[0], x[NODES], 2, 3, places, &t[2]);
    size = ee[0] + ee[1] + ee[2];
    longest = ee[0] > ee[1] ? ee[0] : ee[1];
    longest = longest > ee[2] ? longest : ee[2];
    second = dd[1] < dd[0];
    along = second ? t[1] : t[0];
    edge_u = second ? 0.5 - 0.5 * t[1] : 0.5 + 0.5 * t[0];
    edge_v = second ? 0.5 + 0.5 * t[1] : 0.0;
    best = second ? dd[1] : dd[0];
    last = dd[2] < best;
    along = last ? t[2] : along;
    edge_u = last ? 0.0 : edge_u;
    edge_v = last ? 0.5 - 0.5 * t[2] : edge_v;
    best = last ? dd[2] : best;
    within = (xi > 0.0) & (eta > 0.0) & (xi + eta < 1.0);
    xi = within ? xi : edge_u;
    eta = within ? eta : edge_v;
    footpoint_detail_KIND_surface(x, xi, eta, u, v, d);
    inner = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    inside = within & (inner <= best + footpoint_detail_leeway(u, v, d, inner, size));
    all = dd[0] + dd[1] + dd[2] + inner;
    edge = best;
    best = inside ? inner : best;
    xi = inside ? xi : edge_u;
    eta = inside ? eta : edge_v;
    footpoint_detail_KIND_inward(x, xi, eta, m);
    footpoint_detail_KIND_surface(x, xi, eta, u, v, d);
    at[0] = xi;
    at[1] = eta;
    at[2] = copysign(best, footpoint_detail_side(u, v, m, d, best, size, inside ? 0.0 : 1.0));
    k = last ? 2 : second;
    *region = (1 - inside) * (1 + k + 3 * (along <= -1.0) + (4 - 3 * last) * (along >= 1.0));
    return footpoint_detail_closest_status(flaw, all, footpoint_detail_dot(m, m), size, least, best,
                                           edge, longest);
}
