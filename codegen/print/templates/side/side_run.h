/* Pairs of faces and slave nodes side by side: the loop over blocks of pairs. */

/* Copies columns into a block that is not full, and repeats the last pair to fill it. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_fill(BLOCK *t, const double **x, int count)
{
    int k, l;
    for (k = 0; k < COORDINATES; k++) {
        for (l = 0; l < SIDE; l++)
            t->x[k][l] = x[k][l < count ? l : count - 1];
        x[k] = t->x[k];
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

/* Takes more steps. Stores answers of `failed` pairs that these prove, which then no longer count as failed. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_again(BLOCK *t, double promise, int *failed,
                                                     int count, double *xi, double *eta,
                                                     double *gap)
{
    int l;
    footpoint_detail_KIND_side_steps(t, promise, 1);
    for (l = 0; l < count; l++)
        if (failed[l] && !footpoint_detail_KIND_side_fails(t, l)) {
            xi[l] = t->xi[l];
            eta[l] = t->eta[l];
            gap[l] = t->gap[l];
            failed[l] = 0;
        }
}

/* Searches `failed` pairs one by one. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_mend(footpoint_detail_search *search, int nodes,
                                                    const int *failed, const double *const *x,
                                                    int count, double promise, double *xi,
                                                    double *eta, double *gap, int *status)
{
    int i;
    for (i = 0; i < count; i++)
        if (failed[i]) {
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

/* Repairs unproved answers. If many failed, it first takes more steps, unless rounding forbids most proofs. */
FOOTPOINT_COLD void footpoint_detail_KIND_side_repair(footpoint_detail_search *search, int nodes,
                                                      BLOCK *t, int unproved,
                                                      const double *const *x, int count,
                                                      double promise, double *xi, double *eta,
                                                      double *gap, int *status)
{
    int failed[SIDE], l;
    for (l = 0; l < count; l++)
        failed[l] = unproved > count || footpoint_detail_KIND_side_fails(t, l);
    if (unproved > 3 && unproved <= count && promise > 0.99e-9)
        footpoint_detail_KIND_side_again(t, promise, failed, count, xi, eta, gap);
    footpoint_detail_KIND_side_mend(search, nodes, failed, x, count, promise, xi, eta, gap, status);
}

/* Searches n pairs. A few are searched one by one, which is faster. */
FOOTPOINT_APART void footpoint_detail_KIND_side_run(footpoint_detail_search *search, int nodes,
                                                    size_t n, const double *const *x,
                                                    double promise, double *xi, double *eta,
                                                    double *gap, int *status)
{
    enum { FEW = 8 };
    const double *column[COORDINATES];
    BLOCK t;
    size_t i;
    int k;
    for (i = 0; i < n; i += SIDE) {
        const int count = n - i < SIDE ? (int)(n - i) : SIDE;
        double *const u = xi + i, *const v = eta + i, *const g = gap + i;
        int unproved = SIDE + 1; /* none has been searched */
        for (k = 0; k < COORDINATES; k++)
            column[k] = x[k] + i;
        if (count >= FEW) {
            if (count < SIDE)
                footpoint_detail_KIND_side_fill(&t, column, count);
            footpoint_detail_KIND_side_narrow(column, &t);
            footpoint_detail_KIND_side_steps(&t, promise, 0);
            unproved = count == SIDE
                           ? footpoint_detail_KIND_side_store(&t, SIDE, u, v, g, status + i)
                           : footpoint_detail_KIND_side_store(&t, count, u, v, g, status + i);
        }
        if (unproved)
            footpoint_detail_KIND_side_repair(search, nodes, &t, unproved, column, count, promise,
                                              u, v, g, status + i);
    }
}

FOOTPOINT_PART void footpoint_detail_KIND_checked_n(footpoint_detail_search *search, size_t n,
                                                    const double *const *x, int nodes,
                                                    double promise, double *xi, double *eta,
                                                    double *gap, int *status)
{
    footpoint_detail_KIND_side_run(search, nodes, n, x, promise, xi, eta, gap, status);
}
