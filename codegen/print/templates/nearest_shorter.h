/* The search if the scene assumes that corner A is nearest to the slave node, and |AD| <= |AB|. */

FOOTPOINT_PART REAL_BITS NAME_detail_nearest_shorter(const REAL *const *x, REAL zero, REAL *xi,
                                                     REAL *eta)
{
    const REAL *const xS = x[4];
    const int k = footpoint_detail_nearest_corner(x, xS), mirror = footpoint_detail_mirrored(x, k);
    const int b = (k + (mirror ? 3 : 1)) & 3, d = (k + (mirror ? 1 : 3)) & 3;
    REAL u, v;
    const REAL_BITS flaw = NAME_detail(x[k], x[b], x[(k + 2) & 3], x[d], xS, zero, &u, &v);
    footpoint_detail_turn_back(k, mirror ? v : u, mirror ? u : v, xi, eta);
    return flaw;
}
