/* The Gregory patch near one of its points: a net, and the difference of its inner points from the net's. */

/* Corner c adds f(x) f(y) (x y side + x^2 y / (x + y) twist), f(x) = (1 - x)^2, where x and y are half the distances
 * from the corner along xi and eta. side: nine times the difference of the inner point of the edge along eta from the
 * net's; twist: the other edge's difference minus that. twists: sums of the absolute coordinates. All sides add up to
 * (1 - p^2) (1 - q^2) (inner0 + p inner1 + q inner2 + p q inner3). */
typedef struct {
    footpoint_detail_net net;
    REAL inner[4][4], side[4][4], twist[4][4], twists[4];
} footpoint_detail_gregory_terms;

/* Handles b of the corners along xi, or along eta, from the corner, side by side, and turn = n x b. For a unit normal n,
 * the other handle is k turn + l b. */
typedef struct {
    REAL b[3][4], turn[3][4], k[4], l[4];
} footpoint_detail_gregory_ends;

/* Computes handles along xi (m = 0) or along eta (1), and turns. */
FOOTPOINT_PART void footpoint_detail_gregory_handles(footpoint_detail_corners *of, int m,
                                                     footpoint_detail_gregory_ends *t)
{
    const REAL third = 1.0 / 3.0;
    int c, i;
    FOOTPOINT_UNROLL
    for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++) {
        footpoint_detail_pack n[3], b[3];
        FOOTPOINT_UNROLL
        for (i = 0; i < 3; i++) {
            n[i] = footpoint_detail_of(of->n[i])[c];
            b[i] = third * (footpoint_detail_of(of->edge[m][i])[c] -
                            footpoint_detail_of(of->rise[m])[c] * n[i]);
            footpoint_detail_into(t->b[i])[c] = b[i];
        }
        footpoint_detail_into(t->turn[0])[c] = n[1] * b[2] - n[2] * b[1];
        footpoint_detail_into(t->turn[1])[c] = n[2] * b[0] - n[0] * b[2];
        footpoint_detail_into(t->turn[2])[c] = n[0] * b[1] - n[1] * b[0];
    }
}

/* Computes k and l of both edges of the corners, and bounds the quotients of the squares of edges and handles. */
FOOTPOINT_PART void footpoint_detail_gregory_parts(footpoint_detail_corners *of,
                                                   footpoint_detail_gregory_ends *t,
                                                   footpoint_detail_gregory_ends *o,
                                                   REAL quotient[4])
{
    int c;
    FOOTPOINT_UNROLL
    for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++) {
        const footpoint_detail_pack s = footpoint_detail_beside(t->b, t->b, c);
        const footpoint_detail_pack r = footpoint_detail_beside(o->b, o->b, c);
        const footpoint_detail_pack along = footpoint_detail_beside(t->b, o->b, c);
        const footpoint_detail_pack volume = footpoint_detail_beside(t->turn, o->b, c);
        const footpoint_detail_pack per = 1.0 / (s * r), ps = per * r, pr = per * s;
        footpoint_detail_into(t->k)[c] = volume * ps;
        footpoint_detail_into(o->k)[c] = -volume * pr;
        footpoint_detail_into(t->l)[c] = along * ps;
        footpoint_detail_into(o->l)[c] = along * pr;
        footpoint_detail_into(quotient)[c] =
            footpoint_detail_beside_most(footpoint_detail_beside(of->edge[0], of->edge[0], c) * ps,
                                         footpoint_detail_beside(of->edge[1], of->edge[1], c) * pr);
    }
}

/* Computes nine times the edges' parts of the inner points, minus the net's. `over`: orders numbers by the corners at
 * the edges' other ends. */
FOOTPOINT_PART void footpoint_detail_gregory_make(REAL edge[4][4],
                                                  const footpoint_detail_gregory_ends *t,
                                                  const footpoint_detail_gregory_ends *o, int over,
                                                  REAL made[3][4])
{
    REAL k[4], l[4], there[4], turn[4];
    int c, i;
    footpoint_detail_over(t->k, over, k);
    footpoint_detail_over(t->l, over, l);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        footpoint_detail_over(t->b[i], over, there);
        footpoint_detail_over(t->turn[i], over, turn);
        FOOTPOINT_UNROLL
        for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++) {
            const footpoint_detail_pack K = footpoint_detail_of(t->k)[c],
                                        L = footpoint_detail_of(t->l)[c];
            const footpoint_detail_pack b = footpoint_detail_of(t->b[i])[c];
            const footpoint_detail_pack middle =
                footpoint_detail_of(edge[i])[c] + (footpoint_detail_of(there)[c] - b);
            footpoint_detail_into(made[i])[c] =
                3.0 * ((K - footpoint_detail_of(k)[c]) * footpoint_detail_of(t->turn[i])[c] -
                       K * footpoint_detail_of(turn)[c] +
                       ((L + L) * middle - footpoint_detail_of(l)[c] * b)) -
                9.0 * footpoint_detail_of(o->b[i])[c];
        }
    }
}

