/* The search over a segment in C: the functions of a genome. */
#ifndef FOOTPOINT_HEADER_SEGMENT_H
#define FOOTPOINT_HEADER_SEGMENT_H

#include "../../compile/compiled_file.h"

/** What each of the functions does, said once for all genomes. */
void search_print_contract(const struct unit *u, FILE *out);

/** What all of these begin with, printed before the first of them. */
void search_print_bare(const struct unit *u, const struct function *f, FILE *out);

/** NAME_at, NAME and NAME_n; in float, where there were samples, NAME_sure; those of header_closest.h. */
void search_print(const struct unit *u, const struct function *f, FILE *out);

#endif
