/* The closest point of the closed bilinear segment. */

/* The nearer of the search's point (xi,eta), where it is inside, and the nearest point of the edges, as at: see
 * footpoint_detail_nearest.  A point inside is taken where rounding hides which is nearer.  n, the product of
 * the diagonals, is at right angles to both, so that the height of r over A is warp times a function of xi and eta. */
FOOTPOINT_PART int footpoint_detail_quad4_nearest(const REAL *const *x, REAL_BITS flaw, REAL least,
                                                  REAL xi, REAL eta, REAL at[4], int *region)
{
    REAL e[4][3], p[4][3], ee[4], t[4], dd[4], n[3], f[3], g[3], all = 0.0;
    REAL size, longest, other, best, rest, u, v, edge_u, edge_v, far_u, far_v, nn,
        inner = 0.0, side = 0.0, warp = 0.0;
    int i, inside, left, right, below, above;
    flaw |= footpoint_detail_infinite(xi + eta);
    dd[0] = footpoint_detail_edge(x[0], x[1], x[4], e[0], p[0], &ee[0], &t[0]);
    dd[1] = footpoint_detail_edge(x[1], x[2], x[4], e[1], p[1], &ee[1], &t[1]);
    dd[2] = footpoint_detail_edge(x[2], x[3], x[4], e[2], p[2], &ee[2], &t[2]);
    dd[3] = footpoint_detail_edge(x[3], x[0], x[4], e[3], p[3], &ee[3], &t[3]);
    size = (ee[0] + ee[1]) + (ee[2] + ee[3]);
    longest = ee[0] > ee[1] ? ee[0] : ee[1];
    other = ee[2] > ee[3] ? ee[2] : ee[3];
    longest = longest > other ? longest : other;
    u = 2.0 * t[0] - 1.0;
    v = 2.0 * t[1] - 1.0;
    edge_u = dd[1] < dd[0] ? 1.0 : u;
    edge_v = dd[1] < dd[0] ? v : -1.0;
    best = dd[1] < dd[0] ? dd[1] : dd[0];
    u = 1.0 - 2.0 * t[2];
    v = 1.0 - 2.0 * t[3];
    far_u = dd[3] < dd[2] ? -1.0 : u;
    far_v = dd[3] < dd[2] ? v : 1.0;
    rest = dd[3] < dd[2] ? dd[3] : dd[2];
    edge_u = rest < best ? far_u : edge_u;
    edge_v = rest < best ? far_v : edge_v;
    best = rest < best ? rest : best;
    u = 0.5 * (1.0 + xi);
    v = 0.5 * (1.0 + eta);
    for (i = 0; i < 3; i++) {
        const REAL d = p[0][i] - u * e[0][i] + v * (e[3][i] + u * (e[0][i] + e[2][i]));
        inner += d * d;
        f[i] = e[0][i] + e[1][i];
        g[i] = e[1][i] + e[2][i];
        all += p[0][i];
    }
    inside = (fabs(xi) < 1.0) & (fabs(eta) < 1.0) & (inner <= best + REAL_MARGIN * (best + size));
    best = inside ? inner : best;
    xi = inside ? xi : edge_u;
    eta = inside ? eta : edge_v;
    u = 0.5 * (1.0 + xi);
    v = 0.5 * (1.0 + eta);
    n[0] = f[1] * g[2] - f[2] * g[1];
    n[1] = f[2] * g[0] - f[0] * g[2];
    n[2] = f[0] * g[1] - f[1] * g[0];
    for (i = 0; i < 3; i++) {
        side += n[i] * p[0][i];
        warp += n[i] * e[0][i];
    }
    side -= warp * (u + v - 2.0 * u * v);
    at[0] = xi;
    at[1] = eta;
    nn = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    at[2] = side < 0.0 ? -best : best;
    at[3] = side * side / (nn * best + REAL_MIN);
    left = xi <= -1.0;
    right = xi >= 1.0;
    below = eta <= -1.0;
    above = eta >= 1.0;
    *region = below + 3 * above + 4 * left + (left & above) + right * (2 + 3 * below + 2 * above);
    return footpoint_detail_closest_status(flaw, all, nn, size, least, best, longest);
}
