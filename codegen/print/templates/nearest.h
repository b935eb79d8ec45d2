/* The search if the scene assumes that corner A is nearest to the slave node: u and v are xi and eta found there. */

FOOTPOINT_PART REAL_BITS NAME_detail_nearest(const REAL *const *x, REAL zero, REAL *xi, REAL *eta)
{
    const REAL *const xS = x[4];
    const int k = footpoint_detail_nearest_corner(x, xS);
    REAL u, v;
    const REAL_BITS flaw =
        NAME_detail(x[k], x[(k + 1) & 3], x[(k + 2) & 3], x[(k + 3) & 3], xS, zero, &u, &v);
    footpoint_detail_turn_back(k, u, v, xi, eta);
    return flaw;
}
