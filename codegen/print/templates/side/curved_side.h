/* Pairs of curved faces and slave nodes side by side: the part in single precision. */

/* The terms of a face, one by one. */
typedef union {
    footpoint_detail_KIND_terms of;
    REAL number[sizeof(footpoint_detail_KIND_terms) / sizeof(REAL)];
} footpoint_detail_KIND_side_rounded;

/* Rounds terms in the unit of length, 0 if that is NaN. Sets `range` if the unit is out of range. */
FOOTPOINT_PART void footpoint_detail_KIND_side_round_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    enum { TERMS = sizeof t->narrow / sizeof *t->narrow[0] };
    int l, k;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        REAL length = 0.0;
        union {
            REAL_BITS bits;
            REAL number;
        } per;
        FOOTPOINT_WHOLE
        for (k = 0; k < 6; k++)
            length += fabs((REAL)t->term[k / 3][k % 3][l]);
        per.bits = 0x7f000000u - (footpoint_detail_bits(length) & 0x7f000000u);
        FOOTPOINT_WHOLE
        for (k = 0; k < TERMS; k++)
            t->narrow[k / 3][k % 3][l] = (REAL)t->term[k / 3][k % 3][l] * per.number;
        t->square[l] = (double)per.number * (double)per.number;
        t->range[l] = footpoint_detail_bits(length - 1e-25) | footpoint_detail_bits(1e30 - length) |
                      footpoint_detail_fast();
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_round(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_round_of(t, 8);
    else
        footpoint_detail_KIND_side_round_of(t, SIDE);
}

FOOTPOINT_PART void footpoint_detail_KIND_side_load(const BLOCK *t, int l,
                                                    footpoint_detail_KIND_side_rounded *face)
{
    enum { TERMS = sizeof t->narrow / sizeof *t->narrow[0] };
    int k;
    FOOTPOINT_WHOLE
    for (k = 0; k < TERMS; k++)
        face->number[k] = t->narrow[k / 3][k % 3][l];
}

FOOTPOINT_PART void footpoint_detail_KIND_side_begin_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        footpoint_detail_KIND_side_rounded face;
        REAL p, q;
        footpoint_detail_KIND_side_load(t, l, &face);
        footpoint_detail_KIND_start(&face.of, &p, &q);
        t->p[l] = footpoint_detail_KIND_side_kept(p);
        t->q[l] = footpoint_detail_KIND_side_kept(q);
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_begin(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_begin_of(t, 8);
    else
        footpoint_detail_KIND_side_begin_of(t, SIDE);
}

FOOTPOINT_PART void footpoint_detail_KIND_side_newton_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        footpoint_detail_KIND_side_rounded face;
        REAL p = t->p[l], q = t->q[l];
        footpoint_detail_KIND_side_load(t, l, &face);
        footpoint_detail_KIND_bare(&face.of, &p, &q);
        t->p[l] = footpoint_detail_KIND_side_kept(p);
        t->q[l] = footpoint_detail_KIND_side_kept(q);
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_newton(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_newton_of(t, 8);
    else
        footpoint_detail_KIND_side_newton_of(t, SIDE);
}

/* Takes a Newton step from (p,q), and computes there the values that prove corrections.
 *
 * F = (r_xi . D, r_eta . D) has the Jacobian -H. T(y) = y + A F(y), A being H^-1 as computed at (p,q), has the
 * derivative 1 - A H(y). Let `all` be the sum of the lengths of all steps since (p,q), in maximum norms: of Newton's
 * step, at most 1/25, and of one or two corrections A F, at most 2/25 each. In a ball of 5/4 `all` about (p,q),
 * within 1/4, that derivative is at most h = most + |A| L 5/4 all: `most` bounds |1 - A H(p,q)|, L is a Lipschitz
 * constant of H within 1/4. If h <= 1/5, then T contracts in the ball of 5/4 of the last correction about the point
 * from which it leads: a root lies there, within 5/4 h times that correction of the answer. H is positive definite at
 * the root: A is, and so is every matrix on the way from its inverse to H.
 *
 * L: rows of the derivatives of H add up to at most l_i = r_i a + 2 (r_1 + r_2) a_i + away third[i], as in
 * footpoint_detail_KIND_step() in double: r_i bounds |r_i|, a_i |r_i1| + |r_i2|, a = a_1 + a_2, `away` |D|, all
 * within 1/4.
 *
 * Rounding: terms are rounded once to single precision, so in units u of it errors are not larger than those that
 * footpoint_detail_KIND_step() counts in units of double: of tangents 10 u grown, of second derivatives 18 u grown,
 * of D 18 u far, where `grown` is the bound of footpoint_detail_KIND_growth(), here within 13/100, and far = |D| +
 * grown. Sums of absolute values, off by up to the root of 3 times that, get 4e-6 grown and 4e-6 far, so that all
 * bounds hold for the true vectors.
 *
 * `most`: entries of H are off by (10 u grown) (|r_i| + |r_j|) + 18 u grown |D| + 18 u far |r_ij| and, by products
 * and sums, 4 u (|r_i| |r_j| + |r_ij| |D|); a row of H adds up to 2 r_i grown + a_i |D|, of which A's entries and its
 * divisor add 8 u. In all a row is off by 12 u (grown (4 r_i + r_1 + r_2 + 3 |D|) + 3 a_i far).
 *
 * `off`: in double F_i is off by 20 spread size + 15 |D| units of |r_i| and by 10 grown units of |D|. Products of A
 * and F add 3 units of single precision of the sum of their absolute values, where 5 are counted. The new (p,q) is
 * rounded, which adds 2e-6 to the step, as |p| and |q| are below 30. Numbers lost to zero are below 1e-37, terms below
 * 1e-12, and `size` is at least 1 / 4: `off` has its small factor first, as 1e-16 / det may be lost.
 *
 * A step turns the normal u x v by at most (r_1 a_2 + r_2 a_1) step, rounding by less than a quarter of tiny (r_1 +
 * r_2). `flat` ensures that each of three steps does so by less than a third of its length, whose square is off by
 * 8 u |u|^2 |v|^2, less than a twentieth of 1e-5 |u|^2 |v|^2. So no tangents of an answer are parallel. */
