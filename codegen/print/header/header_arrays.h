/* Searches over arrays: NAME_n, NAME_checked_n and, for many slave nodes over one segment, NAME_over_n of a genome NAME. */
#ifndef FOOTPOINT_HEADER_ARRAYS_H
#define FOOTPOINT_HEADER_ARRAYS_H

#include "../../compile/compiled_file.h"

/** Prints the loops, which all genomes share. */
void arrays_print_helpers(const struct unit *u, FILE *out);

/** Prints the functions of a genome. */
void arrays_print(const struct unit *u, const struct function *f, FILE *out);

#endif
