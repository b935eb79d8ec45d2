/* Bounds of third derivatives of nets in single calls; lanes_sizes.h has them for nets side by side. */

/* Computes the bounds third[] of a net from its vectors x1, y1, X1, Y1, X0, Y0 and m. For |p| <= 1.125, a, w and b,
 * and their first and second derivatives, are at most 0.385, 2.8, 6.75; 1, 2.25, 2; 0.5, 0.75, 1.69, the third
 * derivatives 6, 0, 1.5. Thus third[0] has 0.5 6 + 2 0.75 6.75 + 1.69 2.8 = 17.9 of X1, 2 0.75 2 + 1.69 2.25 = 6.9 of
 * X0; 1.5 0.385 + 2 1.69 2.8 + 0.75 6.75 = 15.2 of Y1, 1.5 + 2 1.69 2.25 + 0.75 2 = 10.7 of Y0, 1.69 of m; third[1]
 * has 1.5 1.125 + 2 1.69 of m. */
FOOTPOINT_PART void footpoint_detail_NET_sizes(const REAL *const v[7], REAL third[2])
{
    REAL by_p[ROOM], by_q[ROOM];
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < THREE; i++) {
        const TRIPLE x1 = ABSOLUTE(OF(v[0])[i]), y1 = ABSOLUTE(OF(v[1])[i]);
        const TRIPLE X1 = ABSOLUTE(OF(v[2])[i]), Y1 = ABSOLUTE(OF(v[3])[i]);
        const TRIPLE X0 = ABSOLUTE(OF(v[4])[i]), Y0 = ABSOLUTE(OF(v[5])[i]);
        const TRIPLE m = ABSOLUTE(OF(v[6])[i]);
        INTO(by_p)[i] = 6.0 * x1 + 17.9 * X1 + 6.9 * X0 + 15.2 * Y1 + 10.7 * Y0 + 1.7 * m;
        INTO(by_q)[i] = 6.0 * y1 + 17.9 * Y1 + 6.9 * Y0 + 15.2 * X1 + 10.7 * X0 + 5.1 * m;
    }
    third[0] = by_p[0] + by_p[1] + by_p[2];
    third[1] = by_q[0] + by_q[1] + by_q[2];
}
