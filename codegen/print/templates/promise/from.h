/* Searches from the last answer, single and over arrays. */

/* Searches without a last answer. */
typedef int footpoint_detail_KIND_name(NODE_PARAMETERS, REAL loc[2], REAL *gap);

/* Returns its highest bit set if (xi,eta) is more than half of the segment away from loc, or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_strayed(const REAL loc[2], REAL xi, REAL eta)
{
    return footpoint_detail_above(xi - loc[0], 1.0) | footpoint_detail_above(eta - loc[1], 1.0);
}

/* Continues from (xi,eta), the unproved end of an expansion about loc: takes two more expansions, then searches without
 * a last answer. */
FOOTPOINT_PART int footpoint_detail_KIND_further(footpoint_detail_KIND_name *name,
                                                 const REAL *const *x, REAL promise, REAL least,
                                                 REAL xi, REAL eta, REAL loc[2], REAL *gap)
{
    REAL g;
    int k;
    for (k = 0; k < 2 && !(footpoint_detail_KIND_strayed(loc, xi, eta) >> REAL_TOP); k++) {
        const REAL_BITS doubt = footpoint_detail_KIND_from(x, promise, least, 2, &xi, &eta, &g);
        if (!((doubt | footpoint_detail_KIND_strayed(loc, xi, eta)) >> REAL_TOP)) {
            loc[0] = xi;
            loc[1] = eta;
            *gap = g;
            return FOOTPOINT_OK;
        }
    }
    return name(VECTOR_ROWS, loc, gap);
}

/* Follows an element of arrays of last answers, which a loop has moved to (u,v). It is seldom called, and so not
 * inlined. */
FOOTPOINT_COLD void footpoint_detail_KIND_follow_one(footpoint_detail_KIND_name *name,
                                                     const REAL *const *x, REAL promise, REAL least,
                                                     REAL u, REAL v, REAL *xi, REAL *eta, REAL *gap,
                                                     int *status)
{
    REAL loc[2];
    loc[0] = *xi;
    loc[1] = *eta;
    *status = footpoint_detail_KIND_further(name, x, promise, least, u, v, loc, gap);
    *xi = loc[0];
    *eta = loc[1];
}

/* Follows arrays in parts, each in a loop that is repeated if many answers are not proved. */
enum { footpoint_detail_KIND_span = 64, footpoint_detail_KIND_few = 8 };

/* Copies the vectors of pair i from the columns x. With `over`, x has the slave nodes' columns and c is the segment. */
FOOTPOINT_PART void footpoint_detail_KIND_pair(REAL (*c)[3], int over, const REAL *const *x,
                                               size_t i, REAL p[VECTORS][3])
{
    int k, j;
    FOOTPOINT_UNROLL
    for (k = 0; k < VECTORS; k++) {
        FOOTPOINT_UNROLL
        for (j = 0; j < 3; j++)
            p[k][j] = !over ? x[3 * k + j][i] : k < SEGMENT_VECTORS ? c[k][j] : x[j][i];
    }
}

/* Searches n pairs or, with `over`, n slave nodes over a segment, which is copied so that no result can change it. */
FOOTPOINT_PART void
footpoint_detail_KIND_from_n(footpoint_detail_KIND_name *name, int over, const REAL *const *segment,
                             size_t n, const REAL *const *x, REAL promise, REAL least,
                             REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                             REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    REAL c[SEGMENT_VECTORS][3], u[footpoint_detail_KIND_span], v[footpoint_detail_KIND_span];
    size_t first, i;
    int j, k;
    for (k = 0; k < SEGMENT_VECTORS; k++)
        for (j = 0; j < 3; j++)
            c[k][j] = over ? segment[k][j] : 0.0;
    for (first = 0; first < n; first += footpoint_detail_KIND_span) {
        const size_t m = n - first < (size_t)footpoint_detail_KIND_span
                             ? n - first
                             : (size_t)footpoint_detail_KIND_span;
        int open = 0;
        FOOTPOINT_EACH
        for (i = first; i < first + m; i++) {
            REAL p[VECTORS][3], a = xi[i], b = eta[i], g;
            const REAL *const row[VECTORS] = {ROWS};
            int doubt;
            footpoint_detail_KIND_pair(c, over, x, i, p);
            doubt =
                (int)(footpoint_detail_KIND_from(row, promise, least, 1, &a, &b, &g) >> REAL_TOP);
            u[i - first] = a;
            v[i - first] = b;
            gap[i] = g;
            status[i] = FOOTPOINT_UNPROVED * doubt;
            open += doubt;
        }
        if (open > footpoint_detail_KIND_few) {
            FOOTPOINT_EACH
            for (i = first; i < first + m; i++) {
                REAL p[VECTORS][3], a = u[i - first], b = v[i - first], g;
                const REAL *const row[VECTORS] = {ROWS};
                const REAL last[2] = {xi[i], eta[i]};
                const int good = status[i] == FOOTPOINT_OK;
                REAL_BITS doubt;
                footpoint_detail_KIND_pair(c, over, x, i, p);
                doubt = footpoint_detail_KIND_from(row, promise, least, 1, &a, &b, &g) |
                        footpoint_detail_KIND_strayed(last, a, b);
                u[i - first] = good ? u[i - first] : a;
                v[i - first] = good ? v[i - first] : b;
                gap[i] = good ? gap[i] : g;
                status[i] = good ? FOOTPOINT_OK : FOOTPOINT_UNPROVED * (int)(doubt >> REAL_TOP);
            }
        }
        for (i = first; i < first + m; i++)
            if (status[i] == FOOTPOINT_OK) {
                xi[i] = u[i - first];
                eta[i] = v[i - first];
            } else {
                REAL p[VECTORS][3];
                const REAL *const row[VECTORS] = {ROWS};
                footpoint_detail_KIND_pair(c, over, x, i, p);
                footpoint_detail_KIND_follow_one(name, row, promise, least, u[i - first],
                                                 v[i - first], &xi[i], &eta[i], &gap[i],
                                                 &status[i]);
            }
    }
}
