/* The side of a surface at a point of an edge or of a corner that faces share, by the sum of their unit normals there, each
 * times the angle of its face around the point (Baerentzen and Aanaes 2005).  Nodes with equal coordinates are the same
 * node. */

/* Returns the next corner, after k in the order `step`, 1 or CORNERS - 1, that is a different point from k; or k. */
FOOTPOINT_COLD int footpoint_detail_KIND_next(const REAL *const *x, int k, int step)
{
    int next = (k + step) % CORNERS;
    while (next != k && footpoint_detail_same(x[next], x[k]))
        next = (next + step) % CORNERS;
    return next;
}

/* Computes the direction e in which the edge to that corner leaves corner k. */
FOOTPOINT_COLD void footpoint_detail_KIND_leave(const REAL *const *x, int k, int step, REAL e[3])
{
    const int to = footpoint_detail_KIND_next(x, k, step), from = (to + CORNERS - step) % CORNERS;
    footpoint_detail_from(x[from], x[to], e);
    if (NODES > CORNERS) { /* e is half of the slope unless that vanishes: middles at a quarter */
        const REAL *const middle = x[CORNERS + (step == 1 ? from : to)];
        REAL slope[3];
        int i;
        for (i = 0; i < 3; i++)
            slope[i] = 4.0 * (middle[i] - x[from][i]) - e[i];
        if (footpoint_detail_dot(slope, slope) > REAL_FLAT * footpoint_detail_dot(e, e))
            for (i = 0; i < 3; i++)
                e[i] = slope[i];
    }
    if (VECTORS > NODES + 1) { /* edges of patches begin at right angles to the normal */
        const REAL *const n = x[NODES + from];
        const REAL along = footpoint_detail_dot(e, n);
        int i;
        for (i = 0; i < 3; i++)
            e[i] -= along * n[i];
    }
}

/* Adds `angle` times the unit normal at (xi,eta) to fan. */
FOOTPOINT_COLD void footpoint_detail_KIND_add_normal(const REAL *const *x, const REAL at[2],
                                                     REAL angle, REAL fan[3])
{
    REAL u[3], v[3], d[3], n[3], m[3], nn, mm, over;
    int i, large;
    footpoint_detail_KIND_surface(x, at[0], at[1], u, v, d);
    footpoint_detail_KIND_inward(x, at[0], at[1], m);
    footpoint_detail_cross(u, v, n);
    nn = footpoint_detail_dot(n, n);
    mm = footpoint_detail_dot(m, m);
    large = nn > REAL_INWARD * REAL_INWARD * mm;
    over = angle / sqrt((large ? nn : mm) + REAL_MIN);
    for (i = 0; i < 3; i++)
        fan[i] += over * (large ? n[i] : m[i]);
}

/* Adds the normal of a face at its corner k, or at t, from -1 to 1, of its edge k. */
FOOTPOINT_COLD void footpoint_detail_KIND_add_corner(const REAL *const *x, int k, REAL fan[3])
{
    REAL a[3], b[3], c[3], at[2], angle;
    footpoint_detail_KIND_leave(x, k, 1, a);
    footpoint_detail_KIND_leave(x, k, CORNERS - 1, b);
    footpoint_detail_cross(a, b, c);
    angle = atan2(sqrt(footpoint_detail_dot(c, c)), footpoint_detail_dot(a, b));
    footpoint_detail_SHAPE_corner(k, at);
    footpoint_detail_KIND_add_normal(x, at, angle, fan);
}

FOOTPOINT_COLD void footpoint_detail_KIND_add_edge(const REAL *const *x, int k, REAL t, REAL fan[3])
{
    REAL from[2], to[2], at[2];
    int i;
    footpoint_detail_SHAPE_corner(k, from);
    footpoint_detail_SHAPE_corner((k + 1) % CORNERS, to);
    for (i = 0; i < 2; i++)
        at[i] = 0.5 * ((1.0 - t) * from[i] + (1.0 + t) * to[i]);
    footpoint_detail_KIND_add_normal(x, at, 3.1415926535897931, fan);
}

/* Finds the corners a and b between which the closest point at loc, in `region` > 0 of a face, lies; they are equal at a corner or on
 * an edge of no length.  Returns its place on the edge, from -1 to 1. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_feature(const REAL *const *x, const REAL loc[2],
                                                  int region, const REAL *end[2])
{
    const int k = (region - 1) % CORNERS, next = (k + 1) % CORNERS;
    REAL from[2], to[2], along, across;
    footpoint_detail_SHAPE_corner(k, from);
    footpoint_detail_SHAPE_corner(next, to);
    along = (loc[0] - from[0]) * (to[0] - from[0]) + (loc[1] - from[1]) * (to[1] - from[1]);
    across = (to[0] - from[0]) * (to[0] - from[0]) + (to[1] - from[1]) * (to[1] - from[1]);
    end[0] = x[k];
    end[1] = region > CORNERS || footpoint_detail_same(x[k], x[next]) ? x[k] : x[next];
    return 2.0 * along / across - 1.0;
}

/* Adds the normal of a face, if it has that edge or corner. */
FOOTPOINT_COLD void footpoint_detail_KIND_add_face(const REAL *const *x, const REAL *const end[2],
                                                   REAL t, REAL fan[3])
{
    REAL y[10][3];
    const REAL *z[10];
    int exponent, k, i, found = 0;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    for (k = 0; k < CORNERS; k++) {
        const REAL *const here = x[k], *const next = x[(k + 1) % CORNERS];
        const int single = end[0] == end[1], first = footpoint_detail_same(here, end[0]);
        const int there = first & footpoint_detail_same(next, end[1]);
        const int back = footpoint_detail_same(here, end[1]) & footpoint_detail_same(next, end[0]);
        if (!(single ? first & !there : there | back)) /* of corners that coincide, the last */
            continue;
        if (!found && footpoint_detail_scale(x, NODES, VECTORS, y, &exponent) != FOOTPOINT_OK)
            return;
        found = 1;
        if (single)
            footpoint_detail_KIND_add_corner(z, k, fan);
        else
            footpoint_detail_KIND_add_edge(z, k, there ? t : -t, fan);
    }
}

/* Returns 1 if the slave node, the last of x, lies behind the point at loc: behind the surface that has the normal `fan` there, or,
 * if that is NULL, behind the face; `edge` is 1 if the point is on an edge of it. */
FOOTPOINT_COLD int footpoint_detail_KIND_behind(const REAL *const *x, const REAL loc[2], int edge,
                                                const REAL *fan)
{
    REAL y[10][3], u[3], v[3], d[3], m[3], dd;
    const REAL *z[10];
    int exponent, i;
    if (footpoint_detail_scale(x, NODES, VECTORS, y, &exponent) != FOOTPOINT_OK)
        return 0;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    footpoint_detail_KIND_surface(z, loc[0], loc[1], u, v, d);
    footpoint_detail_KIND_inward(z, loc[0], loc[1], m);
    dd = footpoint_detail_dot(d, d);
    return (fan ? footpoint_detail_facing(fan, d, dd, 1.0, 1.0, 1.0)
                : footpoint_detail_side(u, v, m, d, dd, 1.0, edge ? 1.0 : 0.0)) < 0.0;
}
