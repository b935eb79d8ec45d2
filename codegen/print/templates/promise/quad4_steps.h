/* Steps to a foot point until one is proved. */

/* Takes up to four steps until one is proved, or they are too short to matter, from finite xi and eta; in a loop over
 * arrays, `fixed` = 1 or 2 steps, with the same answer if these suffice. */
FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_steps(const REAL products[9],
                                                      const footpoint_detail_quad4_vectors *r,
                                                      REAL promise, int fixed, REAL *xi, REAL *eta)
{
    REAL_BITS doubt = footpoint_detail_infinite(*xi + *eta);
    int k = 0;
    if (fixed) {
        const REAL p = *xi, q = *eta;
        REAL u, v;
        REAL_BITS still;
        doubt = footpoint_detail_quad4_step(products, r, promise, xi, eta);
        if (fixed < 2)
            return doubt;
        u = *xi;
        v = *eta;
        /* as below: if the first step was that short, the second is omitted */
        still = footpoint_detail_bits(fabs(u - p) + fabs(v - q) - 0.01 * promise);
        still |= footpoint_detail_quad4_step(products, r, promise, &u, &v);
        *xi = doubt >> REAL_TOP ? u : *xi;
        *eta = doubt >> REAL_TOP ? v : *eta;
        return doubt & still;
    }
    while (!(doubt >> REAL_TOP) && k++ < 4) {
        const REAL u = *xi, v = *eta;
        const REAL_BITS unproved = footpoint_detail_quad4_step(products, r, promise, xi, eta);
        if (!(unproved >> REAL_TOP))
            return unproved;
        doubt = footpoint_detail_infinite(*xi + *eta) |
                footpoint_detail_bits(fabs(*xi - u) + fabs(*eta - v) - 0.01 * promise);
    }
    /* if products have lost too many digits, vectors have not */
    if (promise < 1e-9 && !(footpoint_detail_infinite(*xi + *eta) >> REAL_TOP))
        return footpoint_detail_quad4_prove(r->x, promise, xi, eta);
    return (REAL_BITS)1 << REAL_TOP;
}
