/* The promise of functions with a proof, printed once for all genomes. */

/* NAME, NAME_checked_n and NAME_over_n return FOOTPOINT_OK only if a minimum of the distance to the surface is proved
 * to lie within the macro NAME_PROMISE of (xi,eta), times |xi| or |eta| if that is greater than 1: for any segment,
 * rounding errors included, which no order of summation changes. FOOTPOINT_UNPROVED: the steps found no proof, and loc
 * and gap are where they ended; under -ffast-math nothing is proved. A minimum on the whole surface need not be the
 * nearest point of the segment: see NAME_closest. NAME_at and NAME_n prove nothing. Answers of NAME_checked_n and
 * NAME_over_n may differ from those of NAME within NAME_PROMISE, or prove another minimum. */
