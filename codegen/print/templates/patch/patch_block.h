/* Pairs side by side, for loops over arrays of any caller. */

/* Vectors x of pairs; edges AB, DC, AD, BC, normals, and xS minus the middle, for the search, in a unit of length in
 * which `size`, the sum of the edges' absolute coordinates, is from 1 to 2; that unit. (p,q): the present point of the
 * search; gap. The highest bit of `doubt` is set if they are not proved. It holds `lanes` pairs, 8 or
 * FOOTPOINT_LANES: loops of a known length vectorise with -O2, too. */
typedef struct {
    double x[9][3][FOOTPOINT_LANES], unit[FOOTPOINT_LANES];
    LANE edge[4][3][FOOTPOINT_LANES], normal[4][3][FOOTPOINT_LANES], d[3][FOOTPOINT_LANES];
    LANE size[FOOTPOINT_LANES], p[FOOTPOINT_LANES], q[FOOTPOINT_LANES], gap[FOOTPOINT_LANES];
    LANE_BITS doubt[FOOTPOINT_LANES];
    int lanes;
} BLOCK;

/* Computes from x everything that precedes a search. */
FOOTPOINT_PART void NARROW_of(BLOCK *FOOTPOINT_RESTRICT b, int lanes)
{
    int l, k, i;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        double x[9][3], edge[4][3], d[3], size, inverse;
        FOOTPOINT_UNROLL
        for (k = 0; k < 9; k++) {
            FOOTPOINT_UNROLL
            for (i = 0; i < 3; i++)
                x[k][i] = b->x[k][i][l];
        }
        footpoint_detail_from(x[0], x[1], edge[0]);
        footpoint_detail_from(x[3], x[2], edge[1]);
        footpoint_detail_from(x[0], x[3], edge[2]);
        footpoint_detail_from(x[1], x[2], edge[3]);
        size = (footpoint_detail_sum(edge[0]) + footpoint_detail_sum(edge[1])) +
               (footpoint_detail_sum(edge[2]) + footpoint_detail_sum(edge[3]));
        footpoint_detail_powers(size, &b->unit[l], &inverse);
        b->size[l] = (LANE)(size * inverse);
        FOOTPOINT_UNROLL
        for (i = 0; i < 3; i++) {
            d[i] = 0.25 * (((x[8][i] - x[0][i]) + (x[8][i] - x[1][i])) +
                           ((x[8][i] - x[2][i]) + (x[8][i] - x[3][i])));
            b->d[i][l] = (LANE)(d[i] * inverse);
        }
        FOOTPOINT_UNROLL
        for (k = 0; k < 4; k++) {
            FOOTPOINT_UNROLL
            for (i = 0; i < 3; i++) {
                b->edge[k][i][l] = (LANE)(edge[k][i] * inverse);
                b->normal[k][i][l] = (LANE)x[4 + k][i];
            }
        }
    }
}

FOOTPOINT_APART void NARROW(BLOCK *FOOTPOINT_RESTRICT b)
{
    if (b->lanes == 8)
        NARROW_of(b, 8);
    else
        NARROW_of(b, FOOTPOINT_LANES);
}
