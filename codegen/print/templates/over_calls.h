/* The functions for callers over one segment. */

FOOTPOINT_LOOP void NAME_over_n(const REAL *const nodes[SEGMENT_VECTORS], size_t n,
                                const REAL *const x[3], REAL *FOOTPOINT_RESTRICT xi,
                                REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT gap,
                                int *FOOTPOINT_RESTRICT status)
{
    footpoint_detail_KIND_over_n(NAME_detail_checked, nodes, n, x, SCALED_NODES, PROMISE, xi, eta,
                                 gap, status);
}
