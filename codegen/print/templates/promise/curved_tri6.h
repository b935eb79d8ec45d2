/* The triangle with mid-side nodes as a polynomial of (xi,eta), about A. */

/* With u and v, (xi,eta) minus the middle's, r = r0 + u e + v f + u^2 a / 2 + u v b + v^2 c / 2, d = xS - r0; `size`:
 * the root of the sum of the squares of differences that bound e to c. Rounding: differences are off by a unit, e to c
 * by 5. */
typedef struct {
    REAL e[3], f[3], a[3], b[3], c[3], d[3], size;
} footpoint_detail_tri6_terms;

/* Computes coordinate i of the terms, without `size`, from that of the nodes. */
FOOTPOINT_PART void footpoint_detail_tri6_axis(const REAL x[VECTORS], int i,
                                               footpoint_detail_tri6_terms *t)
{
    const REAL third = 1.0 / 3.0;

    const REAL ad = x[0] - x[3], bd = x[1] - x[3], ef = x[4] - x[5];
    const REAL af = x[0] - x[5], cf = x[2] - x[5], ed = x[4] - x[3];
    const REAL to = (x[6] - x[3]) + (x[6] - x[4]) + (x[6] - x[5]);
    t->e[i] = third * ((x[1] - x[0]) + 4.0 * ef);
    t->f[i] = third * ((x[2] - x[0]) + 4.0 * ed);
    t->a[i] = 4.0 * (ad + bd);
    t->b[i] = 4.0 * (ad + ef);
    t->c[i] = 4.0 * (af + cf);
    t->d[i] = third * (to + third * (ad + (x[1] - x[4]) + cf));
}

/* Returns the square of `size` from the other terms. */
FOOTPOINT_PART REAL footpoint_detail_tri6_square(const footpoint_detail_tri6_terms *t)
{
    REAL sum = 0.0;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL e = 0.5 * t->e[i], f = 0.5 * t->f[i], a = t->a[i] * (1.0 / 24.0);
        const REAL c = t->c[i] * (1.0 / 24.0), b = t->b[i] * (1.0 / 12.0), ad = (a - e) + 2.0 * b;
        const REAL bd = (e + 5.0 * a) - 2.0 * b, ef = (e - a) + b, af = (c - f) + 2.0 * b;
        const REAL cf = (f + 5.0 * c) - 2.0 * b, ed = (f - c) + b;
        sum += ad * ad + bd * bd + ef * ef + af * af + cf * cf + ed * ed;
    }
    return sum;
}

/* Computes r - r0 - p e - q f at (p,q), from the middle. */
FOOTPOINT_PART void footpoint_detail_tri6_arc(const footpoint_detail_tri6_terms *t, REAL p, REAL q,
                                              REAL w[3])
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        w[i] = p * (0.5 * (p * t->a[i]) + q * t->b[i]) + 0.5 * (q * q) * t->c[i];
}

/* Computes tangents and second derivatives at (p,q), and d = xS - r. */
FOOTPOINT_PART void footpoint_detail_tri6_local(const footpoint_detail_tri6_terms *t, REAL p,
                                                REAL q, footpoint_detail_local *l)
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL m = p * t->a[i] + q * t->b[i], n = p * t->b[i] + q * t->c[i];
        l->uu[i] = t->a[i];
        l->uv[i] = t->b[i];
        l->vv[i] = t->c[i];
        l->u[i] = t->e[i] + m;
        l->v[i] = t->f[i] + n;
        l->d[i] = t->d[i] - p * (t->e[i] + 0.5 * m) - q * (t->f[i] + 0.5 * n);
    }
}

/* Returns a bound, over `size`, on |r - D|, |r_xi| and |r_eta|, and, times 1.8, on second derivatives, for |u| = x and
 * |v| = y, and for sums of absolute values: e and f are at most the root of 2, a to c at most the root of 32 times as
 * long as `size`. */
FOOTPOINT_PART REAL footpoint_detail_tri6_growth(REAL x, REAL y)
{
    return (1.0 + (x + y)) * (3.2 + 2.9 * (x + y));
}

/* Returns an equally tight bound on |r - r0|, and 0.4 for d at the middle. */
FOOTPOINT_PART REAL footpoint_detail_tri6_spread(REAL x, REAL y)
{
    return 0.4 + (x + y) * (1.42 + 2.83 * (x + y));
}

/* Bounds third derivatives, which are 0. */
FOOTPOINT_PART void footpoint_detail_tri6_third(const footpoint_detail_tri6_terms *t, REAL x,
                                                REAL y, REAL third[2])
{
    (void)t, (void)x, (void)y;
    third[0] = third[1] = 0.0;
}

/* Computes the third and fourth derivatives r_xi xi eta, r_xi eta eta, r_xi xi eta eta at (p,q), which are 0. */
FOOTPOINT_PART void footpoint_detail_tri6_mixed(const footpoint_detail_tri6_terms *t, REAL p,
                                                REAL q, REAL uuv[3], REAL uvv[3], REAL k[3])
{
    int i;
    (void)t, (void)p, (void)q;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        uuv[i] = uvv[i] = k[i] = 0.0;
}
