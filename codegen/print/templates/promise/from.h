/* Searches from the last answer, single and over arrays. */

/* The search without a last answer. */
typedef int footpoint_detail_KIND_name(NODE_PARAMETERS, REAL loc[2], REAL *gap);

/* Returns its highest bit set if (xi,eta) is more than half of the segment away from loc, or NaN. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_strayed(const REAL loc[2], REAL xi, REAL eta)
{
    return footpoint_detail_above(xi - loc[0], 1.0) | footpoint_detail_above(eta - loc[1], 1.0);
}

/* Continues from (xi,eta), to which an expansion about loc has led without a proof: two more expansions, then the
 * search without a last answer. */
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

/* Follows an element of arrays of last answers, from which loops over arrays have led to (u,v); not inlined, because it
 * is seldom called. */
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

/* Arrays are followed in parts: each part in a loop, which is repeated if many answers are not proved. */
enum { footpoint_detail_KIND_span = 64, footpoint_detail_KIND_few = 8 };

FOOTPOINT_PART void footpoint_detail_KIND_from_n(footpoint_detail_KIND_name *name, size_t n,
                                                 const REAL *const *x, REAL promise, REAL least,
                                                 REAL *FOOTPOINT_RESTRICT xi,
                                                 REAL *FOOTPOINT_RESTRICT eta,
                                                 REAL *FOOTPOINT_RESTRICT gap,
                                                 int *FOOTPOINT_RESTRICT status)
{
    REAL u[footpoint_detail_KIND_span], v[footpoint_detail_KIND_span];
    size_t first, i;
    for (first = 0; first < n; first += footpoint_detail_KIND_span) {
        const size_t m = n - first < (size_t)footpoint_detail_KIND_span
                             ? n - first
                             : (size_t)footpoint_detail_KIND_span;
        int open = 0;
        FOOTPOINT_EACH
        for (i = first; i < first + m; i++) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const row[VECTORS] = {ROWS};
            REAL a = xi[i], b = eta[i], g;
            const int doubt =
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
                const REAL p[VECTORS][3] = {COLUMNS};
                const REAL *const row[VECTORS] = {ROWS};
                const REAL last[2] = {xi[i], eta[i]};
                REAL a = u[i - first], b = v[i - first], g;
                const int good = status[i] == FOOTPOINT_OK;
                const REAL_BITS doubt =
                    footpoint_detail_KIND_from(row, promise, least, 1, &a, &b, &g) |
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
                const REAL p[VECTORS][3] = {COLUMNS};
                const REAL *const row[VECTORS] = {ROWS};
                footpoint_detail_KIND_follow_one(name, row, promise, least, u[i - first],
                                                 v[i - first], &xi[i], &eta[i], &gap[i],
                                                 &status[i]);
            }
    }
}

/* Does the same over one segment. */
FOOTPOINT_PART void
footpoint_detail_KIND_from_over_n(footpoint_detail_KIND_name *name, const REAL *const *segment,
                                  size_t n, const REAL *const *x, REAL promise, REAL least,
                                  REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                  REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    REAL c[SEGMENT_VECTORS][3], u[footpoint_detail_KIND_span], v[footpoint_detail_KIND_span];
    size_t first, i;
    int j, k;
    for (k = 0; k < SEGMENT_VECTORS; k++)
        for (j = 0; j < 3; j++)
            c[k][j] = segment[k][j];
    for (first = 0; first < n; first += footpoint_detail_KIND_span) {
        const size_t m = n - first < (size_t)footpoint_detail_KIND_span
                             ? n - first
                             : (size_t)footpoint_detail_KIND_span;
        int open = 0;
        FOOTPOINT_EACH
        for (i = first; i < first + m; i++) {
            const REAL slave[3] = {x[0][i], x[1][i], x[2][i]};
            const REAL *const row[VECTORS] = {SEGMENT_ROWS, slave};
            REAL a = xi[i], b = eta[i], g;
            const int doubt =
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
                const REAL slave[3] = {x[0][i], x[1][i], x[2][i]};
                const REAL *const row[VECTORS] = {SEGMENT_ROWS, slave};
                const REAL last[2] = {xi[i], eta[i]};
                REAL a = u[i - first], b = v[i - first], g;
                const int good = status[i] == FOOTPOINT_OK;
                const REAL_BITS doubt =
                    footpoint_detail_KIND_from(row, promise, least, 1, &a, &b, &g) |
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
                const REAL slave[3] = {x[0][i], x[1][i], x[2][i]};
                const REAL *const row[VECTORS] = {SEGMENT_ROWS, slave};
                footpoint_detail_KIND_follow_one(name, row, promise, least, u[i - first],
                                                 v[i - first], &xi[i], &eta[i], &gap[i],
                                                 &status[i]);
            }
    }
}
