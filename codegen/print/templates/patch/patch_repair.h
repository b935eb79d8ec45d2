/* Answers on patches if the quick way fails. */

#ifndef FOOTPOINT_OUTSIDE
#define FOOTPOINT_OUTSIDE 1
#endif

/* Returns the squared distance at `at`. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_apart(const footpoint_detail_KIND_terms *of,
                                                const REAL at[2])
{
    footpoint_detail_local r;
    footpoint_detail_KIND_local(of, at[0], at[1], &r);
    return footpoint_detail_dot(r.d, r.d);
}

/* Returns 1 if a minimum of the distance on the closed patch is proved to lie within `promise` of the place to which
 * (p,q), on an edge or in a corner, moves, and the distance falls from there beyond the border. out: 1 or -1 for held
 * coordinates, otherwise 0; r: the surface there.
 *
 * In a corner both slopes must lead outwards by more than rounding. On an edge, along coordinate j, F_j = r_j . D has
 * the derivative -h, h = r_j . r_j - r_jj . D, which changes by at most 3 |r_j| |r_jj| + |D| |r_jjj|: Newton's step is
 * proved as above. Slopes across change by at most |r_ij| |D| + |r_i| |r_j| on the way to the root. */
FOOTPOINT_COLD int footpoint_detail_KIND_border(const footpoint_detail_KIND_terms *of,
                                                const footpoint_detail_local *r, const int out[2],
                                                REAL promise, REAL at[2])
{
    const int j = out[0] ? 1 : 0;
    const REAL *const along = j ? r->v : r->u, *const across = j ? r->u : r->v;
    const REAL *const bend = j ? r->vv : r->uu;
    const REAL size[2] = {footpoint_detail_sum(r->u), footpoint_detail_sum(r->v)};
    const REAL d = footpoint_detail_sum(r->d), third = of->net.third[j],
               other = of->net.third[1 - j] + footpoint_detail_KIND_rim(of);
    const REAL slope = footpoint_detail_dot(across, r->d) * (REAL)out[1 - j];
    const REAL f = footpoint_detail_dot(along, r->d);
    const REAL h = footpoint_detail_dot(along, along) - footpoint_detail_dot(bend, r->d);
    const REAL far = d + of->net.far, step = f / h, ball = 0.125;
    REAL off[2], a, b, error, change, rate, answer;
    if (footpoint_detail_fast() >> REAL_TOP || !(of->net.tilt <= 1.01))
        return 0;
    footpoint_detail_KIND_off(&of->net, size[0], size[1], d, out[0] && out[1] ? 0.0 : fabs(step),
                              off);
    if (out[0] && out[1])
        return footpoint_detail_dot(r->u, r->d) * (REAL)out[0] > 2.0 * off[0] &&
               footpoint_detail_dot(r->v, r->d) * (REAL)out[1] > 2.0 * off[1];
    if (!(h > 1e4 * 1.12e-16 * (far * far)))
        return 0;
    a = footpoint_detail_sum(bend) + ball * third;
    b = size[j] + ball * a;
    error = 1.01 * off[j] / h;
    rate = 1.01 * (3.0 * b * a + (d + ball * b) * third) / h * (fabs(step) + 2.0 * error);
    answer = at[j] + step;
    change = 1.25 * (fabs(step) + error);
    if (!(rate + 1e4 * 1.12e-16 * (far * far) / h <= 0.249 && change <= ball))
        return 0;
    error = 0.72 * rate * fabs(step) + 1.2 * error;
    if (!(error <= 0.999 * promise && fabs(answer) + error <= 1.0))
        return 0;
    a = footpoint_detail_sum(r->uv) + ball * (third + other);
    change *= 1.01 * (a * (d + ball * b) + (size[1 - j] + ball * a) * b);
    if (!(slope > change + 2.0 * off[1 - j]))
        return 0;
    at[j] = answer;
    return 1;
}

/* Computes Newton's step on the patch from `at`, in the coordinates that are not held; the Gauss-Newton step if the
 * Hessian is not positive definite. */
FOOTPOINT_COLD void footpoint_detail_KIND_move(const footpoint_detail_local *r, const int out[2],
                                               REAL step[2])
{
    const REAL uu = footpoint_detail_dot(r->u, r->u), vv = footpoint_detail_dot(r->v, r->v);
    const REAL f = out[0] ? 0.0 : footpoint_detail_dot(r->u, r->d);
    const REAL g = out[1] ? 0.0 : footpoint_detail_dot(r->v, r->d);
    const int alone = out[0] || out[1];
    REAL r11 = uu - footpoint_detail_dot(r->uu, r->d), r22 = vv - footpoint_detail_dot(r->vv, r->d);
    REAL r12 = footpoint_detail_dot(r->u, r->v) - footpoint_detail_dot(r->uv, r->d), det;
    if (alone) {
        r11 = r11 > 0.01 * uu ? r11 : uu;
        r22 = r22 > 0.01 * vv ? r22 : vv;
        r12 = 0.0;
    } else if (!(r11 > 0.0 && r11 * r22 > 1.0001 * (r12 * r12))) {
        r11 = 1.001 * uu;
        r22 = vv;
        r12 = footpoint_detail_dot(r->u, r->v);
    }
    det = r11 * r22 - r12 * r12 + REAL_MIN;
    step[0] = (r22 * f - r12 * g) / det;
    step[1] = (r11 * g - r12 * f) / det;
}

