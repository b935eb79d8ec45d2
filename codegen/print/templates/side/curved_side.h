/* Pairs of curved faces and slave nodes side by side: the part in single precision. */

/* The terms of a face, one by one. */
typedef union {
    footpoint_detail_KIND_terms of;
    REAL number[sizeof(footpoint_detail_KIND_terms) / sizeof(REAL)];
} footpoint_detail_KIND_side_rounded;

/* Rounds terms in the unit of length, and starts. Sets `range` if the unit is out of range. */
FOOTPOINT_APART void footpoint_detail_KIND_side_begin(BLOCK *FOOTPOINT_RESTRICT t)
{
    enum { TERMS = sizeof t->narrow / sizeof *t->narrow[0] };
    int l, k;
    FOOTPOINT_EACH
    for (l = 0; l < SIDE; l++) {
        footpoint_detail_KIND_side_rounded face;
        const REAL size = t->size[l];
        union {
            REAL_BITS bits;
            REAL number;
        } per;
        per.bits = 0x7f000000u - (footpoint_detail_bits(size) & 0x7f800000u);
        FOOTPOINT_WHOLE
        for (k = 0; k < TERMS; k++) {
            face.number[k] = (REAL)t->term[k / 3][k % 3][l] * per.number;
            t->narrow[k / 3][k % 3][l] = face.number[k];
        }
        t->size[l] = size * per.number;
        t->square[l] = (double)per.number * (double)per.number;
        t->range[l] = footpoint_detail_bits(size - 1e-25) | footpoint_detail_bits(1e30 - size) |
                      footpoint_detail_fast();
        footpoint_detail_KIND_start(&face.of, &t->p[l], &t->q[l]);
    }
}

FOOTPOINT_PART void footpoint_detail_KIND_side_load(const BLOCK *t, int l,
                                                    footpoint_detail_KIND_side_rounded *face)
{
    enum { TERMS = sizeof t->narrow / sizeof *t->narrow[0] };
    int k;
    FOOTPOINT_WHOLE
    for (k = 0; k < TERMS; k++)
        face->number[k] = t->narrow[k / 3][k % 3][l];
    face->of.size = t->size[l];
}

FOOTPOINT_APART void footpoint_detail_KIND_side_newton(BLOCK *FOOTPOINT_RESTRICT t)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < SIDE; l++) {
        footpoint_detail_KIND_side_rounded face;
        REAL p = t->p[l], q = t->q[l];
        footpoint_detail_KIND_side_load(t, l, &face);
        footpoint_detail_KIND_bare(&face.of, &p, &q);
        t->p[l] = p;
        t->q[l] = q;
    }
}

/* Computes at (p,q) values that prove corrections.
 *
 * F has the Jacobian -H.  T(y) = y + A F(y), A being H^-1 as computed at (p,q), has the derivative 1 - A H(y).  In a ball of 5/4 step
 * about (p,q), in maximum norms, that is at most h = most + |A| L 5/4 step: `most` bounds |1 - A H(p,q)|, L is a Lipschitz constant
 * of H within 1/5, `step` bounds |A F(p,q)|.  If h <= 1/5, then T contracts in that ball, and a root lies there, within
 * 5/4 h step of T(p,q).  The same holds for a second correction from there with the same A, if the sum of both steps is in the place
 * of `step`.  H is positive definite at the root: A is, and so is every matrix on the way from its inverse to H.
 *
 * L: rows of the derivatives of H add up to at most l_i = r_i a + 2 (r_1 + r_2) a_i + away third[i], as in
 * footpoint_detail_KIND_step() in double: r_i bounds |r_i|, a_i |r_i1| + |r_i2|, a = a_1 + a_2, `away` |D|, all within 1/5.  `grown`,
 * the bound of footpoint_detail_KIND_growth() within 2/25, counts the errors of vectors in u, a unit of single precision, because
 * terms are rounded once to it and so are not further off than in footpoint_detail_KIND_step(): tangents by 10 u grown, second
 * derivatives by 18 u grown, D by 18 u far, far = |D| + grown.  Their sums of absolute values, off by up to the root of 3 times that,
 * get 4e-6 grown and 4e-6 far, so that all bounds hold for the true vectors.
 *
 * `most`: entries of H are off by (10 u grown) (|r_i| + |r_j|) + 18 u grown |D| + 18 u far |r_ij| and, by products and sums, 4 u
 * (|r_i| |r_j| + |r_ij| |D|); a row of H adds up to 2 r_i grown + a_i |D|, of which A's entries and its divisor add 12 u.  In all a row
 * is off by 12 u (grown (4 r_i + r_1 + r_2 + 3 |D|) + 3 a_i far).
 *
 * `off`: in double F_i is off by 20 spread size + 15 |D| units of |r_i| and by 10 grown units of |D|.  Products of A and F add 3 units
 * of single precision of the sum of their absolute values, where 5 are counted.  Numbers lost to zero are below 1e-37, and `size` is
 * at least 1.  A correction turns the normal u x v by at most (r_1 a_2 + r_2 a_1) step, which is less than a third of its length. */
FOOTPOINT_APART void footpoint_detail_KIND_side_bounds(BLOCK *FOOTPOINT_RESTRICT t)
{
    const REAL unit = REAL_UNIT, ball = 0.2;
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < SIDE; l++) {
        const REAL p = t->p[l], q = t->q[l], x = fabs(p) + 0.08, y = fabs(q) + 0.08;
        footpoint_detail_KIND_side_rounded face;
        footpoint_detail_local r;
        footpoint_detail_newton n;
        REAL third[2], mixed, uv, grown, tiny, d, far, away, a1, a2, a, r1, r2, both, row, column;
        REAL place, least, square;
        footpoint_detail_KIND_side_load(t, l, &face);
        footpoint_detail_KIND_local(&face.of, p, q, &r);
        footpoint_detail_newton_of(&r, &n);
        footpoint_detail_KIND_third(&face.of, x, y, third);
        mixed = fabs(n.r12);
        grown = footpoint_detail_KIND_growth(x, y) * face.of.size;
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
        place = 20.0 * footpoint_detail_KIND_spread(x, y) * face.of.size + 15.0 * away;
        row = place * r1 + 10.0 * (grown * away);
        column = place * r2 + 10.0 * (grown * away);
        t->off[l] = 1.13e-16 * n.per *
                    footpoint_detail_KIND_side_greater(n.r22 * row + mixed * column,
                                                       mixed * row + n.r11 * column);
        t->a11[l] = n.r22 * n.per;
        t->a12[l] = -(n.r12 * n.per);
        t->a22[l] = n.r11 * n.per;
        t->bend[l] = r1 * a2 + r2 * a1;
        uv = footpoint_detail_dot(r.u, r.v);
        square = footpoint_detail_dot(r.u, r.u) * footpoint_detail_dot(r.v, r.v) - uv * uv;
        t->flat[l] = 0.3 * footpoint_detail_root_bound(square);
        least = 1e-3 * (n.r11 * n.r22);
        t->doubt[l] = footpoint_detail_bits(n.det - least) | footpoint_detail_bits(square - least) |
                      footpoint_detail_bits(n.r11) | footpoint_detail_bits(1e6 - d) |
                      footpoint_detail_bits(30.0 - footpoint_detail_KIND_side_greater(x, y)) |
                      t->range[l];
    }
}
