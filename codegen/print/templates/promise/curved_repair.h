/* Steps of curved faces if the first steps prove nothing. */

/* Returns the squared distance at `at` and, if gauss is not NULL, computes the Gauss-Newton step from there, which
 * leads downhill. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_apart(const footpoint_detail_KIND_terms *of,
                                                const REAL at[2], REAL *gauss)
{
    footpoint_detail_local r;
    footpoint_detail_KIND_local(of, at[0], at[1], &r);
    if (gauss) {
        const REAL uu = footpoint_detail_dot(r.u, r.u), vv = footpoint_detail_dot(r.v, r.v);
        const REAL uv = footpoint_detail_dot(r.u, r.v), det = 1.001 * uu * vv - uv * uv + REAL_MIN;
        const REAL f = footpoint_detail_dot(r.u, r.d), g = footpoint_detail_dot(r.v, r.d);
        gauss[0] = (vv * f - uv * g) / det;
        gauss[1] = (uu * g - uv * f) / det;
    }
    return footpoint_detail_dot(r.d, r.d);
}

/* Moves from `at`, where the squared distance is *apart, to `to`, if that is nearer; otherwise by damped Gauss-Newton
 * steps, which lead downhill. Returns 0 if nothing is nearer. */
FOOTPOINT_COLD int footpoint_detail_KIND_nearer(const footpoint_detail_KIND_terms *of, REAL to[2],
                                                REAL at[2], REAL *apart)
{
    REAL gauss[2], damp = 1.0, less = footpoint_detail_KIND_apart(of, to, NULL);
    if (!(less <= *apart * (1.0 + REAL_MARGIN))) {
        (void)footpoint_detail_KIND_apart(of, at, gauss);
        do {
            to[0] = at[0] + damp * gauss[0];
            to[1] = at[1] + damp * gauss[1];
            less = footpoint_detail_KIND_apart(of, to, NULL);
            damp *= 0.25;
        } while (!(less < *apart) && damp > 1e-4);
    }
    if (!(less <= *apart * (1.0 + REAL_MARGIN)))
        return 0;
    at[0] = to[0];
    at[1] = to[1];
    *apart = less;
    return 1;
}

/* Takes up to 30 steps from `at` until one is proved. Returns 0 if one is; 1 if steps have ended, because rounding
 * prevents the proof; 2 if they have not. */
FOOTPOINT_COLD int footpoint_detail_KIND_steps(const footpoint_detail_KIND_terms *of, REAL promise,
                                               REAL at[2])
{
    REAL apart = footpoint_detail_KIND_apart(of, at, NULL), to[2], moved;
    int steps;
    for (steps = 0; steps < 30; steps++) {
        to[0] = at[0];
        to[1] = at[1];
        if (!(footpoint_detail_KIND_step(of, promise, &to[0], &to[1]) >> REAL_TOP)) {
            at[0] = to[0];
            at[1] = to[1];
            return 0;
        }
        moved = fabs(to[0] - at[0]) + fabs(to[1] - at[1]);
        if (moved < 1e-4) { /* near a minimum, where rounding hides which is nearer */
            at[0] = to[0];
            at[1] = to[1];
        } else if (!footpoint_detail_KIND_nearer(of, to, at, &apart))
            return 2;
        if (moved < 0.01 * promise && moved < REAL_STILL)
            return 1;
    }
    return 2;
}

/* Repairs an answer from (*xi,*eta), where a search ended, or else from the start of NAME; FOOTPOINT_UNPROVED if
 * nothing is proved. */
FOOTPOINT_COLD int footpoint_detail_KIND_repair(REAL y[VECTORS][3], REAL promise, REAL *xi,
                                                REAL *eta)
{
    const REAL middle = footpoint_detail_KIND_middle();
    footpoint_detail_KIND_terms of;
    const REAL *x[VECTORS];
    REAL at[2], from[2];
    int i, left;
    for (i = 0; i < VECTORS; i++)
        x[i] = y[i];
    footpoint_detail_KIND_expand(x, &of);
    at[0] = fabs(*xi) < 10.0 ? *xi - middle : 0.0;
    at[1] = fabs(*eta) < 10.0 ? *eta - middle : 0.0;
    left = footpoint_detail_KIND_steps(&of, promise, at);
    footpoint_detail_KIND_start(&of, &from[0], &from[1]);
    if (!(fabs(from[0]) < 2.0 && fabs(from[1]) < 2.0))
        from[0] = from[1] = 0.0;
    if (left > 1 && footpoint_detail_KIND_steps(&of, promise, from) == 0) {
        left = 0;
        at[0] = from[0];
        at[1] = from[1];
    }
    *xi = at[0] + middle;
    *eta = at[1] + middle;
    return left ? FOOTPOINT_UNPROVED : FOOTPOINT_OK;
}
