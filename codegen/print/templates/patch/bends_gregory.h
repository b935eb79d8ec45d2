/* Second derivatives of the Gregory patch over parts of it. */

/* Computes the net's, with inner points halfway between those of both edges. */
FOOTPOINT_PART void footpoint_detail_gregory_bends(const footpoint_detail_gregory_terms *t,
                                                   footpoint_detail_bends c)
{
    int k, i, a, b;
    footpoint_detail_net_bends(&t->net, c);
    for (k = 0; k < 4; k++) {
        const int right = k == 1 || k == 2, above = k > 1;
        const int p = right ? 2 : 1, q = above ? 2 : 1;
        REAL(*const pp)
        [3] = c + FOOTPOINT_DETAIL_PP + q, (*const qq)[3] = c + FOOTPOINT_DETAIL_QQ + 2 * p;
        for (i = 0; i < 3; i++) {
            const REAL inner = t->side[k][i] + 0.5 * t->twist[k][i], third = inner / 3.0;
            const REAL quarter = right == above ? 0.25 * inner : -0.25 * inner;
            pp[4 * right][i] -= third;
            pp[4 * !right][i] += 0.5 * third;
            qq[above][i] -= third;
            qq[!above][i] += 0.5 * third;
            for (a = 0; a < 2; a++)
                for (b = 0; b < 2; b++)
                    c[FOOTPOINT_DETAIL_PQ + 3 * (a ? 1 : 2 * right) + (b ? 1 : 2 * above)][i] +=
                        a == b ? quarter : -quarter;
        }
    }
}

/* Adds the second derivatives of f(x) f(y) g, g = x y (x - y) / (2 (x + y)), times e . twist, over a small part to
 * ranges, from the values in its middle (p,q): the factors of `twist` in footpoint_detail_gregory_corners minus half of
 * those of `side`, f(x) f(y) x y. Third derivatives are at most 17.6 + 2.92 / (x + y), see
 * footpoint_detail_gregory_inner. */
FOOTPOINT_COLD void footpoint_detail_gregory_widen_near(const footpoint_detail_gregory_terms *t,
                                                        const REAL e[3], REAL p, REAL q, REAL reach,
                                                        footpoint_detail_range *r)
{
    REAL near[4], w[6][4];
    int k, i;
    footpoint_detail_gregory_near(p, q, near);
    footpoint_detail_gregory_corners(p, q, near, w);
    for (k = 0; k < 4; k++) {
        const REAL sx = k == 1 || k == 2 ? -0.5 : 0.5, sy = k > 1 ? -0.5 : 0.5;
        const REAL x = 0.5 + sx * p, y = 0.5 + sy * q, X = 1.0 - x, Y = 1.0 - y;
        const REAL s[3] = {(1.5 * x - 1.0) * (y * (Y * Y)),
                           sx * sy * (X * (X - (x + x)) * (Y * (Y - (y + y)))),
                           (1.5 * y - 1.0) * (x * (X * X))};
        const REAL twist = footpoint_detail_dot(e, t->twist[k]);
        for (i = 0; i < 3; i++) {
            r->middle[i] += twist * (w[3 + i][k] - 0.5 * s[i]);
            r->half[i] += fabs(twist) * (17.6 + 2.92 * near[k]) * reach;
        }
    }
}

/* Adds them over any part, from low to high, 0 to 1 across the patch.
 *
 * With X = 1 - x, Y = 1 - y, a = x / (x + y), b = 1 - a, |g| <= x y / 2, |g_x| = y |a (1 + b) - 1/2| <= y / 2, |g_y| <=
 * x / 2, g_xx = 2 b^3, |g_xy| = |a^2 (3 - 2 a) - 1/2| <= 1/2, the derivative by x twice is at most Y^2 y (2 - x) + 2 X^2
 * Y^2 b^3, and the mixed derivative X Y (2 x y + x Y + X y + X Y / 2) = (1 - x^2) (1 - y^2) / 2. Over the four corners,
 * Y^2 y adds up to at most Y y <= 1/4, 2 - x to 3, X^2 Y^2 to 1, 1 - x^2 to 3/2. By xi and eta they are 1/4 of that; b
 * <= 1 / (1 + x). */
FOOTPOINT_PART void footpoint_detail_gregory_widen(const footpoint_detail_gregory_terms *t,
                                                   const REAL e[3], const REAL low[2],
                                                   const REAL high[2], footpoint_detail_range *r)
{
    const REAL p = (low[0] + high[0]) - 1.0, q = (low[1] + high[1]) - 1.0;
    const REAL reach = footpoint_detail_greater(high[0] - low[0], high[1] - low[1]);
    const REAL b = 1.0 / (1.0 + footpoint_detail_least(low[0], 1.0 - high[0]));
    const REAL a = 1.0 / (1.0 + footpoint_detail_least(low[1], 1.0 - high[1]));
    REAL most = 0.0;
    int k;
    if (reach < 0.02 && reach < footpoint_detail_gregory_ball(p, q)) {
        footpoint_detail_gregory_widen_near(t, e, p, q, reach, r);
        return;
    }
    for (k = 0; k < 4; k++)
        most = footpoint_detail_greater(most, fabs(footpoint_detail_dot(e, t->twist[k])));
    r->half[0] += most * (0.19 + 0.501 * (b * b * b));
    r->half[1] += 0.29 * most;
    r->half[2] += most * (0.19 + 0.501 * (a * a * a));
}

/* Returns how far inner points move the patch at most: x X y Y, added up over the corners, is at most 1/16. */
FOOTPOINT_PART REAL footpoint_detail_gregory_moved(const footpoint_detail_gregory_terms *t)
{
    REAL most = 0.0;
    int k;
    for (k = 0; k < 4; k++)
        most = footpoint_detail_greater(most, footpoint_detail_sum(t->side[k]) + t->twists[k]);
    return most / 16.0;
}
