/* A curved face as a given point of it sees it. */

FOOTPOINT_PART void footpoint_detail_KIND_anchor_at(const footpoint_detail_KIND_terms *of,
                                                    const REAL at[2], int region,
                                                    footpoint_detail_KIND_anchor *z)
{
    const REAL middle = footpoint_detail_KIND_middle(), p = at[0] - middle, q = at[1] - middle;
    z->at[0] = at[0];
    z->at[1] = at[1];
    z->turn = CORNERS == 4 || region == 0 ? 0 : (region - 1) % CORNERS;
    z->held[0] =
        CORNERS == 4 ? (REAL)((at[0] >= 1.0) - (at[0] <= -1.0)) : (REAL) - (region > CORNERS);
    z->held[1] = CORNERS == 4 ? (REAL)((at[1] >= 1.0) - (at[1] <= -1.0)) : (REAL) - (region > 0);
    footpoint_detail_KIND_local(of, p, q, &z->r);
    if (CORNERS == 4)
        footpoint_detail_KIND_mixed(of, p, q, z->uuv, z->uvv, z->k);
    else if (z->turn > 0)
        footpoint_detail_KIND_turned(z->turn, &z->r);
    footpoint_detail_KIND_slopes(of, p, q, z);
    z->dd = footpoint_detail_dot(z->r.d, z->r.d);
    z->a = footpoint_detail_dot(z->r.uu, z->r.d);
    z->b = footpoint_detail_dot(z->r.uv, z->r.d);
    z->c = footpoint_detail_dot(z->r.vv, z->r.d);
}
