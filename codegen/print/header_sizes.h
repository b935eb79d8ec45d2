/* Determines the sizes of segments that the functions of a header accept. */
#ifndef FOOTPOINT_HEADER_SIZES_H
#define FOOTPOINT_HEADER_SIZES_H

#include "../compile/compiled_file.h"

/** Returns true if a function does not depend on the unit of length, so that its nodes may be scaled. */
bool sizes_scalable(const struct function *f, const struct segment_kind *k);

/** Returns PREFIX_LEAST, in capitals: a checked function does not scale nodes if the sum of the squares of a segment's edges
 * is between it and 1 over it; caller frees. */
char *sizes_least_name(const struct unit *u);

/** Prints that macro. */
void sizes_print_least(const struct unit *u, FILE *out);

#endif
