/* Steps of four-node faces where the quick ones prove nothing. */

/* The square of the distance at (xi,eta), of vectors with over = 1; and where gauss is not
 * NULL, the step of Gauss and Newton from there, which leads downhill. */
FOOTPOINT_COLD REAL footpoint_detail_quad4_apart(const REAL a[3], const REAL b[3], const REAL c[3],
                                                 const REAL d[3], REAL xi, REAL eta, REAL *gauss)
{
    REAL u[3], v[3], w[3], uu, uv, vv, f, g, det;
    int i;
    for (i = 0; i < 3; i++) {
        u[i] = a[i] + eta * c[i];
        v[i] = b[i] + xi * c[i];
        w[i] = d[i] - xi * a[i] - eta * v[i];
    }
    if (gauss) {
        uu = footpoint_detail_dot(u, u);
        uv = footpoint_detail_dot(u, v);
        vv = footpoint_detail_dot(v, v);
        f = footpoint_detail_dot(u, w);
        g = footpoint_detail_dot(v, w);
        det = 1.001 * uu * vv - uv * uv + REAL_MIN;
        gauss[0] = (vv * f - uv * g) / det;
        gauss[1] = (uu * g - uv * f) / det;
    }
    return footpoint_detail_dot(w, w);
}

/* Vectors as sums of edges, four times r's. */
FOOTPOINT_COLD void footpoint_detail_quad4_edges(REAL y[VECTORS][3], REAL a[3], REAL b[3],
                                                 REAL c[3], REAL d[3])
{
    int i;
    for (i = 0; i < 3; i++) {
        const REAL ab = y[1][i] - y[0][i], dc = y[2][i] - y[3][i];
        a[i] = ab + dc;
        b[i] = (y[3][i] - y[0][i]) + (y[2][i] - y[1][i]);
        c[i] = dc - ab;
        d[i] = ((y[4][i] - y[0][i]) + (y[4][i] - y[2][i])) +
               ((y[4][i] - y[1][i]) + (y[4][i] - y[3][i]));
    }
}

/* From `at`, where the square of the distance is *apart, to `to`, if that is nearer; else by damped steps of Gauss and Newton, which
 * lead downhill.  0 if nothing is nearer. */
FOOTPOINT_COLD int footpoint_detail_quad4_nearer(const REAL a[3], const REAL b[3], const REAL c[3],
                                                 const REAL d[3], REAL to[2], REAL at[2],
                                                 REAL *apart)
{
    REAL gauss[2], damp = 1.0, less;
    less = footpoint_detail_quad4_apart(a, b, c, d, to[0], to[1], NULL);
    if (!(less <= *apart * (1.0 + REAL_MARGIN))) {
        (void)footpoint_detail_quad4_apart(a, b, c, d, at[0], at[1], gauss);
        do {
            to[0] = at[0] + damp * gauss[0];
            to[1] = at[1] + damp * gauss[1];
            less = footpoint_detail_quad4_apart(a, b, c, d, to[0], to[1], NULL);
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

/* From (*xi,*eta) by up to 20 steps until one is proved; FOOTPOINT_UNPROVED if none is.  y: the vectors in a unit of length in which the
 * segment is about 1 long. */
FOOTPOINT_COLD int footpoint_detail_quad4_repair(REAL y[VECTORS][3], REAL promise, REAL *xi,
                                                 REAL *eta)
{
    REAL a[3], b[3], c[3], d[3], at[2], to[2], apart, moved;
    const REAL *const x[VECTORS] = {y[0], y[1], y[2], y[3], y[4]};
    int steps, status = FOOTPOINT_UNPROVED;
    footpoint_detail_quad4_edges(y, a, b, c, d);
    at[0] = fabs(*xi) < 1e3 ? *xi : 0.0;
    at[1] = fabs(*eta) < 1e3 ? *eta : 0.0;
    apart = footpoint_detail_quad4_apart(a, b, c, d, at[0], at[1], NULL);
    for (steps = 0; steps < 20; steps++) {
        to[0] = at[0];
        to[1] = at[1];
        if (!(footpoint_detail_quad4_prove(x, promise, &to[0], &to[1]) >> REAL_TOP)) {
            at[0] = to[0];
            at[1] = to[1];
            status = FOOTPOINT_OK;
            break;
        }
        moved = fabs(to[0] - at[0]) + fabs(to[1] - at[1]);
        if (moved < 1e-4) { /* near a minimum, where rounding hides which is nearer */
            at[0] = to[0];
            at[1] = to[1];
        } else if (!footpoint_detail_quad4_nearer(a, b, c, d, to, at, &apart))
            break;
        if (moved < 0.01 * promise) /* rounding forbids the proof */
            break;
    }
    *xi = at[0];
    *eta = at[1];
    return status;
}
