/* What callers have over arrays. */

FOOTPOINT_LOOP void NAME_n(size_t n, const REAL *const x[COORDINATES], REAL *FOOTPOINT_RESTRICT xi,
                           REAL *FOOTPOINT_RESTRICT eta)
{
    footpoint_detail_KIND_n(BARE_SEARCH, n, x, xi, eta);
}

FOOTPOINT_LOOP void NAME_checked_n(size_t n, const REAL *const x[COORDINATES],
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                   REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    footpoint_detail_KIND_checked_n(CHECKED_SEARCH, n, x, SCALED_NODES, xi, eta, gap, status);
}
