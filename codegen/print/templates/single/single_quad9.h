/* Rounding errors of the quadrilateral with mid-side nodes and a middle, term by term. */

/* Adds up the absolute values of all terms that curve the face. */
FOOTPOINT_PART REAL footpoint_detail_quad9_bent(const footpoint_detail_quad9_terms *t)
{
    return footpoint_detail_sum(t->a) + footpoint_detail_sum(t->b) + footpoint_detail_sum(t->c) +
           footpoint_detail_sum(t->g) + footpoint_detail_sum(t->h) + footpoint_detail_sum(t->k);
}

/* Bounds the errors of tangents and of second derivatives, as vectors, in units of rounding. e and f are off by one
 * unit of themselves. a and c are off by 1.42 size, g and h by size, b by half of it, k by 3.5 of it, and also by |a|,
 * 2 |g| + |a| + |k| / 2, 6 |a| + 2 |g| + 3 |k| and the like. Operations add one unit of each partial sum, eight of a
 * term. */
FOOTPOINT_PART REAL footpoint_detail_quad9_tangents_off(const footpoint_detail_quad9_terms *t,
                                                        REAL x, REAL y)
{
    const REAL straight = footpoint_detail_norm(t->e) + footpoint_detail_norm(t->f);
    const REAL bend = footpoint_detail_quad9_bent(t), xx = 0.5 * (x * x), yy = 0.5 * (y * y);
    return 4.0 * straight + (1.5 * t->size + 14.0 * bend) * ((1.0 + x) * (1.0 + y) + xx + yy) +
           (3.5 * t->size + 14.0 * bend) * (xx + yy + x * y * (1.0 + 0.5 * (x + y)));
}

/* Bounds the error of d = xS - r likewise. In the middle, d is off by one unit of itself. */
FOOTPOINT_PART REAL footpoint_detail_quad9_place_off(const footpoint_detail_quad9_terms *t, REAL x,
                                                     REAL y)
{
    const REAL xy = x * y, xx = 0.5 * (x * x), yy = 0.5 * (y * y);
    const REAL along = x * footpoint_detail_norm(t->e) + y * footpoint_detail_norm(t->f);
    const REAL a = footpoint_detail_sum(t->a), g = footpoint_detail_sum(t->g);
    const REAL c = footpoint_detail_sum(t->c), h = footpoint_detail_sum(t->h);
    const REAL k = footpoint_detail_sum(t->k);
    const REAL high = 1.42 * (xx + yy) + 0.5 * xy * (1.0 + x + y + 1.75 * xy);
    const REAL arc =
        xx * (a + y * g) + yy * (c + x * h) + xy * footpoint_detail_sum(t->b) + xx * yy * k;
    return 3.0 * footpoint_detail_norm(t->d) + 6.0 * along + t->size * high + 16.0 * arc +
           xx * (y * (a + 0.5 * k) + yy * (6.0 * a + 2.0 * g)) + yy * x * (c + 0.5 * k);
}
