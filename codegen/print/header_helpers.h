/* What the checked searches of a header over segments share: the gap, nodes in another unit of length, nearest corner.
 */
#ifndef FOOTPOINT_HEADER_HELPERS_H
#define FOOTPOINT_HEADER_HELPERS_H

#include "../compile/compiled_file.h"

/** All of it, and the macro that helpers_least_name() names.  Templates are in templates/. */
void helpers_print(const struct unit *u, FILE *out);

/** Whether a function does not depend on the unit of length, so that it may be called with nodes in another one. */
bool helpers_scalable(const struct function *f, const struct segment_kind *k);

/** PREFIX_LEAST, in capitals: a checked function takes nodes as they are if the sum of the squares of a segment's edges
 * is between it and 1 over it; caller frees. */
char *helpers_least_name(const struct unit *u);

#endif
