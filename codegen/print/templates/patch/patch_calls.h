/* The functions for callers over arrays of patches. */

FOOTPOINT_LOOP void NAME_n(size_t n, const REAL *const x[COORDINATES], REAL *FOOTPOINT_RESTRICT xi,
                           REAL *FOOTPOINT_RESTRICT eta)
{
    footpoint_detail_KIND_n(NAME_detail, n, x, xi, eta);
}

FOOTPOINT_LOOP void NAME_checked_n(size_t n, const REAL *const x[COORDINATES],
                                   REAL *FOOTPOINT_RESTRICT xi, REAL *FOOTPOINT_RESTRICT eta,
                                   REAL *FOOTPOINT_RESTRICT gap, int *FOOTPOINT_RESTRICT status)
{
    RUN(ONCE_BEGIN, ONCE_STEPS, NAME_detail_checked, NULL, n, x, PROMISE, xi, eta, gap, status);
}

FOOTPOINT_LOOP void NAME_over_n(const REAL *const nodes[SEGMENT_VECTORS], size_t n,
                                const REAL *const x[3], REAL *FOOTPOINT_RESTRICT xi,
                                REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT gap,
                                int *FOOTPOINT_RESTRICT status)
{
    RUN(ONCE_BEGIN, ONCE_STEPS, NAME_detail_checked, nodes, n, x, PROMISE, xi, eta, gap, status);
}
