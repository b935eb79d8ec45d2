/* The start of steps, for pairs side by side. */

FOOTPOINT_PART void NAME_begin_of(BLOCK *FOOTPOINT_RESTRICT b, int lanes)
{
    const LANE zero = (LANE)footpoint_detail_zero();
    int l, k, i;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        LANE x[9][3];
        FOOTPOINT_UNROLL
        for (i = 0; i < 3; i++) {
            x[0][i] = 0;
            x[1][i] = b->edge[0][i][l];
            x[2][i] = b->edge[0][i][l] + b->edge[3][i][l];
            x[3][i] = b->edge[2][i][l];
            x[8][i] = b->d[i][l] + (LANE)0.25 * ((x[1][i] + x[3][i]) + x[2][i]);
        }
        FOOTPOINT_UNROLL
        for (k = 0; k < 4; k++) {
            FOOTPOINT_UNROLL
            for (i = 0; i < 3; i++)
                x[4 + k][i] = b->normal[k][i][l];
        }
        (void)NAME_detail(VECTOR_ROWS, zero, &b->p[l], &b->q[l]);
    }
}

FOOTPOINT_APART void NAME_begin(BLOCK *FOOTPOINT_RESTRICT b)
{
    if (b->lanes == 8)
        NAME_begin_of(b, 8);
    else
        NAME_begin_of(b, FOOTPOINT_LANES);
}
