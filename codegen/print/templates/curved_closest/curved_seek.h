/* The closest point of a closed curved face if the quick way proves nothing: by descents and parts of the face,
 * seldom. */

/* Computes Newton's step in the coordinates that no edge holds, or the Gauss-Newton step if Newton's may lead
 * uphill. */
FOOTPOINT_COLD void footpoint_detail_KIND_free_step(const footpoint_detail_KIND_anchor *z,
                                                    const int held[2], REAL h[2])
{
    const REAL uu = footpoint_detail_dot(z->r.u, z->r.u), uv = footpoint_detail_dot(z->r.u, z->r.v);
    const REAL vv = footpoint_detail_dot(z->r.v, z->r.v), f = z->f, g = z->g;
    REAL h11 = uu - z->a, h12 = uv - z->b, h22 = vv - z->c, det = h11 * h22 - h12 * h12;
    if (!(h11 > 1e-3 * uu && h22 > 1e-3 * vv && (held[0] || held[1] || det > 1e-6 * (uu * vv)))) {
        h11 = uu + REAL_MIN;
        h12 = uv;
        h22 = vv + REAL_MIN;
        det = 1.001 * uu * vv - uv * uv + REAL_MIN;
    }
    h[0] = held[0] ? 0.0 : held[1] ? f / h11 : (h22 * f - h12 * g) / det;
    h[1] = held[1] ? 0.0 : held[0] ? g / h22 : (h11 * g - h12 * f) / det;
}

/* Returns a / b. It is not inlined: gcc 12 with AVX divides before it has tested that b is not 0. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_ratio(REAL a, REAL b)
{
    return a / b;
}

/* Computes `to`, the end of the step h from z, or of the part of it in the face; a coordinate within REAL_EDGE of an
 * edge becomes the edge's. */
FOOTPOINT_COLD void footpoint_detail_KIND_along_way(const footpoint_detail_KIND_anchor *z,
                                                    const REAL h[2], REAL to[2])
{
    const REAL x = CORNERS == 4 || z->turn == 0 ? h[0] : z->turn == 1 ? -(h[0] + h[1]) : h[1];
    const REAL y = CORNERS == 4 || z->turn == 0 ? h[1] : z->turn == 1 ? h[0] : -(h[0] + h[1]);
    const REAL low = CORNERS == 3 ? 0.0 : -1.0, third = 1.0 - z->at[0] - z->at[1];
    const REAL way[2] = {x, y};
    REAL part = 1.0;
    int i;
    for (i = 0; i < 2; i++) {
        if (way[i] < 0.0 && part * way[i] < low - z->at[i])
            part = footpoint_detail_KIND_ratio(low - z->at[i], way[i]);
        if (CORNERS == 4 && way[i] > 0.0 && part * way[i] > 1.0 - z->at[i])
            part = footpoint_detail_KIND_ratio(1.0 - z->at[i], way[i]);
    }
    if (CORNERS == 3 && x + y > 0.0 && part * (x + y) > third)
        part = footpoint_detail_KIND_ratio(footpoint_detail_greater(third, 0.0), x + y);
    for (i = 0; i < 2; i++) {
        to[i] = z->at[i] + part * way[i];
        to[i] = to[i] - low < REAL_EDGE ? low : to[i] > 1.0 - REAL_EDGE ? 1.0 : to[i];
    }
    if (CORNERS == 3 && 1.0 - to[0] - to[1] < REAL_EDGE) {
        to[0] = to[0] > 0.5 ? to[0] : 1.0 - to[1];
        to[1] = 1.0 - to[0];
    }
}

/* Takes a step from z on the closed face; if an edge stops it at once, along that edge. */
FOOTPOINT_COLD void footpoint_detail_KIND_step_on(const footpoint_detail_KIND_anchor *z, REAL h[2])
{
    int held[2], i;
    held[0] = fabs(z->held[0]) > 0.0 && z->held[0] * z->f >= 0.0;
    held[1] = fabs(z->held[1]) > 0.0 && z->held[1] * z->g >= 0.0;
    footpoint_detail_KIND_free_step(z, held, h);
    for (i = 0; i < 2; i++)
        if (!held[i] && z->held[i] * h[i] > 0.0) {
            held[i] = 1;
            footpoint_detail_KIND_free_step(z, held, h);
            return;
        }
}

/* Moves *z downhill until steps are within rounding. A step is shortened at most 20 times: compilers that rule out NaN may
 * take its comparisons for true without end. */
FOOTPOINT_COLD void footpoint_detail_KIND_downhill(const footpoint_detail_KIND_terms *of,
                                                   footpoint_detail_KIND_anchor *z)
{
    footpoint_detail_KIND_anchor next;
    REAL h[2], to[2], moved, before = 9.0;
    int i, part;
    for (i = 0; i < 60; i++) {
        footpoint_detail_KIND_step_on(z, h);
        footpoint_detail_KIND_along_way(z, h, to);
        moved = fabs(to[0] - z->at[0]) + fabs(to[1] - z->at[1]);
        if (!(moved > 0.0) || (moved < REAL_STILL && moved >= 0.5 * before))
            return;
        footpoint_detail_KIND_anchor_at(of, to, footpoint_detail_KIND_region(to), &next);
        for (part = 0; part < 20 && moved > REAL_APART && !(next.dd < z->dd); part++) {
            h[0] *= 0.25;
            h[1] *= 0.25;
            footpoint_detail_KIND_along_way(z, h, to);
            moved = fabs(to[0] - z->at[0]) + fabs(to[1] - z->at[1]);
            footpoint_detail_KIND_anchor_at(of, to, footpoint_detail_KIND_region(to), &next);
        }
        *z = next;
        before = moved;
    }
}

