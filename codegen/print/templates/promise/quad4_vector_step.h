/* A step to a foot point, proved only from vectors: in float, where products lose too many digits. */

FOOTPOINT_PART REAL_BITS footpoint_detail_quad4_step(const REAL products[9],
                                                     const footpoint_detail_quad4_vectors *r,
                                                     REAL promise, REAL *xi, REAL *eta)
{
    (void)products;
    return footpoint_detail_quad4_newton(r->x, promise, xi, eta);
}
