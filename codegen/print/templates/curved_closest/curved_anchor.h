/* A curved face relative to one of its points: changes of the squared distance from there. */

/* A point (xi,eta) = at of the closed face, and coordinates (s,t) from there. For quadrilaterals they are xi and eta
 * minus the point's. For a triangle they are the two that vanish at corner number `turn`, so that t >= 0 is the edge
 * between it and the next if the point is on an edge, and s, t >= 0 if it is a corner. held: for s and for t, -1 if the
 * face lies at >= 0, 1 if at <= 0, otherwise 0. r: derivatives by s and t, d = xS - r; uuv, uvv, k: r_sst, r_stt,
 * r_sstt. f, g: slopes r_s . d and r_t . d, off by off_f and off_g; dd = d . d; a, b, c: r_ss . d, r_st . d, r_tt . d.
 * far bounds all vectors. By rounding, entries of the matrix M are off by `off`, d by off_d, dd and its changes by
 * off_dd. Within h of the point, slopes differ from their linear part by at most bent h^2 and change by stiff h. */
typedef struct {
    footpoint_detail_local r;
    REAL at[2], uuv[3], uvv[3], k[3], f, g, dd, a, b, c, off_f, off_g, far, off, off_d, off_dd,
        bent, stiff;
    REAL held[2];
    int turn;
} footpoint_detail_KIND_anchor;

/* Returns the region: 0 inside; 1 to CORNERS: edges; then corners. */
FOOTPOINT_PART int footpoint_detail_KIND_region(const REAL at[2])
{
    if (CORNERS == 3) {
        const int below = at[1] <= 0.0, left = at[0] <= 0.0;
        const int over = fabs(1.0 - at[0] - at[1]) < REAL_STEP;
        return below & left ? 4 : below & over ? 5 : left & over ? 6 : below + 2 * over + 3 * left;
    } else {
        const int left = at[0] <= -1.0, right = at[0] >= 1.0;
        const int below = at[1] <= -1.0, above = at[1] >= 1.0;
        return below + 3 * above + 4 * left + (left & above) + right * (2 + 3 * below + 2 * above);
    }
}

/* Converts derivatives by xi and eta to those by s and t. */
FOOTPOINT_PART void footpoint_detail_KIND_turned(int turn, footpoint_detail_local *r)
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        const REAL u = r->u[i], v = r->v[i], uu = r->uu[i], uv = r->uv[i], vv = r->vv[i];
        r->u[i] = turn == 1 ? v - u : -v;
        r->v[i] = turn == 1 ? -u : u - v;
        r->uu[i] = turn == 1 ? (vv - uv) + (uu - uv) : vv;
        r->uv[i] = turn == 1 ? uu - uv : vv - uv;
        r->vv[i] = turn == 1 ? uu : (vv - uv) + (uu - uv);
    }
}

/* Computes (s,t) from the anchor to (xi,eta) = to. */
FOOTPOINT_PART void footpoint_detail_KIND_way(const footpoint_detail_KIND_anchor *z,
                                              const REAL to[2], REAL h[2])
{
    const REAL x = to[0] - z->at[0], y = to[1] - z->at[1];
    h[0] = CORNERS == 4 || z->turn == 0 ? x : z->turn == 1 ? y : -(x + y);
    h[1] = CORNERS == 4 || z->turn == 0 ? y : z->turn == 1 ? -(x + y) : x;
}
