/* A patch relative to one of its points: changes of the squared distance from there. */

/* A point (xi,eta) = at of the closed patch, and coordinates (s,t) from there. held: for s and for t, -1 if the patch
 * lies at >= 0, 1 if at <= 0, otherwise 0. f, g: slopes r_xi . d and r_eta . d, d = xS - r, off by off_f and off_g; dd =
 * d . d; a, b, c: r_xi xi . d, r_xi eta . d, r_eta eta . d. far: a fifth of it bounds d plus net.far. By rounding,
 * entries of the matrix M are off by `off`, the distance by off_d, dd and its changes by off_dd. Within h of the point,
 * slopes change by at most stiff h and, for h of REAL_FINE in footpoint_detail_KIND_ball, differ from their linear part
 * by bent h^2. */
typedef struct {
    footpoint_detail_local r;
    const footpoint_detail_KIND_terms *of; /* not owned */
    REAL at[2], f, g, dd, a, b, c, off_f, off_g, far, off, off_d, off_dd, bent, stiff;
    REAL held[2];
    int turn; /* 0: only triangles have others */
} footpoint_detail_KIND_anchor;

/* Returns the region: 0 inside; 1 to 4: edges; then corners. */
FOOTPOINT_PART int footpoint_detail_KIND_region(const REAL at[2])
{
    const int left = at[0] <= -1.0, right = at[0] >= 1.0;
    const int below = at[1] <= -1.0, above = at[1] >= 1.0;
    return below + 3 * above + 4 * left + (left & above) + right * (2 + 3 * below + 2 * above);
}

/* Computes (s,t) from the anchor to (xi,eta) = to. */
FOOTPOINT_PART void footpoint_detail_KIND_way(const footpoint_detail_KIND_anchor *z,
                                              const REAL to[2], REAL h[2])
{
    h[0] = to[0] - z->at[0];
    h[1] = to[1] - z->at[1];
}

/* Sets bounds, F = |d| + net.far; nothing is proved if normals are not of length 1.
 *
 * Rounding, u = 1.12e-16, see footpoint_detail_net: entries of M are off by 1e5 u F^2, see
 * footpoint_detail_KIND_form_over. Coordinates of d are off by 29 u net.far + 9 u |d|, the vector by 51 u F, its root of
 * dd by less than 60 u F; dd by 2 |d| times that, 41 u F^2 at most, and where another point is as near, F is less than
 * twice as large, which adds 3 times that. What a quadratic adds by slopes, 60 u F^2, and sums make 250 u F^2; its
 * products with M, of entries up to 280 F^2, stay within what 1e5 u F^2 leave.
 *
 * Changes: |r_i| <= 2.5 net.far, |r_ij| <= 3.5 net.far; so rows of the Hessian add up to at most 2 (6.25 net.far^2 + 3.5
 * |d| net.far) <= 12.5 F^2. Products r_ij . r_k, three times four of them, add up to 105 net.far^2; those of d with third
 * derivatives to 25 |d| net.far of the net and, in the ball, 555 |d| net.far of the twists, which are at most 1.52
 * net.far, times 66 + 2.92 (100 + 2.5): see footpoint_detail_gregory_inner. 105 x^2 + 580 x (1 - x) <= 178; half of that
 * is less than 100. */
FOOTPOINT_PART void footpoint_detail_KIND_bound(footpoint_detail_KIND_anchor *z)
{
    const footpoint_detail_net *const net = &z->of->net;
    const REAL u = footpoint_detail_sum(z->r.u), v = footpoint_detail_sum(z->r.v);
    const REAL d = footpoint_detail_sum(z->r.d), far = net->tilt <= 1.01 ? d + net->far : 2e29;
    const REAL square = far * far;
    REAL off[2];
    footpoint_detail_KIND_off(net, u, v, d, 0.0, off);
    z->off_f = off[0];
    z->off_g = off[1];
    z->far = 5.0 * far;
    z->off = 1e5 * REAL_UNIT * square;
    z->off_d = 60.0 * REAL_UNIT * far;
    z->off_dd = 300.0 * REAL_UNIT * square;
    z->bent = 100.0 * square;
    z->stiff = 20.0 * square;
}

FOOTPOINT_APART void footpoint_detail_KIND_anchor_at(const footpoint_detail_KIND_terms *of,
                                                     const REAL at[2], int region,
                                                     footpoint_detail_KIND_anchor *z)
{
    int i;
    (void)region;
    z->of = of;
    z->turn = 0;
    for (i = 0; i < 2; i++) {
        z->at[i] = at[i];
        z->held[i] = (REAL)((at[i] >= 1.0) - (at[i] <= -1.0));
    }
    footpoint_detail_KIND_local(of, at[0], at[1], &z->r);
    footpoint_detail_KIND_bound(z);
    z->f = footpoint_detail_dot(z->r.u, z->r.d);
    z->g = footpoint_detail_dot(z->r.v, z->r.d);
    z->dd = footpoint_detail_dot(z->r.d, z->r.d);
    z->a = footpoint_detail_dot(z->r.uu, z->r.d);
    z->b = footpoint_detail_dot(z->r.uv, z->r.d);
    z->c = footpoint_detail_dot(z->r.vv, z->r.d);
}
