/* The contract of functions at a place of a face, printed once for all genomes. */

/* NAME:    computes the rows of its banner for the face and the slave node VECTORS at the place loc = {xi, eta}.
 *          A row may be NULL, and then costs nothing if the call is inlined.  Rows are finite, or
 *          untouched on error.  Returns FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (an input, or a row that is not NULL), or
 *          FOOTPOINT_ERR_DEGENERATE (no normal there beyond rounding, or, for derivatives, a singular Hessian of the
 *          distance).
 * NAME_n:  does the same for n pairs; x[3 k + i] is the column of coordinate i of vector k, element j of pair i goes to
 *          row[j * n + i].  Rows must not be NULL and must overlap nothing else; on error they are meaningless.
 * UPPER_GRADIENTS_OF(footpoint_KIND_accurate), at file scope, after the header of that search, defines both functions
 *          joined with the search, footpoint_KIND_accurate_gradients and ..._gradients_n, whose loc, xi and eta are
 *          results; likewise for each function here and each search.  The status is the
 *          search's, or, if rows cannot be computed, theirs; with FOOTPOINT_UNPROVED rows are written. */
