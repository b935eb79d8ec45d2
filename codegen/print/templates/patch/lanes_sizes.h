/* Bounds of third derivatives of nets side by side; see patch_sizes.h. */

FOOTPOINT_PART void footpoint_detail_NET_sizes(const REAL *const v[7], REAL third[2])
{
    const REAL X1 = footpoint_detail_sum(v[2]), Y1 = footpoint_detail_sum(v[3]);
    const REAL X0 = footpoint_detail_sum(v[4]), Y0 = footpoint_detail_sum(v[5]);
    const REAL m = footpoint_detail_sum(v[6]);
    third[0] =
        6.0 * footpoint_detail_sum(v[0]) + 17.9 * X1 + 6.9 * X0 + 15.2 * Y1 + 10.7 * Y0 + 1.7 * m;
    third[1] =
        6.0 * footpoint_detail_sum(v[1]) + 17.9 * Y1 + 6.9 * Y0 + 15.2 * X1 + 10.7 * X0 + 5.1 * m;
}
