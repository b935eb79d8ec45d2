/* Functions at a place of a face: of a file that begins with `face`. */
#ifndef FOOTPOINT_HEADER_PLACE_H
#define FOOTPOINT_HEADER_PLACE_H

#include "../compile/compiled_file.h"

/** What all of them share, and what they do. */
void place_print_helpers(const struct unit *u, FILE *out);

/** NAME and NAME_n of a genome, and the macro that joins them with a search. */
void place_print(const struct unit *u, const struct function *f, FILE *out);

#endif
