/* Steps on curved faces side by side. */

/* Takes as many steps as the promise needs, `from` the last answers if it is 1, or `more` from their end, and proves the
 * last. Gaps precede the last correction, which changes them by its square. */
FOOTPOINT_PART void footpoint_detail_KIND_side_steps(BLOCK *t, double promise, int from, int more)
{
    if (!more) {
        footpoint_detail_LANES_KIND_side_round(t);
        if (from)
            footpoint_detail_KIND_side_resume(t);
        else
            footpoint_detail_LANES_KIND_side_begin(t);
    }
    footpoint_detail_LANES_KIND_side_newton(t);
    if (more || promise < 0.99e-2)
        footpoint_detail_LANES_KIND_side_newton(t);
    footpoint_detail_LANES_KIND_side_prove(t);
    footpoint_detail_KIND_side_settle(t);
    if (more || promise < 0.99e-7) {
        footpoint_detail_KIND_side_slopes(t);
        footpoint_detail_LANES_KIND_side_corrections(t, (LANE)promise);
    }
    footpoint_detail_KIND_side_slopes_and_gaps(t);
    footpoint_detail_LANES_KIND_side_corrections(t, (LANE)promise);
}
