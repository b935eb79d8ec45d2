/* Second derivatives of the Bezier patch over parts of it: the net's. */

FOOTPOINT_PART void footpoint_detail_bezier_bends(const footpoint_detail_bezier_terms *t,
                                                  footpoint_detail_bends c)
{
    footpoint_detail_net_bends(&t->net, c);
}

/* Widens ranges by the second derivatives that nets lack: none. */
FOOTPOINT_PART void footpoint_detail_bezier_widen(const footpoint_detail_bezier_terms *t,
                                                  const REAL e[3], const REAL low[2],
                                                  const REAL high[2], footpoint_detail_range *r)
{
    (void)t, (void)e, (void)low, (void)high, (void)r;
}

/* Returns how far inner points move the patch at most. */
FOOTPOINT_PART REAL footpoint_detail_bezier_moved(const footpoint_detail_bezier_terms *t)
{
    (void)t;
    return 0.0;
}
