/* The triangle with mid-side nodes in powers of xi and eta. */

/* r = xS - c[0] + u c[1] + v c[2] + u^2 c[3] + u v c[4] + v^2 c[5], u = xi - 1/3, v = eta - 1/3; coordinate i. */
FOOTPOINT_PART void footpoint_detail_KIND_powers(const REAL *const *x, int i, REAL c[9])
{
    const REAL a = x[0][i], ab = x[1][i] - a, ac = x[2][i] - a, d = 4.0 * (x[3][i] - a);
    const REAL e = 4.0 * (x[4][i] - a), f = 4.0 * (x[5][i] - a), third = 1.0 / 3.0;
    c[3] = ab + ab - d;
    c[4] = e - d - f;
    c[5] = ac + ac - f;
    c[1] = d - ab + third * (2.0 * c[3] + c[4]);
    c[2] = f - ac + third * (2.0 * c[5] + c[4]);
    c[0] = x[6][i] - a - third * (c[1] + c[2] - third * (c[3] + c[4] + c[5]));
}
