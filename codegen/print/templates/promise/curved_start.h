/* Starts of steps on curved faces, and Newton's step. */

/* Returns the middle's coordinate. Below, coordinates (p,q) are (xi,eta) less the middle's. */
FOOTPOINT_PART REAL footpoint_detail_KIND_middle(void)
{
    return CORNERS == 3 ? 1.0 / 3.0 : 0.0;
}

/* Computes the terms of a face and a slave node. */
FOOTPOINT_PART void footpoint_detail_KIND_expand(const REAL *const *x,
                                                 footpoint_detail_KIND_terms *of)
{
    int i, k;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        REAL node[VECTORS];
        FOOTPOINT_UNROLL
        for (k = 0; k < VECTORS; k++)
            node[k] = x[k][i];
        footpoint_detail_KIND_axis(node, i, of);
    }
    of->size = sqrt(footpoint_detail_KIND_square(of));
}

/* Takes a Gauss-Newton step from the middle, less the effect of curvature along it. */
FOOTPOINT_PART void footpoint_detail_KIND_start(const footpoint_detail_KIND_terms *of, REAL *p,
                                                REAL *q)
{
    const REAL ee = footpoint_detail_dot(of->e, of->e), ef = footpoint_detail_dot(of->e, of->f);
    const REAL ff = footpoint_detail_dot(of->f, of->f), per = 1.0 / (ee * ff - ef * ef);
    const REAL f = footpoint_detail_dot(of->d, of->e), g = footpoint_detail_dot(of->d, of->f);
    const REAL s = (ff * f - ef * g) * per, t = (ee * g - ef * f) * per;
    REAL w[3], along, across;
    footpoint_detail_KIND_arc(of, s, t, w);
    along = footpoint_detail_dot(of->e, w);
    across = footpoint_detail_dot(of->f, w);
    *p = s - (ff * along - ef * across) * per;
    *q = t - (ee * across - ef * along) * per;
}

/* Takes a Newton step from (*p,*q) to the foot point. */
FOOTPOINT_PART void footpoint_detail_KIND_bare(const footpoint_detail_KIND_terms *of, REAL *p,
                                               REAL *q)
{
    footpoint_detail_local r;
    footpoint_detail_newton n;
    footpoint_detail_KIND_local(of, *p, *q, &r);
    footpoint_detail_newton_of(&r, &n);
    *p += n.s;
    *q += n.t;
}
