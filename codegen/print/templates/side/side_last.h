/* Pairs of faces and slave nodes side by side, from the last answers. */

/* Returns a coordinate, or 0, the middle, if it is larger than 31 or NaN. */
FOOTPOINT_PART double footpoint_detail_KIND_side_near(double p)
{
    union {
        double number;
        unsigned long long bits;
    } at;
    at.number = p;
    at.bits &= (footpoint_detail_above(p, 31.0) >> 63) - 1;
    return at.number;
}

/* Copies last answers into a block; repeats the last of `count` to fill it. */
FOOTPOINT_PART void footpoint_detail_KIND_side_keep(BLOCK *t, int count, const double *xi,
                                                    const double *eta)
{
    int l;
    for (l = 0; l < count; l++) {
        t->xi[l] = t->last[0][l] = xi[l];
        t->eta[l] = t->last[1][l] = eta[l];
    }
    for (; l < t->lanes; l++) {
        t->last[0][l] = xi[count - 1];
        t->last[1][l] = eta[count - 1];
    }
}

/* Begins at the last answers, or in the middle. */
FOOTPOINT_PART void footpoint_detail_KIND_side_resume_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    const double middle = footpoint_detail_KIND_middle();
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++) {
        t->p[l] = (LANE)footpoint_detail_KIND_side_near(t->last[0][l] - middle);
        t->q[l] = (LANE)footpoint_detail_KIND_side_near(t->last[1][l] - middle);
    }
}

FOOTPOINT_APART void footpoint_detail_KIND_side_resume(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_resume_of(t, 8);
    else
        footpoint_detail_KIND_side_resume_of(t, SIDE);
}

/* Leaves answers unproved that are more than half of the face away from the last ones. */
FOOTPOINT_PART void footpoint_detail_KIND_side_astray_of(BLOCK *FOOTPOINT_RESTRICT t, int lanes)
{
    int l;
    FOOTPOINT_EACH
    for (l = 0; l < lanes; l++)
        t->wide[l] |= (LANE_BITS)((footpoint_detail_above(t->xi[l] - t->last[0][l], 1.0) |
                                   footpoint_detail_above(t->eta[l] - t->last[1][l], 1.0)) >>
                                  63)
                      << LANE_TOP;
}

FOOTPOINT_APART void footpoint_detail_KIND_side_astray(BLOCK *FOOTPOINT_RESTRICT t)
{
    if (t->lanes == 8)
        footpoint_detail_KIND_side_astray_of(t, 8);
    else
        footpoint_detail_KIND_side_astray_of(t, SIDE);
}
