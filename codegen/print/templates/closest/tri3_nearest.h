/* The closest point of the closed triangle. */

/* The nearer of the search's point (xi,eta), where it is inside, and the nearest point of the edges, as at: see
 * footpoint_detail_nearest.  A point inside is taken where rounding hides which is nearer. */
FOOTPOINT_PART int footpoint_detail_tri3_nearest(const REAL *const *x, REAL_BITS flaw, REAL least,
                                                 REAL xi, REAL eta, REAL at[4], int *region)
{
    REAL e[3][3], p[3][3], ee[4], t[4], dd[4], n[3], all = 0.0;
    REAL size, longest, best, u, v, along, other, nn, inner = 0.0, side = 0.0;
    int i, k, last, inside;
    flaw |= footpoint_detail_infinite(xi + eta);
    dd[0] = footpoint_detail_edge(x[0], x[1], x[3], e[0], p[0], &ee[0], &t[0]);
    dd[1] = footpoint_detail_edge(x[1], x[2], x[3], e[1], p[1], &ee[1], &t[1]);
    dd[2] = footpoint_detail_edge(x[2], x[0], x[3], e[2], p[2], &ee[2], &t[2]);
    size = ee[0] + ee[1] + ee[2];
    longest = ee[0] > ee[1] ? ee[0] : ee[1];
    longest = longest > ee[2] ? longest : ee[2];
    u = 1.0 - t[1];
    v = 1.0 - t[2];
    k = dd[1] < dd[0];
    u = dd[1] < dd[0] ? u : t[0];
    along = dd[1] < dd[0] ? t[1] : t[0];
    best = dd[1] < dd[0] ? dd[1] : dd[0];
    last = dd[2] < best;
    other = dd[1] < dd[0] ? t[1] : 0.0;
    v = dd[2] < best ? v : other;
    u = dd[2] < best ? 0.0 : u;
    along = dd[2] < best ? t[2] : along;
    best = dd[2] < best ? dd[2] : best;
    for (i = 0; i < 3; i++) {
        const REAL d = p[0][i] - xi * e[0][i] + eta * e[2][i];
        inner += d * d;
        all += p[0][i];
    }
    n[0] = e[0][2] * e[2][1] - e[0][1] * e[2][2];
    n[1] = e[0][0] * e[2][2] - e[0][2] * e[2][0];
    n[2] = e[0][1] * e[2][0] - e[0][0] * e[2][1];
    for (i = 0; i < 3; i++)
        side += n[i] * p[0][i];
    inside =
        (xi > 0.0) & (eta > 0.0) & (xi + eta < 1.0) & (inner <= best + REAL_MARGIN * (best + size));
    best = inside ? inner : best;
    at[0] = inside ? xi : u;
    at[1] = inside ? eta : v;
    nn = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    at[2] = side < 0.0 ? -best : best;
    at[3] = side * side / (nn * best + REAL_MIN);
    k += last * (2 - k);
    *region = (1 - inside) * (1 + k + 3 * (along <= 0.0) + (4 - 3 * last) * (along >= 1.0));
    return footpoint_detail_closest_status(flaw, all, nn, size, least, best, longest);
}
