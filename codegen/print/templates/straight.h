/* The search: xi and eta by straight-line code, corners in the order that the scene assumes. */

FOOTPOINT_PART REAL_BITS NAME_detail(NODE_PARAMETERS, REAL zero, REAL *xi, REAL *eta)
{
    STATEMENTS
    return DENOMINATORS;
}
