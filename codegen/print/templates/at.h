/* The unchecked search. */

FOOTPOINT_FN void NAME_at(NODE_PARAMETERS, REAL *xi, REAL *eta)
{
    (void)NAME_detail(NODE_NAMES, 0.0, xi, eta);
}
