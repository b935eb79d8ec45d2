/* The search: xi and eta by straight-line code, corners in the order that the scene assumes. */

FOOTPOINT_PART REAL_BITS NAME_detail(NODE_PARAMETERS, REAL zero, REAL *xi, REAL *eta)
{
    STATEMENTS
    return DENOMINATORS;
}

FOOTPOINT_FN void NAME_at(NODE_PARAMETERS, REAL *xi, REAL *eta)
{
    (void)NAME_detail(NODE_NAMES, 0.0, xi, eta);
}
