/* Lines of C that the functions over a segment share. */
#ifndef FOOTPOINT_HEADER_LINES_H
#define FOOTPOINT_HEADER_LINES_H

#include "../compile/compiled_file.h"

/** "double" or "float". */
const char *lines_real(const struct unit *u);

/** "FUNCTION(const double xA[3], ..., const double xS[3], LAST)", broken where it gets long; `last` with REAL for the type,
 *  no blanks behind commas. */
void lines_print_head(const struct unit *u, const char *function, const char *last, FILE *out);

/** "xA, xB, ..., xS"; caller frees. */
char *lines_vectors(const struct unit *u);

/** The search: from the vectors, which are x, too, to xi, eta and flaw, which it declares.  Corners go into the order
 *  that the scene assumes, and u and v, declared where there is one, found there back to the caller's. */
void lines_print_search(const struct unit *u, const struct function *f, const char *vectors, const char *indent,
                        FILE *out);

/** The same search once more, with a segment y that is about 1 long; or what is wrong with the nodes x, which is so at
 *  once of a search that depends on the unit of length: without nodes there is no length. */
void lines_print_again(const struct unit *u, const struct function *f, FILE *out);

#endif
