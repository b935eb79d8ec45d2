/* Pairs of faces and slave nodes side by side: the loop over blocks of pairs. */

/* Copies columns into a block from the first on, and repeats the last of `count` pairs to fill it. */
FOOTPOINT_PART void footpoint_detail_KIND_side_fill(BLOCK *t, int first, const double **x,
                                                    int count)
{
    int k, l;
    for (k = first; k < COORDINATES; k++) {
        for (l = 0; l < count; l++)
            t->x[k][l] = x[k][l];
        for (; l < t->lanes; l++)
            t->x[k][l] = x[k][count - 1];
        x[k] = t->x[k];
    }
}

/* Copies a segment's nodes into columns of a block. */
FOOTPOINT_PART void footpoint_detail_KIND_side_share(const double *const *segment, BLOCK *t)
{
    int k, l;
    for (k = 0; k < COORDINATES - 3; k++) {
        const double shared = segment[k / 3][k % 3];
        for (l = 0; l < t->lanes; l++)
            t->x[k][l] = shared;
    }
}

/* Stores answers. Returns an upper bound on the number of unproved answers. */
FOOTPOINT_PART int footpoint_detail_KIND_side_store(const BLOCK *t, int count,
                                                    double *FOOTPOINT_RESTRICT xi,
                                                    double *FOOTPOINT_RESTRICT eta,
                                                    double *FOOTPOINT_RESTRICT gap,
                                                    int *FOOTPOINT_RESTRICT status)
{
    unsigned long long infinite = 0;
    LANE_BITS unproved = 0;
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < count; l++) {
        xi[l] = t->xi[l];
        eta[l] = t->eta[l];
        gap[l] = t->gap[l];
        infinite |= footpoint_detail_infinite(t->gap[l]);
    }
    FOOTPOINT_EACH
    for (l = 0; l < count; l++) {
        status[l] = FOOTPOINT_OK;
        unproved += (t->doubt[l] | t->wide[l]) >> LANE_TOP;
    }
    return (int)unproved + (int)(infinite >> 63);
}

/* Returns 0 if an answer is proved. */
FOOTPOINT_PART int footpoint_detail_KIND_side_fails(const BLOCK *t, int l)
{
    return (t->doubt[l] | t->wide[l]) >> LANE_TOP || footpoint_detail_infinite(t->gap[l]) >> 63;
}

/* What to search: `search` from scratch or, unless `name` is NULL, from the last answers, which are in xi and eta, and with
 * NAME; slave nodes over `segment` or, if that is NULL, pairs. */
typedef struct {
    footpoint_detail_search *search;
    footpoint_detail_KIND_name *name;
    const double *const *segment;
    double promise, least;
    int nodes;
} footpoint_detail_KIND_side_call;

/* Takes steps and proves the last, near the last answers if these begin the search. */
FOOTPOINT_PART void footpoint_detail_KIND_side_search(const footpoint_detail_KIND_side_call *call,
                                                      BLOCK *t, int more)
{
    footpoint_detail_KIND_side_steps(t, call->promise, call->name != NULL, more);
    if (call->name)
        footpoint_detail_KIND_side_astray(t);
}

/* Takes more steps. Stores answers of `failed` pairs that these prove, which then no longer count as failed. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_again(const footpoint_detail_KIND_side_call *call,
                                                     BLOCK *t, int *failed, int count, double *xi,
                                                     double *eta, double *gap)
{
    int l;
    footpoint_detail_KIND_side_search(call, t, 1);
    for (l = 0; l < count; l++)
        if (failed[l] && !footpoint_detail_KIND_side_fails(t, l)) {
            xi[l] = t->xi[l];
            eta[l] = t->eta[l];
            gap[l] = t->gap[l];
            failed[l] = 0;
        }
}

/* Searches one pair from scratch. */
FOOTPOINT_PART void footpoint_detail_KIND_side_one(footpoint_detail_search *search, int nodes,
                                                   const double *const *row, double promise,
                                                   double *xi, double *eta, double *gap,
                                                   int *status)
{
    double u, v, g;
    if (search(row, 2, 0.0, &u, &v, &g) >> 63)
        footpoint_detail_KIND_full(search, row, nodes, promise, xi, eta, gap, status);
    else {
        *xi = u;
        *eta = v;
        *gap = g;
        *status = FOOTPOINT_OK;
    }
}

