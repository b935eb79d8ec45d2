/* The functions for callers over arrays. */

FOOTPOINT_LOOP void NAME_n(size_t n, const REAL *const x[COORDINATES], REAL *FOOTPOINT_RESTRICT xi,
                           REAL *FOOTPOINT_RESTRICT eta)
{
    footpoint_detail_KIND_n(NAME_detail, n, x, xi, eta);
}

FOOTPOINT_LOOP void NAME_checked_n(size_t n, const REAL *const x[COORDINATES],
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                   REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    footpoint_detail_KIND_checked_n(NAME_detail_checked, n, x, SCALED_NODES, PROMISE, xi, eta, gap,
                                    status);
}