/* Returns 1 if z[1] is another point of space than z[0], and as near. */
FOOTPOINT_COLD int footpoint_detail_KIND_is_tie(const footpoint_detail_KIND_anchor z[2],
                                                REAL longest)
{
    REAL e[3];
    footpoint_detail_from(z[0].r.d, z[1].r.d, e);
    return footpoint_detail_dot(e, e) > REAL_APART * REAL_APART * longest * longest &&
           fabs(sqrt(z[1].dd) - sqrt(z[0].dd)) + z[0].off_d + z[1].off_d <= REAL_TIE * longest;
}

/* Finds the nearest point by descents, as z[0]; returns its status. A tie is proved, too: no point is nearer by more
 * than REAL_TIE of the longest edge, and another, elsewhere in space, is not farther by more. */
FOOTPOINT_COLD int footpoint_detail_KIND_seek(const footpoint_detail_KIND_terms *of, REAL promise,
                                              REAL longest, footpoint_detail_KIND_anchor z[2])
{
    REAL start[2];
    int tries;
    footpoint_detail_KIND_downhill(of, z);
    for (tries = 0; tries < 8; tries++) {
        if (footpoint_detail_KIND_split(of, z, 1, footpoint_detail_KIND_needed(z, promise), 0.0,
                                        start) == FOOTPOINT_DETAIL_FAR)
            return FOOTPOINT_OK;
        footpoint_detail_KIND_anchor_at(of, start, footpoint_detail_KIND_region(start), &z[1]);
        footpoint_detail_KIND_downhill(of, &z[1]);
        if (z[1].dd < z->dd) {
            z[0] = z[1];
            continue;
        }
        return footpoint_detail_KIND_is_tie(z, longest) && !(footpoint_detail_fast() >> REAL_TOP) &&
                       footpoint_detail_KIND_split(of, z, 2, promise,
                                                   REAL_TIE * longest - z[0].off_d,
                                                   start) == FOOTPOINT_DETAIL_FAR
                   ? FOOTPOINT_NOT_UNIQUE
                   : FOOTPOINT_UNPROVED;
    }
    return FOOTPOINT_UNPROVED;
}

/* Answers after the quick way has proved nothing and ended in `at`: again in a unit of length in which the face is
 * about 1 long, if it is far from that, then by descents. at[2]: the distance. */
FOOTPOINT_COLD int footpoint_detail_KIND_proved_again(footpoint_detail_nearby *nearby,
                                                      const REAL *const *x, int scalable,
                                                      REAL promise, REAL at[3], int *region)
{
    footpoint_detail_KIND_terms of;
    footpoint_detail_KIND_anchor z[2];
    REAL y[VECTORS][3], longest, least;
    REAL_BITS flat;
    const REAL *row[VECTORS];
    int exponent = 0, i, status = footpoint_detail_scale(x, NODES, VECTORS, y, &exponent);
    (void)scalable;
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < VECTORS; i++)
        row[i] = y[i];
    footpoint_detail_KIND_expand(row, &of);
    longest = sqrt(footpoint_detail_KIND_longest(row));
    least = footpoint_detail_KIND_none_within(row);
    if (footpoint_detail_infinite(least) >> REAL_TOP || least > longest)
        return FOOTPOINT_ERR_DOMAIN;
    status = FOOTPOINT_UNPROVED;
    if (exponent > REAL_ORDINARY || exponent < -REAL_ORDINARY) {
        status = nearby(row, 0, 0.0, at, region);
        at[2] = footpoint_detail_signed_root(at[2]);
    }
    if (status == FOOTPOINT_UNPROVED) {
        footpoint_detail_KIND_anchor_at(&of, at, footpoint_detail_KIND_region(at), z);
        status = footpoint_detail_KIND_seek(&of, promise, longest, z);
        *region = footpoint_detail_KIND_region(z->at);
        at[0] = z->at[0];
        at[1] = z->at[1];
        at[2] = footpoint_detail_signed_root(footpoint_detail_KIND_signed(
            row, z, footpoint_detail_KIND_extent(&of), *region, &flat));
        if (flat >> REAL_TOP)
            return FOOTPOINT_ERR_DEGENERATE;
        if (status != FOOTPOINT_UNPROVED && fabs(at[2]) > longest)
            status = FOOTPOINT_ERR_DOMAIN;
    }
    at[2] = ldexp(at[2], exponent);
    return status;
}

/* Returns a lower bound on the distance of the face, for an answer `at` of that status. */
FOOTPOINT_COLD REAL footpoint_detail_KIND_none_nearer(const REAL *const *x, REAL promise,
                                                      int status, const REAL at[3])
{
    footpoint_detail_KIND_terms of;
    footpoint_detail_KIND_anchor z;
    REAL grows, f, g;
    if (status == FOOTPOINT_NOT_UNIQUE)
        return fabs(at[2]);
    if (status == FOOTPOINT_UNPROVED)
        return footpoint_detail_KIND_none_within(x);
    footpoint_detail_KIND_expand(x, &of);
    footpoint_detail_KIND_anchor_at(&of, at, footpoint_detail_KIND_region(at), &z);
    footpoint_detail_KIND_grows(z.held[0], z.f, 0.0, &grows, &f);
    footpoint_detail_KIND_grows(z.held[1], z.g, 0.0, &grows, &g);
    f = at[2] * at[2] - 2.0 * promise * (f + g);
    return sqrt(footpoint_detail_greater(f, 0.0));
}
