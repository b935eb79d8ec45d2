/* The closest point of a closed segment: NAME_closest and NAME_closest_n of a genome NAME. */
#ifndef FOOTPOINT_HEADER_CLOSEST_H
#define FOOTPOINT_HEADER_CLOSEST_H

#include "../compile/compiled_file.h"

/** Whether there are such functions: of bilinear segments and flat triangles, with corners in any order. */
bool closest_exists(const struct unit *u);

/** What they share, and what they do, said once for all genomes. */
void closest_print_helpers(const struct unit *u, FILE *out);
void closest_print_contract(const struct unit *u, FILE *out);

/** Both functions of a genome; `vectors` is "xA, xB, ..., xS". */
void closest_print(const struct unit *u, const struct function *f, const char *vectors, FILE *out);

#endif
