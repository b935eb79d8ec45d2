/* The closest point of the closed triangle. */

/* Finds the foot point, if it is inside, or the nearest point of the edges, as at: see footpoint_detail_nearest.  The
 * foot point is computed from areas, because the rounding errors of a search's Gram determinant grow with the square of
 * the aspect ratio.  The distance of a point inside is measured to the plane, for any errors of xi and eta.  how: 1 if
 * the nearest edge is BC, 1 if it is CA, otherwise 0; the place of its nearest point, from 0 to 1; 1 if the foot point
 * is inside. */
FOOTPOINT_PART int footpoint_detail_tri3_find(const REAL *const *x, REAL least, REAL at[3],
                                              REAL how[4], int *region)
{
    REAL e[3][3], p[3][3], ee[3], t[3], dd[3], d[3], n[3], f[3], nn, size, longest, other;
    REAL second, third, edge, along, u, v, xi, eta, ahead, room, within, best;
    int last, k;
    dd[0] = footpoint_detail_edge(x[0], x[1], x[3], e[0], p[0], &ee[0], &t[0]);
    dd[1] = footpoint_detail_edge(x[1], x[2], x[3], e[1], p[1], &ee[1], &t[1]);
    dd[2] = footpoint_detail_edge(x[2], x[0], x[3], e[2], p[2], &ee[2], &t[2]);
    size = ee[0] + ee[1] + ee[2];
    longest = ee[0] > ee[1] ? ee[0] : ee[1];
    longest = longest > ee[2] ? longest : ee[2];
    second = footpoint_detail_step(dd[0] - dd[1]);
    edge = dd[1] < dd[0] ? dd[1] : dd[0];
    third = footpoint_detail_step(edge - dd[2]);
    edge = dd[2] < edge ? dd[2] : edge;
    along = footpoint_detail_either(third, footpoint_detail_either(second, t[0], t[1]), t[2]);
    u = (1.0 - third) * footpoint_detail_either(second, t[0], 1.0 - t[1]);
    v = footpoint_detail_either(third, second * t[1], 1.0 - t[2]);
    footpoint_detail_cross(e[2], e[0], n);
    nn = footpoint_detail_dot(n, n) + REAL_MIN;
    footpoint_detail_cross(e[2], p[0], f);
    xi = footpoint_detail_dot(f, n) / nn;
    footpoint_detail_cross(e[0], p[0], f);
    eta = footpoint_detail_dot(f, n) / nn;
    room = xi < eta ? xi : eta;
    other = 1.0 - (xi + eta);
    room = other < room ? other : room;
    within = footpoint_detail_step(room - REAL_MIN);
    at[0] = footpoint_detail_either(within, u, xi);
    at[1] = footpoint_detail_either(within, v, eta);
    d[0] = p[0][0] - at[0] * e[0][0] + at[1] * e[2][0];
    d[1] = p[0][1] - at[0] * e[0][1] + at[1] * e[2][1];
    d[2] = p[0][2] - at[0] * e[0][2] + at[1] * e[2][2];
    ahead = footpoint_detail_dot(n, d);
    ahead *= ahead / nn;
    best = footpoint_detail_either(within, edge, ahead);
    at[2] = copysign(best, footpoint_detail_facing(n, d, best, size, ee[0] * ee[2], 1.0 - within));
    last = third > 0.5;
    k = (second > 0.5) * (1 - last) + 2 * last;
    *region = (within < 0.5) * (1 + k + 3 * (along <= 0.0) + (4 - 3 * last) * (along >= 1.0));
    how[0] = second * (1.0 - third);
    how[1] = third;
    how[2] = along;
    how[3] = within;
    return footpoint_detail_closest_status(footpoint_detail_infinite(ahead),
                                           p[0][0] + p[0][1] + p[0][2], nn, size, least, best, edge,
                                           longest);
}
