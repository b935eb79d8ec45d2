/* The closest point of the closed quadrilateral with curved edges. */

/* Finds the nearer of the search's point (xi,eta), if it is inside, and the nearest point of the edges, as at: see
 * footpoint_detail_nearest.  If rounding hides which is nearer, see footpoint_detail_leeway. */
FOOTPOINT_PART int footpoint_detail_KIND_nearest(const REAL *const *x, REAL_BITS flaw, REAL least,
                                                 REAL xi, REAL eta, REAL at[3], int *region)
{
    REAL c[5][8], places[8], ee[4], t[4], dd[4], u[3], v[3], d[3], m[3], inner, all;
    REAL size, longest, other, best, edge, rest, edge_u, edge_v, far_u, far_v;
    int within, inside, left, right, below, above;
    flaw |= footpoint_detail_infinite(xi + eta);
    ee[0] = footpoint_detail_curve_begin(x[0], x[4], x[1], x[NODES], 0, 4, c, places);
    ee[1] = footpoint_detail_curve_begin(x[1], x[5], x[2], x[NODES], 1, 4, c, places);
    ee[2] = footpoint_detail_curve_begin(x[2], x[6], x[3], x[NODES], 2, 4, c, places);
    ee[3] = footpoint_detail_curve_begin(x[3], x[7], x[0], x[NODES], 3, 4, c, places);
    footpoint_detail_curve_steps(4, c, places);
    dd[0] = footpoint_detail_curve_end(x[0], x[4], x[1], x[NODES], 0, 4, places, &t[0]);
    dd[1] = footpoint_detail_curve_end(x[1], x[5], x[2], x[NODES], 1, 4, places, &t[1]);
    dd[2] = footpoint_detail_curve_end(x[2], x[6], x[3], x[NODES], 2, 4, places, &t[2]);
    dd[3] = footpoint_detail_curve_end(x[3], x[7], x[0], x[NODES], 3, 4, places, &t[3]);
    size = (ee[0] + ee[1]) + (ee[2] + ee[3]);
    longest = ee[0] > ee[1] ? ee[0] : ee[1];
    other = ee[2] > ee[3] ? ee[2] : ee[3];
    longest = longest > other ? longest : other;
    edge_u = dd[1] < dd[0] ? 1.0 : t[0];
    edge_v = dd[1] < dd[0] ? t[1] : -1.0;
    best = dd[1] < dd[0] ? dd[1] : dd[0];
    far_u = dd[3] < dd[2] ? -1.0 : -t[2];
    far_v = dd[3] < dd[2] ? -t[3] : 1.0;
    rest = dd[3] < dd[2] ? dd[3] : dd[2];
    edge_u = rest < best ? far_u : edge_u;
    edge_v = rest < best ? far_v : edge_v;
    best = rest < best ? rest : best;
    within = (fabs(xi) < 1.0) & (fabs(eta) < 1.0);
    xi = within ? xi : edge_u;
    eta = within ? eta : edge_v;
    footpoint_detail_KIND_surface(x, xi, eta, u, v, d);
    inner = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    inside = within & (inner <= best + footpoint_detail_leeway(u, v, d, inner, size));
    all = dd[0] + dd[1] + dd[2] + dd[3] + inner;
    edge = best;
    best = inside ? inner : best;
    xi = inside ? xi : edge_u;
    eta = inside ? eta : edge_v;
    footpoint_detail_KIND_inward(x, xi, eta, m);
    footpoint_detail_KIND_surface(x, xi, eta, u, v, d);
    at[0] = xi;
    at[1] = eta;
    at[2] = copysign(best, footpoint_detail_side(u, v, m, d, best, size, inside ? 0.0 : 1.0));
    left = xi <= -1.0;
    right = xi >= 1.0;
    below = eta <= -1.0;
    above = eta >= 1.0;
    *region = below + 3 * above + 4 * left + (left & above) + right * (2 + 3 * below + 2 * above);
    return footpoint_detail_closest_status(flaw, all, footpoint_detail_dot(m, m), size, least, best,
                                           edge, longest);
}
