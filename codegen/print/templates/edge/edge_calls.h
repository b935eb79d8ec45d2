/* The functions for callers. */

FOOTPOINT_FN void NAME_at(NODE_PARAMETERS, REAL *xi)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    footpoint_detail_KIND_at(x, xi);
}

FOOTPOINT_FN int NAME(NODE_PARAMETERS, REAL *xi, REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL at, g;
    if (footpoint_detail_KIND_locate(x, PROMISE, &at, &g) >> REAL_TOP)
        return footpoint_detail_KIND_answer(x, PROMISE, at, xi, gap);
    *xi = at;
    *gap = g;
    return FOOTPOINT_OK;
}

FOOTPOINT_FN int NAME_from(NODE_PARAMETERS, REAL *xi, REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL at = *xi, g;
    if (footpoint_detail_KIND_follow(x, PROMISE, &at, &g) >> REAL_TOP)
        return NAME(NODE_NAMES, xi, gap);
    *xi = at;
    *gap = g;
    return FOOTPOINT_OK;
}

FOOTPOINT_FN int NAME_closest(NODE_PARAMETERS, REAL *xi, REAL *dist, int *region)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    return footpoint_detail_KIND_closest(x, PROMISE, xi, dist, region);
}

FOOTPOINT_FN int NAME_closest_of(size_t n, const REAL *const *x, const REAL xS[2], REAL *xi,
                                 REAL *dist, int *region, size_t *which)
{
    return footpoint_detail_KIND_closest_of(n, x, xS, PROMISE, xi, dist, region, which);
}

FOOTPOINT_LOOP void NAME_n(size_t n, const REAL *const x[COORDINATES], REAL *FOOTPOINT_RESTRICT xi)
{
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][2] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at;
        footpoint_detail_KIND_at(row, &at);
        xi[i] = at;
    }
}

FOOTPOINT_LOOP void NAME_checked_n(size_t n, const REAL *const x[COORDINATES],
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT gap,
                                   int *FOOTPOINT_RESTRICT status)
{
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][2] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at, g;
        status[i] = -(int)(footpoint_detail_KIND_locate(row, PROMISE, &at, &g) >> REAL_TOP);
        xi[i] = at;
        gap[i] = g;
    }
    for (i = 0; i < n; i++)
        if (status[i]) {
            const REAL p[VECTORS][2] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            status[i] = footpoint_detail_KIND_answer(row, PROMISE, xi[i], &xi[i], &gap[i]);
        }
}

FOOTPOINT_LOOP void NAME_over_n(const REAL *const nodes[NODES], size_t n, const REAL *const x[2],
                                REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT gap,
                                int *FOOTPOINT_RESTRICT status)
{
    REAL c[NODES][2];
    size_t i;
    int j;
    for (j = 0; j < NODES; j++) {
        c[j][0] = nodes[j][0];
        c[j][1] = nodes[j][1];
    }
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL s[2] = {x[0][i], x[1][i]};
        const REAL *const row[VECTORS] = {SEGMENT_ROWS, s};
        REAL at, g;
        status[i] = -(int)(footpoint_detail_KIND_locate(row, PROMISE, &at, &g) >> REAL_TOP);
        xi[i] = at;
        gap[i] = g;
    }
    for (i = 0; i < n; i++)
        if (status[i]) {
            const REAL s[2] = {x[0][i], x[1][i]};
            const REAL *const row[VECTORS] = {SEGMENT_ROWS, s};
            status[i] = footpoint_detail_KIND_answer(row, PROMISE, xi[i], &xi[i], &gap[i]);
        }
}

FOOTPOINT_LOOP void NAME_from_n(size_t n, const REAL *const x[COORDINATES],
                                REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT gap,
                                int *FOOTPOINT_RESTRICT status)
{
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][2] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at = xi[i], g;
        const int flaw = (int)(footpoint_detail_KIND_follow(row, PROMISE, &at, &g) >> REAL_TOP);
        status[i] = -flaw;
        xi[i] = flaw ? xi[i] : at;
        gap[i] = flaw ? gap[i] : g;
    }
    for (i = 0; i < n; i++)
        if (status[i]) {
            const REAL p[VECTORS][2] = {COLUMNS};
            status[i] = NAME(ROWS, &xi[i], &gap[i]);
        }
}

FOOTPOINT_LOOP void NAME_closest_n(size_t n, const REAL *const x[COORDINATES],
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT dist,
                                   int *FOOTPOINT_RESTRICT region, int *FOOTPOINT_RESTRICT status)
{
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][2] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at, d;
        int where;
        status[i] = -(int)(footpoint_detail_KIND_near(row, PROMISE, &at, &d, &where) >> REAL_TOP);
        xi[i] = at;
        dist[i] = d;
        region[i] = where;
    }
    for (i = 0; i < n; i++)
        if (status[i]) {
            const REAL p[VECTORS][2] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            status[i] = footpoint_detail_KIND_nearest(row, PROMISE, &xi[i], &dist[i], &region[i]);
        }
}
