/* Projection along a direction: PREFIX_along and PREFIX_along_n, which need no genome. */
#ifndef FOOTPOINT_HEADER_ALONG_H
#define FOOTPOINT_HEADER_ALONG_H

#include "../../compile/compiled_file.h"

/** Returns false, with a line in `d`, if the segment's nodes are of no kind that it knows. */
bool along_check(const struct unit *u, struct diag *d);

/** Of all segments without normals; of others nothing. */
void along_print(const struct unit *u, FILE *out);

#endif
