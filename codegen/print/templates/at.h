/* The unchecked search. */

WITH_WALK
/* WALKED, then WALK_TEXT on the patch; NAME_n is the genome. */
END_WALK
FOOTPOINT_FN void NAME_at(NODE_PARAMETERS, REAL *xi, REAL *eta)
{
    (void)WALKED_detail(NODE_NAMES, 0.0, xi, eta);
    WITH_WALK
    {
        const REAL *const x[VECTORS] = {NODE_NAMES};
        footpoint_detail_KIND_bare_steps(x, WALK_STEPS, WALK_SMALL, xi, eta);
    }
    END_WALK
}
