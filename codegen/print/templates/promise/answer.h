/* Answers if the quick way fails, for searches that prove nothing. */

/* Answers if a search is not good beyond doubt; nothing is promised. */
FOOTPOINT_COLD int footpoint_detail_KIND_answer(footpoint_detail_search *search,
                                                const REAL *const *x, int nodes, REAL promise,
                                                REAL loc[2], REAL *gap)
{
    return footpoint_detail_claim(footpoint_detail_again(search, x, nodes, VECTORS, loc, gap),
                                  promise);
}
