/* The promise of functions of patches, printed once for all genomes. */

/* NAME, NAME_checked_n and NAME_over_n return FOOTPOINT_OK only if a minimum of the distance to the patch, or to the
 * surface that its polynomials make just beyond an edge, is proved to lie within the macro NAME_PROMISE of (xi,eta).
 * FOOTPOINT_OUTSIDE: (xi,eta) lies on an edge or in a corner, and within NAME_PROMISE of a proved minimum of the
 * distance to the closed patch, from which the distance falls beyond the border. Both hold for any normals of length 1,
 * rounding errors included. FOOTPOINT_UNPROVED: the steps found no proof, and loc and gap are where they ended; under
 * -ffast-math nothing is proved. The banner of each function states the share of samples for which OK or OUTSIDE is
 * proved. NAME_at and NAME_n prove nothing. NAME_at may take steps on the patch, which NAME_n does not: their errors are
 * apart in the banner.
 *
 * NAME_checked_n and NAME_over_n search pairs side by side, and repeat those without proof by NAME. Their answers
 * differ from NAME's within the promises. For promises of 1e-3 and more they compute in single precision, with gaps
 * within 1e-6 of the longest edge. */