/* Computes `inner` from `side`. */
FOOTPOINT_PART void footpoint_detail_gregory_inside(footpoint_detail_gregory_terms *t)
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
        const footpoint_detail_pack a = footpoint_detail_of(t->side[0])[i],
                                    b = footpoint_detail_of(t->side[1])[i];
        const footpoint_detail_pack c = footpoint_detail_of(t->side[2])[i],
                                    d = footpoint_detail_of(t->side[3])[i];
        const footpoint_detail_pack s = a + b, S = c + d, r = b - a, R = c - d;
        footpoint_detail_into(t->inner[0])[i] = 0.015625 * (s + S);
        footpoint_detail_into(t->inner[1])[i] = 0.015625 * (r + R);
        footpoint_detail_into(t->inner[2])[i] = 0.015625 * (S - s);
        footpoint_detail_into(t->inner[3])[i] = 0.015625 * (R - r);
    }
}

/* Completes the patch.
 *
 * Rounding, with d* the longest edge and w >= 2.98 the largest quotient of an edge and a handle along it, as lengths,
 * and M = w^2 d*: handles are off by 3.2 u d*, so b / |b|^2 by 3.2 u w and 4 u w of products; |b| <= d* / 3. At the
 * other end of an edge handles are at most w / 3 times as long. So k turn and l b are off by 1.7 u M, twice middle, with
 * middle <= 5 / 3 of an edge, by 13 u M, and made[] <= 1.9 M by 64 u M including the sum. `inner` is 1/64 of four of
 * these: 4.3 u M, less than 0.12 M. In d, factors add up to 1.93, and twists of 130 u M weigh 0.03: 13, and 4 u M of
 * products. In tangents 5.6 and 0.08: 35, and 14 u M. In second derivatives 16 and 0.6: 150, and 30 u M; weights of
 * twists <= 3.8 M are off by 0.5 (3 u / (x + y) / 2 + 20 u), 330 u M at x + y = 0.01. 18, 60 and 280 2.5 allow for
 * all. */
FOOTPOINT_PART void footpoint_detail_gregory_shape(const REAL *const *n,
                                                   footpoint_detail_net_bent bent[4],
                                                   footpoint_detail_gregory_terms *t)
{
    footpoint_detail_corners of;
    footpoint_detail_gregory_ends xi, eta;
    REAL first[3][4], second[3][4], sum[4], size[4], quotient[4], zero[4], third, most;
    int c, i;
    t->net.tilt = footpoint_detail_corners_of(n, bent, &of);
    footpoint_detail_corners_bends(&of, n, bent);
    footpoint_detail_net_expand(bent, &t->net);
    footpoint_detail_gregory_handles(&of, 0, &xi);
    footpoint_detail_gregory_handles(&of, 1, &eta);
    footpoint_detail_gregory_parts(&of, &xi, &eta, quotient);
    footpoint_detail_gregory_make(of.edge[0], &xi, &eta, 1, first);
    footpoint_detail_gregory_make(of.edge[1], &eta, &xi, 3, second);
    FOOTPOINT_UNROLL
    for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++) {
        FOOTPOINT_UNROLL
        for (i = 0; i < 3; i++)
            footpoint_detail_into(first[i])[c] -= footpoint_detail_of(second[i])[c];
        footpoint_detail_into(sum)[c] = footpoint_detail_beside_sizes(second, c);
        footpoint_detail_into(t->twists)[c] = footpoint_detail_beside_sizes(first, c);
        footpoint_detail_into(size)[c] =
            footpoint_detail_beside_most(footpoint_detail_beside_sizes(of.edge[0], c),
                                         footpoint_detail_beside_sizes(of.edge[1], c));
    }
    footpoint_detail_join(0.0, 0.0, 0.0, 0.0, zero);
    footpoint_detail_transpose(second[0], second[1], second[2], zero, t->side);
    footpoint_detail_gregory_inside(t);
    footpoint_detail_transpose(first[0], first[1], first[2], zero, t->twist);
    most = footpoint_detail_corners_most(quotient) * footpoint_detail_corners_most(size);
    third = 2.2 * ((sum[0] + sum[1]) + (sum[2] + sum[3]));
    t->net.third[0] += third;
    t->net.third[1] += third;
    t->net.place += 18.0 * most;
    t->net.turn += 60.0 * most;
    t->net.far += 2.5 * most;
}

