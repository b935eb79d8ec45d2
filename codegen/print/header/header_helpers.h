/* What the checked searches of a header over segments share: the gap, nodes in another unit of length, nearest corner.
 */
#ifndef FOOTPOINT_HEADER_HELPERS_H
#define FOOTPOINT_HEADER_HELPERS_H

#include "../../compile/compiled_file.h"

/** All of it, and the macro that sizes_least_name() names.  Templates are in templates/. */
void helpers_print(const struct unit *u, FILE *out);

#endif
