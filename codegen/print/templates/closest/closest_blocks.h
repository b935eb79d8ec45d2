/* The quick way to closest points, over arrays: blocks of 8 or 32 pairs side by side. Compilers know their lengths, and
 * that their columns do not overlap. */

typedef struct {
    REAL x[COORDINATES][32], at[3][32];
    int region[32], status[32];
} footpoint_detail_KIND_closest_block;

/* Searches the pairs of a block. */
FOOTPOINT_PART void footpoint_detail_KIND_closest_side(footpoint_detail_nearby *nearby,
                                                       footpoint_detail_KIND_closest_block *t,
                                                       int lanes, REAL zero)
{
    const REAL *x[COORDINATES];
    int i;
    for (i = 0; i < COORDINATES; i++)
        x[i] = t->x[i];
    FOOTPOINT_EACH
    for (i = 0; i < lanes; i++) {
        const REAL p[VECTORS][3] = {COLUMNS};
        const REAL *const row[VECTORS] = {ROWS};
        REAL at[3];
        int region;
        t->status[i] = nearby(row, 1, zero, at, &region);
        t->region[i] = region;
        t->at[0][i] = at[0];
        t->at[1][i] = at[1];
        t->at[2][i] = at[2];
    }
}

/* Searches pairs while there are more than two, and returns how many. dist: squares of distances with their signs. */
FOOTPOINT_PART size_t footpoint_detail_KIND_closest_blocks(
    footpoint_detail_nearby *nearby, size_t n, const REAL *const *x, REAL *FOOTPOINT_RESTRICT xi,
    REAL *FOOTPOINT_RESTRICT eta, REAL *FOOTPOINT_RESTRICT dist, int *FOOTPOINT_RESTRICT region,
    int *FOOTPOINT_RESTRICT status)
{
    const REAL zero = footpoint_detail_zero();
    footpoint_detail_KIND_closest_block t;
    size_t i = 0, k;
    while (footpoint_detail_masks() && i + 2 < n) {
        const size_t lanes = n - i < 32 ? 8 : 32, count = n - i < lanes ? n - i : lanes;
        for (k = 0; k < COORDINATES; k++) {
            size_t l;
            for (l = 0; l < lanes; l++)
                t.x[k][l] = x[k][i + (l < count ? l : count - 1)];
        }
        if (lanes == 8)
            footpoint_detail_KIND_closest_side(nearby, &t, 8, zero);
        else
            footpoint_detail_KIND_closest_side(nearby, &t, 32, zero);
        for (k = 0; k < count; k++, i++) {
            xi[i] = t.at[0][k];
            eta[i] = t.at[1][k];
            dist[i] = t.at[2][k];
            region[i] = t.region[k];
            status[i] = t.status[k];
        }
    }
    return i;
}
