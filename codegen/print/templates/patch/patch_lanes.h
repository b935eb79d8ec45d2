/* Patches in loops over arrays: steps, their proof, and repair of unproved answers. */

/* Holds the patches' data, indexed by number of the value. */
enum { footpoint_detail_KIND_count = (sizeof(footpoint_detail_KIND_terms) / sizeof(REAL) + 2) / 3 };
typedef struct {
    REAL v[footpoint_detail_KIND_count][3][FOOTPOINT_LANES];
} footpoint_detail_KIND_lanes;
typedef union {
    footpoint_detail_KIND_terms of;
    REAL v[footpoint_detail_KIND_count][3];
} footpoint_detail_KIND_one;

FOOTPOINT_PART void
footpoint_detail_KIND_shapes_of(const BLOCK *FOOTPOINT_RESTRICT b,
                                footpoint_detail_KIND_lanes *FOOTPOINT_RESTRICT t, int lanes)
{
    int l, k, i;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        footpoint_detail_KIND_one one;
        footpoint_detail_NET_bent bent[4];
        REAL n[4][3];
        const REAL *const normal[4] = {n[0], n[1], n[2], n[3]};
        FOOTPOINT_WHOLE
        for (k = 0; k < 4; k++) {
            FOOTPOINT_WHOLE
            for (i = 0; i < 3; i++) {
                bent[k].edge[i] = b->edge[k][i][l];
                n[k][i] = b->normal[k][i][l];
            }
        }
        FOOTPOINT_WHOLE
        for (i = 0; i < 3; i++) /* copied, but not computed here */
            one.of.net.d[i] = one.v[footpoint_detail_KIND_count - 1][i] = 0.0;
        footpoint_detail_KIND_shape(normal, bent, &one.of);
        FOOTPOINT_WHOLE
        for (k = 0; k < footpoint_detail_KIND_count; k++) {
            FOOTPOINT_WHOLE
            for (i = 0; i < 3; i++)
                t->v[k][i][l] = one.v[k][i];
        }
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_shapes(const BLOCK *FOOTPOINT_RESTRICT b,
                                                  footpoint_detail_KIND_lanes *FOOTPOINT_RESTRICT t)
{
    if (b->lanes == 8)
        footpoint_detail_KIND_shapes_of(b, t, 8);
    else
        footpoint_detail_KIND_shapes_of(b, t, FOOTPOINT_LANES);
}

/* Copies the patch of a lane, with xS of another. */
FOOTPOINT_PART void footpoint_detail_KIND_take(const BLOCK *b, const footpoint_detail_KIND_lanes *t,
                                               int l, footpoint_detail_KIND_one *one)
{
    int k, i;
    FOOTPOINT_WHOLE
    for (k = 0; k < footpoint_detail_KIND_count; k++) {
        FOOTPOINT_WHOLE
        for (i = 0; i < 3; i++)
            one->v[k][i] = t->v[k][i][l];
    }
    FOOTPOINT_WHOLE
    for (i = 0; i < 3; i++)
        one->of.net.d[i] = b->d[i][l];
}

FOOTPOINT_PART void
footpoint_detail_KIND_bares_of(BLOCK *FOOTPOINT_RESTRICT b,
                               const footpoint_detail_KIND_lanes *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        footpoint_detail_KIND_one one;
        footpoint_detail_KIND_take(b, t, l, &one);
        footpoint_detail_KIND_bare(&one.of, &b->p[l], &b->q[l]);
    }
}

FOOTPOINT_APART void
footpoint_detail_KIND_bares(BLOCK *FOOTPOINT_RESTRICT b,
                            const footpoint_detail_KIND_lanes *FOOTPOINT_RESTRICT t)
{
    if (b->lanes == 8)
        footpoint_detail_KIND_bares_of(b, t, 8);
    else
        footpoint_detail_KIND_bares_of(b, t, FOOTPOINT_LANES);
}

FOOTPOINT_PART void
footpoint_detail_KIND_proofs_of(BLOCK *FOOTPOINT_RESTRICT b,
                                const footpoint_detail_KIND_lanes *FOOTPOINT_RESTRICT t,
                                REAL promise, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        const REAL p = b->p[l], q = b->q[l], size = b->size[l];
        footpoint_detail_KIND_one one;
        footpoint_detail_local r;
        REAL_BITS doubt = footpoint_detail_bits(size - 1.0) | footpoint_detail_infinite(size);
        REAL xi = p, eta = q, gap;
        footpoint_detail_KIND_take(b, t, l, &one);
        footpoint_detail_KIND_local(&one.of, p, q, &r);
        doubt |= footpoint_detail_KIND_lane(&one.of, &r, promise, &xi, &eta);
        footpoint_detail_NET_follow(xi - p, eta - q, &r);
        doubt |= footpoint_detail_KIND_rise(&r, &gap);
        b->p[l] = xi;
        b->q[l] = eta;
        b->gap[l] = gap;
        b->doubt[l] = doubt;
    }
}

