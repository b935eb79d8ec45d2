/* The corners of a patch side by side: one number of each, in single calls. */

/* Computes the columns c of four rows a. */
FOOTPOINT_PART void footpoint_detail_transpose(const REAL a0[4], const REAL a1[4], const REAL a2[4],
                                               const REAL a3[4], REAL c[4][4])
{
    REAL even[2][4], odd[2][4];
    footpoint_detail_join(a0[0], a1[0], a0[2], a1[2], even[0]);
    footpoint_detail_join(a2[0], a3[0], a2[2], a3[2], even[1]);
    footpoint_detail_join(a0[1], a1[1], a0[3], a1[3], odd[0]);
    footpoint_detail_join(a2[1], a3[1], a2[3], a3[3], odd[1]);
    footpoint_detail_join(even[0][0], even[0][1], even[1][0], even[1][1], c[0]);
    footpoint_detail_join(odd[0][0], odd[0][1], odd[1][0], odd[1][1], c[1]);
    footpoint_detail_join(even[0][2], even[0][3], even[1][2], even[1][3], c[2]);
    footpoint_detail_join(odd[0][2], odd[0][3], odd[1][2], odd[1][3], c[3]);
}

/* Exchanges numbers of corners that differ along xi (over = 1), or along eta (3). */
FOOTPOINT_PART void footpoint_detail_over(const REAL a[4], int over, REAL b[4])
{
    footpoint_detail_join(a[over], a[1 ^ over], a[2 ^ over], a[3 ^ over], b);
}

/* Returns dot products of vectors side by side. */
FOOTPOINT_PART footpoint_detail_pack footpoint_detail_beside(REAL a[3][4], REAL b[3][4], int c)
{
    return footpoint_detail_of(a[0])[c] * footpoint_detail_of(b[0])[c] +
           footpoint_detail_of(a[1])[c] * footpoint_detail_of(b[1])[c] +
           footpoint_detail_of(a[2])[c] * footpoint_detail_of(b[2])[c];
}

/* Returns sums of the absolute coordinates of vectors side by side. */
FOOTPOINT_PART footpoint_detail_pack footpoint_detail_beside_sizes(REAL a[3][4], int c)
{
    return footpoint_detail_absolute(footpoint_detail_of(a[0])[c]) +
           footpoint_detail_absolute(footpoint_detail_of(a[1])[c]) +
           footpoint_detail_absolute(footpoint_detail_of(a[2])[c]);
}

/* Returns the greater of two numbers up to rounding, without a branch. */
FOOTPOINT_PART footpoint_detail_pack footpoint_detail_beside_most(footpoint_detail_pack a,
                                                                  footpoint_detail_pack b)
{
    return 0.5 * ((a + b) + footpoint_detail_absolute(a - b));
}

/* n: normals; edge[0], edge[1]: the edges along xi and along eta, from the corner; rise: their products with n. The
 * first index is a coordinate. */
typedef struct {
    REAL n[4][4], edge[2][4][4], rise[2][4];
} footpoint_detail_corners;

/* Returns the greatest of the corners' numbers, up to rounding. */
FOOTPOINT_PART REAL footpoint_detail_corners_most(const REAL a[4])
{
    return footpoint_detail_net_most(footpoint_detail_net_most(a[0], a[1]),
                                     footpoint_detail_net_most(a[2], a[3]));
}

/* Arranges the edges AB, DC, AD and BC and the normals by corners. Returns the largest square of a normal. */
FOOTPOINT_PART REAL footpoint_detail_corners_of(const REAL *const *n,
                                                const footpoint_detail_net_bent bent[4],
                                                footpoint_detail_corners *t)
{
    REAL e[4][4], square[4];
    int c, i;
    footpoint_detail_transpose(n[0], n[1], n[2], n[3], t->n);
    footpoint_detail_transpose(bent[0].edge, bent[1].edge, bent[2].edge, bent[3].edge, e);
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        footpoint_detail_join(e[i][0], -e[i][0], -e[i][1], e[i][1], t->edge[0][i]);
        footpoint_detail_join(e[i][2], e[i][3], -e[i][3], -e[i][2], t->edge[1][i]);
    }
    FOOTPOINT_UNROLL
    for (c = 0; c < FOOTPOINT_DETAIL_FOUR; c++) {
        footpoint_detail_into(square)[c] = footpoint_detail_beside(t->n, t->n, c);
        footpoint_detail_into(t->rise[0])[c] = footpoint_detail_beside(t->edge[0], t->n, c);
        footpoint_detail_into(t->rise[1])[c] = footpoint_detail_beside(t->edge[1], t->n, c);
    }
    return footpoint_detail_corners_most(square);
}

/* Bends an edge that rises by `first` and -`second` at its ends, whose normals are m and n. */
FOOTPOINT_PART void footpoint_detail_corners_bend(REAL first, REAL second, const REAL m[4],
                                                  const REAL n[4], footpoint_detail_net_bent *t)
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
        footpoint_detail_into(t->begin)[i] = 0.125 * first * footpoint_detail_of(m)[i];
        footpoint_detail_into(t->end)[i] = -0.125 * second * footpoint_detail_of(n)[i];
    }
}

/* Bends all edges. */
FOOTPOINT_PART void footpoint_detail_corners_bends(footpoint_detail_corners *t,
                                                   const REAL *const *n,
                                                   footpoint_detail_net_bent bent[4])
{
    const REAL *const xi = t->rise[0], *const eta = t->rise[1];
    footpoint_detail_corners_bend(xi[0], xi[1], n[0], n[1], &bent[0]);
    footpoint_detail_corners_bend(xi[3], xi[2], n[3], n[2], &bent[1]);
    footpoint_detail_corners_bend(eta[0], eta[3], n[0], n[3], &bent[2]);
    footpoint_detail_corners_bend(eta[1], eta[2], n[1], n[2], &bent[3]);
}
