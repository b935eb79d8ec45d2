/* Functions at a place of a face: of a file that begins with `face`. */
#ifndef FOOTPOINT_HEADER_PLACE_H
#define FOOTPOINT_HEADER_PLACE_H

#include "../../compile/compiled_file.h"

/** What all of them share, and what they do. */
void place_print_helpers(const struct unit *u, FILE *out);

/** False with *d where rows are more than a header has room for, are called as what it has already, or are not each of one
 *  power of a length, without which there is no second try in another unit; and of float, for which there are none. */
bool place_check(const struct unit *u, struct diag *d);

/** NAME and NAME_n of a genome, and the macro that joins them with a search. */
void place_print(const struct unit *u, const struct function *f, FILE *out);

#endif
