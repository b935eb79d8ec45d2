/* The Gregory patch near one of its points: a net, and the difference of its inner points from the net's. */

/* Corner c adds f(x) f(y) (x y side + x^2 y / (x + y) twist), f(x) = (1 - x)^2, where x and y are half the distances
 * from the corner along xi and eta. side: nine times the difference of the inner point of the edge along eta from the
 * net's; twist: the other edge's difference minus that. twists: sums of the absolute coordinates. */
typedef struct {
    footpoint_detail_net net;
    REAL side[4][4], twist[4][4], twists[4];
} footpoint_detail_gregory_terms;

/* Returns which of AB, DC, AD, BC handle m of corner c lies along. */
FOOTPOINT_PART int footpoint_detail_gregory_edge(int c, int m)
{
    return m ? (c == 0 || c == 3 ? 2 : 3) : c / 2;
}

/* Computes the corners' handles b[c][0] along xi and b[c][1] along eta. */
FOOTPOINT_PART void footpoint_detail_gregory_handles(const footpoint_detail_net_bent bent[4],
                                                     REAL b[4][2][4])
{
    const REAL third = 1.0 / 3.0, rise = 8.0 / 3.0;
    int c, m, i;
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++) {
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const footpoint_detail_net_bent *const t = &bent[footpoint_detail_gregory_edge(c, m)];
            const int ends = m ? c > 1 : c == 1 || c == 2;
            FOOTPOINT_UNROLL
            for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
                const footpoint_detail_pack edge = third * footpoint_detail_of(t->edge)[i];
                if (ends)
                    footpoint_detail_into(b[c][m])[i] =
                        rise * footpoint_detail_of(t->end)[i] - edge;
                else
                    footpoint_detail_into(b[c][m])[i] =
                        edge - rise * footpoint_detail_of(t->begin)[i];
            }
        }
    }
}

/* Computes, for unit normals, handle b[c][1 - m] as k[c][m] n x b[c][m] + l[c][m] b[c][m]; turn: n x b. Returns the
 * largest quotient of the squares of an edge and a handle along it. */
FOOTPOINT_PART REAL footpoint_detail_gregory_parts(const REAL *const *n,
                                                   const footpoint_detail_net_bent bent[4],
                                                   REAL b[4][2][4], REAL turn[4][2][4],
                                                   REAL k[4][2], REAL l[4][2])
{
    REAL most = 0.0, square[4];
    int c, m;
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++)
        square[c] = footpoint_detail_dot(bent[c].edge, bent[c].edge);
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++) {
        const REAL along = footpoint_detail_dot(b[c][0], b[c][1]);
        const REAL s = footpoint_detail_dot(b[c][0], b[c][0]);
        const REAL t = footpoint_detail_dot(b[c][1], b[c][1]), per = 1.0 / (s * t);
        REAL volume;
        footpoint_detail_across(n[c], b[c][0], turn[c][0]);
        footpoint_detail_across(n[c], b[c][1], turn[c][1]);
        volume = footpoint_detail_dot(turn[c][0], b[c][1]);
        k[c][0] = volume * (per * t);
        k[c][1] = -volume * (per * s);
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const REAL inverse = per * (m ? s : t);
            l[c][m] = along * inverse;
            most = footpoint_detail_net_most(most,
                                             square[footpoint_detail_gregory_edge(c, m)] * inverse);
        }
    }
    return most;
}