/* Searches `failed` pairs one by one, from where steps have ended if there are last answers. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_mend(const footpoint_detail_KIND_side_call *call,
                                                    const BLOCK *t, const int *failed,
                                                    const double *const *x, int count, double *xi,
                                                    double *eta, double *gap, int *status)
{
    int i;
    for (i = 0; i < count; i++)
        if (failed[i]) {
            const double p[VECTORS][3] = {COLUMNS};
            const double *const row[VECTORS] = {ROWS};
            if (call->name) {
                double loc[2];
                loc[0] = t->last[0][i];
                loc[1] = t->last[1][i];
                status[i] = footpoint_detail_KIND_further(
                    call->name, row, call->promise, call->least, t->xi[i], t->eta[i], loc, &gap[i]);
                xi[i] = loc[0];
                eta[i] = loc[1];
            } else
                footpoint_detail_KIND_side_one(call->search, call->nodes, row, call->promise,
                                               &xi[i], &eta[i], &gap[i], &status[i]);
        }
}

/* Repairs unproved answers. If many failed, it first takes more steps, unless rounding forbids most proofs. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_repair(const footpoint_detail_KIND_side_call *call,
                                                      BLOCK *t, int unproved,
                                                      const double *const *x, int count, double *xi,
                                                      double *eta, double *gap, int *status)
{
    int failed[SIDE], l;
    for (l = 0; l < count; l++)
        failed[l] = unproved > count || footpoint_detail_KIND_side_fails(t, l);
    if (unproved > 3 && unproved <= count && call->promise > 0.99e-9)
        footpoint_detail_KIND_side_again(call, t, failed, count, xi, eta, gap);
    footpoint_detail_KIND_side_mend(call, t, failed, x, count, xi, eta, gap, status);
}

/* Pairs are quicker side by side, from this number on. */
enum { footpoint_detail_KIND_side_few = 3 };

/* Searches n pairs, or slave nodes over a segment, of columns x. A few are searched one by one. */
FOOTPOINT_APART void footpoint_detail_KIND_side_run(const footpoint_detail_KIND_side_call *call,
                                                    size_t n, const double *const *x, double *xi,
                                                    double *eta, double *gap, int *status)
{
    const int own = call->segment ? COORDINATES - 3 : 0; /* columns that are not of x */
    const double *column[COORDINATES];
    BLOCK t;
    size_t i;
    int count, k;
    t.lanes = n > 16 ? SIDE : 8;
    if (call->segment)
        footpoint_detail_KIND_side_share(call->segment, &t);
    for (k = 0; k < own; k++)
        column[k] = t.x[k];
    for (i = 0; i < n; i += (size_t)count) {
        double *const u = xi + i, *const v = eta + i, *const g = gap + i;
        int unproved = SIDE + 1; /* none has been searched */
        t.lanes = n - i > 16 ? SIDE : 8;
        count = n - i < (size_t)t.lanes ? (int)(n - i) : t.lanes;
        for (k = own; k < COORDINATES; k++)
            column[k] = x[k - own] + i;
        if (call->name)
            footpoint_detail_KIND_side_keep(&t, count, u, v);
        if (count >= footpoint_detail_KIND_side_few) {
            if (count < t.lanes)
                footpoint_detail_KIND_side_fill(&t, own, column, count);
            footpoint_detail_KIND_side_narrow(column, &t);
            footpoint_detail_KIND_side_search(call, &t, 0);
            unproved = count == SIDE
                           ? footpoint_detail_KIND_side_store(&t, SIDE, u, v, g, status + i)
                           : footpoint_detail_KIND_side_store(&t, count, u, v, g, status + i);
        }
        if (unproved)
            footpoint_detail_KIND_side_repair(call, &t, unproved, column, count, u, v, g,
                                              status + i);
    }
}

