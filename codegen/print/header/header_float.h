/* What the search over a segment in float has beyond that in double: coordinates moved and scaled before anything is
 * multiplied. */
#ifndef FOOTPOINT_HEADER_FLOAT_H
#define FOOTPOINT_HEADER_FLOAT_H

#include "../../compile/compiled_file.h"

/** The scale of a segment. */
void single_print_helpers(const struct unit *u, FILE *out);

/** Coordinates as single_inputs() has them, before the statements of a function: those of node A as yA. */
void single_print_inputs(const struct unit *u, const struct function *f, FILE *out);

#endif