/* Completes the patch.
 *
 * Rounding, with d* the longest edge and w >= 2.98 the largest quotient of an edge and a handle along it, as lengths:
 * handles are off by 3.2 u d*, so b / |b|^2 by 3.2 u w and 4 u w of products; |b| <= d* / 3. At the other end of an
 * edge handles are at most w / 3 times as long. So k turn and l b are off by 1.7 u w^2 d*, twice middle, with middle <=
 * 5 / 3 of an edge, by 13 u w^2 d*, and made[] <= 1.9 w^2 d* by 64 u w^2 d* including the sum. In d the four corners
 * weigh 1 / 16 of that, in tangents 1 / 8 and 0.06 of twice that for x / (x + y), in second derivatives 3 / 8 and 0.6
 * of twice that: 5, 12 and 100 u w^2 d*. Weights are off by some 20 u of themselves, those in second derivatives by 0.5
 * (3 u / (x + y) / 2 + 20 u) of twist <= 3.8 w^2 d*, 330 u w^2 d* at x + y = 0.01. 18, 60 and 280 2.5 allow for
 * both. */
FOOTPOINT_PART void footpoint_detail_gregory_shape(const REAL *const *n,
                                                   footpoint_detail_net_bent bent[4],
                                                   footpoint_detail_gregory_terms *t)
{
    REAL b[4][2][4], turn[4][2][4], k[4][2], l[4][2], sides[4], third, most, longest = 0.0;
    int c, m, i;
    footpoint_detail_net_expand(n, bent, &t->net);
    footpoint_detail_gregory_handles(bent, b);
    most = footpoint_detail_gregory_parts(n, bent, b, turn, k, l);
    FOOTPOINT_UNROLL
    for (c = 0; c < 4; c++) {
        REAL made[2][4];
        FOOTPOINT_UNROLL
        for (m = 0; m < 2; m++) {
            const int o = m ? 3 - c : c ^ 1, ends = m ? c > 1 : c == 1 || c == 2;
            const footpoint_detail_pack *const edge =
                footpoint_detail_of(bent[footpoint_detail_gregory_edge(c, m)].edge);
            const footpoint_detail_pack *const here = footpoint_detail_of(b[c][m]);
            const footpoint_detail_pack *const there = footpoint_detail_of(b[o][m]);
            const REAL sum = k[c][m] - k[o][m], twice = 2.0 * l[c][m], sign = ends ? -1.0 : 1.0;
            FOOTPOINT_UNROLL
            for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
                const footpoint_detail_pack middle = sign * edge[i] + (there[i] - here[i]);
                footpoint_detail_into(made[m])[i] =
                    3.0 * (sum * footpoint_detail_of(turn[c][m])[i] -
                           k[c][m] * footpoint_detail_of(turn[o][m])[i] +
                           (twice * middle - l[o][m] * here[i])) -
                    9.0 * footpoint_detail_of(b[c][1 - m])[i];
            }
        }
        FOOTPOINT_UNROLL
        for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
            const footpoint_detail_pack side = footpoint_detail_of(made[1])[i];
            footpoint_detail_into(t->side[c])[i] = side;
            footpoint_detail_into(t->twist[c])[i] = footpoint_detail_of(made[0])[i] - side;
            if (c)
                footpoint_detail_into(sides)[i] += footpoint_detail_absolute(side);
            else
                footpoint_detail_into(sides)[i] = footpoint_detail_absolute(side);
        }
        t->twists[c] = footpoint_detail_sum(t->twist[c]);
        longest = footpoint_detail_net_most(longest, footpoint_detail_sum(bent[c].edge));
    }
    most *= longest;
    third = 2.2 * (sides[0] + sides[1] + sides[2]);
    t->net.third[0] += third;
    t->net.third[1] += third;
    t->net.place += 18.0 * most;
    t->net.turn += 60.0 * most;
    t->net.far += 2.5 * most;
}

/* Computes 1 / (x + y) of the corners, kept from infinity. */
FOOTPOINT_PART void footpoint_detail_gregory_near(REAL p, REAL q, REAL near[4])
{
    const REAL up = 0.5 * (p + q), down = 0.5 * (p - q), tiny = 1e-30;
    const REAL a = 1.0 + up + tiny, c = 1.0 - up + tiny, b = 1.0 - down + tiny,
               d = 1.0 + down + tiny;
    const REAL ac = a * c, bd = b * d, per = 1.0 / (ac * bd);
    footpoint_detail_join(per * c * bd, per * d * ac, per * a * bd, per * b * ac, near);
}

