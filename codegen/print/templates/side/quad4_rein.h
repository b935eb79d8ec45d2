/* Pairs of four-node faces side by side, from last answers: the part in single precision. */

/* Holds back steps from last answers, which may run away. */
FOOTPOINT_PART void footpoint_detail_KIND_side_rein_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        t->p[l] = footpoint_detail_KIND_side_kept(t->p[l]);
        t->q[l] = footpoint_detail_KIND_side_kept(t->q[l]);
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_rein(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_rein_of(t, 8);
    else
        footpoint_detail_KIND_side_rein_of(t, SIDE);
}

/* Returns a number, or 0 if the highest bit of `doubt` is set. */
FOOTPOINT_PART REAL footpoint_detail_KIND_side_unless(REAL_BITS doubt, REAL x)
{
    union {
        REAL_BITS bits;
        REAL number;
    } kept;
    kept.number = x;
    kept.bits &= (doubt >> REAL_TOP) - 1u;
    return kept.number;
}

/* Holds back the corrections of pairs in doubt. */
FOOTPOINT_PART void footpoint_detail_KIND_side_stop_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        const REAL_BITS doubt = t->doubt[l];
        t->a11[l] = footpoint_detail_KIND_side_unless(doubt, t->a11[l]);
        t->a12[l] = footpoint_detail_KIND_side_unless(doubt, t->a12[l]);
        t->a22[l] = footpoint_detail_KIND_side_unless(doubt, t->a22[l]);
        t->off[l] = footpoint_detail_KIND_side_unless(doubt, t->off[l]);
        t->most[l] = footpoint_detail_KIND_side_unless(doubt, t->most[l]);
        t->turn[l] = footpoint_detail_KIND_side_unless(doubt, t->turn[l]);
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_stop(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_stop_of(t, 8);
    else
        footpoint_detail_KIND_side_stop_of(t, SIDE);
}
