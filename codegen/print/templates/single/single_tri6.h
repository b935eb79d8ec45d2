/* Rounding errors of the triangle with mid-side nodes, term by term. */

/* Adds up the absolute values of all terms that curve the face. */
FOOTPOINT_PART REAL footpoint_detail_tri6_bent(const footpoint_detail_tri6_terms *t)
{
    return footpoint_detail_sum(t->a) + footpoint_detail_sum(t->b) + footpoint_detail_sum(t->c);
}

/* Bounds the errors of tangents and of second derivatives, as vectors, in units of rounding. e and f are off by 1.41
 * size + 3 |e| and 1.41 size + 3 |f|; a is off by 5.7 size + |a|, b and c likewise. Operations add one unit of each
 * partial sum. */
FOOTPOINT_PART REAL footpoint_detail_tri6_tangents_off(const footpoint_detail_tri6_terms *t, REAL x,
                                                       REAL y)
{
    const REAL straight = footpoint_detail_norm(t->e) + footpoint_detail_norm(t->f);
    const REAL bend = footpoint_detail_tri6_bent(t);
    return 5.0 * straight + (5.7 * t->size + 4.0 * bend) * (1.0 + x + y);
}

/* Bounds the error of d = xS - r likewise. In the middle, d is off by 6 |d| + 3.7 size, because the distances of xS
 * from mid-side nodes add up to at most 3 |d| + 2.6 size. */
FOOTPOINT_PART REAL footpoint_detail_tri6_place_off(const footpoint_detail_tri6_terms *t, REAL x,
                                                    REAL y)
{
    const REAL xy = x + y;
    const REAL along = x * footpoint_detail_norm(t->e) + y * footpoint_detail_norm(t->f);
    const REAL arc =
        0.5 * (x * x * footpoint_detail_sum(t->a) + y * y * footpoint_detail_sum(t->c)) +
        x * y * footpoint_detail_sum(t->b);
    return 8.0 * footpoint_detail_norm(t->d) + 7.0 * (along + arc) +
           t->size * (3.7 + xy * (1.41 + 2.85 * xy));
}