/* Computes the corners' additions, see above, as factors of side[] and of twist[]: values, first and second derivatives
 * by xi and eta, indexed by corner. */
FOOTPOINT_PART void footpoint_detail_gregory_corners(REAL p, REAL q, const REAL near[4],
                                                     REAL side[6][4], REAL twist[6][4])
{
    REAL along[4], across[4];
    int c;
    footpoint_detail_join(0.5, -0.5, -0.5, 0.5, along);
    footpoint_detail_join(0.5, 0.5, -0.5, -0.5, across);
    FOOTPOINT_UNROLL
    for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++) {
        const footpoint_detail_pack sx = footpoint_detail_of(along)[c];
        const footpoint_detail_pack sy = footpoint_detail_of(across)[c];
        const footpoint_detail_pack x = 0.5 + sx * p, y = 0.5 + sy * q, X = 1.0 - x, Y = 1.0 - y;
        const footpoint_detail_pack f = X * X, g = Y * Y, m = x * f, n = y * g;
        const footpoint_detail_pack a = x * footpoint_detail_of(near)[c];
        const footpoint_detail_pack b = y * footpoint_detail_of(near)[c];
        const footpoint_detail_pack m1 = sx * (X * (X - (x + x))), n1 = sy * (Y * (Y - (y + y)));
        const footpoint_detail_pack h = x * y * a, hx = y * a * (1.0 + b), hy = x * (a * a);
        const footpoint_detail_pack f1 = -2.0 * X, g1 = -2.0 * Y;
        const footpoint_detail_pack fg = f * g, fg1 = f * g1, f1g = f1 * g;
        footpoint_detail_into(side[0])[c] = m * n;
        footpoint_detail_into(side[1])[c] = m1 * n;
        footpoint_detail_into(side[2])[c] = m * n1;
        footpoint_detail_into(side[3])[c] = (1.5 * x - 1.0) * n;
        footpoint_detail_into(side[4])[c] = m1 * n1;
        footpoint_detail_into(side[5])[c] = (1.5 * y - 1.0) * m;
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
    REAL near[4], s[6][4], w[6][4];
    int c, i;
    footpoint_detail_net_local(&t->net, p, q, l);
    footpoint_detail_gregory_near(p, q, near);
    footpoint_detail_gregory_corners(p, q, near, s, w);
    FOOTPOINT_UNROLL
    for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
        footpoint_detail_pack d = footpoint_detail_of(l->d)[i], u = footpoint_detail_of(l->u)[i];
        footpoint_detail_pack v = footpoint_detail_of(l->v)[i], uu = footpoint_detail_of(l->uu)[i];
        footpoint_detail_pack uv = footpoint_detail_of(l->uv)[i],
                              vv = footpoint_detail_of(l->vv)[i];
        FOOTPOINT_UNROLL
        for (c = 0; c < 4; c++) {
            const footpoint_detail_pack y = footpoint_detail_of(t->side[c])[i];
            const footpoint_detail_pack z = footpoint_detail_of(t->twist[c])[i];
            d -= s[0][c] * y + w[0][c] * z;
            u += s[1][c] * y + w[1][c] * z;
            v += s[2][c] * y + w[2][c] * z;
            uu += s[3][c] * y + w[3][c] * z;
            uv += s[4][c] * y + w[4][c] * z;
            vv += s[5][c] * y + w[5][c] * z;
        }
        footpoint_detail_into(l->d)[i] = d;
        footpoint_detail_into(l->u)[i] = u;
        footpoint_detail_into(l->v)[i] = v;
        footpoint_detail_into(l->uu)[i] = uu;
        footpoint_detail_into(l->uv)[i] = uv;
        footpoint_detail_into(l->vv)[i] = vv;
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
