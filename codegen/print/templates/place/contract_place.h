/* What the functions at a place of a face do, said once for all genomes. */

/* NAME:    what its banner says, of the face and the slave node VECTORS at the place loc = {xi, eta}, in
 *          rows; a row that is NULL is not wanted, and costs nothing where the call is inlined.  Rows are finite, or
 *          untouched on error.  Returns FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (an input, or a row that is wanted), or
 *          FOOTPOINT_ERR_DEGENERATE: no normal there that is more than rounding, or, of derivatives, a Hessian of the
 *          distance that is singular.
 * NAME_n:  the same for n pairs; x[3 k + i] is the column of coordinate i of vector k, element j of pair i goes to
 *          row[j * n + i]; rows overlap nothing else, none is NULL; where a status is an error they say nothing.
 * UPPER_GRADIENTS_OF(footpoint_KIND_accurate), at file scope, behind the header of that search, defines the two
 *          with the search before them, footpoint_KIND_accurate_gradients and ..._gradients_n, where loc, xi and eta are
 *          what it finds; and alike for each function here and each search.  The status is the
 *          search's, or where rows cannot be had, their own; with FOOTPOINT_UNPROVED rows are written. */