FOOTPOINT_APART void
footpoint_detail_KIND_proofs(BLOCK *FOOTPOINT_RESTRICT b,
                             const footpoint_detail_KIND_lanes *FOOTPOINT_RESTRICT t, REAL promise)
{
    if (b->lanes == 8)
        footpoint_detail_KIND_proofs_of(b, t, promise, 8);
    else
        footpoint_detail_KIND_proofs_of(b, t, promise, FOOTPOINT_LANES);
}

/* Computes the start of a search. */
typedef void footpoint_detail_KIND_begin(BLOCK *b);

/* Loads columns of `count` pairs, or slave nodes, from `first` on; repeats the last to fill the block. */
FOOTPOINT_PART void footpoint_detail_KIND_load(BLOCK *b, const double *const *column, int begin,
                                               size_t first, int count)
{
    int k, l;
    for (k = begin; k < 27; k++) {
        double *const to = b->x[k / 3][k % 3];
        const double *const from = column[k - begin] + first;
        if (count == FOOTPOINT_LANES)
            for (l = 0; l < FOOTPOINT_LANES; l++)
                to[l] = from[l];
        else {
            for (l = 0; l < count; l++)
                to[l] = from[l];
            for (; l < b->lanes; l++)
                to[l] = from[count - 1];
        }
    }
}

/* Stores results of `count` lanes; the highest bit is set if any of them is not proved. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_store(const BLOCK *b, int count,
                                                     double *FOOTPOINT_RESTRICT xi,
                                                     double *FOOTPOINT_RESTRICT eta,
                                                     double *FOOTPOINT_RESTRICT gap,
                                                     int *FOOTPOINT_RESTRICT status)
{
    REAL_BITS doubt = 0;
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < count; l++) {
        xi[l] = b->p[l];
        eta[l] = b->q[l];
        gap[l] = b->gap[l] * b->unit[l];
        status[l] = FOOTPOINT_OK;
        doubt |= b->doubt[l];
    }
    return doubt;
}

/* Keeps last answers, which results overwrite. */
typedef struct {
    double loc[2][FOOTPOINT_LANES];
} footpoint_detail_KIND_last;

/* Begins with the last answers, or with the middle if an answer is no number. */
FOOTPOINT_PART void footpoint_detail_KIND_resume(BLOCK *b, footpoint_detail_KIND_last *last,
                                                 int count, const double *xi, const double *eta)
{
    int l;
    for (l = 0; l < b->lanes; l++) {
        const int from = l < count ? l : count - 1;
        const REAL x = (REAL)(last->loc[0][l] = xi[from]), y = (REAL)(last->loc[1][l] = eta[from]);
        const int good =
            !((footpoint_detail_above(x, 2.0) | footpoint_detail_above(y, 2.0)) >> REAL_TOP);
        b->p[l] = good ? footpoint_detail_KIND_kept(x) : (REAL)0.0;
        b->q[l] = good ? footpoint_detail_KIND_kept(y) : (REAL)0.0;
    }
}

/* Takes up to `most` steps, until the longest is so short that a proved step mostly succeeds; see step_leaves() of the
 * generator. */
FOOTPOINT_PART void footpoint_detail_KIND_settle(BLOCK *b, const footpoint_detail_KIND_lanes *t,
                                                 int most, double promise)
{
    REAL p[FOOTPOINT_LANES], q[FOOTPOINT_LANES], left = 1.0;
    int l;
    for (; most > 0 && 10.0 * left * left > promise; most--) {
        REAL longest = 0.0;
        for (l = 0; l < b->lanes; l++) {
            p[l] = b->p[l];
            q[l] = b->q[l];
        }
        footpoint_detail_KIND_bares(b, t);
        for (l = 0; l < b->lanes; l++)
            longest = footpoint_detail_greater(
                longest, footpoint_detail_greater(fabs(b->p[l] - p[l]), fabs(b->q[l] - q[l])));
        left = longest * longest * (0.3 * longest + 0.003);
    }
}

/* Doubts answers that are more than half of the patch away from the last answer, or whose last answer is no number. */
FOOTPOINT_PART void footpoint_detail_KIND_astray(BLOCK *b, const footpoint_detail_KIND_last *last)
{
    int l;
    for (l = 0; l < b->lanes; l++)
        b->doubt[l] |= footpoint_detail_above(b->p[l] - (REAL)last->loc[0][l], 1.0) |
                       footpoint_detail_above(b->q[l] - (REAL)last->loc[1][l], 1.0);
}

