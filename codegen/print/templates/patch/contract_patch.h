/* What functions of patches promise, said once for all genomes. */

/* NAME, NAME_checked_n and NAME_over_n return FOOTPOINT_OK only if a minimum of the distance to the patch, or to the surface that its
 * polynomials make just beyond an edge, is proved to lie within NAME_PROMISE, a macro, of (xi,eta).  FOOTPOINT_OUTSIDE: (xi,eta) lies on
 * an edge or in a corner, and within NAME_PROMISE of a proved minimum of the distance to the closed patch, from which the distance falls
 * beyond the border.  Both hold for any normals of length 1, rounding errors included.  FOOTPOINT_UNPROVED: steps came to no proof, loc
 * and gap are where they ended; under -ffast-math nothing is proved.  On how many of the samples OK or OUTSIDE is proved stands above
 * each function.  NAME_at and NAME_n prove nothing.
 *
 * NAME_checked_n and NAME_over_n search 16 pairs side by side, and those without proof again as NAME does.  Their answers differ from its
 * within the promises.  For promises of 1e-3 and more they compute in single precision, gaps within 1e-6 of the longest edge. */
