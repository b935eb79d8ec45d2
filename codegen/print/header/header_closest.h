/* Prints closest points of a closed segment: NAME_closest, NAME_closest_n and NAME_closest_of of a genome NAME. */
#ifndef FOOTPOINT_HEADER_CLOSEST_H
#define FOOTPOINT_HEADER_CLOSEST_H

#include "../../compile/compiled_file.h"

/** Returns true if there are such functions: for corners in any order. */
bool closest_exists(const struct unit *u);

/** Prints their helpers and their contract, once for all genomes. */
void closest_print_helpers(const struct unit *u, FILE *out);
void closest_print_contract(const struct unit *u, FILE *out);

/** Prints the functions of a genome. */
void closest_print(const struct unit *u, const struct function *f, FILE *out);

#endif
