/* The closest point of the closed triangle without a proof. */

/* Has the signature of footpoint_detail_KIND_nearest for other kinds, which use the search's answer. */
FOOTPOINT_PART int footpoint_detail_tri3_nearest(const REAL *const *x, REAL_BITS flaw, REAL least,
                                                 REAL xi, REAL eta, REAL at[3], int *region)
{
    REAL how[4];
    (void)flaw;
    (void)xi;
    (void)eta;
    return footpoint_detail_tri3_find(x, least, at, how, region);
}
