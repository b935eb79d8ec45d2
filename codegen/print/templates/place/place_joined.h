/* What callers have of a search and a place at once: the text of a macro. */

FOOTPOINT_UNUSED
FOOTPOINT_FN int JOINED(NODE_PARAMETERS, REAL loc[2], ROW_PARAMETERS)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL *const row[ROW_COUNT] = {ROW_NAMES};
    REAL xi, eta;
    REAL_BITS flaw = SEARCHED_detail(NODE_NAMES, 0.0, &xi, &eta);
    flaw |= NAME_detail(x, xi, eta, row, 1, 0, 0);
    if (flaw >> REAL_TOP) {
        REAL distance;
        const int status = SEARCH(NODE_NAMES, loc, &distance);
        if (status != FOOTPOINT_OK)
            return status;
        return NAME_detail_again(x, loc[0], loc[1], row, 1);
    }
    loc[0] = xi;
    loc[1] = eta;
    return FOOTPOINT_OK;
}

FOOTPOINT_UNUSED
FOOTPOINT_LOOP void JOINED_n(size_t n, const REAL *const x[COORDINATES],
                             REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta, ROW_COLUMNS,
                             int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const y[VECTORS] = {ROWS};
        REAL *const row[ROW_COUNT] = {ROW_PLACES};
        REAL at[2];
        REAL_BITS flaw = SEARCHED_detail(ROWS, zero, &at[0], &at[1]);
        flaw |= NAME_detail(y, at[0], at[1], row, n, 1, 0);
        xi[i] = at[0];
        eta[i] = at[1];
        status[i] = FOOTPOINT_ERR_DEGENERATE * (int)(flaw >> REAL_TOP);
    }
    for (i = 0; i < n; i++)
        if (status[i] != FOOTPOINT_OK) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const y[VECTORS] = {ROWS};
            REAL *const row[ROW_COUNT] = {ROW_PLACES};
            REAL at[2] = {xi[i], eta[i]}, distance;
            status[i] = SEARCH(ROWS, at, &distance);
            xi[i] = at[0];
            eta[i] = at[1];
            if (status[i] == FOOTPOINT_OK)
                status[i] = NAME_detail_again(y, xi[i], eta[i], row, n);
        }
}
