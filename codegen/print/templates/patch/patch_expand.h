/* Patches of single calls, from their vectors. */

/* Computes the edges AB, DC, AD and BC, and d. */
FOOTPOINT_PART void footpoint_detail_KIND_edges(REAL x[9][4], footpoint_detail_net_bent bent[4],
                                                footpoint_detail_net *t)
{
    const footpoint_detail_pack *const a = footpoint_detail_of(x[0]);
    const footpoint_detail_pack *const b = footpoint_detail_of(x[1]);
    const footpoint_detail_pack *const c = footpoint_detail_of(x[2]);
    const footpoint_detail_pack *const d = footpoint_detail_of(x[3]);
    const footpoint_detail_pack *const s = footpoint_detail_of(x[8]);
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < FOOTPOINT_DETAIL_THREE; i++) {
        footpoint_detail_into(bent[0].edge)[i] = b[i] - a[i];
        footpoint_detail_into(bent[1].edge)[i] = c[i] - d[i];
        footpoint_detail_into(bent[2].edge)[i] = d[i] - a[i];
        footpoint_detail_into(bent[3].edge)[i] = c[i] - b[i];
        footpoint_detail_into(t->d)[i] =
            0.25 * (((s[i] - a[i]) + (s[i] - b[i])) + ((s[i] - c[i]) + (s[i] - d[i])));
    }
}

FOOTPOINT_PART void footpoint_detail_KIND_expand(const REAL *const *x,
                                                 footpoint_detail_KIND_terms *t)
{
    REAL y[9][4];
    const REAL *const n[4] = {y[4], y[5], y[6], y[7]};
    footpoint_detail_net_bent bent[4];
    int k;
    FOOTPOINT_UNROLL
    for (k = 0; k < 9; k++)
        footpoint_detail_load(x[k], y[k]);
    footpoint_detail_KIND_edges(y, bent, &t->net);
    footpoint_detail_KIND_shape(n, bent, t);
}
