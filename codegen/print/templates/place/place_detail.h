/* Computes the rows of a function at a place of a face; again, for callers that stay small, in another unit of length. */

FOOTPOINT_PART REAL_BITS NAME_detail(const REAL *const *x, REAL xi, REAL eta, REAL *const *row,
                                     size_t step, int always, int again)
{
    VECTOR_LIST
    WITH_ROW
    REAL *const ROW = row[ROW_NUMBER];
    END_ROW
    WITH_REQUIRE
    REAL require[REQUIRED];
    END_REQUIRE
    REAL_BITS flaw;
    STATEMENTS
    TESTS
    WITH_GAP_LAST
    if (always || gap) {
        const REAL value = GAP;
        flaw |= again ? 0 : footpoint_detail_infinite(value);
        if (!always && flaw >> REAL_TOP)
            return flaw;
        gap[0 * step] = value;
    } else {
        flaw |= footpoint_detail_infinite(xS[0] + xS[1] + xS[2]);
        if (flaw >> REAL_TOP)
            return flaw;
    }
    END_GAP_LAST
    WITH_GAP_AMONG_ROWS
    if (!always && flaw >> REAL_TOP)
        return flaw;
    END_GAP_AMONG_ROWS
    WITH_SET_ROW
    if (always || ROW) {
        ELEMENTS
    }
    END_SET_ROW
    return flaw;
}

FOOTPOINT_COLD int NAME_detail_again(const REAL *const *x, REAL xi, REAL eta, REAL *const *row,
                                     size_t step)
{
    const int nodes = NODES, vectors = VECTORS, rows = ROW_COUNT, first = FIRST, degree = DEGREE;
    const int shape[2 * ROW_COUNT] = {SIZES_AND_DEGREES};
    footpoint_detail_place *const tangents = TANGENTS;
    REAL space[SPACE];
    return footpoint_detail_place_again(NAME_detail, tangents, first, degree, x, nodes, vectors, xi,
                                        eta, row, step, rows, shape, space);
}
