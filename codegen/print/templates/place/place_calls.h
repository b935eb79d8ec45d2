/* The functions for callers at a place of a face. */

FOOTPOINT_FN int NAME(NODE_PARAMETERS, const REAL loc[2], ROW_PARAMETERS)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    REAL *const row[ROW_COUNT] = {ROW_NAMES};
    if (NAME_detail(x, loc[0], loc[1], row, 1, 0, 0) >> REAL_TOP)
        return NAME_detail_again(x, loc[0], loc[1], row, 1);
    return FOOTPOINT_OK;
}

FOOTPOINT_LOOP void NAME_n(size_t n, const REAL *const x[COORDINATES], const REAL *xi,
                           const REAL *eta, ROW_COLUMNS, int *FOOTPOINT_RESTRICT status)
{
    size_t i;
    FOOTPOINT_EACH
    for (i = 0; i < n; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const y[VECTORS] = {ROWS};
        REAL *const row[ROW_COUNT] = {ROW_PLACES};
        const REAL_BITS flaw = NAME_detail(y, xi[i], eta[i], row, n, 1, 0);
        status[i] = FOOTPOINT_ERR_DEGENERATE * (int)(flaw >> REAL_TOP);
    }
    for (i = 0; i < n; i++)
        if (status[i] != FOOTPOINT_OK) {
            const REAL p[VECTORS][3] = {COLUMNS};
            const REAL *const y[VECTORS] = {ROWS};
            REAL *const row[ROW_COUNT] = {ROW_PLACES};
            status[i] = NAME_detail_again(y, xi[i], eta[i], row, n);
        }
}
