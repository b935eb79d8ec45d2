/* The search over a segment in C: the functions of a genome. */
#ifndef FOOTPOINT_HEADER_SEGMENT_H
#define FOOTPOINT_HEADER_SEGMENT_H

#include "../../compile/compiled_file.h"

/** Prints the contract of each function, once for all genomes. */
void search_print_contract(const struct unit *u, FILE *out);

/** Prints the unchecked search that the functions share; must precede the first of them. */
void search_print_bare(const struct unit *u, const struct function *f, FILE *out);

/** Prints NAME_at, NAME and NAME_n, in float with samples also NAME_sure, and the functions of header_closest.h. */
void search_print(const struct unit *u, const struct function *f, FILE *out);

#endif