/* Takes up to 30 steps from `at` until one is proved. Returns FOOTPOINT_OK, FOOTPOINT_OUTSIDE, or
 * FOOTPOINT_UNPROVED. */
FOOTPOINT_COLD int footpoint_detail_KIND_steps(const footpoint_detail_KIND_terms *of, REAL promise,
                                               REAL at[2])
{
    int steps, i;
    for (steps = 0; steps < 30; steps++) {
        footpoint_detail_local r;
        REAL to[2], step[2], damp = 1.0, apart, moved;
        int out[2];
        footpoint_detail_KIND_local(of, at[0], at[1], &r);
        out[0] = footpoint_detail_dot(r.u, r.d) * at[0] > 0.0 && fabs(at[0]) >= 1.0
                     ? (at[0] > 0.0 ? 1 : -1)
                     : 0;
        out[1] = footpoint_detail_dot(r.v, r.d) * at[1] > 0.0 && fabs(at[1]) >= 1.0
                     ? (at[1] > 0.0 ? 1 : -1)
                     : 0;
        if ((out[0] || out[1]) && footpoint_detail_KIND_border(of, &r, out, promise, at))
            return FOOTPOINT_OUTSIDE;
        to[0] = at[0];
        to[1] = at[1];
        if (!(footpoint_detail_KIND_step(of, &r, 0.25 * footpoint_detail_KIND_ball(at[0], at[1]),
                                         promise, &to[0], &to[1]) >>
              REAL_TOP)) {
            at[0] = to[0];
            at[1] = to[1];
            return FOOTPOINT_OK;
        }
        footpoint_detail_KIND_move(&r, out, step);
        apart = footpoint_detail_dot(r.d, r.d) * (1.0 + REAL_MARGIN);
        do {
            for (i = 0; i < 2; i++)
                to[i] = footpoint_detail_KIND_kept(at[i] + damp * step[i]);
            moved = fabs(to[0] - at[0]) + fabs(to[1] - at[1]);
            damp *= 0.5;
        } while (moved > 1e-4 && damp > 1e-4 && !(footpoint_detail_KIND_apart(of, to) <= apart));
        at[0] = to[0];
        at[1] = to[1];
        if (!(moved > 1e-3 * promise) && !(moved > 1e-12)) /* rounding prevents the proof */
            break;
    }
    return FOOTPOINT_UNPROVED;
}

/* Takes steps from the end of the search, and from the middle. */
FOOTPOINT_COLD int footpoint_detail_KIND_repair(footpoint_detail_search *search,
                                                const REAL *const *x, REAL promise, REAL at[2])
{
    footpoint_detail_KIND_terms of;
    REAL from[2] = {0.0, 0.0}, g;
    int i, status;
    footpoint_detail_KIND_expand(x, &of);
    (void)search(x, 1, 0.0, &at[0], &at[1], &g);
    for (i = 0; i < 2; i++)
        at[i] =
            footpoint_detail_infinite(at[i]) >> REAL_TOP ? 0.0 : footpoint_detail_KIND_kept(at[i]);
    status = footpoint_detail_KIND_steps(&of, promise, at);
    if (status == FOOTPOINT_UNPROVED) {
        status = footpoint_detail_KIND_steps(&of, promise, from);
        for (i = 0; i < 2 && status != FOOTPOINT_UNPROVED; i++)
            at[i] = from[i];
    }
    return status;
}

/* Answers if a search is not good beyond doubt: searches again in a unit of length in which the segment is about 1
 * long, then repairs. */
FOOTPOINT_COLD int footpoint_detail_KIND_answer(footpoint_detail_search *search,
                                                const REAL *const *x, int nodes, REAL promise,
                                                REAL loc[2], REAL *gap)
{
    REAL y[VECTORS][3], at[2], g;
    const REAL *z[VECTORS];
    int exponent = 0, i, status = footpoint_detail_scale(x, NODES, VECTORS, y, &exponent);
    (void)nodes;
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < VECTORS; i++)
        z[i] = y[i];
    if (search(z, 2, 0.0, &at[0], &at[1], &g) >> REAL_TOP) {
        status = footpoint_detail_KIND_repair(search, z, promise, at);
        if (footpoint_detail_KIND_gap(z, at[0], at[1], 1e-6, &g) >> REAL_TOP)
            return FOOTPOINT_ERR_DEGENERATE;
    }
    g = ldexp(g, exponent);
    if (footpoint_detail_infinite(g) >> REAL_TOP)
        return FOOTPOINT_ERR_DEGENERATE; /* the distance overflows */
    loc[0] = at[0];
    loc[1] = at[1];
    *gap = g;
    return status;
}
