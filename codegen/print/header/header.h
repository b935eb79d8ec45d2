/* Prints the C header of a unit: banner, shared helpers and the functions of each genome, in double or float. */
#ifndef FOOTPOINT_HEADER_H
#define FOOTPOINT_HEADER_H

#include "../../compile/compiled_file.h"

void header_print(const struct unit *u, FILE *out);

#endif