/* Computes the derivatives of x by xi and of y by eta. */
FOOTPOINT_PART void footpoint_detail_gregory_signs(REAL along[4], REAL across[4])
{
    footpoint_detail_join(0.5, -0.5, -0.5, 0.5, along);
    footpoint_detail_join(0.5, 0.5, -0.5, -0.5, across);
}

/* Computes 1 / (x + y) of the corners, kept from infinity. */
FOOTPOINT_PART void footpoint_detail_gregory_near(REAL p, REAL q, REAL near[4])
{
    REAL along[4], across[4];
    int c;
    footpoint_detail_gregory_signs(along, across);
    FOOTPOINT_UNROLL
    for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++)
        footpoint_detail_into(near)[c] = 1.0 / (1e-30 + (1.0 + footpoint_detail_of(along)[c] * p +
                                                         footpoint_detail_of(across)[c] * q));
}

/* Computes the corners' factors of twist[], see above: values, first and second derivatives by xi and eta, indexed by
 * corner. */
FOOTPOINT_PART void footpoint_detail_gregory_corners(REAL p, REAL q, const REAL near[4],
                                                     REAL twist[6][4])
{
    REAL along[4], across[4];
    int c;
    footpoint_detail_gregory_signs(along, across);
    FOOTPOINT_UNROLL
    for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++) {
        const footpoint_detail_pack sx = footpoint_detail_of(along)[c];
        const footpoint_detail_pack sy = footpoint_detail_of(across)[c];
        const footpoint_detail_pack x = 0.5 + sx * p, y = 0.5 + sy * q, X = 1.0 - x, Y = 1.0 - y;
        const footpoint_detail_pack f = X * X, g = Y * Y;
        const footpoint_detail_pack a = x * footpoint_detail_of(near)[c];
        const footpoint_detail_pack b = y * footpoint_detail_of(near)[c];
        const footpoint_detail_pack h = x * y * a, hx = y * a * (1.0 + b), hy = x * (a * a);
        const footpoint_detail_pack f1 = -2.0 * X, g1 = -2.0 * Y;
        const footpoint_detail_pack fg = f * g, fg1 = f * g1, f1g = f1 * g;
        footpoint_detail_into(twist[0])[c] = fg * h;
        footpoint_detail_into(twist[1])[c] = sx * (f1g * h + fg * hx);
        footpoint_detail_into(twist[2])[c] = sy * (fg1 * h + fg * hy);
        footpoint_detail_into(twist[3])[c] = 0.5 * (g * h + f1g * hx + fg * (b * b * b));
        footpoint_detail_into(twist[4])[c] =
            sx * sy * (f1 * g1 * h + f1g * hy + fg1 * hx + fg * (a * a * (3.0 - (a + a))));
        footpoint_detail_into(twist[5])[c] = 0.5 * (f * h + fg1 * hy - fg * (a * a * a));
    }
}