/* Searches a pair as NAME does; if `tried` is 1, only after its first attempt. */
FOOTPOINT_PART int footpoint_detail_KIND_alone(ALONE_SEARCH *search, int tried,
                                               const double *const *row, double promise,
                                               double loc[2], double *gap)
{
    double xi, eta, g;
    if (tried || search(row, 2, 0.0, &xi, &eta, &g) >> 63)
        return ALONE_ANSWER(search, row, 4, promise, loc, gap);
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return FOOTPOINT_OK;
}

/* Searches unproved pairs one by one, from the last answers unless `last` is NULL. */
FOOTPOINT_COLD void footpoint_detail_KIND_mend(ALONE_SEARCH *search, int tried, const BLOCK *b,
                                               const footpoint_detail_KIND_last *last, int count,
                                               double promise, double *xi, double *eta, double *gap,
                                               int *status)
{
    int l, k;
    for (l = 0; l < count; l++)
        if (b->doubt[l] >> REAL_TOP) {
            double x[9][3], loc[2] = {0.0, 0.0};
            const double *const row[9] = {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8]};
            for (k = 0; k < 27; k++)
                x[k / 3][k % 3] = b->x[k / 3][k % 3][l];
            for (k = 0; last && k < 2; k++)
                loc[k] = last->loc[k][l];
            status[l] =
                last ? ALONE_FURTHER(search, row, promise, loc, &gap[l])
                     : footpoint_detail_KIND_alone(search, tried, row, promise, loc, &gap[l]);
            xi[l] = loc[0];
            eta[l] = loc[1];
        }
}

/* Searches side by side, from the start of a search or, if `begin` is NULL, from the last answers. `shared` is 1 if t
 * has the patch. */
FOOTPOINT_PART void footpoint_detail_KIND_search(footpoint_detail_KIND_begin *begin, int bare,
                                                 int shared, BLOCK *b,
                                                 footpoint_detail_KIND_lanes *t,
                                                 const footpoint_detail_KIND_last *last,
                                                 double promise)
{
    int k;
    NARROW(b);
    if (!shared)
        footpoint_detail_KIND_shapes(b, t);
    if (begin) {
        begin(b);
        for (k = 0; k < bare; k++)
            footpoint_detail_KIND_bares(b, t);
    } else
        footpoint_detail_KIND_settle(b, t, bare, (REAL)promise);
    footpoint_detail_KIND_proofs(b, t, (REAL)promise);
    if (!begin)
        footpoint_detail_KIND_astray(b, last);
}

/* Searches n pairs or, unless `segment` is NULL, n slave nodes over one segment; `column` holds their coordinates. It
 * starts with `begin` or, if that is NULL, from the last answers in xi and eta, with at most `bare` steps. A few pairs are
 * quicker one by one. */
FOOTPOINT_APART void footpoint_detail_KIND_run(footpoint_detail_KIND_begin *begin, int bare,
                                               ALONE_SEARCH *search, const double *const *segment,
                                               size_t n, const double *const *column,
                                               double promise, double *xi, double *eta, double *gap,
                                               int *status)
{
    const int few = begin ? 4 : 1;
    BLOCK b;
    footpoint_detail_KIND_lanes t;
    footpoint_detail_KIND_last last;
    size_t i;
    int count, l, k;
    for (k = 0; segment && k < 24; k++)
        for (l = 0; l < FOOTPOINT_LANES; l++)
            b.x[k / 3][k % 3][l] = segment[k / 3][k % 3];
    for (i = 0; i < n; i += (size_t)count) {
        REAL_BITS doubt = (REAL_BITS)1 << REAL_TOP;
        b.lanes = n - i > 8 ? FOOTPOINT_LANES : 8;
        count = n - i < (size_t)b.lanes ? (int)(n - i) : b.lanes;
        footpoint_detail_KIND_load(&b, column, segment ? 24 : 0, i, count);
        if (!begin)
            footpoint_detail_KIND_resume(&b, &last, count, xi + i, eta + i);
        if (count >= few) {
            footpoint_detail_KIND_search(begin, bare, segment && i > 0, &b, &t, &last, promise);
            doubt = footpoint_detail_KIND_store(&b, count, xi + i, eta + i, gap + i, status + i);
        } else
            for (l = 0; l < count; l++)
                b.doubt[l] = doubt;
        if (doubt >> REAL_TOP)
            footpoint_detail_KIND_mend(search, count >= few, &b, begin ? NULL : &last, count,
                                       promise, xi + i, eta + i, gap + i, status + i);
    }
}
