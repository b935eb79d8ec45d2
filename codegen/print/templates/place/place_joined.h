/* The functions for callers that join a search and a place: the text of a macro. */

FOOTPOINT_UNUSED
FOOTPOINT_FN int JOINED(NODE_PARAMETERS, REAL loc[2], ROW_PARAMETERS)
{
    REAL distance;
    const int searched = SEARCH(NODE_NAMES, loc, &distance);
    const int status = searched < 0 ? searched : NAME(NODE_NAMES, loc, ROW_NAMES);
    return status == FOOTPOINT_OK ? searched : status;
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
        REAL at[2], distance;
        REAL_BITS flaw = SEARCHED_detail_checked(y, 0, zero, &at[0], &at[1], &distance);
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
            int placed;
            status[i] = SEARCH(ROWS, at, &distance);
            xi[i] = at[0];
            eta[i] = at[1];
            placed = status[i] < 0 ? FOOTPOINT_OK : NAME_detail_again(y, xi[i], eta[i], row, n);
            status[i] = placed == FOOTPOINT_OK ? status[i] : placed;
        }
}
