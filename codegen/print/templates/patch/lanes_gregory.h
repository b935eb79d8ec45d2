/* Gregory patches side by side; see patch_gregory.h. */

/* Inner points add (1 - p^2) (1 - q^2) (inner0 + p inner1 + q inner2 + p q inner3). Each corner adds x^2 y / (x + y)
 * f(x) f(y) twist, f(x) = (1 - x)^2, where x and y are half the distances from it along xi and eta. twists: sums of the
 * absolute coordinates. */
typedef struct {
    footpoint_detail_NET net;
    REAL inner[4][3], twist[4][3], twists[4];
} footpoint_detail_KIND_terms;

/* Holds an edge as its ends use it: the handle along it, 3 n x handle and the other handle; 3 k and 3 l. For a unit
 * normal n, the other handle is k n x handle + l handle. */
typedef struct {
    REAL along[3], turn[3], across[3], k, l;
} footpoint_detail_KIND_end;

/* Computes the handles of a corner, whose edges begin or end there. Returns the largest quotient of the squares of an
 * edge and a handle along it. */
FOOTPOINT_PART REAL footpoint_detail_KIND_corner(const REAL n[3], const REAL x[3], const REAL y[3],
                                                 const REAL xx, const REAL yy,
                                                 footpoint_detail_KIND_end *a,
                                                 footpoint_detail_KIND_end *b)
{
    const REAL along = footpoint_detail_dot(x, y), s = footpoint_detail_dot(x, x);
    const REAL t = footpoint_detail_dot(y, y), per = 3.0 / (s * t), u = per * t, v = per * s;
    int i;
    footpoint_detail_cross(n, x, a->turn);
    footpoint_detail_cross(n, y, b->turn);
    a->k = footpoint_detail_dot(a->turn, y) * u;
    b->k = footpoint_detail_dot(b->turn, x) * v;
    a->l = along * u;
    b->l = along * v;
    FOOTPOINT_WHOLE
    for (i = 0; i < 3; i++) {
        a->along[i] = b->across[i] = x[i];
        b->along[i] = a->across[i] = y[i];
    }
    return footpoint_detail_greater(xx * u, yy * v);
}

/* Computes nine times an edge's part of the inner points at its ends, minus the net's. */
FOOTPOINT_PART void footpoint_detail_KIND_make(const REAL edge[3],
                                               const footpoint_detail_KIND_end *a,
                                               const footpoint_detail_KIND_end *b, REAL first[3],
                                               REAL last[3])
{
    const REAL k = a->k - b->k, l = 2.0 * a->l, m = 2.0 * b->l;
    int i;
    FOOTPOINT_WHOLE
    for (i = 0; i < 3; i++) {
        const REAL middle = edge[i] + (b->along[i] - a->along[i]);
        first[i] = (k * a->turn[i] - a->k * b->turn[i]) +
                   (l * middle - b->l * a->along[i] - 9.0 * a->across[i]);
        last[i] = -(k * b->turn[i] + b->k * a->turn[i]) -
                  (m * middle + a->l * b->along[i] + 9.0 * b->across[i]);
    }
}

/* Computes the handles at the ends of an edge. */
FOOTPOINT_PART void footpoint_detail_KIND_handles(const footpoint_detail_NET_bent *t, REAL a[3],
                                                  REAL b[3])
{
    const REAL third = 1.0 / 3.0, rise = 8.0 / 3.0;
    int i;
    FOOTPOINT_WHOLE
    for (i = 0; i < 3; i++) {
        a[i] = third * t->edge[i] - rise * t->begin[i];
        b[i] = rise * t->end[i] - third * t->edge[i];
    }
}

/* Completes the patch.
 *
 * Rounding, with d* the longest edge, w >= 2.98 the largest quotient of an edge and a handle along it, M = w^2 d*, u a
 * unit of rounding. Handles are off by 3.4 u of their edge, 4 u if normals are rounded, and b / |b|^2, as inversion
 * keeps angles, by that times w / |b|. An edge's part is less than 1.9 M: `l * middle` is off by 41 u M, products with
 * k and the others by 5 u M each, the sum by 8 u M: 73 u M, 84 if normals are rounded. `inner` is 1/64 of four of
 * these: 5.6 u M, less than 0.13 M. In d, factors add up to 1.93, and twists of 168 u M weigh 0.03: 16, and 4 u M of
 * products. In tangents 5.6 and 0.08: 45, and 14 u M. In second derivatives 16 and 0.6: 190, 330 of weights at x + y =
 * 0.01, and 30 u M. The code counts 14, 50 and 980 M in units of 1.5 u, which is more.
 *
 * Third derivatives of the part of `inner`, up to 1/8 beside the patch, are bounded term by term for w = 1 - p^2: its
 * first derivative by 2.25, its second by 2, those of p w by 2.8, 6.75 and 6. */
