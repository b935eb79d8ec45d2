/* Helpers that the checked searches of a header share: the gap, nodes in another unit of length, the nearest corner. */
#ifndef FOOTPOINT_HEADER_HELPERS_H
#define FOOTPOINT_HEADER_HELPERS_H

#include "../../compile/compiled_file.h"

/** Prints all helpers (print/templates/) and the macro that sizes_least_name() names. */
void helpers_print(const struct unit *u, FILE *out);

#endif
