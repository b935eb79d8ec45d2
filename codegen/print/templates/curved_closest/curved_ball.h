/* The size of a curved face. */

/* Returns roughly the sum of the squares of its edges. */
FOOTPOINT_PART REAL footpoint_detail_KIND_extent(const footpoint_detail_KIND_terms *of)
{
    return 4.0 * of->size * of->size;
}

/* Returns a lower bound on the distance of the face, for any slave node: by the ball about the middle that contains all
 * control points. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_none_within(const REAL *const *x)
{
    footpoint_detail_KIND_terms of;
    REAL e[3], most = 0.0, middle;
    int k, i;
    footpoint_detail_KIND_expand(x, &of);
    for (k = 0; k < NODES; k++) {
        const int side = k - CORNERS, next = (side + 1) % CORNERS;
        const int between = side >= 0 && side < CORNERS;
        for (i = 0; i < 3; i++)
            e[i] = (between ? 2.0 * x[k][i] - 0.5 * (x[side][i] + x[next][i]) : x[k][i]) -
                   x[NODES][i] + of.d[i];
        most = footpoint_detail_greater(most, footpoint_detail_dot(e, e));
    }
    if (CORNERS == 4) { /* the control point in the middle, so that the face has r0 there */
        for (i = 0; i < 3; i++) {
            e[i] = 0.0;
            for (k = 0; k < 2 * CORNERS; k++)
                e[i] += (k < CORNERS ? 0.25 : -1.0) * (x[k][i] - x[NODES][i] + of.d[i]);
        }
        most = footpoint_detail_greater(most, footpoint_detail_dot(e, e));
    }
    middle = footpoint_detail_length(of.d);
    if (footpoint_detail_infinite(middle) >> REAL_TOP)
        return middle;
    most = sqrt(most);
    return footpoint_detail_greater(middle - most - 900.0 * REAL_UNIT * (middle + most), 0.0);
}
