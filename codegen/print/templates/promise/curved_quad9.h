/* The quadrilateral with mid-side nodes and a middle as a polynomial of (xi,eta). */

/* r = M + xi e + eta f + xi^2 a / 2 + xi eta b + eta^2 c / 2 + xi^2 eta g / 2 + xi eta^2 h / 2 + xi^2 eta^2 k / 4, M
 * the node in the middle, d = xS - M; `size`: the root of the sum of the squares of half the edges and of the lines
 * from M to the nodes between corners. Rounding: differences are off by a unit, e to h by 3, k by 4. */
typedef struct {
    REAL e[3], f[3], a[3], b[3], c[3], g[3], h[3], k[3], d[3], size;
} footpoint_detail_quad9_terms;

/* Computes coordinate i of the terms, without `size`, from that of the nodes. */
FOOTPOINT_PART void footpoint_detail_quad9_axis(const REAL x[VECTORS], int i,
                                                footpoint_detail_quad9_terms *t)
{
    const REAL ae = x[0] - x[4], be = x[1] - x[4], bf = x[1] - x[5];
    const REAL cf = x[2] - x[5], cg = x[2] - x[6], dg = x[3] - x[6];
    const REAL dh = x[3] - x[7], ah = x[0] - x[7];
    const REAL em = x[4] - x[8], fm = x[5] - x[8], gm = x[6] - x[8];
    const REAL hm = x[7] - x[8], ab = ae + be, bc = bf + cf, cd = cg + dg, da = dh + ah;
    t->e[i] = 0.5 * (x[5] - x[7]);
    t->f[i] = 0.5 * (x[6] - x[4]);
    t->a[i] = fm + hm;
    t->b[i] = 0.25 * ((x[0] - x[1]) + (x[2] - x[3]));
    t->c[i] = em + gm;
    t->g[i] = 0.5 * (cd - ab);
    t->h[i] = 0.5 * (bc - da);
    t->k[i] = (ab + cd) - 2.0 * t->a[i];
    t->d[i] = x[9] - x[8];
}

/* Returns the square of `size` from the other terms. */
FOOTPOINT_PART REAL footpoint_detail_quad9_square(const footpoint_detail_quad9_terms *t)
{
    REAL sum = 0.0;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL e = 2.0 * t->e[i] + t->h[i], f = 2.0 * t->f[i] + t->g[i];
        const REAL a = t->a[i] + 0.5 * t->k[i], c = t->c[i] + 0.5 * t->k[i];
        sum += e * e + f * f + 8.0 * t->b[i] * t->b[i] + a * a + c * c + t->g[i] * t->g[i];
        sum += t->h[i] * t->h[i] + 2.0 * (t->e[i] * t->e[i] + t->f[i] * t->f[i]);
        sum += 0.5 * (t->a[i] * t->a[i] + t->c[i] * t->c[i]);
    }
    return sum;
}

/* Computes r - r0 - p e - q f at (p,q), from the middle, without k. */
FOOTPOINT_PART void footpoint_detail_quad9_arc(const footpoint_detail_quad9_terms *t, REAL p,
                                               REAL q, REAL w[3])
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++)
        w[i] = p * (0.5 * p * (t->a[i] + q * t->g[i]) + q * (t->b[i] + 0.5 * q * t->h[i])) +
               0.5 * (q * q) * t->c[i];
}

/* Computes tangents and second derivatives at (p,q), and d = xS - r. */
FOOTPOINT_PART void footpoint_detail_quad9_local(const footpoint_detail_quad9_terms *t, REAL p,
                                                 REAL q, footpoint_detail_local *l)
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL pg = p * t->g[i], qh = q * t->h[i], pk = p * t->k[i];
        const REAL m = t->e[i] + q * (t->b[i] + 0.5 * qh), n = t->f[i] + p * (t->b[i] + 0.5 * pg);
        l->uu[i] = t->a[i] + q * (t->g[i] + 0.5 * (q * t->k[i]));
        l->uv[i] = t->b[i] + pg + q * (t->h[i] + pk);
        l->vv[i] = t->c[i] + p * (t->h[i] + 0.5 * pk);
        l->u[i] = m + p * l->uu[i];
        l->v[i] = n + q * l->vv[i];
        l->d[i] = t->d[i] - p * (m + 0.5 * (p * l->uu[i])) - q * (t->f[i] + 0.5 * (q * t->c[i]));
    }
}

/* Returns a bound, over `size`, on |r - M|, |r_xi| and |r_eta|, and, times 1.8, on second derivatives, for |xi| = x and
 * |eta| = y, and for sums of absolute values: e to h are at most as long as `size`, except a and c, which are at most
 * the root of 2 times, and k, which is at most the root of 12 times as long. */
FOOTPOINT_PART REAL footpoint_detail_quad9_growth(REAL x, REAL y)
{
    return 1.2 * (1.0 + x + x * x) * (1.0 + y + y * y);
}

/* Returns an equally tight bound on |r - r0|, and 0.4 for d at the middle: e and f are at most as long as `size` over
 * the root of 2. */
FOOTPOINT_PART REAL footpoint_detail_quad9_spread(REAL x, REAL y)
{
    const REAL xy = x * y;
    return 0.4 + (x + y) * (0.71 + 0.5 * xy) + 0.71 * (x * x + y * y) + xy * (0.5 + 0.87 * xy);
}

/* Bounds twice |r_xi xi eta| + |r_xi eta eta|, and with xi and eta exchanged, within 1/8 of (x,y). */
FOOTPOINT_PART void footpoint_detail_quad9_third(const footpoint_detail_quad9_terms *t, REAL x,
                                                 REAL y, REAL third[2])
{
    const REAL k = footpoint_detail_sum(t->k);
    const REAL g = footpoint_detail_sum(t->g) + (y + 0.125) * k;
    const REAL h = footpoint_detail_sum(t->h) + (x + 0.125) * k;
    third[0] = 2.0 * g + h;
    third[1] = g + 2.0 * h;
}

/* Computes the third and fourth derivatives r_xi xi eta, r_xi eta eta, r_xi xi eta eta at (p,q). */
FOOTPOINT_PART void footpoint_detail_quad9_mixed(const footpoint_detail_quad9_terms *t, REAL p,
                                                 REAL q, REAL uuv[3], REAL uvv[3], REAL k[3])
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        uuv[i] = t->g[i] + q * t->k[i];
        uvv[i] = t->h[i] + p * t->k[i];
        k[i] = t->k[i];
    }
}
