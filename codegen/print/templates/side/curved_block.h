/* Pairs of curved faces and slave nodes side by side, for loops over arrays: the part in double. */

enum { SIDE = 32 }; /* pairs at a time, or 8 */

/* The terms of a face, one by one; the last is `size`. */
typedef union {
    footpoint_detail_KIND_terms of;
    double number[sizeof(footpoint_detail_KIND_terms) / sizeof(double)];
} footpoint_detail_KIND_side_terms;

enum {
    footpoint_detail_KIND_side_vectors = sizeof(footpoint_detail_KIND_terms) / sizeof(double) / 3
};

/* Holds values of pairs. `term` has the vectors of faces; `narrow` has them rounded, in a unit of length, a power of
 * 2, in which the absolute values of the coordinates of e and f add up to 1 to 4; `square` changes products of
 * lengths to that unit. Steps in single precision end at (p,q), from the middle; the answer is (xi,eta), the
 * last one `last`. Slopes f and
 * g, and a11 to `flat`, prove it: see footpoint_detail_f_KIND_side_prove. A pair is not proved if the highest bit of
 * `doubt` or `wide` is set. */
typedef struct {
    double x[COORDINATES][SIDE];
    double term[footpoint_detail_KIND_side_vectors][3][SIDE], square[SIDE];
    double xi[SIDE], eta[SIDE], last[2][SIDE];
    double f[SIDE], g[SIDE];
    double gap[SIDE];
    LANE narrow[footpoint_detail_KIND_side_vectors][3][SIDE];
    LANE p[SIDE], q[SIDE];
    LANE a11[SIDE], a12[SIDE];
    LANE a22[SIDE], most[SIDE];
    LANE turn[SIDE], off[SIDE], bend[SIDE], flat[SIDE];
    LANE_BITS range[SIDE], doubt[SIDE], wide[SIDE];
    int lanes; /* 8 or SIDE: loops of a known length vectorise with -O2, too */
} BLOCK;

/* Computes terms from columns x. */
FOOTPOINT_PART void footpoint_detail_KIND_side_narrow_of(const double *const *x,
                                                         BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l, i, k;
    for (i = 0; i < 3; i++) {
        const double *column[VECTORS];
        for (k = 0; k < VECTORS; k++)
            column[k] = x[3 * k + i];
        FOOTPOINT_EACH
        for (l = 0; l < lanes; l++) {
            footpoint_detail_KIND_side_terms face;
            double node[VECTORS];
            FOOTPOINT_WHOLE
            for (k = 0; k < VECTORS; k++)
                node[k] = column[k][l];
            footpoint_detail_KIND_axis(node, 0, &face.of);
            FOOTPOINT_WHOLE
            for (k = 0; k < footpoint_detail_KIND_side_vectors; k++)
                t->term[k][i][l] = face.number[3 * k];
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

/* Puts the answer where steps in single precision have ended. */
FOOTPOINT_PART void footpoint_detail_KIND_side_settle_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    const double middle = footpoint_detail_KIND_middle();
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        t->xi[l] = (double)t->p[l] + middle;
        t->eta[l] = (double)t->q[l] + middle;
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_settle(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_settle_of(t, 8);
    else
        footpoint_detail_KIND_side_settle_of(t, SIDE);
}

/* Computes the slopes f = r_xi . D and g = r_eta . D at (xi,eta), with D = xS - r, in the unit of `narrow`, and the
 * gap, if they are asked for; of pairs in doubt, which may have run away, in the middle, where nothing overflows. */
FOOTPOINT_PART void footpoint_detail_KIND_side_place(BLOCK *FOOTPOINT_RESTRICT t, int slopes,
                                                     int gap, int lanes)
{
    const double middle = footpoint_detail_KIND_middle();
    int l, k;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        footpoint_detail_KIND_side_terms face;
        const double kept = 1.0 - (double)(int)(t->doubt[l] >> 31);
        footpoint_detail_local r;
        double n[3];
        FOOTPOINT_WHOLE
        for (k = 0; k < 3 * footpoint_detail_KIND_side_vectors; k++)
            face.number[k] = t->term[k / 3][k % 3][l];
        footpoint_detail_KIND_local(&face.of, kept * (t->xi[l] - middle),
                                    kept * (t->eta[l] - middle), &r);
        if (slopes) {
            t->f[l] = footpoint_detail_dot(r.u, r.d) * t->square[l];
            t->g[l] = footpoint_detail_dot(r.v, r.d) * t->square[l];
        }
        if (gap) {
            footpoint_detail_cross(r.u, r.v, n);
            t->gap[l] = footpoint_detail_dot(r.d, n) *
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
