/* Sizes of segments that the functions of a header are for. */
#ifndef FOOTPOINT_HEADER_SIZES_H
#define FOOTPOINT_HEADER_SIZES_H

#include "../../compile/compiled_file.h"

/** Whether a function does not depend on the unit of length, so that it may be called with nodes in another one. */
bool sizes_scalable(const struct function *f, const struct segment_kind *k);

/** PREFIX_LEAST, in capitals: a checked function takes nodes as they are if the sum of the squares of a segment's edges
 * is between it and 1 over it; caller frees. */
char *sizes_least_name(const struct unit *u);

/** That macro. */
void sizes_print_least(const struct unit *u, FILE *out);

#endif
