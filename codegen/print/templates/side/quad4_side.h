/* Pairs of four-node faces and slave nodes side by side: the part in single precision. */

/* Computes products. Sets doubt if the unit of length is out of range. */
FOOTPOINT_PART void footpoint_detail_KIND_side_products_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l, i, k;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        REAL a[4][3], size, per;
        union {
            REAL_BITS bits;
            REAL number;
        } unit;
        FOOTPOINT_WHOLE
        for (k = 0; k < 4; k++) {
            FOOTPOINT_WHOLE
            for (i = 0; i < 3; i++)
                a[k][i] = t->narrow[k][i][l];
        }
        size = footpoint_detail_sum(a[0]) + footpoint_detail_sum(a[1]);
        unit.bits = 0x7f000000u - (footpoint_detail_bits(size) & 0x7f000000u);
        per = unit.number;
        FOOTPOINT_WHOLE
        for (k = 0; k < 4; k++) {
            FOOTPOINT_WHOLE
            for (i = 0; i < 3; i++)
                a[k][i] *= per;
        }
        t->square[l] = (double)per * (double)per;
        t->doubt[l] = footpoint_detail_bits(size - 1e-25) | footpoint_detail_bits(1e30 - size) |
                      footpoint_detail_fast();
        t->product[0][l] = footpoint_detail_dot(a[0], a[0]);
        t->product[1][l] = footpoint_detail_dot(a[0], a[1]);
        t->product[2][l] = footpoint_detail_dot(a[1], a[1]);
        FOOTPOINT_WHOLE
        for (k = 0; k < 3; k++) {
            t->product[3 + k][l] = footpoint_detail_dot(a[k], a[2]);
            t->product[6 + k][l] = footpoint_detail_dot(a[k], a[3]);
        }
        t->product[9][l] = footpoint_detail_dot(a[3], a[3]);
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_products(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_products_of(t, 8);
    else
        footpoint_detail_KIND_side_products_of(t, SIDE);
}

/* Holds values at (p,q): products e, tu = r_xi . c, tv = r_eta . c, y = r_xi . r_eta - a . b, and the Hessian [r11 r12;
 * r12 r22] of half the squared distance. */
typedef struct {
    REAL e[10], p, q, tu, tv, y, r11, r22, r12;
} footpoint_detail_KIND_side_bend;

FOOTPOINT_PART void footpoint_detail_KIND_side_visit(const BLOCK *t, int l,
                                                     footpoint_detail_KIND_side_bend *h)
{
    int k;
    FOOTPOINT_WHOLE
    for (k = 0; k < 10; k++)
        h->e[k] = t->product[k][l];
    h->p = t->p[l];
    h->q = t->q[l];
    h->tu = h->e[3] + h->q * h->e[5];
    h->tv = h->e[4] + h->p * h->e[5];
    h->y = h->p * h->e[3] + h->q * h->tv;
    h->r11 = h->e[0] + h->q * (h->e[3] + h->tu);
    h->r22 = h->e[2] + h->p * (h->e[4] + h->tv);
    h->r12 = (h->e[1] - h->e[8]) + (h->y + h->y);
}

/* Starts at the projection of the slave node on the parallelogram of the mid-lines, corrected for c to first order. */
FOOTPOINT_PART void footpoint_detail_KIND_side_begin_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        const REAL aa = t->product[0][l], ab = t->product[1][l], bb = t->product[2][l];
        const REAL ac = t->product[3][l], bc = t->product[4][l], ad = t->product[6][l];
        const REAL bd = t->product[7][l], per = 1.0 / (aa * bb - ab * ab);
        const REAL p = (bb * ad - ab * bd) * per, q = (aa * bd - ab * ad) * per, pq = p * q * per;
        t->p[l] = p - (bb * ac - ab * bc) * pq;
        t->q[l] = q - (aa * bc - ab * ac) * pq;
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_begin(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_begin_of(t, 8);
    else
        footpoint_detail_KIND_side_begin_of(t, SIDE);
}

