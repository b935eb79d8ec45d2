/* The closest point of the closed bilinear segment. */

/* Finds the nearer of the search's point (xi,eta), if it is inside, and the nearest point of the edges, as at: see
 * footpoint_detail_nearest.  If rounding hides which is nearer, see footpoint_detail_leeway.  m, the product of the
 * diagonals, is 8 times the normal in the middle: normals are linear in xi and eta. */
FOOTPOINT_PART int footpoint_detail_quad4_nearest(const REAL *const *x, REAL_BITS flaw, REAL least,
                                                  REAL xi, REAL eta, REAL at[3], int *region)
{
    REAL e[4][3], p[4][3], ee[4], t[4], dd[4], d[3], f[3], g[3], m[3], mm, size, longest, other;
    REAL up, on, across, edge, sides, u, v, inner, room, within, best;
    int left, right, below, above, i;
    dd[0] = footpoint_detail_edge(x[0], x[1], x[4], e[0], p[0], &ee[0], &t[0]);
    dd[1] = footpoint_detail_edge(x[1], x[2], x[4], e[1], p[1], &ee[1], &t[1]);
    dd[2] = footpoint_detail_edge(x[3], x[2], x[4], e[2], p[2], &ee[2], &t[2]);
    dd[3] = footpoint_detail_edge(x[0], x[3], x[4], e[3], p[3], &ee[3], &t[3]);
    size = (ee[0] + ee[1]) + (ee[2] + ee[3]);
    longest = ee[0] > ee[1] ? ee[0] : ee[1];
    other = ee[2] > ee[3] ? ee[2] : ee[3];
    longest = longest > other ? longest : other;
    up = footpoint_detail_step(dd[0] - dd[2]);
    on = footpoint_detail_step(dd[3] - dd[1]);
    edge = dd[2] < dd[0] ? dd[2] : dd[0];
    sides = dd[1] < dd[3] ? dd[1] : dd[3];
    across = footpoint_detail_step(edge - sides);
    edge = sides < edge ? sides : edge;
    u = footpoint_detail_either(across, footpoint_detail_either(up, t[0], t[2]), on);
    v = footpoint_detail_either(across, up, footpoint_detail_either(on, t[3], t[1]));
    footpoint_detail_quad4_surface(x, xi, eta, f, g, d);
    inner = footpoint_detail_dot(d, d);
    room = 1.0 - fabs(xi);
    other = 1.0 - fabs(eta);
    room = other < room ? other : room;
    other = edge + footpoint_detail_leeway(f, g, d, inner, size) - inner;
    room = other < room ? other : room;
    within = footpoint_detail_step(room - REAL_MIN);
    xi = footpoint_detail_either(within, 2.0 * u - 1.0, xi);
    eta = footpoint_detail_either(within, 2.0 * v - 1.0, eta);
    best = footpoint_detail_either(within, edge, inner);
    footpoint_detail_from(x[0], x[2], f);
    footpoint_detail_from(x[1], x[3], g);
    footpoint_detail_cross(f, g, m);
    mm = footpoint_detail_dot(m, m);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        m[i] *= 0.125 * REAL_INWARD;
    footpoint_detail_quad4_surface(x, xi, eta, f, g, d);
    at[0] = xi;
    at[1] = eta;
    at[2] = copysign(best, footpoint_detail_side(f, g, m, d, best, size, 1.0 - within));
    left = xi <= -1.0;
    right = xi >= 1.0;
    below = eta <= -1.0;
    above = eta >= 1.0;
    *region = below + 3 * above + 4 * left + (left & above) + right * (2 + 3 * below + 2 * above);
    return footpoint_detail_closest_status(flaw | footpoint_detail_infinite(inner),
                                           p[0][0] + p[0][1] + p[0][2], mm, size, least, best, edge,
                                           longest);
}
