/* Steps on four-node faces side by side. */

/* Takes as many steps as the promise needs, `from` the last answers if it is 1, or `more` from their end, and proves the
 * last. */
FOOTPOINT_PART void footpoint_detail_KIND_side_steps(BLOCK *t, double promise, int from, int more)
{
    footpoint_detail_LANES_KIND_side_products(t);
    if (!more && from) {
        footpoint_detail_KIND_side_resume(t);
        footpoint_detail_LANES_KIND_side_newton(t);
        footpoint_detail_LANES_KIND_side_rein(t);
    } else if (!more) {
        footpoint_detail_LANES_KIND_side_begin(t);
        footpoint_detail_LANES_KIND_side_gauss(t);
    }
    if (!more && promise > 0.99e-3) {
        footpoint_detail_LANES_KIND_side_rough(t, (LANE)promise);
        footpoint_detail_KIND_side_gaps(t);
        return;
    }
    footpoint_detail_LANES_KIND_side_newton(t);
    if (from)
        footpoint_detail_LANES_KIND_side_rein(t);
    footpoint_detail_LANES_KIND_side_bounds(t);
    if (from)
        footpoint_detail_LANES_KIND_side_stop(t);
    if (more || promise < 0.99e-7) {
        footpoint_detail_KIND_side_slopes(t);
        footpoint_detail_LANES_KIND_side_corrections(t, (LANE)promise);
        if (from)
            footpoint_detail_LANES_KIND_side_stop(t);
    }
    footpoint_detail_KIND_side_slopes_and_gaps(t);
    footpoint_detail_LANES_KIND_side_corrections(t, (LANE)promise);
}