/* Returns 1 / det, or 0 if |det| is small beside `all`: a step across nearly parallel tangents would lead so far outside that
 * products overflow. */
FOOTPOINT_PART REAL footpoint_detail_KIND_side_per(REAL det, REAL all)
{
    union {
        REAL number;
        REAL_BITS bits;
    } per;
    per.number = 1.0 / det;
    per.bits &= (footpoint_detail_bits(fabs(det) - 1e-4 * all) >> REAL_TOP) - 1u;
    return per.number;
}

/* Takes a Gauss-Newton step or a Newton step. */
FOOTPOINT_PART void footpoint_detail_KIND_side_step(BLOCK *FOOTPOINT_RESTRICT t, int gauss,
                                                    int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        footpoint_detail_KIND_side_bend h;
        REAL r12, z, f, g, per, all;
        footpoint_detail_KIND_side_visit(t, l, &h);
        r12 = gauss ? h.e[1] + h.y : h.r12;
        z = gauss ? h.e[8] : h.y;
        f = h.e[6] + h.q * (z + h.p * h.tu);
        g = h.e[7] + h.p * (z + h.q * h.tv);
        all = h.r11 * h.r22;
        per = footpoint_detail_KIND_side_per(all - r12 * r12, all);
        t->p[l] = (h.r22 * f - r12 * g) * per;
        t->q[l] = (h.r11 * g - r12 * f) * per;
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_gauss(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_step(t, 1, 8);
    else
        footpoint_detail_KIND_side_step(t, 1, SIDE);
}

FOOTPOINT_APART void footpoint_detail_KIND_side_newton(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_step(t, 0, 8);
    else
        footpoint_detail_KIND_side_step(t, 0, SIDE);
}

/* Computes at (p,q) values that prove corrections, and F = (f,g) in single precision if `rough`.
 *
 * F has the Jacobian -H.  T(y) = y + A F(y), A being H^-1 as computed at (p,q), has the derivative 1 - A H(y).  In a ball of 5/4 step
 * about (p,q), in maximum norms, that is at most h = most + |A| L 5/4 step: `most` bounds |1 - A H(p,q)|, L is a Lipschitz constant
 * of H within 2/3, `step` bounds |A F(p,q)|.  If h <= 1/5, then T contracts in that ball, and a root lies there, within
 * 5/4 h step of T(p,q).  The same holds for a second correction from there with the same A.  Rounding of F adds `off`, of the
 * products of A and F 3 units of the sum of their absolute values, where 5 are counted.  H is positive definite at the root: A is,
 * and so is every matrix on the way from its inverse to H.
 *
 * Rounding errors in units of single precision: let U = |a| + |q c|, V = |b| + |p c|, T = |d| + |p a| + |q| V and W = U
 * V + |c| T. Then r11 is off by 11 U U, r12 by 11 W, r22 by 11 V V. Entries of A add 2 units of H, their divisor adds
 * 5, so `most` needs 18 units of |A| |H|; the code counts 22. r_xi . c is off by 8 |c| U, which L includes. F is off by
 * 14 U T and 14 V T. In double, F is off by 13 units of the bounds here at the point where it is computed, and by 17 at
 * a second correction, up to 1 / 12 away.
 *
 * Vectors are rounded in double, d by at most 6 units of |a| + |b| + |c|, for which T has 1e-9 of that sum.  Through T, `most`,
 * `turn` and `off` then prove nothing if |c| exceeds about 5e4 U, and what is left fits into the slack of 14 and 22.  Where F is
 * in double, `off` counts |c| itself.  If tiny numbers are flushed to zero, coordinates lose 1.2e-38, so the face must be 1e-25 long.
 * A correction turns the normal u x v by at most |c| (U + V) step, which is less than a third of its length each time. */
FOOTPOINT_PART void footpoint_detail_KIND_side_bound(BLOCK *FOOTPOINT_RESTRICT t, int rough,
                                                     int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        footpoint_detail_KIND_side_bend h;
        REAL x, y, r12, det, per, a, b, c, d, U, V, T, W, bend, off, row, column;
        footpoint_detail_KIND_side_visit(t, l, &h);
        x = fabs(h.p);
        y = fabs(h.q);
        r12 = fabs(h.r12);
        det = h.r11 * h.r22 - h.r12 * h.r12;
        per = 1.0 / det;
        a = footpoint_detail_root_bound(h.e[0]);
        b = footpoint_detail_root_bound(h.e[2]);
        c = footpoint_detail_root_bound(h.e[5]);
        d = footpoint_detail_root_bound(h.e[9]);
        U = a + y * c;
        V = b + x * c;
        T = d + x * a + y * V + 1e-9 * (a + b + c); /* vectors are rounded in double */
        W = U * V + c * T;
        row = U * U + W;
        column = V * V + W;
        t->most[l] = 22.0 * REAL_UNIT * per *
                     footpoint_detail_KIND_side_greater(h.r22 * row + r12 * column,
                                                        r12 * row + h.r11 * column);
        bend = c * (U + V);
        t->bend[l] = bend;
        t->turn[l] = 1.25 * per * (footpoint_detail_KIND_side_greater(h.r11, h.r22) + r12) *
                     (4.0 * (fabs(h.tu) + fabs(h.tv)) + 2.0 * h.e[5] + 32.0 * REAL_UNIT * bend);
        if (rough) {
            const REAL z = (h.e[1] - h.e[8]) + h.y;
            t->slope[0][l] = (h.e[6] - h.p * (h.e[0] + h.q * h.e[3])) - h.q * z;
            t->slope[1][l] = (h.e[7] - h.q * (h.e[2] + h.p * h.e[4])) - h.p * z;
            off = 14.0 * REAL_UNIT * per * T;
            row = U;
            column = V;
        } else {
            const REAL above = 1.0 + x, beside = 1.0 + y;
            off = 18.0 * 1.12e-16 * per * (d + above * beside * (a + b + c));
            row = beside * (a + c);
            column = above * (b + c + 0.08 * a);
        }
        t->off[l] = off * footpoint_detail_KIND_side_greater(h.r22 * row + r12 * column,
                                                             r12 * row + h.r11 * column);
        t->a11[l] = h.r22 * per;
        t->a12[l] = -(h.r12 * per);
        t->a22[l] = h.r11 * per;
        a = h.e[1] + h.y;
        b = h.r11 * h.r22;
        a = b - a * a;
        b *= 1e-3;
        t->flat[l] = 0.3 * footpoint_detail_root_bound(a);
        t->doubt[l] |= footpoint_detail_bits(det - b) | footpoint_detail_bits(a - b) |
                       footpoint_detail_bits(h.r11) | footpoint_detail_bits(1e6 - h.e[9]) |
                       footpoint_detail_bits(1e8 * h.e[0] - h.e[2]) |
                       footpoint_detail_bits(1e8 * h.e[2] - h.e[0]) |
                       footpoint_detail_bits(30.0 - footpoint_detail_KIND_side_greater(x, y));
    }
}

FOOTPOINT_PART void footpoint_detail_KIND_side_bounds_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    footpoint_detail_KIND_side_bound(t, 0, lanes);
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        t->xi[l] = (double)t->p[l];
        t->eta[l] = (double)t->q[l];
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_bounds(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_bounds_of(t, 8);
    else
        footpoint_detail_KIND_side_bounds_of(t, SIDE);
}

FOOTPOINT_PART void footpoint_detail_KIND_side_rough_of(BLOCK *FOOTPOINT_RESTRICT t, REAL promise,
                                                        int lanes)
{
    int l;
    footpoint_detail_KIND_side_bound(t, 1, lanes);
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        t->xi[l] = (double)t->p[l];
        t->eta[l] = (double)t->q[l];
        footpoint_detail_KIND_side_correct(t, l, t->slope[0][l], t->slope[1][l], promise);
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_rough(BLOCK *FOOTPOINT_RESTRICT t, REAL promise)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_rough_of(t, promise, 8);
    else
        footpoint_detail_KIND_side_rough_of(t, promise, SIDE);
}
