/* The proof that no point of a closed curved face is nearer than a given point, by parts of the face. */

/* Finds roughly the least point of the quadratic in the polygon h: inside, or on an edge. */
FOOTPOINT_COLD void footpoint_detail_KIND_lowest(const REAL f[2], const REAL m[3],
                                                 REAL h[CORNERS][2], REAL k[2])
{
    const REAL det = m[0] * m[2] - m[1] * m[1] + REAL_MIN;
    const REAL x = (m[2] * f[0] - m[1] * f[1]) / det, y = (m[0] * f[1] - m[1] * f[0]) / det;
    REAL best = 0.0, slope[2], at[2];
    int i, inside = det > 1e-9 * (m[0] * m[2]);
    for (i = 0; i < CORNERS; i++) {
        const REAL *const from = h[i], *const to = h[(i + 1) % CORNERS];
        const REAL e[2] = {to[0] - from[0], to[1] - from[1]};
        const REAL bend = e[0] * (m[0] * e[0] + 2.0 * m[1] * e[1]) + m[2] * e[1] * e[1];
        REAL t, value;
        inside &= e[0] * (y - from[1]) - e[1] * (x - from[0]) >= 0.0;
        (void)footpoint_detail_bowl(f, m, from, slope);
        t = -0.5 * (e[0] * slope[0] + e[1] * slope[1]) / footpoint_detail_greater(bend, REAL_MIN);
        t = t > 0.0 ? t < 1.0 ? t : 1.0 : 0.0;
        at[0] = from[0] + t * e[0];
        at[1] = from[1] + t * e[1];
        value = footpoint_detail_bowl(f, m, at, slope);
        if (i == 0 || value < best) {
            best = value;
            k[0] = at[0];
            k[1] = at[1];
        }
    }
    if (inside) {
        k[0] = x;
        k[1] = y;
    }
}

/* Returns a lower bound of the squared distance over a part with corners h, (s,t) from its middle z. The change of the
 * squared distance from z is a mean of quadratics, with the matrices at corners. Each, made convex, lies above its
 * tangent plane near its least point, and the plane is least at a corner.
 *
 * Rounding: see footpoint_detail_KIND_slopes. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_least_of(const footpoint_detail_KIND_anchor *z,
                                                   REAL h[CORNERS][2])
{
    const REAL none[2] = {0.0, 0.0}, f[2] = {z->f, z->g};
    REAL a = 0.0, b = 0.0, least = 0.0, mean[3] = {0.0, 0.0, 0.0}, k[2], slope[2];
    footpoint_detail_KIND_form form;
    int i, j;
    footpoint_detail_KIND_form_over(z, h, none, &form);
    for (i = 0; i < CORNERS; i++) {
        a = footpoint_detail_greater(a, fabs(h[i][0]));
        b = footpoint_detail_greater(b, fabs(h[i][1]));
        mean[0] += form.m11[i] / CORNERS;
        mean[1] += form.m12[i] / CORNERS;
        mean[2] += form.m22[i] / CORNERS;
    }
    (void)footpoint_detail_convex(mean, a, b);
    footpoint_detail_KIND_lowest(f, mean, h, k);
    for (i = 0; i < CORNERS; i++) {
        REAL m[3], here, down = 0.0;
        m[0] = form.m11[i];
        m[1] = form.m12[i];
        m[2] = form.m22[i];
        here = -footpoint_detail_convex(m, a, b);
        here += footpoint_detail_bowl(f, m, k, slope);
        for (j = 0; j < CORNERS; j++)
            down = footpoint_detail_least(down, slope[0] * (h[j][0] - k[0]) +
                                                    slope[1] * (h[j][1] - k[1]));
        least = i ? footpoint_detail_least(least, here + down) : here + down;
    }
    return z->dd + least - 2.0 * (a * z->off_f + b * z->off_g) -
           (z->off_dd + 2.0 * z->off * (a * a + b * b));
}

/* Parts of the face, by their corners (xi,eta). */
typedef struct {
    REAL at[CORNERS][2];
} footpoint_detail_KIND_piece;

/* Halves a part, with middle z, at the edge that is longest in space; quadrilaterals also at the opposite edge. */
FOOTPOINT_COLD void footpoint_detail_KIND_halve(const footpoint_detail_KIND_anchor *z,
                                                footpoint_detail_KIND_piece *one,
                                                footpoint_detail_KIND_piece *other)
{
    int k = 0, i;
    REAL longest = -1.0;
    *other = *one;
    for (i = 0; i < CORNERS; i++) {
        const REAL *const from = one->at[i], *const to = one->at[(i + 1) % CORNERS];
        REAL square = 0.0;
        int j;
        for (j = 0; j < 3; j++) {
            const REAL e = (to[0] - from[0]) * z->r.u[j] + (to[1] - from[1]) * z->r.v[j];
            square += e * e;
        }
        if (square > longest) {
            longest = square;
            k = i;
        }
    }
    for (i = 0; i < 2; i++) {
        const int next = (k + 1) % CORNERS, third = (k + 2) % CORNERS, last = (k + 3) % CORNERS;
        if (CORNERS == 4)
            one->at[third][i] = other->at[last][i] = 0.5 * (one->at[third][i] + one->at[last][i]);
        one->at[next][i] = other->at[k][i] = 0.5 * (one->at[k][i] + one->at[next][i]);
    }
}