FOOTPOINT_PART void footpoint_detail_KIND_shape(const REAL *const *n,
                                                footpoint_detail_NET_bent bent[4],
                                                footpoint_detail_KIND_terms *t)
{
    footpoint_detail_KIND_end end[4][2]; /* of AB, DC, AD, BC */
    REAL handle[4][2][3], square[4], along[4][3], up[4][3], most, longest = 0.0, sums[4];
    int c, i;
    footpoint_detail_NET_bend_all(n, bent, &t->net);
    footpoint_detail_NET_expand(bent, &t->net);
    FOOTPOINT_WHOLE
    for (c = 0; c < 4; c++) {
        footpoint_detail_KIND_handles(&bent[c], handle[c][0], handle[c][1]);
        square[c] = footpoint_detail_dot(bent[c].edge, bent[c].edge);
        longest = footpoint_detail_greater(longest, footpoint_detail_sum(bent[c].edge));
    }
    most = footpoint_detail_greater(
        footpoint_detail_greater(
            footpoint_detail_KIND_corner(n[0], handle[0][0], handle[2][0], square[0], square[2],
                                         &end[0][0], &end[2][0]),
            footpoint_detail_KIND_corner(n[1], handle[0][1], handle[3][0], square[0], square[3],
                                         &end[0][1], &end[3][0])),
        footpoint_detail_greater(
            footpoint_detail_KIND_corner(n[2], handle[1][1], handle[3][1], square[1], square[3],
                                         &end[1][1], &end[3][1]),
            footpoint_detail_KIND_corner(n[3], handle[1][0], handle[2][1], square[1], square[2],
                                         &end[1][0], &end[2][1])));
    footpoint_detail_KIND_make(bent[0].edge, &end[0][0], &end[0][1], along[0], along[1]);
    footpoint_detail_KIND_make(bent[1].edge, &end[1][0], &end[1][1], along[3], along[2]);
    footpoint_detail_KIND_make(bent[2].edge, &end[2][0], &end[2][1], up[0], up[3]);
    footpoint_detail_KIND_make(bent[3].edge, &end[3][0], &end[3][1], up[1], up[2]);
    FOOTPOINT_WHOLE
    for (i = 0; i < 3; i++) {
        const REAL s = up[0][i] + up[1][i], S = up[2][i] + up[3][i];
        const REAL r = up[1][i] - up[0][i], R = up[2][i] - up[3][i];
        t->inner[0][i] = 0.015625 * (s + S);
        t->inner[1][i] = 0.015625 * (r + R);
        t->inner[2][i] = 0.015625 * (S - s);
        t->inner[3][i] = 0.015625 * (R - r);
    }
    FOOTPOINT_WHOLE
    for (c = 0; c < 4; c++) {
        FOOTPOINT_WHOLE
        for (i = 0; i < 3; i++)
            t->twist[c][i] = along[c][i] - up[c][i];
        t->twists[c] = footpoint_detail_sum(t->twist[c]);
        sums[c] = footpoint_detail_sum(t->inner[c]);
    }
    t->net.third[0] += 13.5 * sums[0] + 42.0 * sums[1] + 26.4 * sums[2] + 59.1 * sums[3];
    t->net.third[1] += 13.5 * sums[0] + 26.4 * sums[1] + 42.0 * sums[2] + 59.1 * sums[3];
    most *= 0.34 * longest;
    t->net.place += 3.0 * t->net.base + 14.0 * most;
    t->net.turn += 6.0 * t->net.base + 50.0 * most;
    t->net.far += 0.1 * t->net.base + 3.5 * most;
}

/* Computes 1 / (x + y) of the corners, kept from infinity. */
FOOTPOINT_PART void footpoint_detail_KIND_near(REAL p, REAL q, REAL near[4])
{
    const REAL up = 0.5 * (p + q), down = 0.5 * (p - q), tiny = 1e-30;
    const REAL a = 1.0 + up + tiny, c = 1.0 - up + tiny, b = 1.0 - down + tiny,
               d = 1.0 + down + tiny;
    const REAL ac = a * c, bd = b * d, per = 1.0 / (ac * bd);
    near[0] = per * c * bd;
    near[1] = per * d * ac;
    near[2] = per * a * bd;
    near[3] = per * b * ac;
}

