/* Quadrilaterals with mid-side nodes in powers of xi and eta. */

/* r = xS - c[0] + u c[1] + v c[2] + u^2 (c[3] + v c[6] + v^2 c[8]) + u v (c[4] + v c[7]) + v^2 c[5], u = xi, v = eta, where
 * faces of eight nodes have no c[8]; coordinate i. */
FOOTPOINT_PART void footpoint_detail_KIND_powers(const REAL *const *x, int i, REAL c[9])
{
    const REAL a = x[0][i], ab = x[1][i] - a, ac = x[2][i] - a, ad = x[3][i] - a;
    const REAL e = x[4][i] - a, f = x[5][i] - a, g = x[6][i] - a, h = x[7][i] - a;
    const REAL middle =
        NODES > 8 ? x[NODES - 1][i] - a : 0.5 * ((e + g) + (f + h)) - 0.25 * (ab + ac + ad);
    c[0] = x[NODES][i] - a - middle;
    c[1] = 0.5 * (f - h);
    c[2] = 0.5 * (g - e);
    c[3] = 0.5 * (f + h) - middle;
    c[4] = 0.25 * (ac - ab - ad);
    c[5] = 0.5 * (e + g) - middle;
    c[6] = 0.25 * (ac + ad - ab) - c[2];
    c[7] = 0.25 * (ab + ac - ad) - c[1];
    c[8] = 0.25 * (ab + ac + ad) - 0.5 * ((e + g) + (f + h)) + middle;
}