/* Computes the middle of a part. */
FOOTPOINT_COLD void footpoint_detail_KIND_middle_of(const footpoint_detail_KIND_piece *part,
                                                    REAL at[2])
{
    int i;
    for (i = 0; i < 2; i++)
        at[i] = CORNERS == 4 ? 0.5 * (part->at[0][i] + part->at[2][i])
                             : (part->at[0][i] + part->at[1][i] + part->at[CORNERS - 1][i]) / 3.0;
}

/* Returns 1 if a part has no point nearer than `most`, a squared distance, near one of n anchors where the slope nearly
 * vanishes. */
FOOTPOINT_COLD int footpoint_detail_KIND_about(const footpoint_detail_KIND_anchor *z, int n,
                                               const footpoint_detail_KIND_piece *part, REAL most)
{
    int i, k;
    for (i = 0; i < n; i++) {
        footpoint_detail_KIND_form m;
        REAL h[CORNERS][2], grow[2], f, g, fall;
        footpoint_detail_KIND_grows(z[i].held[0], z[i].f, z[i].off_f, &grow[0], &f);
        footpoint_detail_KIND_grows(z[i].held[1], z[i].g, z[i].off_g, &grow[1], &g);
        for (k = 0; k < CORNERS; k++)
            footpoint_detail_KIND_way(&z[i], part->at[k], h[k]);
        footpoint_detail_KIND_form_over(&z[i], h, grow, &m);
        fall = 2.02 * (m.high * f * f + m.wide * g * g) / m.det + z[i].off_dd;
        if (m.det > 0.0 && m.low > 0.0 && z[i].dd - fall >= most)
            return 1;
    }
    return 0;
}

/* Returns the result of a proof that no point of the face is nearer than z[0], except within `promise` of it; or, if
 * slack > 0, that no point is nearer by more than slack. z[1], if n > 1, is another point as near. start: a point that
 * is, or may be, nearer. */
FOOTPOINT_COLD int footpoint_detail_KIND_split(const footpoint_detail_KIND_terms *of,
                                               const footpoint_detail_KIND_anchor *z, int n,
                                               REAL promise, REAL slack, REAL start[2])
{
    footpoint_detail_KIND_piece stack[FOOTPOINT_DETAIL_DEPTH + 2];
    const REAL less = sqrt(z->dd) - slack, most = slack > 0.0 ? less * less : z->dd;
    int top = 0, parts;
    if (slack > 0.0 && !(less > 0.0))
        return FOOTPOINT_DETAIL_FAR;
    footpoint_detail_KIND_whole(stack[0].at);
    for (parts = 0; top >= 0; parts++) {
        footpoint_detail_KIND_piece *const part = &stack[top];
        footpoint_detail_KIND_anchor c;
        REAL h[CORNERS][2], middle[2], width = 0.0, least;
        int k;
        if (slack > 0.0 ? footpoint_detail_KIND_about(z, n, part, most)
                        : !(footpoint_detail_KIND_sole_of(z, part->at, promise) >> REAL_TOP)) {
            top--;
            continue;
        }
        footpoint_detail_KIND_middle_of(part, middle);
        footpoint_detail_KIND_anchor_at(of, middle, 0, &c);
        for (k = 0; k < CORNERS; k++) {
            footpoint_detail_KIND_way(&c, part->at[k], h[k]);
            width = footpoint_detail_greater(width, fabs(h[k][0]) + fabs(h[k][1]));
        }
        least = footpoint_detail_KIND_least_of(&c, h);
        start[0] = middle[0];
        start[1] = middle[1];
        if (least > most + z->off_dd) { /* as `most` is off by that */
            top--;
            continue;
        }
        if (slack <= 0.0 && c.dd < z->dd - c.off_dd)
            return FOOTPOINT_DETAIL_NEARER;
        if (parts >= FOOTPOINT_DETAIL_PARTS || width < 1e-4 || top >= FOOTPOINT_DETAIL_DEPTH)
            return FOOTPOINT_DETAIL_DOUBT;
        footpoint_detail_KIND_halve(&c, part, &stack[top + 1]);
        top++;
    }
    return FOOTPOINT_DETAIL_FAR;
}