/* Computes the factors of a twist: value, first and second derivatives by xi and eta. */
FOOTPOINT_PART void footpoint_detail_KIND_twist(REAL along, REAL across, REAL p, REAL q, REAL near,
                                                REAL w[6])
{
    const REAL sx = 0.5 * along, sy = 0.5 * across, x = 0.5 + sx * p, y = 0.5 + sy * q;
    const REAL X = 1.0 - x, Y = 1.0 - y, f = X * X, g = Y * Y, a = x * near, b = y * near;
    const REAL aa = a * a, bb = b * b, h = x * y * a, hx = y * a * (1.0 + b), hy = x * aa;
    const REAL f1 = -2.0 * X, g1 = -2.0 * Y, fg = f * g, fg1 = f * g1, f1g = f1 * g;
    w[0] = fg * h;
    w[1] = sx * (f1g * h + fg * hx);
    w[2] = sy * (fg1 * h + fg * hy);
    w[3] = 0.5 * (g * h + f1g * hx + fg * (bb * b));
    w[4] = sx * sy * (f1 * g1 * h + f1g * hy + fg1 * hx + fg * (aa * (3.0 - (a + a))));
    w[5] = 0.5 * (f * h + fg1 * hy - fg * (aa * a));
}

FOOTPOINT_PART void footpoint_detail_KIND_local(const footpoint_detail_KIND_terms *t, REAL p,
                                                REAL q, footpoint_detail_local *l)
{
    const REAL w = 1.0 - p * p, a = p * w, a1 = 1.0 - 3.0 * (p * p), p2 = p + p, p6 = 6.0 * p;
    const REAL z = 1.0 - q * q, c1 = q * z, d1 = 1.0 - 3.0 * (q * q), q2 = q + q, q6 = 6.0 * q;
    REAL near[4], s[4][6];
    int c, i;
    footpoint_detail_KIND_near(p, q, near);
    FOOTPOINT_WHOLE
    for (c = 0; c < 4; c++)
        footpoint_detail_KIND_twist(c == 1 || c == 2 ? -1.0 : 1.0, c > 1 ? -1.0 : 1.0, p, q,
                                    near[c], s[c]);
    footpoint_detail_NET_local(&t->net, p, q, l);
    FOOTPOINT_WHOLE
    for (i = 0; i < 3; i++) {
        const REAL i0 = t->inner[0][i], i1 = t->inner[1][i], i2 = t->inner[2][i],
                   i3 = t->inner[3][i];
        const REAL e = w * i0 + a * i1, f = w * i2 + a * i3;
        const REAL e1 = a1 * i1 - p2 * i0, f1 = a1 * i3 - p2 * i2;
        l->d[i] -= z * e + c1 * f;
        l->u[i] += z * e1 + c1 * f1;
        l->v[i] += d1 * f - q2 * e;
        l->uu[i] -= z * (p6 * i1 + 2.0 * i0) + c1 * (p6 * i3 + 2.0 * i2);
        l->uv[i] += d1 * f1 - q2 * e1;
        l->vv[i] -= 2.0 * e + q6 * f;
        FOOTPOINT_WHOLE
        for (c = 0; c < 4; c++) {
            const REAL y = t->twist[c][i];
            l->d[i] -= s[c][0] * y;
            l->u[i] += s[c][1] * y;
            l->v[i] += s[c][2] * y;
            l->uu[i] += s[c][3] * y;
            l->uv[i] += s[c][4] * y;
            l->vv[i] += s[c][5] * y;
        }
    }
}

/* As in patch_gregory.h. */
FOOTPOINT_PART REAL footpoint_detail_KIND_inner(const footpoint_detail_KIND_terms *t, REAL p,
                                                REAL q)
{
    REAL near[4], sum = 0.0;
    int c;
    footpoint_detail_KIND_near(p, q, near);
    FOOTPOINT_WHOLE
    for (c = 0; c < 4; c++)
        sum += t->twists[c] * (16.5 + 2.92 * near[c]);
    return sum;
}

FOOTPOINT_PART REAL footpoint_detail_KIND_ball(REAL p, REAL q)
{
    const REAL most = 0.2475 - 0.125 * (fabs(p) + fabs(q));
    return most < 0.125 ? most : 0.125;
}
