/* The promise of functions that stay in the closed segment, printed once for all genomes. */

/* NAME and NAME_checked_n stay in the closed segment, |xi| <= 1 and |eta| <= 1. FOOTPOINT_OK: a minimum of the distance
 * to the surface is proved to lie within the macro NAME_PROMISE of (xi,eta). FOOTPOINT_OUTSIDE: (xi,eta) lies on an
 * edge or in a corner, and within NAME_PROMISE of a proved minimum of the distance to the closed segment, from which
 * the distance falls beyond the border. Both hold for any segment, rounding errors included. FOOTPOINT_UNPROVED: the
 * steps found no proof, and loc and gap are where they ended; under -ffast-math nothing is proved. NAME_at and NAME_n
 * prove nothing, and assume the order of corners of the banner. */