FOOTPOINT_PART void footpoint_detail_KIND_side_prove_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    const REAL unit = REAL_UNIT, ball = 0.25;
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        const REAL p = t->p[l], q = t->q[l], x = fabs(p) + 0.13, y = fabs(q) + 0.13;
        footpoint_detail_KIND_side_rounded face;
        footpoint_detail_local r;
        footpoint_detail_newton n;
        REAL third[2], size, mixed, uv, grown, tiny, d, far, away, a1, a2, a, r1, r2, both, row,
            column;
        REAL place, least, most, square, step;
        footpoint_detail_KIND_side_load(t, l, &face);
        size = footpoint_detail_root_bound(footpoint_detail_KIND_square(&face.of));
        footpoint_detail_KIND_local(&face.of, p, q, &r);
        footpoint_detail_newton_of(&r, &n);
        footpoint_detail_KIND_third(&face.of, x, y, third);
        mixed = fabs(n.r12);
        grown = footpoint_detail_KIND_growth(x, y) * size;
        tiny = 4e-6 * grown;
        uv = footpoint_detail_sum(r.uv) + tiny;
        a1 = footpoint_detail_sum(r.uu) + uv + ball * third[0];
        a2 = footpoint_detail_sum(r.vv) + uv + ball * third[1];
        a = a1 + a2;
        r1 = footpoint_detail_sum(r.u) + tiny + ball * a1;
        r2 = footpoint_detail_sum(r.v) + tiny + ball * a2;
        both = r1 + r2;
        d = footpoint_detail_sum(r.d);
        far = d + grown;
        d += 4e-6 * far;
        away = d + ball * both;
        row = r1 * a + 2.0 * both * a1 + away * third[0];
        column = r2 * a + 2.0 * both * a2 + away * third[1];
        t->turn[l] = 1.27 * n.per *
                     footpoint_detail_KIND_side_greater(n.r22 * row + mixed * column,
                                                        mixed * row + n.r11 * column);
        place = both + 3.0 * d;
        row = grown * (4.0 * r1 + place) + 3.0 * (a1 * far);
        column = grown * (4.0 * r2 + place) + 3.0 * (a2 * far);
        t->most[l] = 12.2 * unit * n.per *
                     footpoint_detail_KIND_side_greater(n.r22 * row + mixed * column,
                                                        mixed * row + n.r11 * column);
        place = 20.0 * footpoint_detail_KIND_spread(x, y) * size + 15.0 * away;
        row = place * r1 + 10.0 * (grown * away);
        column = place * r2 + 10.0 * (grown * away);
        t->off[l] = 1.13e-16 *
                    footpoint_detail_KIND_side_greater(n.r22 * row + mixed * column,
                                                       mixed * row + n.r11 * column) *
                    n.per;
        t->a11[l] = n.r22 * n.per;
        t->a12[l] = -(n.r12 * n.per);
        t->a22[l] = n.r11 * n.per;
        step = 1.01 * footpoint_detail_KIND_side_greater(fabs(n.s), fabs(n.t)) + 2e-6;
        t->most[l] += t->turn[l] * step;
        t->p[l] = footpoint_detail_KIND_side_kept(p + n.s);
        t->q[l] = footpoint_detail_KIND_side_kept(q + n.t);
        t->bend[l] = r1 * a2 + r2 * a1;
        uv = footpoint_detail_dot(r.u, r.v);
        most = footpoint_detail_dot(r.u, r.u) * footpoint_detail_dot(r.v, r.v);
        square = most - uv * uv;
        t->flat[l] = 0.3 * footpoint_detail_root_bound(square) - tiny * both;
        least = 1e-3 * (n.r11 * n.r22);
        t->doubt[l] = footpoint_detail_bits(n.det - least) | footpoint_detail_bits(square - least) |
                      footpoint_detail_bits(square - 1e-5 * most) | footpoint_detail_bits(n.r11) |
                      footpoint_detail_bits(1e6 - d) | footpoint_detail_bits(1e2 - size) |
                      footpoint_detail_bits(0.04 - step) |
                      footpoint_detail_bits(t->flat[l] - t->bend[l] * step) |
                      footpoint_detail_bits(30.0 - footpoint_detail_KIND_side_greater(x, y)) |
                      t->range[l];
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_prove(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_prove_of(t, 8);
    else
        footpoint_detail_KIND_side_prove_of(t, SIDE);
}
