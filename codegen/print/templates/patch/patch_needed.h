/* The promise to prove for a whole closed patch. */

/* Returns 1 if the closest point lies in the region of z, provided that it is within REAL_FINE of z, or 4e-10 in
 * coordinates that an edge holds: their slopes keep their signs. */
FOOTPOINT_PART int footpoint_detail_KIND_is_clear(const footpoint_detail_KIND_anchor *z)
{
    const REAL kept = 4.1e-10 * z->stiff, near = 2.1 * REAL_FINE;
    const REAL s =
        fabs(z->held[0]) > 0.0 ? z->held[0] * z->f - z->off_f - kept : 1.0 - fabs(z->at[0]) - near;
    const REAL t =
        fabs(z->held[1]) > 0.0 ? z->held[1] * z->g - z->off_g - kept : 1.0 - fabs(z->at[1]) - near;
    return !(footpoint_detail_bits(footpoint_detail_least(s, t)) >> REAL_TOP);
}

/* Returns the promise to prove for the whole patch: the caller's, if `close` does not suffice. `close` leaves 4e-10 to
 * coordinates that an edge holds. Near the corners of Gregory patches footpoint_detail_KIND_within does not hold. */
FOOTPOINT_PART REAL footpoint_detail_KIND_needed(const footpoint_detail_KIND_anchor *z,
                                                 REAL promise)
{
    const REAL close = REAL_FINE;
    return promise < close && footpoint_detail_KIND_is_clear(z) &&
                   footpoint_detail_KIND_ball(z->at[0], z->at[1]) > 4.1e-10 &&
                   !(footpoint_detail_KIND_within(z, close, promise) >> REAL_TOP)
               ? close
               : promise;
}
