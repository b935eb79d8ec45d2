/* The quadrilateral with mid-side nodes as a polynomial of (xi,eta). */

/* r = r0 + xi e + eta f + xi^2 a / 2 + xi eta b + eta^2 c / 2 + xi^2 eta g / 2 + xi eta^2 h / 2, d = xS - r0; `size`:
 * the root of the sum of the squares of half the edges. Rounding: differences are off by a unit, e to h by 3. */
typedef struct {
    REAL e[3], f[3], a[3], b[3], c[3], g[3], h[3], d[3], size;
} footpoint_detail_quad8_terms;

/* Computes coordinate i of the terms, without `size`, from that of the nodes. */
FOOTPOINT_PART void footpoint_detail_quad8_axis(const REAL x[VECTORS], int i,
                                                footpoint_detail_quad8_terms *t)
{
    const REAL ae = x[0] - x[4], be = x[1] - x[4], bf = x[1] - x[5];
    const REAL cf = x[2] - x[5], cg = x[2] - x[6], dg = x[3] - x[6];
    const REAL dh = x[3] - x[7], ah = x[0] - x[7];
    const REAL ab = ae + be, bc = bf + cf, cd = cg + dg, da = dh + ah;
    t->e[i] = 0.5 * (x[5] - x[7]);
    t->f[i] = 0.5 * (x[6] - x[4]);
    t->a[i] = 0.5 * (ab + cd);
    t->b[i] = 0.25 * ((x[0] - x[1]) + (x[2] - x[3]));
    t->c[i] = 0.5 * (bc + da);
    t->g[i] = 0.5 * (cd - ab);
    t->h[i] = 0.5 * (bc - da);
    t->d[i] = 0.5 * ((x[8] - x[5]) + (x[8] - x[7]) + t->a[i]);
}

/* Returns the square of `size` from the other terms. */
FOOTPOINT_PART REAL footpoint_detail_quad8_square(const footpoint_detail_quad8_terms *t)
{
    REAL sum = 0.0;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL e = 2.0 * t->e[i] + t->h[i], f = 2.0 * t->f[i] + t->g[i];
        sum += e * e + f * f + 8.0 * t->b[i] * t->b[i] + t->a[i] * t->a[i] + t->c[i] * t->c[i];
        sum += t->g[i] * t->g[i] + t->h[i] * t->h[i];
    }
    return sum;
}

/* Computes r - r0 - p e - q f at (p,q), from the middle. */
FOOTPOINT_PART void footpoint_detail_quad8_arc(const footpoint_detail_quad8_terms *t, REAL p,
                                               REAL q, REAL w[3])
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        w[i] = p * (0.5 * p * (t->a[i] + q * t->g[i]) + q * (t->b[i] + 0.5 * q * t->h[i])) +
               0.5 * (q * q) * t->c[i];
}

/* Computes tangents and second derivatives at (p,q), and d = xS - r. */
FOOTPOINT_PART void footpoint_detail_quad8_local(const footpoint_detail_quad8_terms *t, REAL p,
                                                 REAL q, footpoint_detail_local *l)
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL pg = p * t->g[i], qh = q * t->h[i];
        const REAL m = t->e[i] + q * (t->b[i] + 0.5 * qh), n = t->f[i] + p * (t->b[i] + 0.5 * pg);
        l->uu[i] = t->a[i] + q * t->g[i];
        l->uv[i] = t->b[i] + pg + qh;
        l->vv[i] = t->c[i] + p * t->h[i];
        l->u[i] = m + p * l->uu[i];
        l->v[i] = n + q * l->vv[i];
        l->d[i] = t->d[i] - p * (m + 0.5 * (p * l->uu[i])) - q * (t->f[i] + 0.5 * (q * t->c[i]));
    }
}

/* Returns a bound, over `size`, on |r - (F + H) / 2|, |r_xi| and |r_eta|, and, times 1.8, on second derivatives, for
 * |xi| = x and |eta| = y, and for sums of absolute values: a, c, e, f, g, h are at most as long as `size`, b half as
 * long. */
FOOTPOINT_PART REAL footpoint_detail_quad8_growth(REAL x, REAL y)
{
    return (1.0 + x + 0.5 * (x * x)) * (1.0 + y + 0.5 * (y * y));
}

/* Returns an equally tight bound on |r - r0|, and 0.4 for d at the middle. */
FOOTPOINT_PART REAL footpoint_detail_quad8_spread(REAL x, REAL y)
{
    return 0.4 + (x + y) * (1.0 + 0.5 * (x * y)) + 0.5 * (x * x + y * y + x * y);
}

/* Bounds twice |r_xi xi eta| + |r_xi eta eta|, and with xi and eta exchanged. */
FOOTPOINT_PART void footpoint_detail_quad8_third(const footpoint_detail_quad8_terms *t, REAL x,
                                                 REAL y, REAL third[2])
{
    const REAL g = footpoint_detail_sum(t->g), h = footpoint_detail_sum(t->h);
    (void)x, (void)y;
    third[0] = 2.0 * g + h;
    third[1] = g + 2.0 * h;
}

/* Computes the third and fourth derivatives r_xi xi eta, r_xi eta eta, r_xi xi eta eta at (p,q). */
FOOTPOINT_PART void footpoint_detail_quad8_mixed(const footpoint_detail_quad8_terms *t, REAL p,
                                                 REAL q, REAL uuv[3], REAL uvv[3], REAL k[3])
{
    int i;
    (void)p, (void)q;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        uuv[i] = t->g[i];
        uvv[i] = t->h[i];
        k[i] = 0.0;
    }
}