/* Computes tangents and second derivatives at (p,q), and d = xS - r. */
FOOTPOINT_PART void footpoint_detail_gregory_local(const footpoint_detail_gregory_terms *t, REAL p,
                                                   REAL q, footpoint_detail_local *l)
{
    const REAL w = 1.0 - p * p, a = p * w, a1 = 1.0 - 3.0 * (p * p), p2 = p + p, p6 = 6.0 * p;
    const REAL z = 1.0 - q * q, e = q * z, e1 = 1.0 - 3.0 * (q * q), q2 = q + q, q6 = 6.0 * q;
    REAL near[4], s[6][4];
    int c, i;
    footpoint_detail_net_local(&t->net, p, q, l);
    footpoint_detail_gregory_near(p, q, near);
    footpoint_detail_gregory_corners(p, q, near, s);
    FOOTPOINT_UNROLL
    for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
        const footpoint_detail_pack i0 = footpoint_detail_of(t->inner[0])[i],
                                    i1 = footpoint_detail_of(t->inner[1])[i];
        const footpoint_detail_pack i2 = footpoint_detail_of(t->inner[2])[i],
                                    i3 = footpoint_detail_of(t->inner[3])[i];
        const footpoint_detail_pack x = w * i0 + a * i1, y = w * i2 + a * i3;
        const footpoint_detail_pack x1 = a1 * i1 - p2 * i0, y1 = a1 * i3 - p2 * i2;
        footpoint_detail_into(l->d)[i] -= z * x + e * y;
        footpoint_detail_into(l->u)[i] += z * x1 + e * y1;
        footpoint_detail_into(l->v)[i] += e1 * y - q2 * x;
        footpoint_detail_into(l->uu)[i] -= z * (p6 * i1 + 2.0 * i0) + e * (p6 * i3 + 2.0 * i2);
        footpoint_detail_into(l->uv)[i] += e1 * y1 - q2 * x1;
        footpoint_detail_into(l->vv)[i] -= 2.0 * x + q6 * y;
        FOOTPOINT_UNROLL
        for (c = 0; c < 4; c++) {
            const footpoint_detail_pack k = footpoint_detail_of(t->twist[c])[i];
            footpoint_detail_into(l->d)[i] -= s[0][c] * k;
            footpoint_detail_into(l->u)[i] += s[1][c] * k;
            footpoint_detail_into(l->v)[i] += s[2][c] * k;
            footpoint_detail_into(l->uu)[i] += s[3][c] * k;
            footpoint_detail_into(l->uv)[i] += s[4][c] * k;
            footpoint_detail_into(l->vv)[i] += s[5][c] * k;
        }
    }
}

/* Returns the excess of third derivatives over the net's bounds, inside: the twists' are less than 16.5 + 2.92 / (x +
 * y) times those, within a quarter of x + y.
 *
 * Derivation: h = x^2 y / (x + y), a = x / (x + y), b = 1 - a: h_x = y a (1 + b), h_y = x a^2, h_xx = 2 b^3, h_xy = a^2
 * (3 - 2 a), h_yy = -2 a^3, and the third derivatives -6 b^3, 6 a b^2, -6 a^2 b, 6 a^3 over x + y. There x, y are at
 * most 1.0625, a and b 7/6, f 1.13, f' 2.125, f'' 2. The third derivatives add 6/8 f f (|b^3| + 2 |a| b^2 + a^2 |b|) /
 * (0.75 (x + y)) <= 1.28 2.08 / (x + y), other terms 14.5 and 15.2 by Leibniz' rule. For `side`, m = x f and its
 * derivatives are at most 0.149, 1.27, 4.38, 6: (6 0.149 + 3 4.38 1.27) / 8 = 2.2, in
 * footpoint_detail_gregory_expand. */
FOOTPOINT_PART REAL footpoint_detail_gregory_inner(const footpoint_detail_gregory_terms *t, REAL p,
                                                   REAL q)
{
    REAL near[4], sum = 0.0;
    int c;
    footpoint_detail_gregory_near(p, q, near);
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++)
        sum += t->twists[c] * (16.5 + 2.92 * near[c]);
    return sum;
}

/* Returns the excess of r_ppq over the net's bound along edges q = -1 and 1, and of r_pqq along the others: for the two
 * corners of an edge |f'' x + 2 f'| / 8 <= 0.55 twists each, and 0 along the others. r_ppp and r_qqq along edges are
 * the net's. */
FOOTPOINT_FN REAL footpoint_detail_gregory_rim(const footpoint_detail_gregory_terms *t)
{
    return 0.55 * (t->twists[0] + t->twists[1] + t->twists[2] + t->twists[3]);
}

/* Returns the distance from (p,q) within which inner bounds hold, and not nearer to a corner than x + y = 0.01, where
 * rounding takes the digits of second derivatives. */
FOOTPOINT_PART REAL footpoint_detail_gregory_ball(REAL p, REAL q)
{
    return 0.2475 - footpoint_detail_net_most(0.125 * (fabs(p) + fabs(q)), 0.1225);
}

/* Returns the ball for a step from a near start: a small one, because third derivatives are large. */
FOOTPOINT_PART REAL footpoint_detail_gregory_proof_ball(REAL step)
{
    return 1.5 * step + 1e-6;
}

/* Leaves a step as it is, without third derivatives. */
FOOTPOINT_PART void footpoint_detail_gregory_bend(const footpoint_detail_gregory_terms *of, REAL p,
                                                  REAL q, const footpoint_detail_local *l,
                                                  const footpoint_detail_newton *n, REAL h[2])
{
    (void)of, (void)p, (void)q, (void)l, (void)n, (void)h;
}
