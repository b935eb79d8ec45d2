/* Pairs of four-node faces and slave nodes side by side: the loop that callers have. */

/* Copies columns from `begin` on for a block that is not full, the last pair in place of those that lack. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_fill(BLOCK *t, const double **x, int begin,
                                                    int count)
{
    int k, l;
    for (k = begin; k < 15; k++) {
        for (l = 0; l < SIDE; l++)
            t->x[k][l] = x[k][l < count ? l : count - 1];
        x[k] = t->x[k];
    }
}

/* Takes as many steps as the promise needs, and proves the last. */
FOOTPOINT_PART void footpoint_detail_KIND_side_steps(BLOCK *t, double promise)
{
    footpoint_detail_LANES_KIND_side_products(t);
    footpoint_detail_LANES_KIND_side_begin(t);
    footpoint_detail_LANES_KIND_side_gauss(t);
    if (promise > 0.99e-3) {
        footpoint_detail_LANES_KIND_side_rough(t, (LANE)promise);
        footpoint_detail_KIND_side_gaps(t);
        return;
    }
    footpoint_detail_LANES_KIND_side_newton(t);
    footpoint_detail_LANES_KIND_side_bounds(t);
    if (promise < 0.99e-7) {
        footpoint_detail_KIND_side_slopes(t);
        footpoint_detail_LANES_KIND_side_corrections(t, (LANE)promise);
    }
    footpoint_detail_KIND_side_slopes_and_gaps(t);
    footpoint_detail_LANES_KIND_side_corrections(t, (LANE)promise);
}

/* Stores answers.  Returns 0 if all are proved. */
FOOTPOINT_PART int footpoint_detail_KIND_side_store(const BLOCK *t, int count,
                                                    double *FOOTPOINT_RESTRICT xi,
                                                    double *FOOTPOINT_RESTRICT eta,
                                                    double *FOOTPOINT_RESTRICT gap,
                                                    int *FOOTPOINT_RESTRICT status)
{
    unsigned long long infinite = 0;
    LANE_BITS doubt = 0;
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
        doubt |= t->doubt[l] | t->wide[l];
    }
    return infinite >> 63 || doubt >> LANE_TOP;
}

/* Searches one by one the pairs that are not proved, or all of them. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_mend(footpoint_detail_search *search, int nodes,
                                                    const BLOCK *t, int all, const double *const *x,
                                                    int count, double promise, double *xi,
                                                    double *eta, double *gap, int *status)
{
    int i;
    for (i = 0; i < count; i++)
        if (all || (t->doubt[i] | t->wide[i]) >> LANE_TOP ||
            footpoint_detail_infinite(t->gap[i]) >> 63) {
            const double p[VECTORS][3] = {COLUMNS};
            const double *const row[VECTORS] = {ROWS};
            double u, v, g;
            if (search(row, 2, 0.0, &u, &v, &g) >> 63)
                footpoint_detail_KIND_full(search, row, nodes, promise, &xi[i], &eta[i], &gap[i],
                                           &status[i]);
            else {
                xi[i] = u;
                eta[i] = v;
                gap[i] = g;
                status[i] = FOOTPOINT_OK;
            }
        }
}

/* Searches n pairs, or n slave nodes over one segment unless that is NULL.  A few are done sooner one by one. */
FOOTPOINT_APART void footpoint_detail_KIND_side_run(footpoint_detail_search *search, int nodes,
                                                    const double *const *segment, size_t n,
                                                    const double *const *x, double promise,
                                                    double *xi, double *eta, double *gap,
                                                    int *status)
{
    enum { FEW = 8 };
    const int begin = segment ? 12 : 0;
    const double *column[15];
    BLOCK t;
    size_t i;
    int k, l;
    for (k = 0; k < begin; k++) {
        for (l = 0; l < SIDE; l++)
            t.x[k][l] = segment[k / 3][k % 3];
        column[k] = t.x[k];
    }
    for (i = 0; i < n; i += SIDE) {
        const int count = n - i < SIDE ? (int)(n - i) : SIDE;
        for (k = begin; k < 15; k++)
            column[k] = x[k - begin] + i;
        if (count < SIDE && count >= FEW)
            footpoint_detail_KIND_side_fill(&t, column, begin, count);
        if (count >= FEW) {
            footpoint_detail_KIND_side_narrow(column, &t);
            footpoint_detail_KIND_side_steps(&t, promise);
        }
        if (count == SIDE
                ? footpoint_detail_KIND_side_store(&t, SIDE, xi + i, eta + i, gap + i, status + i)
                : count < FEW || footpoint_detail_KIND_side_store(&t, count, xi + i, eta + i,
                                                                  gap + i, status + i))
            footpoint_detail_KIND_side_mend(search, nodes, &t, count < FEW, column, count, promise,
                                            xi + i, eta + i, gap + i, status + i);
    }
}

FOOTPOINT_PART void footpoint_detail_KIND_checked_n(footpoint_detail_search *search, size_t n,
                                                    const double *const *x, int nodes,
                                                    double promise, double *xi, double *eta,
                                                    double *gap, int *status)
{
    footpoint_detail_KIND_side_run(search, nodes, NULL, n, x, promise, xi, eta, gap, status);
}

FOOTPOINT_PART void footpoint_detail_KIND_over_n(footpoint_detail_search *search,
                                                 const double *const *segment, size_t n,
                                                 const double *const *x, int nodes, double promise,
                                                 double *xi, double *eta, double *gap, int *status)
{
    footpoint_detail_KIND_side_run(search, nodes, segment, n, x, promise, xi, eta, gap, status);
}
