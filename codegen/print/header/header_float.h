/* Prints the additional code of searches over a segment in float: coordinates are moved and scaled before they are multiplied. */
#ifndef FOOTPOINT_HEADER_FLOAT_H
#define FOOTPOINT_HEADER_FLOAT_H

#include "../../compile/compiled_file.h"

/** Prints the scale of a segment. */
void single_print_helpers(const struct unit *u, FILE *out);

/** Prints the coordinates of single_inputs(), before the statements of a function; node A's are named yA. */
void single_print_inputs(const struct unit *u, const struct function *f, FILE *out);

#endif
