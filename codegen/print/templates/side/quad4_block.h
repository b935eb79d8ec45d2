/* Pairs of four-node faces and slave nodes side by side, for loops over arrays: the part in double. */

enum { SIDE = 32 }; /* pairs at a time, or 8 */

/* Holds values of pairs. `vector` has a, b, c and d, with 4 r = c0 + xi a + eta b + xi eta c and d = 4 xS - c0;
 * `narrow` has them rounded. `product` has a a, a b, b b, a c, b c, c c, a d, b d, c d, d d in a unit of length in
 * which the absolute values of the coordinates of a and b add up to 1 to 4. `square` changes products of lengths to
 * that unit. Steps in single precision end at (p,q); the answer is (xi,eta), the
 * last one `last`. Slopes f and g, or `slope`, and a11 to
 * `flat` prove it: see footpoint_detail_f_KIND_side_bound. A pair is not proved if the highest bit of `doubt` or `wide`
 * is set. */
typedef struct {
    double x[15][SIDE];
    double vector[4][3][SIDE], square[SIDE];
    double xi[SIDE], eta[SIDE], last[2][SIDE];
    double f[SIDE], g[SIDE];
    double gap[SIDE];
    LANE narrow[4][3][SIDE], product[10][SIDE];
    LANE p[SIDE], q[SIDE], slope[2][SIDE];
    LANE a11[SIDE], a12[SIDE];
    LANE a22[SIDE], most[SIDE];
    LANE turn[SIDE], off[SIDE], bend[SIDE], flat[SIDE];
    LANE_BITS doubt[SIDE], wide[SIDE];
    int lanes; /* 8 or SIDE: loops of a known length vectorise with -O2, too */
} BLOCK;

/* Steps begin at the distance from here. */
FOOTPOINT_PART double footpoint_detail_KIND_middle(void)
{
    return 0.0;
}

/* Computes a, b, c and d from columns x. In units of rounding of their coordinates, a is off by 2 |a| + |c|, b by |a| +
 * 2 |b| + 3 |c|, c by |a| + 2 |c|, d by 4 |a| + 3 |b| + 6 |c| + 3 |d|. */
FOOTPOINT_PART void footpoint_detail_KIND_side_narrow_of(const double *const *x,
                                                         BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l, i, k;
    for (i = 0; i < 3; i++) {
        const double *const xa = x[i], *const xb = x[3 + i], *const xc = x[6 + i];
        const double *const xd = x[9 + i], *const xs = x[12 + i];
        FOOTPOINT_EACH
        for (l = 0; l < lanes; l++) {
            const double ab = xb[l] - xa[l], dc = xc[l] - xd[l], c = dc - ab;
            const double b = 2.0 * (xd[l] - xa[l]) + c;
            const double all[4] = {ab + dc, b, c, (4.0 * (xs[l] - xa[l]) - b) - 2.0 * ab};
            FOOTPOINT_WHOLE
            for (k = 0; k < 4; k++) {
                t->vector[k][i][l] = all[k];
                t->narrow[k][i][l] = (LANE)all[k];
            }
        }
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_narrow(const double *const *x,
                                                       BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_narrow_of(x, t, 8);
    else
        footpoint_detail_KIND_side_narrow_of(x, t, SIDE);
}

/* Computes the slopes and the gap at (xi,eta), if they are asked for. Slopes are f = r_xi . D and g = r_eta . D with D
 * = xS - r, times 16 and in the unit of products.
 *
 * Let P = 1 + |xi|, Q = 1 + |eta| and far = |d| + P Q (|a| + |b| + |c|). In units of rounding, 4 r_xi is off by 4 Q
 * (|a| + |c|), 4 r_eta by P (|a| + 4 |b| + 4 |c|), 4 D by 6 far, f by 13 far Q (|a| + |c|), and g by 13 far P (0.08 |a|
 * + |b| + |c|). */
FOOTPOINT_PART void footpoint_detail_KIND_side_place(BLOCK *FOOTPOINT_RESTRICT t, int slopes,
                                                     int gap, int lanes)
{
    int l, i;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        const double xi = t->xi[l], eta = t->eta[l], square = t->square[l];
        double u[3], v[3], w[3], n[3];
        FOOTPOINT_WHOLE
        for (i = 0; i < 3; i++) {
            u[i] = t->vector[0][i][l] + eta * t->vector[2][i][l];
            v[i] = t->vector[1][i][l] + xi * t->vector[2][i][l];
            w[i] = (t->vector[3][i][l] - xi * t->vector[0][i][l]) - eta * v[i];
        }
        if (slopes) {
            t->f[l] = footpoint_detail_dot(u, w) * square;
            t->g[l] = footpoint_detail_dot(v, w) * square;
        }
        if (gap) {
            footpoint_detail_cross(u, v, n);
            t->gap[l] = 0.25 * footpoint_detail_dot(w, n) *
                        footpoint_detail_KIND_side_root(footpoint_detail_dot(n, n));
        }
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_slopes(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_place(t, 1, 0, 8);
    else
        footpoint_detail_KIND_side_place(t, 1, 0, SIDE);
}

FOOTPOINT_APART void footpoint_detail_KIND_side_gaps(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_place(t, 0, 1, 8);
    else
        footpoint_detail_KIND_side_place(t, 0, 1, SIDE);
}

FOOTPOINT_APART void footpoint_detail_KIND_side_slopes_and_gaps(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_place(t, 1, 1, 8);
    else
        footpoint_detail_KIND_side_place(t, 1, 1, SIDE);
}