/* Searches from scratch. */
FOOTPOINT_PART void footpoint_detail_KIND_side_scratch(footpoint_detail_search *search,
                                                       const double *const *segment, size_t n,
                                                       const double *const *x, int nodes,
                                                       double promise, double *xi, double *eta,
                                                       double *gap, int *status)
{
    footpoint_detail_KIND_side_call call;
    call.search = search;
    call.name = NULL;
    call.segment = segment;
    call.promise = promise;
    call.least = 0.0;
    call.nodes = nodes;
    footpoint_detail_KIND_side_run(&call, n, x, xi, eta, gap, status);
}

FOOTPOINT_PART void footpoint_detail_KIND_checked_n(footpoint_detail_search *search, size_t n,
                                                    const double *const *x, int nodes,
                                                    double promise, double *xi, double *eta,
                                                    double *gap, int *status)
{
    footpoint_detail_KIND_side_scratch(search, NULL, n, x, nodes, promise, xi, eta, gap, status);
}

/* Searches slave nodes x over a segment. Its nodes are copied, so that no result changes them. */
FOOTPOINT_PART void footpoint_detail_KIND_over_n(footpoint_detail_search *search,
                                                 const double *const *segment, size_t n,
                                                 const double *const *x, int nodes, double promise,
                                                 double *xi, double *eta, double *gap, int *status)
{
    double c[SEGMENT_VECTORS][3];
    size_t i;
    int j, k;
    if (n >= footpoint_detail_KIND_side_few) {
        footpoint_detail_KIND_side_scratch(search, segment, n, x, nodes, promise, xi, eta, gap,
                                           status);
        return;
    }
    for (k = 0; k < SEGMENT_VECTORS; k++)
        for (j = 0; j < 3; j++)
            c[k][j] = segment[k][j];
    for (i = 0; i < n; i++) {
        const double s[3] = {x[0][i], x[1][i], x[2][i]};
        const double *const row[VECTORS] = {SEGMENT_ROWS, s};
        footpoint_detail_KIND_side_one(search, nodes, row, promise, &xi[i], &eta[i], &gap[i],
                                       &status[i]);
    }
}

/* Searches one pair from the last answer, which is in xi and eta, by NAME_from. */
FOOTPOINT_PART void footpoint_detail_KIND_side_follow(footpoint_detail_KIND_name *from,
                                                      const double *const *x, double *xi,
                                                      double *eta, double *gap, int *status)
{
    double loc[2];
    loc[0] = *xi;
    loc[1] = *eta;
    *status = from(VECTOR_ROWS, loc, gap);
    *xi = loc[0];
    *eta = loc[1];
}

/* Searches from the last answers pairs or, unless `segment` is NULL, slave nodes over it, which is copied. */
FOOTPOINT_PART void footpoint_detail_KIND_from_n(footpoint_detail_KIND_name *name,
                                                 footpoint_detail_KIND_name *from,
                                                 const double *const *segment, size_t n,
                                                 const double *const *x, double promise,
                                                 double least, double *xi, double *eta, double *gap,
                                                 int *status)
{
    double c[SEGMENT_VECTORS][3];
    size_t i;
    int j, k;
    if (n >= footpoint_detail_KIND_side_few) {
        footpoint_detail_KIND_side_call call;
        call.search = NULL;
        call.name = name;
        call.segment = segment;
        call.promise = promise;
        call.least = least;
        call.nodes = 0;
        footpoint_detail_KIND_side_run(&call, n, x, xi, eta, gap, status);
        return;
    }
    for (k = 0; k < SEGMENT_VECTORS; k++)
        for (j = 0; j < 3; j++)
            c[k][j] = segment ? segment[k][j] : 0.0;
    for (i = 0; i < n; i++) {
        double p[VECTORS][3];
        const double *const row[VECTORS] = {ROWS};
        for (k = 0; k < VECTORS; k++)
            for (j = 0; j < 3; j++)
                p[k][j] = !segment ? x[3 * k + j][i] : k < SEGMENT_VECTORS ? c[k][j] : x[j][i];
        footpoint_detail_KIND_side_follow(from, row, &xi[i], &eta[i], &gap[i], &status[i]);
    }
}
