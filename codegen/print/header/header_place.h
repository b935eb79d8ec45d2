/* Prints functions at a place of a face, for a file that begins with `face`. */
#ifndef FOOTPOINT_HEADER_PLACE_H
#define FOOTPOINT_HEADER_PLACE_H

#include "../../compile/compiled_file.h"

/** Prints the helpers and the contract that all of them share. */
void place_print_helpers(const struct unit *u, FILE *out);

/** Returns false with *d filled if there are more rows than a header has room for, if a name is taken, or if the elements of a row are
 *  not all of the same power of a length, which a second try in another unit requires; and in float, which is not supported. */
bool place_check(const struct unit *u, struct diag *d);

/** Prints NAME and NAME_n of a genome, and the macro that joins them with a search. */
void place_print(const struct unit *u, const struct function *f, FILE *out);

#endif
