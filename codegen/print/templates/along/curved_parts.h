/* All points at which a line meets a curved face: parts are quartered until each is proved to contain at most one.
 *
 * Seen along the line, the face is two polynomials of u and v, and the line is 0. Over a part, the square about (u, v)
 * that reaches `half` to each side, their values are means of nine control points, the Bernstein coefficients. If these
 * lie on one side of a line through 0, there is no point. If the tangents in the middle separate u from v, the proofs
 * of footpoint_detail_KIND_meet hold for a part as for the whole face. Parts overlap a little, so that rounding loses
 * no point on their edges. */

/* The polynomials, with a bound of their rounding errors on the face, and the n points {u, v, 0} found; at most eight
 * if all points of the face are proved. {u, v, 1}: no point is proved to lie within the promise. */
typedef struct {
    REAL q[2][9], off, found[9][3];
    int n;
} footpoint_detail_KIND_view;

/* Expands c about (u, v), with `half` as the unit. */
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

/* Returns 1 if the control points of both polynomials lie on one side of a line through 0, farther from it than
 * rounding reaches: `right` and `left` enclose them. */
FOOTPOINT_FN int footpoint_detail_KIND_misses(REAL q[2][9], REAL off)
{
    REAL right[2], left[2], z[9][2], most, least;
    int n, m;
    for (n = 0; n < 9; n++) {
        const REAL i = (REAL)(n % 3 - 1), j = (REAL)(n / 3 - 1), e = 2.0 * i * i - 1.0;
        const REAL d = 2.0 * j * j - 1.0;
        REAL a, b;
        for (m = 0; m < 2; m++)
            z[n][m] = q[m][0] - i * q[m][1] - j * q[m][2] - e * q[m][3] - i * j * q[m][4] -
                      d * q[m][5] - e * j * q[m][6] - i * d * q[m][7] - e * d * q[m][8];
        a = n ? right[0] * z[n][1] - right[1] * z[n][0] : 0.0;
        b = n ? z[n][0] * left[1] - z[n][1] * left[0] : 0.0;
        if (n && a >= 0.0 && b >= 0.0 &&
            (z[n][0] * right[0] + z[n][1] * right[1] > 0.0 ||
             z[n][0] * left[0] + z[n][1] * left[1] > 0.0))
            continue;
        if (n && !(a > 0.0) && !(b > 0.0))
            return 0;
        for (m = 0; m < 2; m++) {
            left[m] = n == 0 || a > 0.0 ? z[n][m] : left[m];
            right[m] = n == 0 || !(a > 0.0) ? z[n][m] : right[m];
        }
    }
    most = sqrt(right[0] * right[0] + right[1] * right[1]);
    least = sqrt(left[0] * left[0] + left[1] * left[1]);
    if (!(most > off && least > off))
        return 0;
    for (m = 0; m < 2; m++)
        right[m] = right[m] / most + left[m] / least;
    least = off * (fabs(right[0]) + fabs(right[1]));
    for (n = 0; n < 9; n++)
        if (!(z[n][0] * right[0] + z[n][1] * right[1] > least))
            return 0;
    return 1;
}

/* Returns 0 if the part is proved to contain no point, 1 for one point, within `most` times half of at = {u, v}, 2 if
 * neither is proved. */
FOOTPOINT_COLD int footpoint_detail_KIND_line_about(footpoint_detail_KIND_view *s, REAL u, REAL v,
                                                    REAL half, REAL most, REAL at[2])
{
    REAL part[2][9], k[9], l[9], w[3], off[2], across, aa, bb;
    const REAL *const f = part[0], *const g = part[1];
    REAL_BITS doubt, hit;
    int i;
    for (i = 0; i < 2; i++)
        footpoint_detail_KIND_moved(s->q[i], u, v, half, part[i]);
    if (footpoint_detail_KIND_misses(part, s->off))
        return 0;
    across = f[1] * g[2] - g[1] * f[2];
    aa = f[1] * f[1] + g[1] * g[1];
    bb = f[2] * f[2] + g[2] * g[2];
    if (!(across * across > REAL_FLAT * (aa * bb)))
        return 2;
    for (i = 0; i < 9; i++) {
        k[i] = (g[2] * f[i] - f[2] * g[i]) / across;
        l[i] = (f[1] * g[i] - g[1] * f[i]) / across;
    }
    off[0] = (fabs(f[2]) + fabs(g[2])) / fabs(across) * s->off;
    off[1] = (fabs(f[1]) + fabs(g[1])) / fabs(across) * s->off;
    doubt = footpoint_detail_KIND_meet(k, l, off, 1.0, most, w, &hit);
    if (!(hit >> REAL_TOP))
        return 0;
    if (doubt >> REAL_TOP)
        return 2;
    at[0] = u + half * w[0];
    at[1] = v + half * w[1];
    return fabs(w[0]) < 1.01 && fabs(w[1]) < 1.01;
}

/* Returns 1 if the part is proved to contain no point or one point, which is added to the points found unless it is one
 * of them. It is found again in a sixteenth of the part about it. If it is known to half of the promise, points within
 * twice that are the same, because parts overlap by more. */
FOOTPOINT_FN int footpoint_detail_KIND_part(footpoint_detail_KIND_view *s, REAL u, REAL v,
                                            REAL half)
{
    const REAL near = half / 16.0, promise = 0.49 * ALONG_PROMISE;
    REAL at[2], *to = s->found[s->n];
    int i;
    const int told = footpoint_detail_KIND_line_about(s, u, v, half, 1e-4, at);
    if (told != 1)
        return told == 0;
    to[0] = at[0];
    to[1] = at[1];
    to[2] = near < 3.0 * ALONG_PROMISE ||
            footpoint_detail_KIND_line_about(s, at[0], at[1], near, promise / near, to) != 1;
    for (i = 0; i < s->n && !(to[2] > 0.0); i++)
        if (fabs(s->found[i][0] - to[0]) <= 2.0 * ALONG_PROMISE &&
            fabs(s->found[i][1] - to[1]) <= 2.0 * ALONG_PROMISE)
            return 1;
    if (s->n == 8)
        return 0;
    s->n++;
    return 1;
}

/* Finds all points in the face or at its edges. The last point is unproved if thousands of parts do not suffice, for
 * example if the line touches the surface. Parts are numbered i, j on their level. */
FOOTPOINT_FN void footpoint_detail_KIND_meets(footpoint_detail_KIND_view *s)
{
    const REAL low = NODES > 6 ? -1.0 : -1.0 / 3.0;
    REAL half = NODES > 6 ? 1.0 : 0.5, u = 0.0, v = 0.0;
    int level = 0, i = 0, j = 0, visits;
    for (visits = 0; visits < 4000; visits++) {
        u = low + half * (REAL)(2 * i + 1);
        v = low + half * (REAL)(2 * j + 1);
        if (!(NODES < 7 && u + v > 1.0 / 3.0 + 2.01 * half) &&
            !footpoint_detail_KIND_part(s, u, v, 1.001 * half + 4.0 * ALONG_PROMISE)) {
            if (++level > REAL_DIGITS / 2 + 3)
                break;
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
            return;
        j += i & 1;
        i ^= 1;
    }
    s->found[s->n][0] = u;
    s->found[s->n][1] = v;
    s->found[s->n++][2] = 1.0;
}
