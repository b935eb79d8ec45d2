/* All points where a line meets a curved face: its parts are quartered until it is proved of each that it holds none or one.
 *
 * Seen along the line the face is two polynomials of u and v, and the line is 0.  Over a part, the square about (u, v) that
 * reaches `half` to each side, their values are means of nine control points, Bernstein coefficients: where these lie on one
 * side of a line through 0 there is no point.  Where the tangents at the middle tell u from v, the proofs of
 * footpoint_detail_KIND_meet hold for a part as for the whole face.  Parts overlap a little, so that rounding loses no
 * point on their edges. */

/* c about (u, v) with `half` for a unit. */
FOOTPOINT_FN void footpoint_detail_KIND_moved(const REAL c[9], REAL u, REAL v, REAL half,
                                              REAL part[9])
{
    const REAL square = half * half, cube = half * square, top = NODES > 8 ? c[8] : 0.0;
    const REAL a = NODES > 6 ? c[6] + 2.0 * v * top : 0.0, b = NODES > 6 ? c[7] : 0.0;
    REAL slope[2];
    part[0] = c[0] - u * c[1] - v * c[2] - footpoint_detail_KIND_bend(c, u, v, slope);
    part[1] = half * (c[1] + slope[0]);
    part[2] = half * (c[2] + slope[1]);
    part[3] = square * (c[3] + v * (a - v * top));
    part[4] = square * (c[4] + 2.0 * (u * a + v * b));
    part[5] = square * (c[5] + u * (b + u * top));
    part[6] = cube * a;
    part[7] = cube * (b + 2.0 * u * top);
    part[8] = half * cube * top;
}

/* 1 if the control points of both polynomials lie on one side of a line through 0: `right` and `left` enclose them. */
FOOTPOINT_FN int footpoint_detail_KIND_misses(REAL q[2][9])
{
    REAL right[2], left[2], z[2];
    int n, m;
    for (n = 0; n < 9; n++) {
        const REAL i = (REAL)(n % 3 - 1), j = (REAL)(n / 3 - 1), e = 2.0 * i * i - 1.0;
        const REAL d = 2.0 * j * j - 1.0;
        REAL a, b;
        for (m = 0; m < 2; m++)
            z[m] = q[m][0] - i * q[m][1] - j * q[m][2] - e * q[m][3] - i * j * q[m][4] -
                   d * q[m][5] - e * j * q[m][6] - i * d * q[m][7] - e * d * q[m][8];
        a = n ? right[0] * z[1] - right[1] * z[0] : 0.0;
        b = n ? z[0] * left[1] - z[1] * left[0] : 0.0;
        if (n && a >= 0.0 && b >= 0.0 &&
            (z[0] * right[0] + z[1] * right[1] > 0.0 || z[0] * left[0] + z[1] * left[1] > 0.0))
            continue;
        if (n && !(a > 0.0) && !(b > 0.0))
            return 0;
        for (m = 0; m < 2; m++) {
            left[m] = n == 0 || a > 0.0 ? z[m] : left[m];
            right[m] = n == 0 || !(a > 0.0) ? z[m] : right[m];
        }
    }
    return 1;
}

/* 1 if it is proved that a part holds no point, or one, which joins the n that are found if it is none of these. */
FOOTPOINT_FN int footpoint_detail_KIND_part(REAL q[2][9], REAL u, REAL v, REAL half,
                                            REAL found[8][2], int *n)
{
    REAL part[2][9], k[9], l[9], w[2], across, aa, bb;
    const REAL *const f = part[0], *const g = part[1];
    int i;
    for (i = 0; i < 2; i++)
        footpoint_detail_KIND_moved(q[i], u, v, half, part[i]);
    if (footpoint_detail_KIND_misses(part))
        return 1;
    across = f[1] * g[2] - g[1] * f[2];
    aa = f[1] * f[1] + g[1] * g[1];
    bb = f[2] * f[2] + g[2] * g[2];
    if (!(across * across > 100.0 * REAL_FLAT * (aa * bb)))
        return 0;
    for (i = 0; i < 9; i++) {
        k[i] = (g[2] * f[i] - f[2] * g[i]) / across;
        l[i] = (f[1] * g[i] - g[1] * f[i]) / across;
    }
    if (footpoint_detail_KIND_meet(k, l, 1.0, 1e-8, w) >> REAL_TOP)
        return 0;
    if (fabs(w[0]) > 0.9995 || fabs(w[1]) > 0.9995)
        return 1;
    for (i = 0; i < *n; i++)
        if (fabs(found[i][0] - u) <= half && fabs(found[i][1] - v) <= half)
            return 1;
    if (*n == 8)
        return 0;
    found[*n][0] = u + half * w[0];
    found[*n][1] = v + half * w[1];
    ++*n;
    return 1;
}

/* The number of points in the face or at its edges, found[] = {u, v}; -1 if thousands of parts do not tell, as where the
 * line touches the surface.  Parts are numbered i, j on their level. */
FOOTPOINT_FN int footpoint_detail_KIND_meets(REAL q[2][9], REAL found[8][2])
{
    const REAL low = NODES > 6 ? -1.0 : -1.0 / 3.0;
    REAL half = NODES > 6 ? 1.0 : 0.5;
    int level = 0, i = 0, j = 0, n = 0, visits;
    for (visits = 0; visits < 4000; visits++) {
        const REAL u = low + half * (REAL)(2 * i + 1), v = low + half * (REAL)(2 * j + 1);
        const int beyond = NODES < 7 && u + v > 1.0 / 3.0 + 2.01 * half;
        if (!beyond && !footpoint_detail_KIND_part(q, u, v, 1.001 * half, found, &n)) {
            if (++level > REAL_DIGITS / 2 + 3)
                return -1;
            half *= 0.5;
            i *= 2;
            j *= 2;
            continue;
        }
        for (; i & j & 1; level--) {
            half *= 2.0;
            i >>= 1;
            j >>= 1;
        }
        if (level == 0)
            return n;
        j += i & 1;
        i ^= 1;
    }
    return -1;
}
