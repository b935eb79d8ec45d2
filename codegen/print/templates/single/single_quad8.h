/* Rounding errors of the quadrilateral with mid-side nodes, term by term. */

/* Adds up the absolute values of all terms that curve the face. */
FOOTPOINT_PART REAL footpoint_detail_quad8_bent(const footpoint_detail_quad8_terms *t)
{
    return footpoint_detail_sum(t->a) + footpoint_detail_sum(t->b) + footpoint_detail_sum(t->c) +
           footpoint_detail_sum(t->g) + footpoint_detail_sum(t->h);
}

/* Bounds the errors of tangents and of second derivatives, as vectors, in units of rounding. e and f are off by one
 * unit of themselves. a to h are off by `size`, the size of the halves of the edges (b by half of it), and by 2 |a| +
 * |g| and the like. Operations add one unit of each partial sum, seven of a term. */
FOOTPOINT_PART REAL footpoint_detail_quad8_tangents_off(const footpoint_detail_quad8_terms *t,
                                                        REAL x, REAL y)
{
    const REAL straight = footpoint_detail_norm(t->e) + footpoint_detail_norm(t->f);
    const REAL bend = footpoint_detail_quad8_bent(t);
    return 4.0 * straight +
           (t->size + 9.0 * bend) * ((1.0 + x) * (1.0 + y) + 0.5 * (x * x + y * y));
}

/* Bounds the error of d = xS - r likewise. In the middle, d is off by 3 |d| + |e| + size / 2 + 2 |a| + |g|. */
FOOTPOINT_PART REAL footpoint_detail_quad8_place_off(const footpoint_detail_quad8_terms *t, REAL x,
                                                     REAL y)
{
    const REAL xx = 0.5 * (x * x), yy = 0.5 * (y * y);
    const REAL e = footpoint_detail_norm(t->e), along = x * e + y * footpoint_detail_norm(t->f);
    const REAL a = footpoint_detail_sum(t->a), g = footpoint_detail_sum(t->g);
    const REAL c = footpoint_detail_sum(t->c), h = footpoint_detail_sum(t->h);
    const REAL high = 0.5 + xx + yy + 0.5 * (x * y) * (1.0 + x + y);
    const REAL arc = xx * (a + y * g) + yy * (c + x * h) + x * y * footpoint_detail_sum(t->b);
    return 5.0 * footpoint_detail_norm(t->d) + 6.0 * along + e + t->size * high + 12.0 * arc +
           2.0 * a + g + xx * (1.0 + y) * (a + g) + yy * (1.0 + x) * (c + h);
}
