/* Values at a place of an edge: shape functions, tangent, normal, gap, and their derivatives at a foot point. */

/* Holds an edge at one place, and the parts of derivatives. */
struct footpoint_detail_KIND_rates {
    REAL phi[VECTORS],
        slope[VECTORS]; /* coefficients of the vectors in r - xS, and their derivatives by xi */
    REAL t[2], bend[2], n[2], gap, tt,
        stiff; /* r', r'', normal; half of (|xS - r|^2)'' at a foot point */
};

/* Computes the values at xi.  The highest bit of the result is set if there is no normal, or a value is not finite. */
FOOTPOINT_PART REAL_BITS footpoint_detail_KIND_rates_at(const REAL *const *x, REAL xi,
                                                        struct footpoint_detail_KIND_rates *e)
{
    REAL bend[NODES], d[2], edges = 0.0, length;
    int j, k;
    footpoint_detail_KIND_shape(xi, e->phi, e->slope, bend);
    e->phi[NODES] = -1.0;
    e->slope[NODES] = 0.0;
    for (j = 0; j < 2; j++) {
        e->t[j] = e->bend[j] = 0.0;
        d[j] = x[NODES][j] - x[0][j];
        for (k = 1; k < NODES; k++) {
            const REAL edge = x[k][j] - x[0][j];
            e->t[j] += e->slope[k] * edge;
            e->bend[j] += bend[k] * edge;
            d[j] -= e->phi[k] * edge;
            edges += edge * edge;
        }
    }
    e->tt = footpoint_detail_plane_dot(e->t, e->t);
    length = sqrt(e->tt);
    e->n[0] = e->t[1] / length;
    e->n[1] = -e->t[0] / length;
    e->gap = footpoint_detail_plane_dot(d, e->n);
    e->stiff = e->tt - e->gap * footpoint_detail_plane_dot(e->bend, e->n);
    return footpoint_detail_outside(e->tt) |
           footpoint_detail_bits(e->tt - REAL_FLAT * (1.0 + xi * xi) * edges) |
           footpoint_detail_infinite(e->gap + xi);
}

/* Returns the status of a place without values, or of derivatives if the foot point is not unique. */
FOOTPOINT_PART int footpoint_detail_KIND_placed(const REAL *const *x, REAL xi,
                                                const struct footpoint_detail_KIND_rates *e,
                                                REAL_BITS flaw, int derivatives)
{
    const REAL least = 1e-14 * (e->tt + fabs(e->gap) * (fabs(e->bend[0]) + fabs(e->bend[1])));
    REAL_BITS infinite = footpoint_detail_infinite(xi);
    int k;
    if (!(flaw >> REAL_TOP) &&
        !(derivatives && footpoint_detail_below(e->stiff, least) >> REAL_TOP))
        return FOOTPOINT_OK;
    for (k = 0; k < VECTORS; k++)
        infinite |= footpoint_detail_infinite(x[k][0]) | footpoint_detail_infinite(x[k][1]);
    return infinite >> REAL_TOP ? FOOTPOINT_ERR_NOT_FINITE : FOOTPOINT_ERR_DEGENERATE;
}

FOOTPOINT_FN int PREFIX_place(NODE_PARAMETERS, REAL xi, REAL *phi, REAL *r_xi, REAL *normal,
                              REAL *gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    struct footpoint_detail_KIND_rates e;
    const REAL_BITS flaw = footpoint_detail_KIND_rates_at(x, xi, &e);
    const int status = footpoint_detail_KIND_placed(x, xi, &e, flaw, 0);
    int j;
    if (status != FOOTPOINT_OK)
        return status;
    for (j = 0; phi && j < NODES; j++)
        phi[j] = e.phi[j];
    for (j = 0; r_xi && j < 2; j++)
        r_xi[j] = e.t[j];
    for (j = 0; normal && j < 2; j++)
        normal[j] = e.n[j];
    if (gap)
        *gap = e.gap;
    return FOOTPOINT_OK;
}

/* Returns the derivative of xi by coordinate j of vector k. */
FOOTPOINT_PART REAL footpoint_detail_KIND_d_xi(const struct footpoint_detail_KIND_rates *e, int k,
                                               int j)
{
    return (e->slope[k] * e->gap * e->n[j] - e->phi[k] * e->t[j]) / e->stiff;
}

FOOTPOINT_FN int PREFIX_gradients(NODE_PARAMETERS, REAL xi, REAL *d_xi, REAL *d_gap)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    struct footpoint_detail_KIND_rates e;
    const REAL_BITS flaw = footpoint_detail_KIND_rates_at(x, xi, &e);
    const int status = footpoint_detail_KIND_placed(x, xi, &e, flaw, 1);
    int i;
    for (i = 0; status == FOOTPOINT_OK && i < COORDINATES; i++) {
        if (d_xi)
            d_xi[i] = footpoint_detail_KIND_d_xi(&e, i / 2, i % 2);
        if (d_gap)
            d_gap[i] = -e.phi[i / 2] * e.n[i % 2];
    }
    return status;
}

FOOTPOINT_FN int PREFIX_hessian(NODE_PARAMETERS, REAL xi, REAL *d_normal, REAL *hessian)
{
    const REAL *const x[VECTORS] = {NODE_NAMES};
    struct footpoint_detail_KIND_rates e;
    const REAL_BITS flaw = footpoint_detail_KIND_rates_at(x, xi, &e);
    const int status = footpoint_detail_KIND_placed(x, xi, &e, flaw, 1);
    REAL turn[COORDINATES], along[COORDINATES];
    int i, j;
    if (status != FOOTPOINT_OK)
        return status;
    for (i = 0; i < COORDINATES; i++) { /* of xi, and of the normal: by coordinate a, turn t_a */
        along[i] = footpoint_detail_KIND_d_xi(&e, i / 2, i % 2);
        turn[i] =
            -(e.slope[i / 2] * e.n[i % 2] + footpoint_detail_plane_dot(e.bend, e.n) * along[i]) /
            e.tt;
    }
    for (j = 0; d_normal && j < 2; j++)
        for (i = 0; i < COORDINATES; i++)
            d_normal[j * COORDINATES + i] = turn[i] * e.t[j];
    for (i = 0; hessian && i < COORDINATES; i++)
        for (j = 0; j <= i; j++)
            hessian[i * (i + 1) / 2 + j] =
                -e.phi[i / 2] * turn[j] * e.t[i % 2] - e.slope[i / 2] * along[j] * e.n[i % 2];
    return FOOTPOINT_OK;
}
