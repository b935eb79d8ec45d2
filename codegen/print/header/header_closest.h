/* The closest point of a closed segment: NAME_closest, NAME_closest_n and NAME_closest_of of a genome NAME. */
#ifndef FOOTPOINT_HEADER_CLOSEST_H
#define FOOTPOINT_HEADER_CLOSEST_H

#include "../../compile/compiled_file.h"

/** Whether there are such functions: of segments without normals, with corners in any order. */
bool closest_exists(const struct unit *u);

/** What they share, and what they do, said once for all genomes. */
void closest_print_helpers(const struct unit *u, FILE *out);
void closest_print_contract(const struct unit *u, FILE *out);

/** The functions of a genome. */
void closest_print(const struct unit *u, const struct function *f, FILE *out);

#endif
